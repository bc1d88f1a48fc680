#include "line_kind.hpp"

#include <cstdlib>
#include <stdexcept>
#include <utility>

#include <asio/ip/tcp.hpp>

#include <sbgc/io/open.hpp>

#include "sockets.hpp"

namespace sbgc::test {

LineKind line_kind() {
  static const LineKind kind = [] {
    const char* const given = std::getenv("SBGC_TEST_LINE");  // NOLINT(concurrency-mt-unsafe)
    const std::string name = given == nullptr ? "memory" : given;
    if (name == "memory") return LineKind::memory;
    if (name == "pty") return LineKind::terminal;
    if (name == "tcp") return LineKind::tcp;
    throw std::runtime_error("SBGC_TEST_LINE is memory, pty or tcp, not " + name);
  }();
  return kind;
}

TransportFactory over(std::string address) {
  return [address = std::move(address)](const asio::any_io_executor& executor) {
    io::OpenResult opened = io::open(executor, address);
    if (!opened) throw std::runtime_error(opened.error.message);
    return std::move(opened.transport);
  };
}

std::string accept_once(const asio::any_io_executor& executor,
                        std::function<void(std::unique_ptr<io::Transport>)> serve) {
  using asio::ip::tcp;
  const auto acceptor =
      std::make_shared<tcp::acceptor>(executor, tcp::endpoint(asio::ip::address_v4::loopback(), 0));
  acceptor->async_accept(
      [acceptor, serve = std::move(serve)](std::error_code error, tcp::socket socket) {
        if (!error) serve(std::make_unique<SocketTransport<tcp::socket>>(std::move(socket)));
      });
  return "tcp:127.0.0.1:" + std::to_string(acceptor->local_endpoint().port());
}

}  // namespace sbgc::test
