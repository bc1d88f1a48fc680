/// The places where hosts connect to a board.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>

#include <asio/any_io_executor.hpp>

#include "serving/live_board.hpp"

namespace sbgc::serving {

/// Destroying an endpoint closes it; not while the executor runs. The functions that open one throw
/// std::runtime_error with a sentence for the user.
class Endpoint {
 public:
  Endpoint() = default;
  Endpoint(const Endpoint&) = delete;
  Endpoint& operator=(const Endpoint&) = delete;
  virtual ~Endpoint() = default;

  /// What a host connects to, in the form that the library accepts: "tcp:127.0.0.1:5000",
  /// "/dev/pts/7"; a remark for the user may follow: "/dev/pts/7 (also /tmp/gimbal)".
  virtual std::string address() const = 0;
};

/// Lines for the user.
using Log = std::function<void(const std::string&)>;

struct EndpointLogs {
  Log event{};    ///< hosts come and go, datagrams are lost
  Log warning{};  ///< problems
};

/// Host and port to listen on.
struct ListenAddress {
  std::string host = "127.0.0.1";
  std::uint16_t port = 0;  ///< 0: any free port
};

/// A pseudo-terminal; with `link`, a symbolic link to it while it exists. `has_rate`: bytes are
/// garbled while the host has set another baud rate than the board.
std::unique_ptr<Endpoint> open_terminal(const asio::any_io_executor& executor, LiveBoard& board,
                                        const std::string& link, bool has_rate,
                                        const EndpointLogs& logs);

/// Listens for hosts; refuses those for which there is no place or no port of the board.
std::unique_ptr<Endpoint> listen_tcp(const asio::any_io_executor& executor, LiveBoard& board,
                                     const ListenAddress& address, std::size_t places,
                                     const EndpointLogs& logs);

/// Each sender of datagrams is a host, as long as it keeps its place: see DatagramHosts.
std::unique_ptr<Endpoint> listen_udp(const asio::any_io_executor& executor, LiveBoard& board,
                                     const ListenAddress& address, std::size_t places,
                                     const EndpointLogs& logs);

/// Standard input and output, raw bytes. `on_end`: the input has ended and all output has been
/// written, or an error occurred.
std::unique_ptr<Endpoint> use_stdio(const asio::any_io_executor& executor, LiveBoard& board,
                                    std::function<void(std::error_code)> on_end);

}  // namespace sbgc::serving
