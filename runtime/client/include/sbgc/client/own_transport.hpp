/// Connecting over a line of one's own.
#pragma once

#include <functional>
#include <memory>

#include <asio/any_io_executor.hpp>

#include <sbgc/client/client.hpp>
#include <sbgc/client/options.hpp>
#include <sbgc/client/result.hpp>
#include <sbgc/io/transport.hpp>

namespace sbgc {

/// Makes a transport whose executor is the given one.
using TransportFactory =
    std::function<std::unique_ptr<io::Transport>(const asio::any_io_executor& executor)>;

/// As Client::connect(), over what `make` returns: an own Transport, an end of a pair in memory. If
/// that has a LineControl, its settings are searched for, unless options.find_line is false.
Result<Client> connect_over(const TransportFactory& make, const ConnectOptions& options = {});

}  // namespace sbgc
