/// From an address to a board that has introduced itself.
#pragma once

#include <chrono>
#include <functional>
#include <memory>
#include <string>

#include <asio/any_io_executor.hpp>

#include <sbgc/client/client.hpp>
#include <sbgc/client/conversation.hpp>
#include <sbgc/client/own_transport.hpp>

namespace sbgc::detail {

/// How a client comes by its transport; it may block no longer than `timeout`.
struct Opener {
  std::function<io::OpenResult(const asio::any_io_executor& executor,
                               std::chrono::milliseconds timeout)>
      open;
  bool find_line = false;  ///< if the transport has one
};

Opener opener_of(const std::string& address, const ConnectOptions& options);
Opener opener_of(const TransportFactory& make, const ConnectOptions& options);

/// Hands out a conversation as soon as there is one, before anything can block: who has it can
/// close it, which ends connect().
using OnBegun = std::function<void(const Conversation&)>;

/// Opens the line and gets to know the board. Blocks, no longer than options.timeout; some other
/// thread must run the executor meanwhile.
Result<Conversation> connect(const asio::any_io_executor& executor, const Opener& opener,
                             const ConnectOptions& options, const OnBegun& on_begun = {});

/// Makes clients of conversations, and gets at these again.
struct ClientMaker {
  static const Conversation& conversation(const Client& client) { return client.conversation_; }

  /// `keeper` lives as long as the client.
  static Client make(std::shared_ptr<const void> keeper, Conversation conversation) {
    return {std::move(keeper), std::move(conversation)};
  }
};

}  // namespace sbgc::detail
