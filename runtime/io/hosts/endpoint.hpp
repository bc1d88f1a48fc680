/// Endpoints where hosts connect, and the ports behind them: those of an emulated board, or of a
/// bridge to a real one.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>

#include <asio/any_io_executor.hpp>

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
  /// Keeps the host's port, however silent the host is.
  virtual void keep_place(std::size_t) {}
  virtual void disconnect(std::size_t port) = 0;
  /// Reports that the host sends no more, but still receives.
  virtual void end_input(std::size_t port) = 0;
  /// Reports that the baud rate of the host's side has changed; 0 if it has none.
  virtual void set_host_rate(std::size_t port, std::uint32_t rate) = 0;

  /// Returns the number of bytes from the host that wait for execution.
  virtual std::size_t queued_bytes(std::size_t port) const = 0;
  /// Returns the number of bytes that the host may send now.
  virtual std::size_t room(std::size_t port) const = 0;
  /// True if no more output is expected for this host, apart from unsolicited messages.
  virtual bool is_quiet(std::size_t port) const = 0;
  /// True if bytes for the host were lost, or another host needs its place: after receiving the
  /// waiting bytes, it must leave.
  virtual bool must_leave(std::size_t) const { return false; }
  virtual void receive(std::size_t port, std::span<const std::uint8_t> bytes) = 0;
  /// Returns the bytes for the host.
  virtual std::span<const std::uint8_t> output(std::size_t port) const = 0;
  /// Removes bytes that the host has received.
  virtual void take(std::size_t port, std::size_t size) = 0;

  /// Returns the time since the beginning.
  virtual Instant now() const = 0;

  /// Wraps the transports of hosts that connect from now on. For tests.
  std::function<std::unique_ptr<io::Transport>(std::unique_ptr<io::Transport>)> between{};
};

/// Its destructor closes the endpoint; it must not run while the executor runs. The functions that
/// open endpoints throw std::runtime_error with a sentence for the user.
class Endpoint {
 public:
  Endpoint() = default;
  Endpoint(const Endpoint&) = delete;
  Endpoint& operator=(const Endpoint&) = delete;
  virtual ~Endpoint() = default;

  /// The address that hosts connect to, in the form that the library accepts, e.g.
  /// "tcp:127.0.0.1:5000" or "/dev/pts/7". A remark may follow: "/dev/pts/7 (also /tmp/gimbal)".
  virtual std::string address() const = 0;
};

/// A callback for log lines for the user.
using Log = std::function<void(const std::string&)>;

struct EndpointLogs {
  Log event{};    ///< hosts connect and leave, datagrams are lost
  Log warning{};  ///< problems
};

/// The host and port to listen on.
struct ListenAddress {
  std::string host = "127.0.0.1";
  std::uint16_t port = 0;  ///< 0 selects any free port
};

/// Opens a pseudo-terminal and, if `link` is not empty, a symbolic link to it while it exists. With
/// `has_rate`, bytes are garbled while the host's baud rate differs from the board's.
std::unique_ptr<Endpoint> open_terminal(const asio::any_io_executor& executor, HostPorts& board,
                                        const std::string& link, bool has_rate,
                                        const EndpointLogs& logs);

/// Listens for hosts; rejects those for which there is no place or no port of the board.
std::unique_ptr<Endpoint> listen_tcp(const asio::any_io_executor& executor, HostPorts& board,
                                     const ListenAddress& address, std::size_t places,
                                     const EndpointLogs& logs);

/// Each sender of datagrams is a host as long as it keeps its place; see DatagramHosts.
std::unique_ptr<Endpoint> listen_udp(const asio::any_io_executor& executor, HostPorts& board,
                                     const ListenAddress& address, std::size_t places,
                                     const EndpointLogs& logs);

/// Serves standard input and output as raw bytes. `on_end` is called on an error, or once the input
/// has ended and all output is written.
std::unique_ptr<Endpoint> use_stdio(const asio::any_io_executor& executor, HostPorts& board,
                                    std::function<void(std::error_code)> on_end);

}  // namespace sbgc::hosts
