#include "serving/live_board.hpp"

#include <utility>

namespace sbgc::serving {

namespace {

/// The minimum interval of the timer: events within it are handled together, each at its own time.
/// A tenth of the time that a request and its response take at 115200 baud.
constexpr Duration granularity = microseconds(250);

/// The line begins at 0; silences and text lines count from there.
constexpr Instant line_beginning{};

}  // namespace

LiveBoard::LiveBoard(const asio::any_io_executor& executor,
                     const emulator::EmulatorOptions& options, emulator::Memory memory)
    : timer_(executor),
      beginning_(timer_.now()),
      emulator_(options, std::move(memory), line_beginning - options.board.start_time,
                line_beginning),
      revision_(emulator_.board().memory().revision) {
  settle();
}

Instant LiveBoard::now() const { return line_beginning + (timer_.now() - beginning_); }

void LiveBoard::skip(Duration time) {
  beginning_ = beginning_ - time;
  timer_at_ = Instant::never;  // it would fire too late
  emulator_.advance(now());
  settle();
}

std::optional<std::size_t> LiveBoard::connect(bool is_usb, std::function<void()> wake) {
  const auto port = emulator_.connect(is_usb, now());
  if (port) wakes_[*port] = std::move(wake);
  settle_soon();
  return port;
}

void LiveBoard::disconnect(std::size_t port) {
  emulator_.disconnect(port, now());
  wakes_[port] = nullptr;
  settle();
}

void LiveBoard::end_input(std::size_t port) {
  emulator_.end_input(port, now());
  settle_soon();
}

void LiveBoard::set_host_rate(std::size_t port, std::uint32_t rate) {
  // A pseudo-terminal has no parity, so it always matches.
  emulator_.set_host_line(port, LineSettings{rate, emulator_.line().parity}, now());
  settle_soon();
}

void LiveBoard::receive(std::size_t port, std::span<const std::uint8_t> bytes) {
  emulator_.from_host(port, bytes, now());
  settle();
}

void LiveBoard::take(std::size_t port, std::size_t size) {
  emulator_.take(port, size, now());
  settle();
}

void LiveBoard::memory_saved(std::uint32_t revision) {
  emulator_.memory_saved(revision, now());
  settle();
}

void LiveBoard::memory_not_saved(std::uint32_t revision) {
  emulator_.memory_not_saved(revision, now());
  settle();
}

void LiveBoard::settle() {
  is_unsettled_ = true;
  if (is_settling_) return;  // the loop below handles it
  is_settling_ = true;
  // Each call takes time, and may create new output for hosts notified before.
  while (std::exchange(is_unsettled_, false)) {
    for (const auto& wake : wakes_) {
      if (wake) wake();
    }
  }
  is_settling_ = false;
  if (after_traffic) after_traffic();
  if (std::exchange(revision_, memory().revision) != memory().revision && on_memory_changed) {
    on_memory_changed();
  }
  set_timer();
}

void LiveBoard::settle_soon() {
  is_unsettled_ = true;
  if (!is_settling_) set_timer();
}

void LiveBoard::set_timer() {
  const Instant next = is_unsettled_ ? now() : emulator_.next();
  if (next == Instant::never) {
    timer_at_ = next;
    timer_.cancel();
    return;
  }
  const Instant at = later(next, now() + granularity);
  if (timer_at_ <= at) return;  // it fires soon enough
  timer_at_ = at;
  timer_.start(beginning_ + (at - line_beginning), [this] {
    timer_at_ = Instant::never;
    emulator_.advance(now());
    settle();
  });
}

}  // namespace sbgc::serving
