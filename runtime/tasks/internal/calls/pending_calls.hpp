/// The pending calls of a conversation, and the order of its motion commands.
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include <sbgc/client/options.hpp>
#include <sbgc/client/reply.hpp>
#include <sbgc/client/request.hpp>
#include <sbgc/session.hpp>

#include "lock.hpp"

namespace sbgc::detail {

/// A stop, and any later motion, supersedes the motion of tasks that began before: these may send
/// no more motion. A stop is superseded by a later motion, but not by a later stop.
class MotionOrder {
 public:
  /// Called with the number of the later task that supersedes this one.
  using Superseded = std::function<void(TaskNumber by)>;
  using Calls = std::vector<std::function<void()>>;

  /// Assigns a number to a task that begins.
  TaskNumber begin() noexcept { return ++last_; }

  /// Called once if the task is superseded, until leave().
  void join(TaskNumber task, Superseded superseded) {
    tasks_.insert_or_assign(task, Entry{std::move(superseded)});
  }
  void leave(TaskNumber task) { tasks_.erase(task); }

  /// True if the task may send no more motion.
  bool is_superseded(TaskNumber task) const noexcept {
    return task < std::max(last_motion_, last_stop_);
  }

  /// Returns false if the task may not send this motion command; otherwise records it, and appends
  /// the calls that notify the superseded tasks.
  bool admit(TaskNumber task, bool stops, Calls& calls) {
    if (task < last_motion_ || (!stops && task < last_stop_)) return false;
    TaskNumber& last = stops ? last_stop_ : last_motion_;
    last = std::max(last, task);
    const auto own = tasks_.find(task);
    if (own != tasks_.end() && !stops) own->second.has_moved = true;
    std::erase_if(tasks_, [&](auto& one) {
      const bool is_superseded = one.first < task && (!stops || one.second.has_moved);
      if (is_superseded) {
        calls.push_back([tell = std::move(one.second.superseded), task] { tell(task); });
      }
      return is_superseded;
    });
    return true;
  }

 private:
  struct Entry {
    Superseded superseded{};
    bool has_moved = false;
  };

  TaskNumber last_{};
  TaskNumber last_motion_{};  // the latest task that has moved the camera
  TaskNumber last_stop_{};
  std::map<TaskNumber, Entry> tasks_{};
};

using ReplyHandler = std::function<void(Result<Reply>)>;

/// A call and its deadline.
struct Call {
  CallId id{};
  TaskNumber task{};  ///< the task that makes it; 0: none
  Request request{};
  SendOptions send{};
  Instant deadline = Instant::never;
  Duration allowed{};  ///< from its start to the deadline
  std::function<void(unsigned)> on_confirmation{};
  std::function<void(const Frame&)> on_series{};
  ReplyHandler handler{};
  Handle handle{};  ///< in the session, once sent; only Dialogue uses it
  std::atomic<bool> was_sent = false;
};

using CallPointer = std::shared_ptr<Call>;

/// Creates a call that starts at `now`. `options` override `defaults`.
CallPointer make_call(CallId id, Request request, const CallOptions& options,
                      const ConnectOptions& defaults, Instant now, ReplyHandler handler);
/// Returns whole milliseconds, rounded up: "150 ms".
std::string milliseconds_text(Duration duration);
/// The error of a call that was not sent because of a stop, or of a later motion.
ClientError superseded_error(const Call& call);
/// The result of a call whose deadline has passed: an error, unless only an optional confirmation
/// is missing.
Result<Reply> overdue_result(const Call& call);

/// A call is removed before it is ended, so each call ends exactly once. Not thread-safe: the owner
/// locks it, but not while a handler runs.
class PendingCalls {
 public:
  /// At most `most_waiting` calls wait for room in the session, not counting stops.
  explicit PendingCalls(std::size_t most_waiting) : most_waiting_(most_waiting) {}

  /// The removed calls that a new one supersedes, and functions that notify the tasks.
  struct Superseded {
    std::vector<CallPointer> calls{};
    MotionOrder::Calls tasks{};
  };

  /// Adds the call, or returns the reason for rejecting it. In the same step, removes the calls
  /// that wait for the session and must not follow it: the sending thread sends a stop first, and
  /// must not find older motion after it.
  std::optional<ClientError> add(const CallPointer& call, Superseded& superseded);
  /// Removes a call; null if it has already ended.
  CallPointer take(CallId id);
  /// Removes a call whose deadline has passed; null if there is none.
  CallPointer take_overdue(Instant at);
  /// Removes all calls and rejects later ones with this error.
  std::vector<CallPointer> take_all(ClientError refusal);

  /// Returns the next call that waits for the session: a stop, or the oldest for which
  /// `has_room(call)`; null if there is none. It stays pending.
  CallPointer next_waiting(const std::function<bool(const Call&)>& has_room);
  /// Returns the earliest deadline of all calls.
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

/// The pending calls of a conversation, which may be shared between threads.
class SharedCalls : public Guarded<PendingCalls> {
 public:
  explicit SharedCalls(std::size_t most_waiting, LockPointer lock = nullptr)
      : Guarded(std::move(lock), most_waiting) {}

  /// Passes its result to the handler of a call that was removed or never added. Must be called
  /// without the lock.
  void complete(const Call& call, Result<Reply> result) {
    if (!result) lock()->count_failed();
    call.handler(std::move(result));
  }

  /// Adds a call, ends the calls that it supersedes, and notifies the tasks. Returns the reason for
  /// rejecting it.
  std::optional<ClientError> begin(const CallPointer& call) {
    PendingCalls::Superseded superseded;
    auto refusal = lock()->add(call, superseded);
    for (const auto& tell : superseded.tasks) tell();
    for (const CallPointer& one : superseded.calls) complete(*one, superseded_error(*one));
    return refusal;
  }
};

}  // namespace sbgc::detail
