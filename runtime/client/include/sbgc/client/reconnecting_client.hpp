/// The former name of a client that reconnects. Removed with the next release.
#pragma once

#include <string>
#include <utility>

#include <sbgc/client/client.hpp>
#include <sbgc/client/reconnect_options.hpp>

namespace sbgc {

// clang-format mistakes the attribute for a declaration.
// clang-format off
/// Use Client::connect() with ReconnectOptions.
class [[deprecated("use Client::connect() with ReconnectOptions")]] ReconnectingClient
    : public Client {
 public:
  /// Gives a client its former name.
  // NOLINTNEXTLINE(google-explicit-constructor): another name for the same
  ReconnectingClient(Client client) noexcept : Client(std::move(client)) {}

  /// Use Client::connect(). Errors: its errors.
  static Result<ReconnectingClient> connect(const std::string& address,
                                            const ReconnectOptions& options = {}) {
    auto client = Client::connect(address, options);
    if (!client) return std::move(client).error();
    return ReconnectingClient(*std::move(client));
  }
};
// clang-format on

}  // namespace sbgc
