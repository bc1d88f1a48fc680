// A TCP port as an endpoint.

#include <algorithm>
#include <chrono>
#include <utility>
#include <vector>

#include <asio/steady_timer.hpp>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <sys/socket.h>

#include <sbgc/io/internal/stream_transport.hpp>

#include "hosts/fewer_reports.hpp"
#include "hosts/host.hpp"
#include "hosts/listen.hpp"
#include "hosts/without_http.hpp"

namespace sbgc::hosts {

namespace {

using asio::ip::tcp;

/// The pause after a failed accept, for example because of too many open files.
constexpr auto wait_after_failure = std::chrono::milliseconds(200);

/// Enables keep-alive, so that a silent host whose computer or network has failed does not keep its
/// port. With data in transit, the system gives up later, after its retransmissions. Errors are
/// ignored: a host is accepted without keep-alive, too.
void enable_keep_alive(tcp::socket& socket) {
  constexpr int quiet_seconds = 10;
  constexpr int seconds_between = 5;
  constexpr int times = 4;
  std::error_code ignored;
  socket.set_option(tcp::socket::keep_alive(true), ignored);
  const auto set = [&](int option, int value) {
    ::setsockopt(socket.native_handle(), IPPROTO_TCP, option, &value, sizeof value);
  };
  set(TCP_KEEPIDLE, quiet_seconds);
  set(TCP_KEEPINTVL, seconds_between);
  set(TCP_KEEPCNT, times);
}

class Connection final : public io::detail::StreamTransport<tcp::socket> {
 public:
  explicit Connection(tcp::socket socket)
      : StreamTransport(std::move(socket), [](std::error_code error) { return error; }) {}

  std::string description() const override { return "TCP connection"; }
};

class TcpEndpoint final : public Endpoint {
 public:
  TcpEndpoint(const asio::any_io_executor& executor, HostPorts& board, const ListenAddress& listen,
              std::size_t places, EndpointLogs logs)
      : board_(board),
        acceptor_(executor),
        timer_(executor),
        logs_(std::move(logs)),
        refused_(with_fewer_reports(logs_.warning)),
        places_(places) {
    const tcp::endpoint endpoint(address_of(listen), listen.port);
    bind_to(acceptor_, endpoint, "tcp", logs_);
    acceptor_.listen();
    accept();
  }

  TcpEndpoint(const TcpEndpoint&) = delete;
  TcpEndpoint& operator=(const TcpEndpoint&) = delete;
  ~TcpEndpoint() override {
    for (const auto& host : hosts_) host->close();
  }

  std::string address() const override { return "tcp:" + place_of(acceptor_.local_endpoint()); }

 private:
  void accept() {
    acceptor_.async_accept([this](std::error_code error, tcp::socket socket) {
      if (error == asio::error::operation_aborted) return;
      if (!error) {
        welcome(std::move(socket));
        return accept();
      }
      logs_.warning(address() + ": " + error.message());
      timer_.expires_after(wait_after_failure);
      timer_.async_wait([this](std::error_code aborted) {
        if (!aborted) accept();
      });
    });
  }

  void welcome(tcp::socket socket) {
    std::error_code error;
    const tcp::endpoint peer = socket.remote_endpoint(error);
    if (error) return;  // already closed
    socket.set_option(tcp::no_delay(true), error);
    enable_keep_alive(socket);
    const std::string name = "tcp:" + place_of(peer);
    std::shared_ptr<Host> host;
    if (hosts_.size() < places_) {
      host = Host::connect(board_, without_http(std::make_unique<Connection>(std::move(socket))));
    }
    if (host == nullptr) {
      return refused_(
          fmt::format("{} refused: all {} places for TCP are in use", name, hosts_.size()));
    }
    host->on_end = [this, name, leaving = host.get()](std::error_code end) {
      std::erase_if(hosts_, [&](const auto& one) { return one.get() == leaving; });
      if (is_http_request(end)) {
        return refused_(name + " refused: it sent an HTTP request, as a web page does");
      }
      logs_.event(name + " has left");
    };
    hosts_.push_back(host);
    logs_.event(fmt::format("{} is host {}", name, host->port()));
    host->start();
  }

  HostPorts& board_;
  tcp::acceptor acceptor_;
  asio::steady_timer timer_;
  EndpointLogs logs_;
  Log refused_;
  std::size_t places_;
  std::vector<std::shared_ptr<Host>> hosts_{};
};

}  // namespace

std::unique_ptr<Endpoint> listen_tcp(const asio::any_io_executor& executor, HostPorts& board,
                                     const ListenAddress& address, std::size_t places,
                                     const EndpointLogs& logs) {
  return std::make_unique<TcpEndpoint>(executor, board, address, places, logs);
}

}  // namespace sbgc::hosts
