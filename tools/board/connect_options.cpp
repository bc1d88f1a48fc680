#include "board/connect_options.hpp"

#include "board/configuration.hpp"
#include "board/password.hpp"
#include "command/command_error.hpp"
#include "command/remark.hpp"

namespace sbgc::tools {

GimbalOptions with_configuration(const GimbalOptions& options) {
  if (options.name.empty()) return options;
  if (!options.port.empty()) {
    throw CommandError("--port and --gimbal exclude each other", wrong_usage);
  }
  const NamedGimbal named = find_gimbal(options.name);
  GimbalOptions result = options;
  result.port = named.port;
  if (!result.timeout) result.timeout = named.timeout;
  if (!result.attempts) result.attempts = named.attempts;
  if (result.password_file.empty()) result.password_file = named.password_file;
  if (!result.attempt_timeout) result.attempt_timeout = named.attempt_timeout;
  return result;
}

void warn_of_password_in(const std::string& capture) {
  remark("sbgc: {} will hold the password: keep it private\n",
         capture == "-" ? "the capture" : capture);
}

ConnectOptions connect_options(const GimbalOptions& options) {
  ConnectOptions result;
  if (options.timeout) result.timeout = *options.timeout;
  if (options.attempts) result.retries = *options.attempts - 1;
  if (options.attempt_timeout) result.attempt_timeout = *options.attempt_timeout;
  if (!options.password_file.empty()) {
    // Otherwise every device on this machine would get it.
    if (options.port.empty()) {
      throw CommandError("--password-file needs --port or --gimbal", wrong_usage);
    }
    const std::string whose = options.name.empty() ? options.port : "gimbal " + options.name;
    result.password = read_password(options.password_file, whose);
    if (!options.capture.empty()) warn_of_password_in(options.capture);
  }
  result.capture = options.capture;
  result.on_capture_error = [has_lost_capture =
                                 options.has_lost_capture](const ClientError& error) {
    *has_lost_capture = true;
    remark("sbgc: {}\n", error.message);
  };
  return result;
}

CallOptions call_options(const GimbalOptions& options) {
  CallOptions result;
  if (options.timeout) result.timeout = *options.timeout;
  return result;
}

}  // namespace sbgc::tools
