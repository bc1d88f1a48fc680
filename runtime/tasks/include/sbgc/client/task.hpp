/// Tasks: operations of several calls, as state machines without I/O.
///
/// A task is a coroutine that is driven from outside: step() returns the next action, and the
/// driver executes it and hands the result to the task. Anything with a clock and a line can be the
/// driver: Client::run(), AsyncClient::async_run(), a test in virtual time, a browser.
///
///     sbgc::Task<sbgc::Result<double>> yaw_after(std::chrono::seconds pause) {
///       sbgc::TaskMachine& task = co_await sbgc::tasks::this_task();
///       auto waited = co_await sbgc::tasks::wait_until(task.now() + sbgc::seconds(pause.count()));
///       if (!waited) co_return waited.error();
///       const auto angles = co_await sbgc::tasks::call(sbgc::msg::GetAnglesRequest{});
///       if (!angles) co_return angles.error();
///       co_return angles->axes.yaw.imu_angle.degrees();
///     }
///
/// Such a coroutine takes its parameters by value: a reference may dangle when the task resumes.
#pragma once

#include <concepts>
#include <coroutine>
#include <cstdint>
#include <deque>
#include <functional>
#include <limits>
#include <list>
#include <memory>
#include <optional>
#include <span>
#include <unordered_map>
#include <utility>
#include <vector>

#include <sbgc/client/board_identity.hpp>
#include <sbgc/client/notice.hpp>
#include <sbgc/client/options.hpp>
#include <sbgc/client/reply.hpp>
#include <sbgc/client/request.hpp>
#include <sbgc/client/subscription.hpp>
#include <sbgc/client/typed.hpp>
#include <sbgc/internal/message_type.hpp>
#include <sbgc/result.hpp>
#include <sbgc/time.hpp>

namespace sbgc {

/// The next action for the driver of a task.
struct TaskStep {
  /// The action of the driver.
  enum class Kind : std::uint8_t {
    call,    ///< start `request`; pass its result to TaskMachine::replied()
    cancel,  ///< cancel `call`; its result no longer matters
    wait,    ///< call step() again on the next event, at the latest at `until`
    done,    ///< the task is over
  };

  Kind kind{};
  CallId call{};  ///< of `call` and `cancel`
  Result<detail::Request> request =
      ClientError{};  ///< of `call`; an error is the result of the call
  /// For a `call` that starts a data stream: the request that ends it. Pass the frames of the
  /// stream to TaskMachine::received(); `cancel` ends the stream, also after the reply.
  std::optional<detail::Request> stream_end{};
  CallOptions options{};           ///< of `call`
  Instant until = Instant::never;  ///< of `wait`
  /// For `wait`: true if TaskMachine::wake() ends it.
  bool can_be_woken = false;
  /// For `cancel`: the stream that TaskMachine::keep() holds for the call. Drop it after canceling.
  Subscription stream{};
};

/// The state of a running task. Not thread-safe.
class TaskMachine {
 public:
  /// Called by Task::begin().
  explicit TaskMachine(const BoardIdentity& board) : board_(board) {}
  TaskMachine(const TaskMachine&) = delete;
  TaskMachine& operator=(const TaskMachine&) = delete;
  ~TaskMachine() = default;

  // For the driver.

  /// Runs the task as far as possible. `now` must not decrease. At its end, its remaining calls are
  /// canceled first.
  TaskStep step(Instant now);
  /// Ends a task that threw: step() cancels its calls, and does not resume it.
  void abandon() noexcept { coroutine_ = nullptr; }
  /// Keeps the data stream of a call until the call is canceled; drops it if it already was.
  void keep(CallId id, Subscription stream);
  /// True if a call is running.
  bool is_calling() const;
  /// Reports that a call has ended.
  void replied(CallId id, Result<Reply> reply);
  /// Reports a confirmation of a call that has not ended yet.
  void confirmed(CallId id);
  /// Reports a message of the series that precedes the response to a call, or of its data stream.
  void received(CallId id, std::vector<std::uint8_t> body);
  /// Passes a notice of the client to the listeners of the task.
  void notice(const Notice& notice);
  /// Passes on a message of the board that belongs to no call, if overhears().
  void overheard(std::uint8_t id, std::span<const std::uint8_t> body);
  /// Ends the current or next wait with ErrorCode::cancelled, once. The task may still clean up.
  void cancel() noexcept { is_cancelled_ = true; }
  /// Tells the task that the one with this number supersedes the motion of earlier ones: ends the
  /// current or next wait of an earlier one with ErrorCode::superseded, once.
  void supersede(TaskNumber by) noexcept { is_superseded_ = is_superseded_ || number_ < by; }
  /// The number of the task in its client, which its calls carry; 0 if there is none.
  TaskNumber number() const noexcept { return number_; }
  /// Sets the number.
  void set_number(TaskNumber number) noexcept {
    if (std::exchange(number_, number) != number) is_superseded_ = false;
  }
  /// Ends a wait of tasks::wait_for_wake().
  void wake() noexcept { is_woken_ = true; }

  /// True if the task wants messages that belong to no call. Changes only during a step.
  bool overhears() const noexcept { return static_cast<bool>(overhearing_); }
  /// Sets before the first step whether the line may duplicate frames.
  void set_repeating_line(bool may_repeat) noexcept { line_may_repeat_ = may_repeat; }

  // For the task.

  /// Returns the time of the last step.
  Instant now() const noexcept { return now_; }
  /// Returns the identity of the board.
  const BoardIdentity& identity() const noexcept { return board_; }
  /// The framing of the board's last answer.
  Framing framing() const noexcept { return framing_; }

  /// True if a confirmation may be a duplicate of an earlier one.
  bool line_may_repeat() const noexcept { return line_may_repeat_; }

  /// Starts a call that runs concurrently with the task.
  template <Callable M>
  CallId begin(const M& request, const CallOptions& options) {
    if constexpr (!std::same_as<M, AnyMessage>) {
      static_assert(M::direction != Direction::from_board, "only the board sends this message");
    }
    return begin_call(detail::prepare(request, board_.versions(), options.validate), options);
  }
  /// Starts a data stream of M, which runs until end(), or until the end of the task: `request` has
  /// its interval and configuration. Its frames form a series. Fails for firmware without streams.
  template <Message M, Message Request>
  CallId begin_stream(Request request, const CallOptions& options = {}) {
    detail::choose_stream<M>(request);
    if (auto refusal = detail::stream_refusal(detail::message_type<M>(), board_.versions())) {
      return begin_call(*std::move(refusal), options);
    }
    auto end = detail::prepare(detail::stream_end(request), board_.versions(), options.validate);
    if (!end) return begin_call(std::move(end).error(), options);
    return begin_call(detail::prepare(request, board_.versions(), options.validate), options,
                      *std::move(end));
  }
  /// True if the call was confirmed at least once, or a message of its series has arrived.
  bool has_started(CallId id) const;
  /// Returns the bodies of the messages of its series that have arrived since the last call.
  std::vector<std::vector<std::uint8_t>> take_series(CallId id);
  /// Returns the result of a call; null while it is running.
  const Result<Reply>* reply(CallId id) const;
  /// Drops a call; cancels it if it is running, and ends its data stream.
  void end(CallId id);

  /// Handles a notice.
  using NoticeHandler = std::function<void(const Notice&)>;
  /// A place in the list of listeners.
  using Listener = std::list<NoticeHandler>::iterator;
  /// Calls the handler with each notice until stop_listening().
  Listener listen(NoticeHandler handler);
  /// Removes a listener.
  void stop_listening(Listener listener) { listeners_.erase(listener); }
  /// Handles a message that belongs to no call.
  using OverhearingHandler =
      std::function<void(std::uint8_t id, std::span<const std::uint8_t> body)>;
  /// Calls the handler with each message that belongs to no call; an empty one ends this.
  void overhear(OverhearingHandler handler) { overhearing_ = std::move(handler); }

  /// The events that a coroutine waits for. The first one resumes it.
  struct Wait {
    CallId call{};                 ///< the end of this call
    bool start_is_enough = false;  ///< also its first confirmation
    Instant until = Instant::never;
    bool for_wake = false;  ///< also wake()
  };
  /// Records the waiting coroutine and its wait conditions; called by functions of sbgc::tasks.
  void wait(std::coroutine_handle<> coroutine, const Wait& wait) noexcept {
    coroutine_ = coroutine;
    wait_ = wait;
  }
  /// The error that ended the last wait early; success if there was none.
  Result<void> end_of_wait() const;

 private:
  struct Call {
    unsigned confirmations{};
    bool has_series{};
    std::vector<std::vector<std::uint8_t>> series{};
    std::optional<Result<Reply>> reply{};
    Subscription stream{};

    bool has_started() const noexcept { return confirmations != 0 || has_series; }
  };

  /// Sets the coroutine that step() resumes when the present one has suspended; null at the end.
  /// (Resuming it from there would need tail calls, which WebAssembly may lack.)
  void go_on(std::coroutine_handle<> coroutine) noexcept {
    coroutine_ = coroutine;
    goes_on_ = static_cast<bool>(coroutine);
  }
  CallId begin_call(Result<detail::Request> request, const CallOptions& options,
                    std::optional<detail::Request> stream_end = {});
  bool is_ready();

  BoardIdentity board_;
  Instant now_{};
  Framing framing_ = basic_framing;
  std::coroutine_handle<> coroutine_{};  // the coroutine to resume next
  bool goes_on_ = false;                 // without waiting
  Wait wait_{.until = Instant{std::numeric_limits<std::int64_t>::min()}};
  std::deque<TaskStep> steps_{};
  std::unordered_map<CallId, Call> calls_{};
  std::list<NoticeHandler> listeners_{};
  OverhearingHandler overhearing_{};
  bool line_may_repeat_ = false;
  bool is_cancelled_ = false;
  bool is_superseded_ = false;
  std::optional<ErrorCode> cut_short_{};
  bool is_woken_ = false;
  TaskNumber number_{};

  template <class R>
  friend class Task;
};

/// A task that returns an R, such as Result<void>. It does nothing until it is driven, or awaited
/// by another task.
template <class R>
class [[nodiscard]] Task {
  struct Promise;

 public:
  /// Required by the language for coroutines.
  using promise_type = Promise;
  /// The type of its result.
  using result_type = R;

  /// Takes over a task that has not begun, or is being driven.
  Task(Task&& other) noexcept
      : coroutine_(std::exchange(other.coroutine_, nullptr)), machine_(std::move(other.machine_)) {}
  /// Swaps two tasks.
  Task& operator=(Task&& other) noexcept {
    std::swap(coroutine_, other.coroutine_);
    std::swap(machine_, other.machine_);
    return *this;
  }
  Task(const Task&) = delete;
  Task& operator=(const Task&) = delete;
  ~Task() {
    if (coroutine_) coroutine_.destroy();
  }

  /// Starts the task for this board. Must be called only once.
  TaskMachine& begin(const BoardIdentity& board) {
    machine_ = std::make_unique<TaskMachine>(board);
    coroutine_.promise().machine = machine_.get();
    machine_->coroutine_ = coroutine_;
    return *machine_;
  }
  /// Precondition: the last step was TaskStep::Kind::done.
  R result() && { return *std::move(coroutine_.promise().result); }

  // For use inside another task.
  // NOLINTBEGIN(readability-identifier-naming): names that the language requires

  /// False: a task does nothing before it is awaited.
  bool await_ready() const noexcept { return false; }
  /// Runs it in the machine of the awaiting task.
  template <class Other>
  void await_suspend(std::coroutine_handle<Other> awaiting) noexcept {
    coroutine_.promise().machine = awaiting.promise().machine;
    coroutine_.promise().awaiting = awaiting;
    coroutine_.promise().machine->go_on(coroutine_);
  }
  /// Returns its result.
  R await_resume() { return *std::move(coroutine_.promise().result); }

  // NOLINTEND(readability-identifier-naming)

 private:
  struct Final {
    bool await_ready() const noexcept { return false; }
    void await_suspend(std::coroutine_handle<Promise> ended) const noexcept {
      ended.promise().machine->go_on(ended.promise().awaiting);
    }
    void await_resume() const noexcept {}
  };

  struct Promise {
    TaskMachine* machine{};
    std::coroutine_handle<> awaiting{};
    std::optional<R> result{};

    Task get_return_object() { return Task(std::coroutine_handle<Promise>::from_promise(*this)); }
    std::suspend_always initial_suspend() const noexcept { return {}; }
    Final final_suspend() const noexcept { return {}; }
#if defined(__cpp_exceptions)
    /// Exceptions of user-provided handlers propagate to the driver.
    void unhandled_exception() { throw; }
#else
    void unhandled_exception() const noexcept {}
#endif
    template <class Value>
    void return_value(Value&& value) {
      result.emplace(std::forward<Value>(value));
    }
  };

  explicit Task(std::coroutine_handle<Promise> coroutine) noexcept : coroutine_(coroutine) {}

  std::coroutine_handle<Promise> coroutine_;
  std::unique_ptr<TaskMachine> machine_{};
};

namespace detail {

struct ThisTask {
  TaskMachine* machine{};

  bool await_ready() const noexcept { return false; }
  template <class Promise>
  bool await_suspend(std::coroutine_handle<Promise> coroutine) noexcept {
    machine = coroutine.promise().machine;
    return false;
  }
  TaskMachine& await_resume() const noexcept { return *machine; }
};

struct Waiting {
  TaskMachine::Wait wait{};
  TaskMachine* machine{};

  bool await_ready() const noexcept { return false; }
  template <class Promise>
  void await_suspend(std::coroutine_handle<Promise> coroutine) noexcept {
    machine = coroutine.promise().machine;
    machine->wait(coroutine, wait);
  }
  Result<void> await_resume() const { return machine->end_of_wait(); }
};

/// It has a constructor, because g++ 12 copies the bytes of a temporary aggregate.
template <Callable M>
struct Calling {
  Calling(M to_send, CallOptions with) : request(std::move(to_send)), options(std::move(with)) {}

  M request;
  CallOptions options;
  TaskMachine* machine{};
  CallId id{};

  bool await_ready() const noexcept { return false; }
  template <class Promise>
  void await_suspend(std::coroutine_handle<Promise> coroutine) {
    machine = coroutine.promise().machine;
    id = machine->begin(request, options);
    machine->wait(coroutine, {.call = id});
  }
  CallResult<M> await_resume() { return read_response<M>(take()); }

  Result<Reply> take() {
    const Result<Reply>* const reply = machine->reply(id);
    Result<Reply> result =
        reply != nullptr ? *reply : Result<Reply>(machine->end_of_wait().error());
    machine->end(id);
    return result;
  }
};

template <Callable M>
struct Transacting : Calling<M> {
  using Calling<M>::Calling;
  Result<Reply> await_resume() { return this->take(); }
};

}  // namespace detail

namespace tasks {

/// Awaiting it returns the TaskMachine of the running coroutine.
inline detail::ThisTask this_task() noexcept { return {}; }

/// Like Client::call(), but never calls CallOptions::on_confirmation.
template <Callable M>
detail::Calling<M> call(const M& request, const CallOptions& options = {}) {
  return {request, options};
}

/// Like Client::transact(), but never calls CallOptions::on_confirmation.
template <Callable M>
detail::Transacting<M> transact(const M& request, const CallOptions& options = {}) {
  return {request, options};
}

/// Waits until `until`; fails with ErrorCode::cancelled or ErrorCode::superseded.
inline detail::Waiting wait_until(Instant until) noexcept { return {{.until = until}}; }
/// Waits for TaskMachine::wake(), at the latest until `until`.
inline detail::Waiting wait_for_wake(Instant until) noexcept {
  return {{.until = until, .for_wake = true}};
}
/// Waits for the end of a call started with TaskMachine::begin(), at the latest until `until`.
inline detail::Waiting wait_for_call(CallId id, Instant until) noexcept {
  return {{.call = id, .until = until}};
}
/// Waits for the first confirmation or the end of a call, at the latest until `until`.
inline detail::Waiting wait_for_start(CallId id, Instant until) noexcept {
  return {{.call = id, .start_is_enough = true, .until = until}};
}

}  // namespace tasks
}  // namespace sbgc
