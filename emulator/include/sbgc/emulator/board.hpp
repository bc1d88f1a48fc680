/// An emulated gimbal controller.
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

/// What became of a frame from a host.
enum class Outcome : std::uint8_t {
  carried_out,
  refused,       ///< answered with CMD_ERROR, or not confirmed where that means it
  unknown,       ///< not a command that this board and firmware know
  malformed,     ///< a body of a size that the command does not have
  lost,          ///< the input buffer had no room
  not_listening  ///< the board was starting, or in its bootloader
};

struct BoardCounters {
  std::uint64_t requests{};  ///< frames from hosts
  std::uint64_t refused{};
  std::uint64_t unknown{};  ///< and malformed ones
  std::uint64_t lost{};     ///< because the input buffer was full
  std::uint64_t sent{};     ///< frames to hosts
  std::uint64_t skipped{};  ///< samples of streams for which there was no room
  std::uint64_t restarts{};
  std::uint64_t outputs_lost{};  ///< restarts that dropped pending output
};

/// The board. It answers every command of the protocol and drives a simulated gimbal.
///
/// It has no clock, line or thread: pass received bytes to receive(), call advance() no later than
/// next(), and send what output() returns. Everything happens at its own time, however often
/// advance() is called. Times must not decrease. One thread at a time.
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

  /// Connects a host to a free interface; empty if all are taken.
  std::optional<std::size_t> open_port(bool is_usb = false);
  /// Disconnects the host and drops its data streams and pending output. Precondition for all
  /// functions that take a port: it is open.
  void close_port(std::size_t port);
  /// The host sends nothing more but still receives its responses: only its data streams end.
  void end_input(std::size_t port);

  void receive(std::size_t port, std::span<const std::uint8_t> bytes, Instant now);
  void advance(Instant now);
  /// When advance() next has something to do; Instant::never if only receive() can change that.
  Instant next() const;

  /// Bytes to send to that host, up to the first that must wait for memory_saved().
  std::span<const std::uint8_t> output(std::size_t port) const;
  /// The first `size` bytes of the output have been sent. Precondition: size <=
  /// output(port).size().
  void sent(std::size_t port, std::size_t size, Instant now);

  /// Size of the queued requests of that host, in bytes.
  std::size_t queued_bytes(std::size_t port) const;
  /// No request of the host is queued, not even a partial frame, and no output is pending.
  bool is_quiet(std::size_t port) const;

  /// Power off and on.
  void restart(Instant now);
  /// A silent board neither receives nor sends.
  void set_silent(bool is_silent);

  /// What survives a power cycle. Its `revision` grows with each change.
  const Memory& memory() const;
  /// With BoardOptions::waits_for_saving: the memory as of that revision is saved, and hosts may
  /// learn of the changes up to it.
  void memory_saved(std::uint32_t revision, Instant now);
  /// Saving that revision failed: confirmations of the changes up to it become CMD_ERROR. The
  /// changes stay in the memory, still to be saved.
  void memory_not_saved(std::uint32_t revision, Instant now);
  Gimbal& gimbal();
  const BoardCounters& counters() const;
  const BoardOptions& options() const;
  /// The rate that SERIAL_SPEED set at the last start.
  std::uint32_t baud_rate() const;

  /// Called for each frame from a host once it has been dealt with, and for each frame to a host
  /// (then `outcome` is empty).
  struct Traffic {
    Instant at{};
    std::size_t port{};
    Frame frame{};
    std::optional<Outcome> outcome{};
  };
  std::function<void(const Traffic&)> on_traffic{};

 private:
  class Core;
  /// For calls that may report traffic.
  Core& entered();

  std::unique_ptr<Core> core_;
};

}  // namespace sbgc::emulator
