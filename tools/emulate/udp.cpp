// A UDP port as an endpoint.

#include <algorithm>
#include <array>
#include <chrono>
#include <optional>
#include <utility>
#include <vector>

#include <asio/buffer.hpp>
#include <asio/steady_timer.hpp>

#include "listen.hpp"

namespace sbgc::emulate {

namespace {

using asio::ip::udp;

/// Fits into what most networks carry in one piece.
constexpr std::size_t datagram_size = 1400;
/// Nothing tells that a host has left. One that has been quiet for so long may be replaced when the
/// ports are all taken, and is forgotten after the longer time.
constexpr Duration quiet_time = seconds(5);
constexpr Duration idle_time = seconds(60);

struct Peer {
  udp::endpoint endpoint{};
  std::size_t port{};
  Instant heard{};
};

class UdpEndpoint final : public Endpoint {
 public:
  UdpEndpoint(const asio::any_io_executor& executor, LiveBoard& board, const ListenAddress& listen,
              EndpointLogs logs)
      : board_(board), socket_(executor), timer_(executor), logs_(std::move(logs)) {
    bind_to(socket_, udp::endpoint(address_of(listen), listen.port), "udp", logs_);
    socket_.non_blocking(true);
    receive();
    watch();
  }

  UdpEndpoint(const UdpEndpoint&) = delete;
  UdpEndpoint& operator=(const UdpEndpoint&) = delete;
  // NOLINTNEXTLINE(bugprone-exception-escape): only if there is no memory left
  ~UdpEndpoint() override {
    for (const Peer& peer : peers_) board_.disconnect(peer.port);
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
    Peer* const peer = peer_of(from_);
    if (peer == nullptr) return refuse();
    peer->heard = board_.now();
    // Datagrams that come faster than the board's line are lost; one alone has room whatever its
    // size.
    if (bytes.size() <= board_.room(peer->port) || board_.waiting(peer->port) == 0) {
      return board_.receive(peer->port, bytes);
    }
    if (is_time_to_tell(lost_)) {
      logs_.event(fmt::format("{}: a datagram of {} bytes is lost, as earlier ones still wait",
                              name_of(from_), bytes.size()));
    }
  }

  void refuse() {
    if (!is_time_to_tell(refused_)) return;
    logs_.warning(name_of(from_) + " refused: all ports of the board are taken");
  }

  /// One line is enough for all datagrams of some time. `told`: when there was one.
  bool is_time_to_tell(std::optional<Instant>& told) const {
    const Instant now = board_.now();
    if (told && now - *told < quiet_time) return false;
    told = now;
    return true;
  }

  Peer* peer_of(const udp::endpoint& endpoint) {
    const auto known = std::find_if(peers_.begin(), peers_.end(),
                                    [&](const Peer& peer) { return peer.endpoint == endpoint; });
    if (known != peers_.end()) return &*known;
    auto port = connect(endpoint);
    if (!port &&
        forget(std::min_element(peers_.begin(), peers_.end(),
                                [](const Peer& a, const Peer& b) { return a.heard < b.heard; }))) {
      port = connect(endpoint);
    }
    if (!port) return nullptr;
    peers_.push_back({endpoint, *port, board_.now()});
    logs_.event(fmt::format("{} is host {}", name_of(endpoint), *port));
    return &peers_.back();
  }

  std::optional<std::size_t> connect(const udp::endpoint& endpoint) {
    return board_.connect(false, [this, endpoint] { send(endpoint); });
  }

  /// Whether that one has been quiet, and is forgotten.
  bool forget(std::vector<Peer>::iterator peer, Duration after = quiet_time) {
    if (peer == peers_.end() || board_.now() - peer->heard < after) return false;
    const Peer gone = *peer;
    peers_.erase(peer);
    board_.disconnect(gone.port);
    logs_.event(name_of(gone.endpoint) + " has left");
    return true;
  }

  void watch() {
    timer_.expires_after(std::chrono::seconds(1));
    timer_.async_wait([this](std::error_code error) {
      if (error) return;
      while (forget(
          std::find_if(peers_.begin(), peers_.end(),
                       [&](const Peer& peer) { return board_.now() - peer.heard >= idle_time; }),
          idle_time)) {
      }
      watch();
    });
  }

  void send(const udp::endpoint& endpoint) {
    const auto peer = std::find_if(peers_.begin(), peers_.end(),
                                   [&](const Peer& one) { return one.endpoint == endpoint; });
    if (peer == peers_.end()) return;
    const std::size_t port = peer->port;
    for (auto waiting = board_.output(port); !waiting.empty(); waiting = board_.output(port)) {
      const std::size_t size = std::min(waiting.size(), datagram_size);
      std::error_code lost;  // as datagrams are
      socket_.send_to(asio::buffer(waiting.data(), size), endpoint, 0, lost);
      board_.take(port, size);
    }
  }

  static std::string name_of(const udp::endpoint& endpoint) { return "udp:" + place_of(endpoint); }

  LiveBoard& board_;
  udp::socket socket_;
  asio::steady_timer timer_;
  EndpointLogs logs_;
  std::vector<Peer> peers_{};
  std::array<std::uint8_t, 65536> input_{};
  udp::endpoint from_{};
  std::optional<Instant> refused_{};  ///< when a host was last told of as refused
  std::optional<Instant> lost_{};     ///< when a datagram was last told of as lost
};

}  // namespace

std::unique_ptr<Endpoint> listen_udp(const asio::any_io_executor& executor, LiveBoard& board,
                                     const ListenAddress& address, const EndpointLogs& logs) {
  return std::make_unique<UdpEndpoint>(executor, board, address, logs);
}

}  // namespace sbgc::emulate
