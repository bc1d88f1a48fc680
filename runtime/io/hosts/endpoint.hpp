/// The places where hosts connect to a board.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>

#include <asio/any_io_executor.hpp>

#include "hosts/host_ports.hpp"

namespace sbgc::hosts {

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

/// Receives lines for the user.
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
