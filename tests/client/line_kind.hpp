/// The kind of line between client and board, which is the same in all tests of a program.
#pragma once

#include <functional>
#include <memory>
#include <string>

#include <asio/any_io_executor.hpp>

#include <sbgc/client/own_transport.hpp>
#include <sbgc/io/transport.hpp>

namespace sbgc::test {

enum class LineKind : std::uint8_t { memory, terminal, tcp };

/// What the environment variable SBGC_TEST_LINE says: "memory", which is the default, "pty" or
/// "tcp". Throws std::runtime_error if it says anything else.
LineKind line_kind();

/// Opens an address. Throws std::runtime_error if that fails.
TransportFactory over(std::string address);

/// Listens on a port of this machine that is free, on the executor, and hands over who connects
/// first. Returns the address.
std::string accept_once(const asio::any_io_executor& executor,
                        std::function<void(std::unique_ptr<io::Transport>)> serve);

}  // namespace sbgc::test
