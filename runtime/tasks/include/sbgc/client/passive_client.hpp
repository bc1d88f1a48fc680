/// The client without threads, clocks and I/O, for programs that bring their own: a simulation, a
/// test in virtual time, a browser.
///
///     sbgc::PassiveClient client;
///     client.connect([&](const sbgc::Result<void>& connected) { ... });
///     client.start(sbgc::tasks::move_to({.yaw = 30_deg}), [&](const auto& moved) { ... });
///
/// Its owner passes received bytes to it, and sends the bytes that it returns:
///
///     if (const auto bytes = client.advance(now); !bytes.empty()) {
///       line.write(bytes);
///       client.written(now);
///     }
///     if (const auto bytes = line.read_until(client.deadline()); !bytes.empty()) {
///       client.receive(bytes, now);
///     }
///
/// Commands can move the camera; see docs/2-safety.md.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <utility>

#include <sbgc/client/board_identity.hpp>
#include <sbgc/client/message_key.hpp>
#include <sbgc/client/notice.hpp>
#include <sbgc/client/options.hpp>
#include <sbgc/client/raw_request.hpp>
#include <sbgc/client/subscription.hpp>
#include <sbgc/client/task.hpp>
#include <sbgc/line.hpp>
#include <sbgc/result.hpp>
#include <sbgc/time.hpp>

namespace sbgc {

/// A conversation with a board, and the tasks that run in it. Times must not decrease. Handlers run
/// inside the functions that take a time. Not thread-safe.
class PassiveClient {
 public:
  /// The options for opening a line have no effect: `timeout`, `detect_line`, `capture` and `wrap`.
  /// `line_may_repeat` says that the line, such as UDP, may deliver bytes twice.
  explicit PassiveClient(const ConnectOptions& options = {}, bool line_may_repeat = false);
  PassiveClient(const PassiveClient&) = delete;
  PassiveClient& operator=(const PassiveClient&) = delete;
  ~PassiveClient();

  /// Applies these settings to the line and discards received bytes; returns false if it cannot.
  using SetLine = std::function<bool(const LineSettings&)>;
  /// Searches for the line settings at which the board answers, as Detector does, and keeps them.
  /// Must precede everything else. Errors: `not_found`; it can be called again then.
  void detect_line(SetLine set_line, std::function<void(const Result<void>&)> done);
  /// Sets the settings of the line, on which pacing and timeouts depend.
  void set_line(const LineSettings& line);
  /// Reads the board's identity, sending the password first if there is one, and changes to its
  /// newest framing if the board answers in it. Tasks that start before the identity is known fail
  /// for boards and firmware that lack a command. Errors: those of Client::call().
  void connect(std::function<void(const Result<void>&)> done);
  /// Returns the identity of the board; empty before connect() has succeeded.
  const BoardIdentity& identity() const noexcept;
  /// Counters since construction.
  SessionStatistics statistics() const noexcept;
  /// Sets an identity that is known from elsewhere.
  void set_identity(const BoardIdentity& board);

  /// Starts a task, which runs concurrently with others; calls `done(result)` at its end. The
  /// returned task is valid until then; call advance() after changing it.
  template <class R, class Done>
  TaskMachine& start(Task<R> task, Done done) {
    const auto own = std::make_shared<Task<R>>(std::move(task));
    return start(own->begin(identity()),
                 [own, done = std::move(done)]() mutable { done(std::move(*own).result()); });
  }

  /// Calls `handler` with every M that the board sends, solicited or not.
  template <Message M>
  Subscription subscribe(std::function<void(const M&)> handler) {
    return subscribe(detail::key_of<M>, detail::typed_handler<M>(std::move(handler)));
  }
  /// Calls `handler` for all other events: resets, errors.
  Subscription on_notice(std::function<void(const Notice&)> handler);
  /// Calls `handler` with every frame that the board sends, including unknown messages.
  Subscription on_frame(std::function<void(const BoardFrame&)> handler);

  /// Takes bytes from the board.
  void receive(std::span<const std::uint8_t> bytes, Instant now);
  /// Runs the tasks as far as possible. Returns the bytes to send, valid until the next call; no
  /// more bytes are returned until written() is called.
  std::span<const std::uint8_t> advance(Instant now);
  /// Reports that the bytes of advance() have been sent.
  void written(Instant now);
  /// The latest time for the next call of advance(); the time of the last call if work is pending.
  Instant deadline() const noexcept;

  class State;
  /// For the library itself.
  State& state() const noexcept { return *state_; }

 private:
  TaskMachine& start(TaskMachine& task, std::function<void()> finish);
  Subscription subscribe(detail::MessageKey key, detail::MessageHandler handler);

  std::unique_ptr<State> state_;
};

}  // namespace sbgc
