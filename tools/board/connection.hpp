/// Connecting to the gimbal that the options name, with or without reconnection.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <utility>

#include <sbgc/client/client.hpp>
#include <sbgc/client/options.hpp>
#include <sbgc/client/request.hpp>
#include <sbgc/io/transport.hpp>

#include "command/command_error.hpp"
#include "command/common_options.hpp"

namespace sbgc::tools {

/// Returns the options with those of the named gimbal in the configuration file filled in. Throws
/// CommandError.
GimbalOptions with_configuration(const GimbalOptions& options);

/// Returns the options of the library, without `wrap`.
ConnectOptions connect_options(const GimbalOptions& options);

/// Warns that a capture contains the password.
void warn_of_password_in(const std::string& capture);

/// Returns the options of a call that has its own timeout.
CallOptions call_options(const GimbalOptions& options);

/// Returns a transport to use in place of the one that was opened.
using Wrap = std::function<std::unique_ptr<io::Transport>(std::unique_ptr<io::Transport>)>;

/// The address and the options of a connection.
struct LineChoice {
  std::string address{};
  ConnectOptions options{};
};

/// Throws CommandError if the address is malformed, which is a usage error.
void require_address(const std::string& address);

/// Returns the address of the options, or of the only gimbal found, and the options of the library,
/// with printing of frames if requested. `wrap` is applied to the transport first. Throws
/// CommandError; if several gimbals are found, the message lists them.
LineChoice choose_line(const GimbalOptions& given, Wrap wrap = {});

/// Connects to the gimbal. Throws CommandError.
Client connect(const GimbalOptions& options, Wrap wrap = {});

/// The variable with which `sbgc shell` passes the line to the gimbal to its commands.
inline constexpr const char* shell_line_variable = "SBGC_SHELL_LINE";
/// Describes the line to the gimbal; `own` describes the line of this command.
std::string line_to_gimbal(const std::string& own);

/// Ends the command with the message of the error, and with the status `interrupted` or
/// `cannot_tell` if that is the cause.
[[noreturn]] void fail(const ClientError& error);

/// Returns the value of a result, or ends the command with its error.
template <class T>
T value_of(Result<T> result) {
  if (!result) fail(result.error());
  return *std::move(result);
}
inline void value_of(const Result<void>& result) {
  if (!result) fail(result.error());
}

/// Throws CommandError if the board lacks the command, or, if `validate`, does not allow a value.
/// Like Client::call(), but sends nothing.
template <Message M>
void require_possible(const Client& client, const M& request, bool validate = true) {
  value_of(detail::prepare(request, client.identity().versions(), validate));
}

inline void require_possible(const Client& client, const AnyMessage& request,
                             bool validate = true) {
  value_of(detail::prepare(request, client.identity().versions(), validate));
}

/// Connects to the gimbal like connect(), but to a client that reconnects by itself. `adjust`
/// changes the options of the library. Throws CommandError.
Client connect_for_long(const GimbalOptions& options,
                        const std::function<void(ConnectOptions&)>& adjust = {});

/// True if the address is that of a capture, which ends but is never lost.
bool is_replay(const GimbalOptions& options);

/// Writes a line to standard error for each change of the connection while the result exists.
Subscription report_changes(Client& client);

}  // namespace sbgc::tools
