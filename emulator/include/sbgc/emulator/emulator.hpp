/// A board with its lines: an emulated gimbal as a host sees it.
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

/// Options of a board with its line.
struct EmulatorOptions {
  BoardOptions board{};
  LineOptions line{};  ///< of each port; each connection derives its own seed
  /// From each start of the board, the rate of the line follows the parameter SERIAL_SPEED.
  bool rate_from_parameters = false;
  std::optional<Duration> restart_at{};  ///< an unrequested reset, this long after `beginning`
};

/// A board with its lines. Like Board, it has no clock, socket or thread: pass the host's bytes to
/// from_host(), call advance() at next() or later, and take the bytes of to_host(). Events happen
/// at their exact times, whenever advance() is called. Times must not decrease. Not thread-safe.
class Emulator {
 public:
  /// The largest number of bytes that wait for the host to take them; the line may add a few. At
  /// the limit, the board's output waits, and stream samples and text lines are skipped.
  static constexpr std::size_t output_limit = 65536;
  /// The largest number of bytes from the host that are on the line or queued at the board, in
  /// addition to the board's input buffer; see room().
  static constexpr std::size_t input_limit = 4096;

  /// Powers the board on. Times in `options` count from `beginning`, usually equal to `now`.
  Emulator(const EmulatorOptions& options, Memory memory, Instant now, Instant beginning);
  Emulator(const EmulatorOptions& options, Memory memory, Instant now)
      : Emulator(options, std::move(memory), now, now) {}

  /// Connects a host to a free port. Returns nothing if all are in use. A USB port has no baud
  /// rate.
  std::optional<std::size_t> connect(bool is_usb, Instant now);
  /// Disconnects the host. The port must be connected, as for all functions that take a port.
  void disconnect(std::size_t port, Instant now);
  /// The settings of the host's serial port. Without a value they always match those of the board.
  void set_host_line(std::size_t port, const std::optional<LineSettings>& settings, Instant now);

  /// Reports that the host sends no more bytes: its streams and text lines end. Once is_quiet() is
  /// true, it has received everything it requested.
  void end_input(std::size_t port, Instant now);

  /// The number of bytes from the host that are on the line or queued.
  std::size_t queued_bytes(std::size_t port) const;
  /// Returns the number of bytes that the host should send for now. from_host() accepts more.
  std::size_t room(std::size_t port) const;
  /// Processes bytes from a host.
  void from_host(std::size_t port, std::span<const std::uint8_t> bytes, Instant now);
  /// True if no request of the host is pending and all output for it has been taken.
  bool is_quiet(std::size_t port) const;
  /// Runs line and board up to this time, which must not decrease.
  void advance(Instant now);
  /// The next time at which advance() has something to do.
  Instant next() const;
  /// The bytes that have arrived at the host. take() removes them; precondition: size <=
  /// to_host(port).size().
  std::span<const std::uint8_t> to_host(std::size_t port) const;
  /// Removes bytes that have been passed to the host.
  void take(std::size_t port, std::size_t size, Instant now);

  /// Turns the power off and on.
  void restart(Instant now);

  /// Applies the faults of board and line in these options from now on, and calls Gimbal::change().
  /// All other options keep their values.
  void change(const EmulatorOptions& options, Instant now);

  /// Like Board::memory_saved() and Board::memory_not_saved().
  void memory_saved(std::uint32_t revision, Instant now);
  void memory_not_saved(std::uint32_t revision, Instant now);

  /// Returns the board.
  Board& board() { return board_; }
  const Board& board() const { return board_; }
  /// The current settings of the board's end of the line.
  const LineSettings& line() const { return options_.line.board; }
  /// Returns the counters of one direction of a line.
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
  /// Executes everything that is due at this time.
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
