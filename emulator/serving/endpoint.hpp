/// Where hosts reach a board.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>

#include <asio/any_io_executor.hpp>

#include "serving/live_board.hpp"

namespace sbgc::serving {

/// Destroying it closes it; not while the executor runs. The functions that open one throw
/// std::runtime_error with a sentence for people.
class Endpoint {
 public:
  Endpoint() = default;
  Endpoint(const Endpoint&) = delete;
  Endpoint& operator=(const Endpoint&) = delete;
  virtual ~Endpoint() = default;

  /// What a host connects to, as the library takes it: "tcp:127.0.0.1:5000", "/dev/pts/7"; for
  /// people there may be more: "/dev/pts/7 (also /tmp/gimbal)".
  virtual std::string address() const = 0;
};

/// What happens to hosts, for people.
using Log = std::function<void(const std::string&)>;

struct EndpointLogs {
  Log event{};    ///< hosts come and go, datagrams are lost
  Log warning{};  ///< what is not as it should be
};

/// Host and port to listen on.
struct ListenAddress {
  std::string host = "127.0.0.1";
  std::uint16_t port = 0;  ///< 0: any that is free
};

/// A pseudo-terminal; with `link`, a symbolic link to it while it exists. `has_rate`: bytes are
/// garbled while the host has set another baud rate than the board.
std::unique_ptr<Endpoint> open_terminal(const asio::any_io_executor& executor, LiveBoard& board,
                                        const std::string& link, bool has_rate,
                                        const EndpointLogs& logs);

/// Listens for hosts; those beyond the number of `places`, or for whom the board has no port, are
/// refused.
std::unique_ptr<Endpoint> listen_tcp(const asio::any_io_executor& executor, LiveBoard& board,
                                     const ListenAddress& address, std::size_t places,
                                     const EndpointLogs& logs);

/// Each sender of datagrams is a host, as long as it keeps its place: see DatagramHosts.
std::unique_ptr<Endpoint> listen_udp(const asio::any_io_executor& executor, LiveBoard& board,
                                     const ListenAddress& address, std::size_t places,
                                     const EndpointLogs& logs);

/// Standard input and output, bytes as they are. `on_end`: the input has ended, and whatever came
/// of it has been written; or it can not go on.
std::unique_ptr<Endpoint> use_stdio(const asio::any_io_executor& executor, LiveBoard& board,
                                    std::function<void(std::error_code)> on_end);

}  // namespace sbgc::serving
