/// An emulated board in real time, or in the virtual time of its executor.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>

#include <asio/any_io_executor.hpp>

#include <sbgc/emulator/emulator.hpp>
#include <sbgc/io/internal/timer.hpp>

#include "hosts/endpoint.hpp"

namespace sbgc::serving {

/// Drives the emulator with the clock of the executor. All calls must come from the thread of the
/// executor.
class LiveBoard : public hosts::HostPorts {
 public:
  /// The board's own time is 0 when it has finished starting; times in `options` count from there.
  LiveBoard(const asio::any_io_executor& executor, const emulator::EmulatorOptions& options,
            emulator::Memory memory);

  std::optional<std::size_t> connect(bool is_usb, std::function<void()> wake) override;
  void disconnect(std::size_t port) override;
  void end_input(std::size_t port) override;
  void set_host_rate(std::size_t port, std::uint32_t rate) override;

  std::size_t queued_bytes(std::size_t port) const override { return emulator_.queued_bytes(port); }
  std::size_t room(std::size_t port) const override { return emulator_.room(port); }
  bool is_quiet(std::size_t port) const override { return emulator_.is_quiet(port); }
  void receive(std::size_t port, std::span<const std::uint8_t> bytes) override;
  std::span<const std::uint8_t> output(std::size_t port) const override {
    return emulator_.to_host(port);
  }
  void take(std::size_t port, std::size_t size) override;

  /// Reports that changes of the memory up to this revision are saved, or could not be saved.
  void memory_saved(std::uint32_t revision);
  void memory_not_saved(std::uint32_t revision);

  const emulator::Memory& memory() const { return emulator_.board().memory(); }
  emulator::Emulator& emulator() { return emulator_; }
  Instant now() const override;
  /// Advances the time of this board immediately. For tests.
  void skip(Duration time);

  /// Called when the memory of the board has changed.
  std::function<void()> on_memory_changed{};
  /// Called when the board has no more work for now.
  std::function<void()> after_traffic{};

 private:
  /// Called after every event: notifies the hosts and sets the timer.
  void settle();
  /// Does the same from the timer, for callers that do not allow callbacks.
  void settle_soon();
  void set_timer();

  io::detail::Timer timer_;
  Instant beginning_;
  emulator::Emulator emulator_;
  std::array<std::function<void()>, emulator::Board::max_ports> wakes_{};
  Instant timer_at_ = Instant::never;
  std::uint32_t revision_;
  bool is_settling_ = false;
  bool is_unsettled_ = false;  // hosts have not been notified of the last event
};

}  // namespace sbgc::serving
