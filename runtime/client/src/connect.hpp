/// Connecting: from an address to an identified board.
#pragma once

#include <chrono>
#include <functional>
#include <memory>
#include <string>

#include <asio/any_io_executor.hpp>

#include <sbgc/client/conversation.hpp>
#include <sbgc/client/own_transport.hpp>

namespace sbgc::detail {

/// How a client obtains its transport; `open` may block for at most `timeout`.
struct Opener {
  std::function<io::OpenResult(const asio::any_io_executor& executor,
                               std::chrono::milliseconds timeout)>
      open;
  bool detect_line = false;  ///< only if the transport has a LineControl
};

Opener opener_of(const std::string& address, const ConnectOptions& options);
Opener opener_of(const TransportFactory& make, const ConnectOptions& options);

/// Receives the conversation before connect() can block. Closing it ends connect().
using OnStarted = std::function<void(const Conversation&)>;

/// Opens the line and reads the identity of the board. Blocks for at most options.timeout; another
/// thread must run the executor meanwhile.
Result<Conversation> connect(const asio::any_io_executor& executor, const Opener& opener,
                             const ConnectOptions& options, const OnStarted& on_begun = {});

class Connection;

/// Connects with an I/O thread of its own; see connect().
Result<std::shared_ptr<Connection>> connect_with_thread(const Opener& opener,
                                                        const ConnectOptions& options,
                                                        const OnStarted& on_begun = {});

}  // namespace sbgc::detail
