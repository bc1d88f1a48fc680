/// An emulated gimbal controller: the other end of the line.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>

#include <sbgc/emulator/board_options.hpp>
#include <sbgc/emulator/memory.hpp>
#include <sbgc/frame.hpp>
#include <sbgc/time.hpp>

namespace sbgc::emulator {

/// What has come of a frame from the host.
enum class Outcome : std::uint8_t {
  carried_out,
  refused,       ///< CMD_ERROR, or no confirmation where that means it
  unknown,       ///< no command, or none that this board and firmware know
  malformed,     ///< a body of a size that the command does not have
  lost,          ///< the input buffer had no room
  not_listening  ///< the board was starting, or in its bootloader
};

struct BoardCounters {
  std::uint64_t requests{};  ///< frames from hosts
  std::uint64_t refused{};
  std::uint64_t unknown{};  ///< and malformed ones
  std::uint64_t lost{};     ///< by a full input buffer
  std::uint64_t sent{};     ///< frames to hosts
  std::uint64_t skipped{};  ///< samples of streams for which there was no room
  std::uint64_t restarts{};
  std::uint64_t outputs_lost{};  ///< restarts that lost what waited to be sent
};

/// The board. It answers every command of the protocol, with a simulated gimbal behind it.
///
/// It has no clock, line or thread: call receive() with what the host sends, advance() at the time
/// that next() names or earlier, and take what output() offers. Everything happens at its own time
/// whether advance() is called often or rarely. Times must not decrease. One thread at a time.
class Board {
 public:
  /// Serial interfaces that one board has.
  static constexpr std::size_t max_ports = 8;

  /// Switches the board on.
  Board(const BoardOptions& options, Memory memory, Instant now);
  Board(const Board&) = delete;
  Board(Board&& other) noexcept;
  Board& operator=(const Board&) = delete;
  Board& operator=(Board&& other) noexcept;
  ~Board();

  /// A host connects to a free interface; nothing if all are taken.
  std::optional<std::size_t> open_port(bool is_usb = false);
  /// It leaves; its data streams and what waits for it are forgotten. Precondition for all with a
  /// port: it is open.
  void close_port(std::size_t port);
  /// It sends nothing any more, but takes what it has asked for: only its data streams end.
  void end_input(std::size_t port);

  void receive(std::size_t port, std::span<const std::uint8_t> bytes, Instant now);
  void advance(Instant now);
  /// When advance() has something to do, Instant::never if only after receive().
  Instant next() const;

  /// What waits to be sent to that host, up to what waits for memory_saved().
  std::span<const std::uint8_t> output(std::size_t port) const;
  /// The first `size` bytes of it have been sent. Precondition: size <= output(port).size().
  void sent(std::size_t port, std::size_t size, Instant now);

  /// Bytes of requests of that host that wait for their turn.
  std::size_t queued_bytes(std::size_t port) const;
  /// Nothing that the host has sent waits to be carried out, not even a frame that has only begun,
  /// and nothing waits to be sent to it.
  bool is_quiet(std::size_t port) const;

  /// Power off and on.
  void restart(Instant now);
  /// Says nothing any more and hears nothing, or does again.
  void set_silent(bool is_silent);

  /// What to keep while the power is off. Its `revision` grows with each change.
  const Memory& memory() const;
  /// With BoardOptions::waits_for_saving: the memory as it was at that revision is safe, and hosts
  /// may hear of the changes up to there.
  void memory_saved(std::uint32_t revision, Instant now);
  /// It can not be saved: confirmations of the changes up to there become CMD_ERROR. The changes
  /// stay in the memory, as what is still to be saved.
  void memory_not_saved(std::uint32_t revision, Instant now);
  Gimbal& gimbal();
  const BoardCounters& counters() const;
  const BoardOptions& options() const;
  /// The rate that SERIAL_SPEED has set at the last start.
  std::uint32_t baud_rate() const;

  /// Called for each frame from a host when it has been dealt with, and for each frame to one
  /// (`outcome` empty then).
  struct Traffic {
    Instant at{};
    std::size_t port{};
    Frame frame{};
    std::optional<Outcome> outcome{};
  };
  std::function<void(const Traffic&)> on_traffic{};

 private:
  class Core;
  /// For calls in which there may be traffic to tell of.
  Core& entered();

  std::unique_ptr<Core> core_;
};

}  // namespace sbgc::emulator
