/// Gimbals behind a network: a serial server, or a radio link that speaks UDP.
#pragma once

#include <chrono>
#include <cstdint>
#include <string>

#include <asio/any_io_executor.hpp>

#include <sbgc/io/transport.hpp>

namespace sbgc::io {

/// Connects within `timeout`, which includes looking up the name; blocks until then. Small writes
/// go out at once.
OpenResult open_tcp(const asio::any_io_executor& executor, const std::string& host,
                    std::uint16_t port,
                    std::chrono::milliseconds timeout = std::chrono::seconds(5));

/// A socket that talks to one peer only. Datagrams are taken for a stream of bytes: what is lost on
/// the way is missing in it. Nothing is sent to open it, so that a peer that is not there shows
/// later only: as Errc::refused if its machine says so, else as silence. Blocks while the name is
/// looked up.
OpenResult open_udp(const asio::any_io_executor& executor, const std::string& host,
                    std::uint16_t port,
                    std::chrono::milliseconds timeout = std::chrono::seconds(5));

}  // namespace sbgc::io
