/// A board with its lines: what a host sees of an emulated gimbal.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include <sbgc/board/board.hpp>
#include <sbgc/board/line.hpp>

namespace sbgc::board {

struct EmulatorOptions {
  Options board{};
  LineOptions line{};  ///< of each port
  /// The line's rate is what the SERIAL_SPEED of the settings says, from each start on.
  bool rate_of_settings = false;
  std::optional<Duration> restart_at{};  ///< a reset that nobody asked for, since the beginning
};

/// As Board, sans-I/O: the same calls, with the lines between.
class Emulator {
 public:
  Emulator(const EmulatorOptions& options, Memory memory, Instant now);

  std::optional<std::size_t> connect(bool is_usb, Instant now);
  void disconnect(std::size_t port, Instant now);
  /// What the host's serial port is set to, if it has settings.
  void set_host_line(std::size_t port, const LineSettings& settings);

  void from_host(std::size_t port, std::span<const std::uint8_t> bytes, Instant now);
  void advance(Instant now);
  Instant next() const;
  /// What has arrived at the host; take() says how much of it is taken. Untaken bytes are limited:
  /// when they reach 64 KiB the board's output waits.
  std::span<const std::uint8_t> to_host(std::size_t port) const;
  void take(std::size_t port, std::size_t size, Instant now);

  Board& board();
};

}  // namespace sbgc::board
