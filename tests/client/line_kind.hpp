/// The kind of line between client and board; it is the same in all tests of a program.
#pragma once

#include <functional>
#include <memory>
#include <string>

#include <asio/any_io_executor.hpp>

#include <sbgc/client/own_transport.hpp>
#include <sbgc/io/transport.hpp>

namespace sbgc::test {

enum class LineKind : std::uint8_t { memory, terminal, tcp };

/// Returns the kind given by the environment variable SBGC_TEST_LINE: "memory" (the default), "pty"
/// or "tcp". Throws std::runtime_error for any other value.
LineKind line_kind();

/// Opens an address. Throws std::runtime_error on failure.
TransportFactory over(std::string address);

/// Listens on a free port of this machine, on `executor`, and calls `serve` with the first
/// connection. Returns the address.
std::string accept_once(const asio::any_io_executor& executor,
                        std::function<void(std::unique_ptr<io::Transport>)> serve);

}  // namespace sbgc::test
