/// A client in virtual time: task, conversation and emulated board in one thread, without I/O.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <stdexcept>
#include <utility>
#include <vector>

#include <sbgc/client/task.hpp>
#include <sbgc/emulator/emulator.hpp>
#include <sbgc/messages.hpp>

#include "conversation/dialogue.hpp"
#include "tasks/hold_speed.hpp"

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

/// A board and its time, which several clients can share.
struct VirtualBoard {
  explicit VirtualBoard(const emulator::EmulatorOptions& options = {}, emulator::Memory memory = {})
      : emulator(options, std::move(memory), now) {}

  Instant now{1'000'000};
  emulator::Emulator emulator;
};

/// A client as in a browser: everything is a function of the time passed in.
class VirtualClient {
 public:
  explicit VirtualClient(const emulator::EmulatorOptions& options = {},
                         emulator::Memory memory = {}, VirtualLine* line = nullptr,
                         ConnectOptions client = {})
      : VirtualClient(std::make_shared<VirtualBoard>(options, std::move(memory)), line,
                      std::move(client)) {}
  explicit VirtualClient(std::shared_ptr<VirtualBoard> board, VirtualLine* line = nullptr,
                         ConnectOptions client = {})
      : board_(std::move(board)),
        line_(line != nullptr ? *line : perfect_line_),
        port_(board_->emulator.connect(true, board_->now).value()),
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
    std::optional<R> result;
    TaskMachine& machine = start(std::move(task), [&](R one) { result = std::move(one); });
    while (true) {
      at_each_step(machine);
      const Instant next = proceed();
      if (result) return *std::move(result);
      if (next == Instant::never) throw std::runtime_error("nothing will ever happen");
      if (next > now()) board_->now = later(now() + microseconds(1), next);
    }
  }
  template <class R>
  R run(Task<R> task) {
    return run(std::move(task), [](TaskMachine&) {});
  }

  /// Starts a task beside others; proceed() runs them.
  template <class R, class Done>
  TaskMachine& start(Task<R> task, Done done) {
    const auto own = std::make_shared<Task<R>>(std::move(task));
    TaskMachine& machine = own->begin(identity_);
    machine.set_number(calls_->order().begin());
    machine.set_repeating_line(line_.may_repeat() || client_.duplicate_window.count() != 0);
    const auto running = std::make_shared<Running>();
    running->machine = &machine;
    running->finish = [own, done = std::move(done)] { done(std::move(*own).result()); };
    running->notices = delivery_.on_notice([&machine](const Notice& one) { machine.notice(one); });
    running->strays = delivery_.on_frame([&machine](const BoardFrame& one) {
      if (!one.belongs_to_call) machine.overheard(one.frame.id);
    });
    running_.push_back(running);
    return machine;
  }

  /// Runs what can run now, and exchanges bytes; returns when to call it again, which is now if
  /// there is more to do.
  Instant proceed() {
    Instant next = Instant::never;
    const auto tasks = running_;  // a task that ends may start another one
    for (const auto& running : tasks) next = earlier(next, step(*running));
    const auto is_over = [](const auto& one) { return one->is_over; };
    std::erase_if(running_, is_over);
    next = earlier(next, exchange_bytes());
    return std::exchange(has_news_, false) ? now() : next;
  }

  /// Lets time pass, in which tasks run.
  void pass(Duration time) {
    for (const Instant end = now() + time; now() < end;) {
      const Instant next = earlier(proceed(), end);
      if (next > now()) board_->now = next;
    }
  }

  /// Holds a speed until its owner is silent for half a second.
  std::shared_ptr<detail::HeldSpeed> held_speed() {
    return std::make_shared<detail::HeldSpeed>(
        detail::DeadMansSwitch(milliseconds(500), milliseconds(100)),
        detail::HeldSpeed::Order{
            .begin = [this] { return calls_->order().begin(); },
            .is_superseded =
                [this](TaskNumber one) { return calls_->order().is_superseded(one); }});
  }
  Instant now() const noexcept { return board_->now; }
  emulator::Gimbal& gimbal() { return emulator().board().gimbal(); }
  emulator::Emulator& emulator() { return board_->emulator; }
  /// Cuts the line from the host to the board.
  void cut_the_line() { is_cut_ = true; }
  std::size_t pending() const { return calls_->size(); }
  detail::Delivery& delivery() { return delivery_; }
  const BoardIdentity& identity() const { return identity_; }

 private:
  using Way = VirtualLine::Way;
  using Bytes = VirtualLine::Bytes;

  struct Running {
    TaskMachine* machine{};
    std::function<void()> finish{};
    detail::Delivery::Registration notices{};
    detail::Delivery::Registration strays{};
    TaskNumber joined{};
    bool is_over = false;
  };

  static Task<Result<msg::BoardInfo>> introduction() {
    // The board is starting.
    co_return co_await tasks::call(msg::BoardInfoRequest{}, {.retries = 2});
  }

  /// Runs a task until it waits or ends; returns until when it waits.
  Instant step(Running& running) {
    TaskMachine& task = *running.machine;
    while (true) {
      TaskStep step = task.step(now());
      switch (step.kind) {
        case TaskStep::Kind::done:
          calls_->order().leave(running.joined);
          running.is_over = true;
          running.finish();
          has_news_ = true;
          return Instant::never;
        case TaskStep::Kind::call: begin(running, std::move(step)); break;
        case TaskStep::Kind::cancel: cancel(step.call); break;
        case TaskStep::Kind::wait: return step.until;
      }
    }
  }

  void begin(Running& running, TaskStep step) {
    TaskMachine& task = *running.machine;
    const CallId id = step.call;
    if (!step.request) return task.replied(id, std::move(step.request).error());
    if (step.request->is_motion && running.joined != task.number()) {
      calls_->order().leave(running.joined);
      running.joined = task.number();
      calls_->order().join(running.joined, [&task, this](TaskNumber by) {
        has_news_ = true;
        task.supersede(by);
      });
    }
    step.options.on_confirmation = [&task, this, id](unsigned) {
      has_news_ = true;
      task.confirmed(id);
    };
    step.options.on_series = [&task, this, id](const Frame& frame) {
      has_news_ = true;
      task.received(id, {frame.body.begin(), frame.body.end()});
    };
    const detail::CallPointer call =
        detail::make_call(id, *std::move(step.request), step.options, client_, now(),
                          [&task, this, id](Result<Reply> reply) {
                            has_news_ = true;
                            task.replied(id, std::move(reply));
                          });
    call->task = task.number();
    if (auto refusal = calls_.begin(call)) return task.replied(id, *std::move(refusal));
  }

  void cancel(CallId id) {
    if (const auto call = calls_->take(id)) dialogue_.forget(*call);
  }

  /// Transfers bytes in both directions; returns when to call it again.
  Instant exchange_bytes() {
    const Output output = dialogue_.advance(now(), true);
    if (!output.bytes.empty()) {
      if (!is_cut_) line_.send(Way::to_board, output.bytes, now());
      dialogue_.written(now());
      has_news_ = true;
    }
    const Bytes requests = line_.receive(Way::to_board, now());
    if (!requests.empty()) emulator().from_host(port_, requests, now());
    emulator().advance(now());
    const auto sent = emulator().to_host(port_);
    if (!sent.empty()) {
      line_.send(Way::to_host, sent, now());
      emulator().take(port_, sent.size(), now());
    }
    const Bytes answers = line_.receive(Way::to_host, now());
    if (!answers.empty()) {
      dialogue_.feed(answers, now());
      has_news_ = true;
    }
    return earlier(output.deadline, earlier(emulator().next(), line_.next()));
  }

  std::shared_ptr<VirtualBoard> board_;
  bool is_cut_ = false;
  bool has_news_ = false;
  VirtualLine perfect_line_{};
  VirtualLine& line_;
  std::size_t port_;
  ConnectOptions client_;
  BoardIdentity identity_{};
  detail::SharedCalls calls_{std::size_t{64}};
  detail::Delivery delivery_{};
  detail::Dialogue dialogue_{client_, calls_, delivery_};
  std::vector<std::shared_ptr<Running>> running_{};
};

}  // namespace sbgc::test
