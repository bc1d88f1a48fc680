/// An asynchronous client that connects again by itself when the line is lost.
///
///     sbgc::AsyncReconnectingClient client(context.get_executor());
///     client.async_connect("/dev/ttyUSB0", [&](sbgc::Result<void> connected) { … });
///
/// Include the messages you use, such as <sbgc/messages/realtime.hpp>.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <utility>

#include <asio/any_io_executor.hpp>

#include <sbgc/client/async_calls.hpp>
#include <sbgc/client/own_transport.hpp>
#include <sbgc/client/reconnect_options.hpp>

namespace sbgc {

/// Does for an execution context what ReconnectingClient does for threads: the connection is
/// restored after the line was lost, subscriptions and data streams go on, and operations during an
/// outage fail or wait, see ReconnectOptions::calls. A task ends with the connection on which it
/// began.
///
/// A thread of the client opens lines and searches; handlers run on the executor.
/// `context.run()` does not return while the client is connected or searching: call close().
///
/// Destroying the client ends all operations with ErrorCode::cancelled or, if they wait for a
/// connection, with ErrorCode::not_connected; it waits for a pending open (resolving a host name,
/// connecting over TCP). The execution context must outlive the client, and must run for operations
/// to make progress.
class AsyncReconnectingClient : public AsyncCalls {
 public:
  explicit AsyncReconnectingClient(const asio::any_io_executor& executor);

  /// Like ReconnectingClient::connect(): the first connection must succeed. Handler:
  /// void(Result<void>). Subscriptions and streams of an earlier connect end.
  template <class Token>
  auto async_connect(const std::string& address, const ReconnectOptions& options, Token&& token) {
    return begin_connect(address, TransportFactory(), options, token);
  }
  template <class Token>
  auto async_connect(const std::string& address, Token&& token) {
    return async_connect(address, ReconnectOptions(), std::forward<Token>(token));
  }
  /// Like reconnecting_over().
  template <class Token>
  auto async_connect_over(const TransportFactory& make, const ReconnectOptions& options,
                          Token&& token) {
    return begin_connect(std::string(), make, options, token);
  }
  template <class Token>
  auto async_connect_over(const TransportFactory& make, Token&& token) {
    return async_connect_over(make, ReconnectOptions(), std::forward<Token>(token));
  }

  /// Calls `handler` with each change of the state of the connection, on the executor. Returns an
  /// empty subscription before async_connect().
  Subscription on_change(std::function<void(const LinkChange&)> handler);
  /// Like ReconnectingClient::check().
  void check();

  /// `closed` before async_connect().
  LinkState state() const;
  /// How many connections have been made.
  std::uint64_t connections() const;

 private:
  class Impl;
  friend class SpeedControl;

  explicit AsyncReconnectingClient(const std::shared_ptr<Impl>& impl);

  template <class Token>
  auto begin_connect(const std::string& address, const TransportFactory& make,
                     const ReconnectOptions& options, Token& token) {
    return initiate<Result<void>>(
        token, [&impl = *impl_, address, make, options](const Completion<Result<void>>& done) {
          return connect(impl, address, make, options, done);
        });
  }
  static detail::Stop connect(Impl& impl, const std::string& address, const TransportFactory& make,
                              const ReconnectOptions& options,
                              const Completion<Result<void>>& done);
  /// Returns the client of the current connection.
  Result<std::shared_ptr<Client>> connected() const;

  std::shared_ptr<Impl> impl_;
};

}  // namespace sbgc
