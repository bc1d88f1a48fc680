/// The board's side of network connections.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <type_traits>
#include <utility>

#include <asio/buffer.hpp>
#include <asio/ip/tcp.hpp>
#include <asio/ip/udp.hpp>
#include <asio/write.hpp>

#include <sbgc/io/transport.hpp>

#include "scripted_board.hpp"

namespace sbgc::test {

/// A connected socket, or one that learns its peer from the first datagram.
template <class Socket>
class SocketTransport : public io::Transport {
 public:
  explicit SocketTransport(Socket socket) : socket_(std::move(socket)) {}

  void async_read(std::span<std::uint8_t> into, Handler handler) override {
    const auto buffer = asio::buffer(into.data(), into.size());
    if constexpr (is_datagram) {
      socket_.async_receive_from(buffer, peer_, std::move(handler));
    } else {
      socket_.async_read_some(buffer, std::move(handler));
    }
  }
  void async_write(std::span<const std::uint8_t> bytes, Handler handler) override {
    const auto buffer = asio::buffer(bytes.data(), bytes.size());
    if constexpr (is_datagram) {
      socket_.async_send_to(buffer, peer_, std::move(handler));
    } else {
      asio::async_write(socket_, buffer, std::move(handler));
    }
  }
  void close() override {
    std::error_code ignored;
    socket_.close(ignored);
  }
  asio::any_io_executor executor() override { return socket_.get_executor(); }
  std::string description() const override { return "a socket of the test"; }

 private:
  static constexpr bool is_datagram = std::is_same_v<Socket, asio::ip::udp::socket>;

  Socket socket_;
  typename Socket::protocol_type::endpoint peer_;
};

/// Serves a port of this machine and returns its address.
inline std::string serve_udp(ScriptedBoard& board) {
  asio::ip::udp::socket socket(board.executor(), {asio::ip::address_v4::loopback(), 0});
  const std::uint16_t port = socket.local_endpoint().port();
  board.serve(std::make_unique<SocketTransport<asio::ip::udp::socket>>(std::move(socket)));
  return "udp:127.0.0.1:" + std::to_string(port);
}

}  // namespace sbgc::test
