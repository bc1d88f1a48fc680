// A UDP port as an endpoint.

#include <algorithm>
#include <array>
#include <chrono>
#include <optional>
#include <utility>

#include <asio/buffer.hpp>
#include <asio/post.hpp>
#include <asio/steady_timer.hpp>

#include "hosts/datagram_hosts.hpp"
#include "hosts/listen.hpp"

namespace sbgc::hosts {

namespace {

using asio::ip::udp;

/// Most networks transport this size without fragmentation.
constexpr std::size_t datagram_size = 1400;
/// The interval of log lines about lost and refused datagrams.
constexpr Duration log_interval = seconds(5);

class UdpEndpoint final : public Endpoint {
 public:
  UdpEndpoint(const asio::any_io_executor& executor, HostPorts& board, const ListenAddress& listen,
              std::size_t places, EndpointLogs logs)
      : board_(board), socket_(executor), timer_(executor), logs_(std::move(logs)), hosts_(places) {
    bind_to(socket_, udp::endpoint(address_of(listen), listen.port), "udp", logs_);
    socket_.non_blocking(true);
    receive();
    watch();
  }

  UdpEndpoint(const UdpEndpoint&) = delete;
  UdpEndpoint& operator=(const UdpEndpoint&) = delete;
  ~UdpEndpoint() override {
    for (const auto& host : hosts_.all()) board_.disconnect(host.port);
  }

  std::string address() const override { return "udp:" + place_of(socket_.local_endpoint()); }

 private:
  void receive() {
    socket_.async_receive_from(asio::buffer(input_), from_,
                               [this](std::error_code error, std::size_t size) {
                                 if (error == asio::error::operation_aborted) return;
                                 if (!error && size > 0) take({input_.data(), size});
                                 receive();
                               });
  }

  void take(std::span<const std::uint8_t> bytes) {
    const bool is_new = hosts_.find(from_) == nullptr;
    const auto* const host = host_of(from_);
    if (host == nullptr) return refuse();
    const std::size_t port = host->port;
    // Datagrams that arrive faster than the board's line transfers them are lost; a single one
    // always fits.
    if (bytes.size() <= board_.room(port) || board_.queued_bytes(port) == 0) {
      board_.receive(port, bytes);
      // A host that is refused immediately must not fill the log.
      const bool stays = is_new && !board_.must_leave(port);
      if (stays) logs_.event(fmt::format("{} is host {}", name_of(from_), port));
      return;
    }
    if (is_time_to_log(lost_)) {
      logs_.event(
          fmt::format("{}: lost a datagram of {} bytes, because earlier ones are still waiting",
                      name_of(from_), bytes.size()));
    }
  }

  void refuse() {
    if (!is_time_to_log(refused_)) return;
    logs_.warning(fmt::format("{} refused: all {} places for UDP are in use", name_of(from_),
                              hosts_.places()));
  }

  /// True if another line may be written. `logged` is the time of the last one.
  bool is_time_to_log(std::optional<Instant>& logged) const {
    const Instant now = board_.now();
    if (logged && now - *logged < log_interval) return false;
    logged = now;
    return true;
  }

  const DatagramHosts::Host* host_of(const udp::endpoint& endpoint) {
    const Instant now = board_.now();
    if (const auto* const known = hosts_.find(endpoint)) {
      hosts_.hear(endpoint, now);
      return known;
    }
    if (hosts_.is_full()) {
      const auto gone = hosts_.make_room(endpoint, now);
      if (!gone) return nullptr;
      leave(*gone);
    }
    const auto port = board_.connect(false, [this, endpoint] { send(endpoint); });
    if (!port) return nullptr;
    return &hosts_.add(endpoint, *port, now);
  }

  void leave(const DatagramHosts::Host& host) {
    board_.disconnect(host.port);
    logs_.event(name_of(host.endpoint) + " has left");
  }

  void watch() {
    timer_.expires_after(std::chrono::seconds(1));
    timer_.async_wait([this](std::error_code error) {
      if (error) return;
      while (const auto gone = hosts_.forget(board_.now())) leave(*gone);
      watch();
    });
  }

  void send(const udp::endpoint& endpoint) {
    const auto* const host = hosts_.find(endpoint);
    if (host == nullptr) return;
    const std::size_t port = host->port;
    for (auto waiting = board_.output(port); !waiting.empty(); waiting = board_.output(port)) {
      const std::size_t size = std::min(waiting.size(), datagram_size);
      std::error_code lost;  // ignored, like a lost datagram
      socket_.send_to(asio::buffer(waiting.data(), size), endpoint, 0, lost);
      hosts_.answer(endpoint, board_.now());
      board_.take(port, size);
    }
    if (!board_.must_leave(port)) return;
    // Deferred, because this may be a call from the board.
    asio::post(socket_.get_executor(), [this, endpoint] {
      const auto* const leaving = hosts_.find(endpoint);
      if (leaving == nullptr || !board_.must_leave(leaving->port)) return;
      board_.disconnect(hosts_.remove(leaving->port)->port);
    });
  }

  static std::string name_of(const udp::endpoint& endpoint) { return "udp:" + place_of(endpoint); }

  HostPorts& board_;
  udp::socket socket_;
  asio::steady_timer timer_;
  EndpointLogs logs_;
  DatagramHosts hosts_;
  std::array<std::uint8_t, 65536> input_{};
  udp::endpoint from_{};
  std::optional<Instant> refused_{};  ///< last log of a refused host
  std::optional<Instant> lost_{};     ///< last log of a lost datagram
};

}  // namespace

std::unique_ptr<Endpoint> listen_udp(const asio::any_io_executor& executor, HostPorts& board,
                                     const ListenAddress& address, std::size_t places,
                                     const EndpointLogs& logs) {
  return std::make_unique<UdpEndpoint>(executor, board, address, places, logs);
}

}  // namespace sbgc::hosts
