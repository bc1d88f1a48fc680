/// The asynchronous client: talks to a gimbal from an Asio program, with completion tokens.
///
///     sbgc::AsyncClient client(context.get_executor());
///     client.async_connect("/dev/ttyUSB0", [&](sbgc::Result<void> connected) {
///       client.async_call(sbgc::msg::GetAnglesRequest{},
///                         [](sbgc::Result<sbgc::msg::GetAngles> angles) { … });
///
/// or in a coroutine (examples/coroutine.cpp):
///
///     auto connected = co_await client.async_connect("/dev/ttyUSB0", asio::use_awaitable);
///
/// Include the messages you use, such as <sbgc/messages/realtime.hpp>.
#pragma once

#include <memory>
#include <string>
#include <utility>

#include <asio/any_io_executor.hpp>

#include <sbgc/client/async_calls.hpp>
#include <sbgc/client/own_transport.hpp>

namespace sbgc {

/// A connected board, driven by an execution context.
///
/// Destroying the client ends all operations with ErrorCode::cancelled; it waits for a pending open
/// (resolving a host name, connecting over TCP). The execution context must outlive the client, and
/// must run for operations to make progress.
class AsyncClient : public AsyncCalls {
 public:
  explicit AsyncClient(const asio::any_io_executor& executor);

  /// Like Client::connect(). Handler: void(Result<void>). Other operations fail with
  /// ErrorCode::not_connected until it has succeeded, and again after another attempt has started.
  template <class Token>
  auto async_connect(const std::string& address, const ConnectOptions& options, Token&& token) {
    return initiate<Result<void>>(
        token, [&impl = *impl_, address, options](const Completion<Result<void>>& done) {
          return begin_connect(impl, address, options, done);
        });
  }
  template <class Token>
  auto async_connect(const std::string& address, Token&& token) {
    return async_connect(address, ConnectOptions(), std::forward<Token>(token));
  }
  /// Like connect_over().
  template <class Token>
  auto async_connect_over(const TransportFactory& make, const ConnectOptions& options,
                          Token&& token) {
    return initiate<Result<void>>(
        token, [&impl = *impl_, make, options](const Completion<Result<void>>& done) {
          return begin_connect(impl, make, options, done);
        });
  }
  template <class Token>
  auto async_connect_over(const TransportFactory& make, Token&& token) {
    return async_connect_over(make, ConnectOptions(), std::forward<Token>(token));
  }

 private:
  class Impl;

  explicit AsyncClient(const std::shared_ptr<Impl>& impl);

  static detail::Stop begin_connect(Impl& impl, const std::string& address,
                                    const ConnectOptions& options,
                                    const Completion<Result<void>>& done);
  static detail::Stop begin_connect(Impl& impl, const TransportFactory& make,
                                    const ConnectOptions& options,
                                    const Completion<Result<void>>& done);

  std::shared_ptr<Impl> impl_;
};

}  // namespace sbgc
