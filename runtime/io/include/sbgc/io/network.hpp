/// Transports over a network, such as a serial server or a radio link that uses UDP.
#pragma once

#include <chrono>
#include <cstdint>
#include <string>

#include <asio/any_io_executor.hpp>

#include <sbgc/io/transport.hpp>

namespace sbgc::io {

/// Connects to a host. Blocks for at most `timeout`, including the name lookup. Small writes are
/// sent immediately (TCP_NODELAY).
OpenResult open_tcp(const asio::any_io_executor& executor, const std::string& host,
                    std::uint16_t port,
                    std::chrono::milliseconds timeout = std::chrono::seconds(5));

/// Opens a socket that communicates with one peer. Datagrams are treated as a byte stream: lost
/// ones are missing in it. Opening sends nothing, so an absent peer is noticed only later: as
/// Errc::refused if its machine reports it, else as silence. Blocks during the name lookup.
OpenResult open_udp(const asio::any_io_executor& executor, const std::string& host,
                    std::uint16_t port,
                    std::chrono::milliseconds timeout = std::chrono::seconds(5));

/// Continues on a connected TCP or UDP socket: see adopt().
OpenResult adopt_socket(const asio::any_io_executor& executor, int descriptor);

}  // namespace sbgc::io
