/// Connecting over a custom transport.
#pragma once

#include <concepts>
#include <functional>
#include <memory>

#include <asio/any_io_executor.hpp>

#include <sbgc/client/client.hpp>
#include <sbgc/client/options.hpp>
#include <sbgc/client/result.hpp>
#include <sbgc/io/transport.hpp>

namespace sbgc {

/// Creates a transport whose executor is `executor`.
using TransportFactory =
    std::function<std::unique_ptr<io::Transport>(const asio::any_io_executor& executor)>;

/// Like Client::connect(), but over the transport that `make` returns, such as a custom Transport
/// or one end of an in-memory pair. If the transport has a LineControl, the line settings are
/// detected unless options.detect_line is false. Errors: those of Client::connect().
Result<Client> connect_over(const TransportFactory& make, const ConnectOptions& options = {});

namespace detail {
Result<Client> keep_connected_over(const TransportFactory& make, const ReconnectOptions& options);
}

/// The same, but reconnects over another transport whenever the connection breaks. `make` is called
/// for each attempt, on a thread of the client, and may return null if no transport is available.
/// Errors: those of Client::connect().
template <std::same_as<ReconnectOptions> Options>
Result<Client> connect_over(const TransportFactory& make, const Options& options) {
  return detail::keep_connected_over(make, options);
}

/// Use connect_over(). Errors: those of Client::connect(). Removed with the next release.
[[deprecated("use connect_over() with ReconnectOptions")]] inline Result<Client> reconnecting_over(
    const TransportFactory& make, const ReconnectOptions& options = {}) {
  return connect_over(make, options);
}

}  // namespace sbgc
