/// The calls of a conversation that have not ended.
#pragma once

#include <deque>
#include <functional>
#include <optional>
#include <set>
#include <unordered_map>
#include <utility>
#include <vector>

#include "call.hpp"
#include "motion_order.hpp"

namespace sbgc::detail {

/// Whoever ends a call takes it out first, so each call ends exactly once. Not thread-safe: the
/// owner locks it, but not while a handler runs.
class PendingCalls {
 public:
  /// At most `most_waiting` calls wait for room in the session, besides stops.
  explicit PendingCalls(std::size_t most_waiting) : most_waiting_(most_waiting) {}

  /// The calls that a new one supersedes, taken out, and functions that tell the tasks.
  struct Superseded {
    std::vector<CallPointer> calls{};
    MotionOrder::Calls tasks{};
  };

  /// Adds the call, or returns the reason for rejecting it. In the same
  /// step, takes out the calls that wait for the session and must not follow it: the thread that
  /// sends takes a stop first, and must not find older motion behind it.
  std::optional<ClientError> add(const CallPointer& call, Superseded& superseded);
  /// Takes a call out; null if it has already ended.
  CallPointer take(CallId id);
  /// Takes out a call whose deadline has passed; null if there is none.
  CallPointer take_overdue(Instant at);
  /// Takes all calls out and rejects later ones with this error.
  std::vector<CallPointer> take_all(ClientError refusal);

  /// Returns the next call that waits for the session: a stop, else the oldest for which
  /// `has_room(call)`; null if there is none. It stays pending.
  CallPointer next_waiting(const std::function<bool(const Call&)>& has_room);
  /// The earliest deadline of all calls.
  Instant deadline() const;

  /// The tasks of the conversation, and which of them may still move the camera.
  MotionOrder& order() noexcept { return order_; }

  void count_begun() noexcept { ++begun_; }
  void count_failed() noexcept { ++failed_; }
  std::size_t size() const noexcept { return calls_.size(); }
  std::uint64_t begun() const noexcept { return begun_; }
  std::uint64_t failed() const noexcept { return failed_; }

 private:
  void take_superseded(const Call& later, std::vector<CallPointer>& superseded);

  const std::size_t most_waiting_;
  std::uint64_t begun_{};
  std::uint64_t failed_{};
  std::optional<ClientError> refusal_;
  std::unordered_map<CallId, CallPointer> calls_;
  // These may hold calls that have ended.
  std::deque<CallPointer> waiting_effects_;
  std::deque<CallPointer> waiting_reads_;
  std::set<std::pair<Instant, CallId>> deadlines_;
  MotionOrder order_;
};

}  // namespace sbgc::detail
