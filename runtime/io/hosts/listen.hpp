/// Network addresses to listen on.
#pragma once

#include <stdexcept>
#include <string>

#include <asio/ip/tcp.hpp>
#include <asio/ip/udp.hpp>
#include <fmt/format.h>

#include "hosts/endpoint.hpp"

namespace sbgc::hosts {

/// Returns the address of a numeric host or "localhost"; other names are not resolved.
inline asio::ip::address address_of(const ListenAddress& listen) {
  if (listen.host == "localhost") return asio::ip::address_v4::loopback();
  std::error_code error;
  asio::ip::address result = asio::ip::make_address(listen.host, error);
  if (error) {
    throw std::runtime_error(fmt::format(
        "'{}' is not an address to listen on, such as 127.0.0.1, 0.0.0.0 or [::1]", listen.host));
  }
  return result;
}

/// For example "127.0.0.1:5000" or "[::1]:5000".
template <class AsioEndpoint>
std::string place_of(const AsioEndpoint& endpoint) {
  const std::string host = endpoint.address().to_string();
  const std::string name = endpoint.address().is_v6() ? "[" + host + "]" : host;
  return fmt::format("{}:{}", name, endpoint.port());
}

/// Opens and binds a socket or an acceptor; `protocol` is for messages.
template <class Socket, class AsioEndpoint>
void bind_to(Socket& socket, const AsioEndpoint& endpoint, const char* protocol,
             const EndpointLogs& logs) {
  std::error_code error;
  socket.open(endpoint.protocol(), error);
  if constexpr (requires { socket.listen(); }) {
    if (!error) socket.set_option(asio::socket_base::reuse_address(true), error);
  }
  if (!error) socket.bind(endpoint, error);
  if (error) {
    throw std::runtime_error(
        fmt::format("cannot listen on {}:{}: {}", protocol, place_of(endpoint), error.message()));
  }
  if (!endpoint.address().is_loopback()) {
    logs.warning(fmt::format("{}:{} is open to any other machine", protocol,
                             place_of(socket.local_endpoint())));
  }
}

}  // namespace sbgc::hosts
