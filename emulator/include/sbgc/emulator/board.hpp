/// An emulated gimbal controller.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <span>

#include <sbgc/emulator/board_options.hpp>
#include <sbgc/emulator/memory.hpp>
#include <sbgc/frame.hpp>
#include <sbgc/time.hpp>

namespace sbgc::emulator {

/// The reaction of the board to a frame from a host.
enum class Reaction : std::uint8_t {
  executed,
  refused,        ///< answered with CMD_ERROR, or unconfirmed where that signals a refusal
  unknown,        ///< not a command that this board and firmware know
  malformed,      ///< a body of a size that the command does not allow
  lost,           ///< dropped, because the input buffer was full
  not_listening,  ///< dropped, because the board was starting or in its bootloader
  locked          ///< ignored, because the port requires the password first
};

/// Counters of what a board has received and sent.
struct BoardCounters {
  std::uint64_t requests{};  ///< frames from hosts
  std::uint64_t refused{};   ///< requests that the board answered with an error
  std::uint64_t unknown{};   ///< includes malformed ones
  std::uint64_t lost{};      ///< the input buffer was full
  std::uint64_t sent{};      ///< frames to hosts
  std::uint64_t skipped{};   ///< stream samples skipped because the output buffer was full
  std::uint64_t restarts{};
  std::uint64_t outputs_lost{};  ///< restarts that dropped pending output
};

/// The board. It answers every command of the protocol and drives a simulated gimbal.
///
/// With BoardOptions::password, each port ignores everything and sends nothing until a request for
/// the introduction has the password. It is locked again when its host leaves or the board
/// restarts.
///
/// It has no clock, line or thread: pass received bytes to receive(), call advance() no later than
/// next(), and send the bytes of output(). Events happen at their exact times, however often
/// advance() is called. Times must not decrease. Not thread-safe.
class Board {
 public:
  /// The number of serial interfaces of a board.
  static constexpr std::size_t max_ports = 8;

  /// Powers the board on.
  Board(const BoardOptions& options, Memory memory, Instant now);
  Board(const Board&) = delete;
  Board(Board&& other) noexcept;
  Board& operator=(const Board&) = delete;
  /// Takes over the board, with its hosts.
  Board& operator=(Board&& other) noexcept;
  ~Board();

  /// Connects a host to a free interface. Returns nothing if all are in use.
  std::optional<std::size_t> open_port(bool is_usb = false);
  /// Disconnects the host and drops its data streams and pending output. The port must be open, as
  /// for all functions that take a port.
  void close_port(std::size_t port);
  /// Reports that the host sends no more requests but still receives: only its streams end.
  void end_input(std::size_t port);

  /// Processes bytes from a host.
  void receive(std::size_t port, std::span<const std::uint8_t> bytes, Instant now);
  /// Runs the board up to this time, which must not decrease.
  void advance(Instant now);
  /// The next time at which advance() has something to do; Instant::never if that depends on
  /// receive().
  Instant next() const;

  /// The bytes to send to this host, up to the first that must wait for memory_saved().
  std::span<const std::uint8_t> output(std::size_t port) const;
  /// Reports that the first `size` bytes of the output have been sent. Precondition: size <=
  /// output(port).size().
  void sent(std::size_t port, std::size_t size, Instant now);

  /// The size of this host's queued requests in bytes.
  std::size_t queued_bytes(std::size_t port) const;
  /// True if no request of the host is queued, not even a partial frame, and no output is pending.
  bool is_quiet(std::size_t port) const;

  /// Turns the power off and on.
  void restart(Instant now);
  /// Applies other faults, and Gimbal::change(), from now on.
  void change(const BoardFaults& faults, const Gimbal::Options& gimbal, Instant now);
  /// While silent, the board neither receives nor sends.
  void set_silent(bool is_silent);

  /// The data that survive a power cycle. Its `revision` grows with each change.
  const Memory& memory() const;
  /// Reports that the memory is saved up to this revision, so hosts may learn of its changes. Only
  /// for BoardOptions::waits_for_saving.
  void memory_saved(std::uint32_t revision, Instant now);
  /// Reports that saving this revision failed: confirmations of changes up to it become CMD_ERROR.
  /// The changes stay in memory and still need saving.
  void memory_not_saved(std::uint32_t revision, Instant now);
  /// The firmware that hosts have loaded into modules; empty for an incomplete one.
  const std::map<msg::ModuleId, std::vector<std::uint8_t>>& module_firmware() const;
  /// Returns the gimbal that the board drives.
  Gimbal& gimbal();
  /// Returns the counters since the board was made.
  const BoardCounters& counters() const;
  /// Returns the options that it was made with.
  const BoardOptions& options() const;
  /// The baud rate that SERIAL_SPEED selected at the last start.
  std::uint32_t baud_rate() const;

  /// Called for each frame from a host after it was handled, and for each frame to a host, without
  /// `reaction`.
  struct Traffic {
    Instant at{};
    std::size_t port{};
    Frame frame{};
    std::optional<Reaction> reaction{};
  };
  /// Called with each frame in both directions, unless empty.
  std::function<void(const Traffic&)> on_traffic{};

 private:
  class Core;
  /// Must be used for calls that may report traffic.
  Core& entered();

  std::unique_ptr<Core> core_;
};

}  // namespace sbgc::emulator
