/// The calls of a conversation that have not ended.
#pragma once

#include <atomic>
#include <deque>
#include <mutex>
#include <optional>
#include <set>
#include <unordered_map>
#include <utility>
#include <vector>

#include "call.hpp"

namespace sbgc::detail {

/// Who ends a call takes it out first, so that each ends once. Thread-safe; handlers run without
/// the lock.
class PendingCalls {
 public:
  using Ticket = Conversation::Ticket;

  /// No more than `most_waiting` calls wait for room in the session.
  explicit PendingCalls(std::size_t most_waiting) : most_waiting_(most_waiting) {}

  /// Takes the call in and gives it its ticket, or says why not.
  std::optional<ClientError> add(const CallPointer& call);
  /// Takes a call out; null if it has ended.
  CallPointer take(Ticket ticket);
  /// Takes out a call whose deadline has passed; null if there is none.
  CallPointer take_overdue(Instant at);
  /// Takes all calls out, and refuses later ones with this error.
  std::vector<CallPointer> take_all(ClientError refusal);

  /// The next call that waits for the session; null if none does. It stays pending.
  CallPointer next_waiting();
  /// The first deadline of all calls.
  Instant deadline() const;

  /// Hands out the result of a call that has been taken out, or was never taken in.
  void complete(const Call& call, Result<Reply> result);
  /// Counts a call that failed before it began.
  void count_failure();
  std::uint64_t begun() const noexcept { return begun_; }
  std::uint64_t failed() const noexcept { return failed_; }

 private:
  const std::size_t most_waiting_;
  std::atomic<std::uint64_t> begun_{};
  std::atomic<std::uint64_t> failed_{};

  mutable std::mutex mutex_;
  std::optional<ClientError> refusal_;
  Ticket last_ticket_{};
  std::unordered_map<Ticket, CallPointer> calls_;
  std::deque<CallPointer> waiting_;  // may hold calls that have ended
  std::set<std::pair<Instant, Ticket>> deadlines_;
};

}  // namespace sbgc::detail
