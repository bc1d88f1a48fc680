/// Ports to which hosts connect: an emulated board, or a bridge to a real one.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>

#include <sbgc/io/transport.hpp>
#include <sbgc/time.hpp>

namespace sbgc::hosts {

/// Ports that exchange bytes with one host each. All calls must come from the thread of the
/// executor.
class HostPorts {
 public:
  HostPorts() = default;
  HostPorts(const HostPorts&) = delete;
  HostPorts& operator=(const HostPorts&) = delete;
  virtual ~HostPorts() = default;

  /// Returns the port, or nothing if all are in use. Calls `wake`, but never from inside connect(),
  /// when there may be output or room.
  virtual std::optional<std::size_t> connect(bool is_usb, std::function<void()> wake) = 0;
  /// The host keeps its port, however silent it is.
  virtual void keep_place(std::size_t) {}
  virtual void disconnect(std::size_t port) = 0;
  /// The host sends no more, but still receives.
  virtual void end_input(std::size_t port) = 0;
  /// The baud rate of the host's side has changed; 0 if it has none.
  virtual void set_host_rate(std::size_t port, std::uint32_t rate) = 0;

  /// The bytes from the host that wait for execution.
  virtual std::size_t queued_bytes(std::size_t port) const = 0;
  /// How many bytes the host may send now.
  virtual std::size_t room(std::size_t port) const = 0;
  /// True if nothing more is to come for this host, apart from unsolicited messages.
  virtual bool is_quiet(std::size_t port) const = 0;
  /// True if bytes for the host were lost, or another needs its place: it gets the bytes that wait,
  /// then it must leave.
  virtual bool must_leave(std::size_t) const { return false; }
  virtual void receive(std::size_t port, std::span<const std::uint8_t> bytes) = 0;
  /// The bytes for the host.
  virtual std::span<const std::uint8_t> output(std::size_t port) const = 0;
  /// Removes bytes that the host has received.
  virtual void take(std::size_t port, std::size_t size) = 0;

  /// The time since the beginning.
  virtual Instant now() const = 0;

  /// Wraps the transports of hosts that connect from now on. For tests.
  std::function<std::unique_ptr<io::Transport>(std::unique_ptr<io::Transport>)> between{};
};

}  // namespace sbgc::hosts
