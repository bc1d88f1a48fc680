/// A client in virtual time: task, conversation and emulated board in one thread, without I/O.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <stdexcept>
#include <utility>
#include <vector>

#include <sbgc/client/task.hpp>
#include <sbgc/emulator/emulator.hpp>
#include <sbgc/messages.hpp>

#include "conversation/dialogue.hpp"

namespace sbgc::test {

/// The line between a virtual client and its board. Bytes arrive at once, unless a derived class
/// knows better.
class VirtualLine {
 public:
  using Way = emulator::Line::Way;
  using Bytes = std::vector<std::uint8_t>;

  VirtualLine() = default;
  VirtualLine(const VirtualLine&) = delete;
  VirtualLine& operator=(const VirtualLine&) = delete;
  virtual ~VirtualLine() = default;

  /// Takes bytes from one end.
  virtual void send(Way way, std::span<const std::uint8_t> bytes, Instant) {
    Bytes& under_way = way == Way::to_board ? to_board_ : to_host_;
    under_way.insert(under_way.end(), bytes.begin(), bytes.end());
  }
  /// Returns the bytes that have arrived at the other end.
  virtual Bytes receive(Way way, Instant) {
    return std::exchange(way == Way::to_board ? to_board_ : to_host_, {});
  }
  /// When further bytes arrive.
  virtual Instant next() const { return Instant::never; }
  virtual bool may_repeat() const { return false; }

 private:
  Bytes to_board_{};
  Bytes to_host_{};
};

/// A client as in a browser: everything is a function of the time passed in.
class VirtualClient {
 public:
  explicit VirtualClient(const emulator::EmulatorOptions& options = {},
                         emulator::Memory memory = {}, VirtualLine* line = nullptr,
                         ConnectOptions client = {})
      : line_(line != nullptr ? *line : perfect_line_),
        emulator_(options, std::move(memory), now_),
        port_(emulator_.connect(true, now_).value()),
        client_(std::move(client)) {
    const Result<msg::BoardInfo> info = run(introduction());
    if (!info) throw std::runtime_error(info.error().message);
    identity_.info = *info;
  }
  VirtualClient(const VirtualClient&) = delete;
  VirtualClient& operator=(const VirtualClient&) = delete;
  ~VirtualClient() = default;

  /// Runs a task to its end; calls `at_each_step(task)` before each step.
  template <class R, class Watch>
  R run(Task<R> task, Watch at_each_step) {
    TaskMachine& machine = task.begin(identity_);
    machine.set_repeating_line(line_.may_repeat() || client_.duplicate_window.count() != 0);
    const auto notices = delivery_.on_notice([&](const Notice& one) { machine.notice(one); });
    const auto strays = delivery_.on_frame([&](const BoardFrame& one) {
      if (!one.belongs_to_call) machine.overheard(one.frame.id);
    });
    for (bool is_done = false; !is_done;) {
      at_each_step(machine);
      is_done = step(machine);
    }
    return std::move(task).result();
  }
  template <class R>
  R run(Task<R> task) {
    return run(std::move(task), [](TaskMachine&) {});
  }

  Instant now() const noexcept { return now_; }
  emulator::Gimbal& gimbal() { return emulator_.board().gimbal(); }
  emulator::Emulator& emulator() { return emulator_; }
  /// Cuts the line from the host to the board.
  void cut_the_line() { is_cut_ = true; }
  std::size_t pending() const { return calls_->size(); }
  detail::Delivery& delivery() { return delivery_; }
  const BoardIdentity& identity() const { return identity_; }

 private:
  using Way = VirtualLine::Way;
  using Bytes = VirtualLine::Bytes;

  static Task<Result<msg::BoardInfo>> introduction() {
    // The board is starting.
    co_return co_await tasks::call(msg::BoardInfoRequest{}, {.retries = 2});
  }

  /// Runs until the task waits, then advances to the next event.
  bool step(TaskMachine& task) {
    TaskStep step = task.step(now_);
    switch (step.kind) {
      case TaskStep::Kind::done: return true;
      case TaskStep::Kind::call: begin(task, std::move(step)); return false;
      case TaskStep::Kind::cancel: cancel(step.call); return false;
      case TaskStep::Kind::wait: break;
    }
    const Instant next = exchange_bytes();
    if (!has_news_ && next == Instant::never && step.until == Instant::never) {
      throw std::runtime_error("nothing will ever happen");
    }
    if (!has_news_) now_ = later(now_ + microseconds(1), earlier(next, step.until));
    has_news_ = false;
    return false;
  }

  void begin(TaskMachine& task, TaskStep step) {
    const CallId id = step.call;
    if (!step.request) return task.replied(id, std::move(step.request).error());
    step.options.on_confirmation = [&task, this, id](unsigned) {
      has_news_ = true;
      task.confirmed(id);
    };
    step.options.on_series = [&task, this, id](const Frame& frame) {
      has_news_ = true;
      task.received(id, {frame.body.begin(), frame.body.end()});
    };
    const detail::CallPointer call =
        detail::make_call(id, *std::move(step.request), step.options, client_, now_,
                          [&task, this, id](Result<Reply> reply) {
                            has_news_ = true;
                            task.replied(id, std::move(reply));
                          });
    std::vector<detail::CallPointer> older;
    if (auto refusal = calls_->add(call, older)) return task.replied(id, *std::move(refusal));
    for (const detail::CallPointer& superseded : older) {
      calls_.complete(*superseded, detail::superseded_error(*superseded));
    }
  }

  void cancel(CallId id) {
    if (const auto call = calls_->take(id)) dialogue_.forget(*call);
  }

  /// Transfers bytes in both directions; returns when to call it again.
  Instant exchange_bytes() {
    const Output output = dialogue_.advance(now_, true);
    if (!output.bytes.empty()) {
      if (!is_cut_) line_.send(Way::to_board, output.bytes, now_);
      dialogue_.written(now_);
      has_news_ = true;
    }
    const Bytes requests = line_.receive(Way::to_board, now_);
    if (!requests.empty()) emulator_.from_host(port_, requests, now_);
    emulator_.advance(now_);
    const auto sent = emulator_.to_host(port_);
    if (!sent.empty()) {
      line_.send(Way::to_host, sent, now_);
      emulator_.take(port_, sent.size(), now_);
    }
    const Bytes answers = line_.receive(Way::to_host, now_);
    if (!answers.empty()) {
      dialogue_.feed(answers, now_);
      has_news_ = true;
    }
    return earlier(output.deadline, earlier(emulator_.next(), line_.next()));
  }

  Instant now_{1'000'000};
  bool is_cut_ = false;
  bool has_news_ = false;
  VirtualLine perfect_line_{};
  VirtualLine& line_;
  emulator::Emulator emulator_;
  std::size_t port_;
  ConnectOptions client_;
  BoardIdentity identity_{};
  detail::SharedCalls calls_{std::size_t{64}};
  detail::Delivery delivery_{};
  detail::Dialogue dialogue_{client_, calls_, delivery_};
};

}  // namespace sbgc::test
