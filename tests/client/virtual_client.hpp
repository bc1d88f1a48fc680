/// A client in virtual time: task, conversation and emulated board in one thread, without I/O.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <stdexcept>
#include <utility>
#include <vector>

#include <sbgc/client/passive_client.hpp>
#include <sbgc/emulator/emulator.hpp>
#include <sbgc/messages.hpp>

#include "passive_state.hpp"
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

/// A board without noise, of this firmware.
inline emulator::EmulatorOptions calm_board(int firmware = 2590) {
  emulator::EmulatorOptions options;
  options.board.gimbal.noise = 0;
  options.board.firmware = msg::FirmwareVersion(static_cast<std::uint16_t>(firmware));
  return options;
}

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
                         const ConnectOptions& client = {})
      : VirtualClient(std::make_shared<VirtualBoard>(options, std::move(memory)), line, client) {}
  explicit VirtualClient(std::shared_ptr<VirtualBoard> board, VirtualLine* line = nullptr,
                         const ConnectOptions& client = {})
      : board_(std::move(board)),
        line_(line != nullptr ? *line : perfect_line_),
        port_(board_->emulator.connect(true, board_->now).value()),
        client_(client, line_.may_repeat()) {
    const Result<msg::BoardInfo> info = run(introduction());
    if (!info) throw std::runtime_error(info.error().message);
    client_.set_identity({*info});
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
    return client_.start(std::move(task), std::move(done));
  }

  /// Runs what can run now, and exchanges bytes; returns when to call it again, which is now if
  /// there is more to do.
  Instant proceed() {
    const auto requests = client_.advance(now());
    if (!requests.empty()) {
      if (!is_cut_) line_.send(Way::to_board, requests, now());
      client_.written(now());
    }
    exchange_bytes();
    return earlier(client_.deadline(), earlier(emulator().next(), line_.next()));
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
            .begin = [this] { return client_.state().order().begin(); },
            .is_superseded =
                [this](TaskNumber one) { return client_.state().order().is_superseded(one); }});
  }
  Instant now() const noexcept { return board_->now; }
  emulator::Gimbal& gimbal() { return emulator().board().gimbal(); }
  emulator::Emulator& emulator() { return board_->emulator; }
  /// Cuts the line from the host to the board.
  void cut_the_line() { is_cut_ = true; }
  std::size_t pending() const { return client_.state().pending(); }
  detail::Delivery& delivery() { return client_.state().delivery(); }
  const BoardIdentity& identity() const { return client_.identity(); }
  PassiveClient& client() noexcept { return client_; }

 private:
  using Way = VirtualLine::Way;
  using Bytes = VirtualLine::Bytes;

  static Task<Result<msg::BoardInfo>> introduction() {
    // The board is starting.
    co_return co_await tasks::call(msg::BoardInfoRequest{}, {.retries = 2});
  }

  /// Transfers bytes to the board, and from it.
  void exchange_bytes() {
    const Bytes requests = line_.receive(Way::to_board, now());
    if (!requests.empty()) emulator().from_host(port_, requests, now());
    emulator().advance(now());
    const auto sent = emulator().to_host(port_);
    if (!sent.empty()) {
      line_.send(Way::to_host, sent, now());
      emulator().take(port_, sent.size(), now());
    }
    client_.receive(line_.receive(Way::to_host, now()), now());
  }

  std::shared_ptr<VirtualBoard> board_;
  bool is_cut_ = false;
  VirtualLine perfect_line_{};
  VirtualLine& line_;
  std::size_t port_;
  PassiveClient client_;
};

}  // namespace sbgc::test
