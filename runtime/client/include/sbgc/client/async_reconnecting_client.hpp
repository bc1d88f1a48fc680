/// The former name of an asynchronous client that reconnects. Removed with the next release.
#pragma once

#include <string>
#include <utility>

#include <sbgc/client/async_client.hpp>

namespace sbgc {

/// Use AsyncClient::async_connect() with ReconnectOptions.
class [[deprecated(
    "use AsyncClient::async_connect() with ReconnectOptions")]] AsyncReconnectingClient
    : public AsyncClient {
 public:
  using AsyncClient::AsyncClient;

  /// Use AsyncClient::async_connect(). Errors: those of Client::connect(), and `cancelled`.
  template <class Token>
  auto async_connect(const std::string& address, const ReconnectOptions& options, Token&& token) {
    return AsyncClient::async_connect(address, options, std::forward<Token>(token));
  }
  template <class Token>
  auto async_connect(const std::string& address, Token&& token) {
    return async_connect(address, ReconnectOptions(), std::forward<Token>(token));
  }
  /// Use AsyncClient::async_connect_over(). Errors: those of Client::connect(), and `cancelled`.
  template <class Token>
  auto async_connect_over(const TransportFactory& make, const ReconnectOptions& options,
                          Token&& token) {
    return AsyncClient::async_connect_over(make, options, std::forward<Token>(token));
  }
  template <class Token>
  auto async_connect_over(const TransportFactory& make, Token&& token) {
    return async_connect_over(make, ReconnectOptions(), std::forward<Token>(token));
  }
};

}  // namespace sbgc
