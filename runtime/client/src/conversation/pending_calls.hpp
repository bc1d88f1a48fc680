/// The calls of a conversation that have not ended.
#pragma once

#include <atomic>
#include <deque>
#include <functional>
#include <mutex>
#include <optional>
#include <set>
#include <unordered_map>
#include <utility>
#include <vector>

#include "call.hpp"

namespace sbgc::detail {

/// Whoever ends a call takes it out first, so each call ends exactly once. Thread-safe; handlers
/// run without the lock.
class PendingCalls {
 public:
  using Ticket = Conversation::Ticket;

  /// At most `most_waiting` calls wait for room in the session, besides stops.
  explicit PendingCalls(std::size_t most_waiting) : most_waiting_(most_waiting) {}

  /// Adds the call and assigns its ticket, or returns the reason for rejecting it. In the same
  /// step, takes out the calls that wait for the session and must not follow it: the thread that
  /// sends takes a stop first, and must not find older motion behind it.
  std::optional<ClientError> add(const CallPointer& call, std::vector<CallPointer>& superseded);
  /// Takes a call out; null if it has already ended.
  CallPointer take(Ticket ticket);
  /// Takes out a call whose deadline has passed; null if there is none.
  CallPointer take_overdue(Instant at);
  /// Takes all calls out and rejects later ones with this error.
  std::vector<CallPointer> take_all(ClientError refusal);

  /// Returns the next call that waits for the session: a stop, else the oldest for which
  /// `has_room(call)`; null if there is none. It stays pending.
  CallPointer next_waiting(const std::function<bool(const Call&)>& has_room);
  /// The earliest deadline of all calls.
  Instant deadline() const;

  /// Passes its result to the handler of a call that was taken out, or was never added.
  void complete(const Call& call, Result<Reply> result);
  /// Counts a call that failed before it started.
  void count_failure();
  std::uint64_t begun() const noexcept { return begun_; }
  std::uint64_t failed() const noexcept { return failed_; }

 private:
  void take_superseded(const Call& later, std::vector<CallPointer>& superseded);

  const std::size_t most_waiting_;
  std::atomic<std::uint64_t> begun_{};
  std::atomic<std::uint64_t> failed_{};

  mutable std::mutex mutex_;
  std::optional<ClientError> refusal_;
  Ticket last_ticket_{};
  std::unordered_map<Ticket, CallPointer> calls_;
  // These may hold calls that have ended.
  std::deque<CallPointer> waiting_effects_;
  std::deque<CallPointer> waiting_reads_;
  std::set<std::pair<Instant, Ticket>> deadlines_;
};

}  // namespace sbgc::detail
