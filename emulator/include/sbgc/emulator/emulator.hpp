/// A board with its lines: what a host sees of an emulated gimbal.
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
  LineOptions line{};  ///< of each port; connections get seeds of their own from its seed
  /// The line's rate is what the SERIAL_SPEED of the settings says, from each start on.
  bool rate_from_parameters = false;
  std::optional<Duration> restart_at{};  ///< a reset that nobody asked for, since the beginning
};

/// The board behind its lines. Like Board it has no clock, socket or thread: call from_host() with
/// what the host sends, advance() at the time that next() names or later, and take what to_host()
/// offers. Whenever advance() is called, everything happens at its own time. Times must not
/// decrease. One thread at a time.
class Emulator {
 public:
  /// What has arrived at the host and is not taken is limited to so many bytes, give or take what
  /// the line holds: then the board's output waits, samples of its streams are skipped, and
  /// text lines left out.
  static constexpr std::size_t output_limit = 65536;
  /// So many bytes from the host may be on their way to the board or wait there for their turn,
  /// beyond its input buffer: see room().
  static constexpr std::size_t input_limit = 4096;

  /// Switches the board on. `beginning` is where times in `options` are counted from; as a rule the
  /// same moment.
  Emulator(const EmulatorOptions& options, Memory memory, Instant now, Instant beginning);
  Emulator(const EmulatorOptions& options, Memory memory, Instant now)
      : Emulator(options, std::move(memory), now, now) {}

  /// A host connects to a free port; nothing if all are taken. A port that is USB has no rate.
  std::optional<std::size_t> connect(bool is_usb, Instant now);
  /// It leaves. Precondition for all that take a port: it is connected.
  void disconnect(std::size_t port, Instant now);
  /// What the host's serial port is set to; none: whatever is right.
  void set_host_line(std::size_t port, const std::optional<LineSettings>& settings, Instant now);

  /// The host sends nothing any more: its streams and text lines end, so that is_quiet() tells when
  /// it has all that it has asked for.
  void end_input(std::size_t port, Instant now);

  /// Bytes from the host that are on their way, or wait to be carried out.
  std::size_t queued_bytes(std::size_t port) const;
  /// How many bytes the host should send at most for now; from_host() takes more.
  std::size_t room(std::size_t port) const;
  void from_host(std::size_t port, std::span<const std::uint8_t> bytes, Instant now);
  /// Nothing that the host has sent waits to be carried out, and all that is for it has been taken.
  bool is_quiet(std::size_t port) const;
  void advance(Instant now);
  Instant next() const;
  /// What has arrived at the host; take() says how much of it is taken.
  /// Precondition: size <= to_host(port).size().
  std::span<const std::uint8_t> to_host(std::size_t port) const;
  void take(std::size_t port, std::size_t size, Instant now);

  /// Power off and on.
  void restart(Instant now);

  /// As those of the board.
  void memory_saved(std::uint32_t revision, Instant now);
  void memory_not_saved(std::uint32_t revision, Instant now);

  Board& board() { return board_; }
  const Board& board() const { return board_; }
  /// The board's end of the line as it is now.
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
  /// From the board's output onto the line, as far as there is room.
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
