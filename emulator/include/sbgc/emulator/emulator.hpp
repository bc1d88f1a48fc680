/// A board behind its lines: an emulated gimbal as a host sees it.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include <sbgc/emulator/board.hpp>
#include <sbgc/emulator/line.hpp>

namespace sbgc::emulator {

struct EmulatorOptions {
  BoardOptions board{};
  LineOptions line{};  ///< of each port; each connection derives its own seed
  /// The line's rate follows the parameter SERIAL_SPEED, from each start on.
  bool rate_from_parameters = false;
  std::optional<Duration> restart_at{};  ///< an unrequested reset, this long after the beginning
};

/// The board behind its lines. Like Board it has no clock, socket or thread: pass what the host
/// sends to from_host(), call advance() at next() or later, and take what to_host() offers.
/// Everything happens at its own time, whenever advance() is called. Times must not decrease. One
/// thread at a time.
class Emulator {
 public:
  /// Limit of the bytes that have arrived at the host and are not taken, give or take what the line
  /// holds. At the limit the board's output waits, samples of its streams are skipped and text
  /// lines are left out.
  static constexpr std::size_t output_limit = 65536;
  /// Limit of the bytes from the host that are on their way to the board or queued there, beyond
  /// its input buffer: see room().
  static constexpr std::size_t input_limit = 4096;

  /// Switches the board on. Times in `options` count from `beginning`, usually the same moment.
  Emulator(const EmulatorOptions& options, Memory memory, Instant now, Instant beginning);
  Emulator(const EmulatorOptions& options, Memory memory, Instant now)
      : Emulator(options, std::move(memory), now, now) {}

  /// Connects a host to a free port; empty if all are taken. A USB port has no rate.
  std::optional<std::size_t> connect(bool is_usb, Instant now);
  /// Disconnects the host. Precondition for all functions that take a port: it is connected.
  void disconnect(std::size_t port, Instant now);
  /// The settings of the host's serial port; empty: always the right ones.
  void set_host_line(std::size_t port, const std::optional<LineSettings>& settings, Instant now);

  /// The host sends nothing more: its streams and text lines end, and once is_quiet() it has
  /// everything it asked for.
  void end_input(std::size_t port, Instant now);

  /// Bytes from the host that are on their way or queued.
  std::size_t queued_bytes(std::size_t port) const;
  /// How many bytes the host should send at most for now; from_host() accepts more.
  std::size_t room(std::size_t port) const;
  void from_host(std::size_t port, std::span<const std::uint8_t> bytes, Instant now);
  /// No request of the host is pending, and all output for it has been taken.
  bool is_quiet(std::size_t port) const;
  void advance(Instant now);
  Instant next() const;
  /// What has arrived at the host; take() removes it. Precondition: size <= to_host(port).size().
  std::span<const std::uint8_t> to_host(std::size_t port) const;
  void take(std::size_t port, std::size_t size, Instant now);

  /// Power off and on.
  void restart(Instant now);

  /// As in Board.
  void memory_saved(std::uint32_t revision, Instant now);
  void memory_not_saved(std::uint32_t revision, Instant now);

  Board& board() { return board_; }
  const Board& board() const { return board_; }
  /// The current settings of the board's end of the line.
  const LineSettings& line() const { return options_.line.board; }
  const LineCounters& counters(std::size_t port, Line::Way way) const;

 private:
  struct Port {
    bool is_usb = false;
    Line to_board;
    Line to_host;
    std::vector<std::uint8_t> arrived{};  // at the host

    bool has_room() const { return arrived.size() + to_host.under_way() < output_limit; }
  };

  Port& at(std::size_t port);
  const Port& at(std::size_t port) const;
  /// Everything that happens at this moment.
  void step(Instant now);
  /// Puts the board's output on the line, as far as there is room.
  void pump(std::size_t number, Port& port, Instant now);
  void follow_rate();
  void follow_restarts();

  EmulatorOptions options_;
  Instant beginning_;
  std::optional<Instant> restart_at_{};
  Board board_;
  std::array<std::optional<Port>, Board::max_ports> ports_{};
  std::uint32_t connections_ = 0;
  std::uint64_t outputs_lost_ = 0;
  std::vector<std::uint8_t> received_{};  // scratch
};

}  // namespace sbgc::emulator
