#include "board/gimbal_options.hpp"

#include <vector>

#include <sbgc/detail/suggestions.hpp>
#include <sbgc/io/open.hpp>

#include "board/configuration.hpp"
#include "command/command_error.hpp"
#include "command/duration.hpp"
#include "command/remark.hpp"

namespace sbgc::tools {

namespace {

std::string addresses() {
  std::vector<std::string> result{"/dev/ttyUSB0"};
  for (const io::AddressKind& kind : io::address_kinds) {
    if (kind.leads_to_gimbal) result.emplace_back(kind.syntax);
  }
  return detail::alternatives(result, false);
}

}  // namespace

void add_gimbal_options(CLI::App& command, GimbalOptions& options) {
  const auto add = [&](const char* name, auto& value, const char* type, const std::string& help) {
    return command.add_option(name, value, help)->type_name(type)->group(gimbal_group);
  };
  add("-p,--port", options.port, "ADDRESS",
      "Address of the gimbal: " + addresses() +
          ". Without it, the only gimbal found on the serial ports");
  add("-g,--gimbal", options.name, "GIMBAL", "Name of the gimbal in the configuration file");
  add_duration(command, "--timeout", options.timeout,
               "The longest time to connect (20s), and to wait for the response to one request (as "
               "specified for the command)")
      ->group(gimbal_group);
  add("--attempts", options.attempts, "NUMBER",
      "How often a request is sent if no response arrives and it may be repeated (3)")
      ->check(CLI::Range(1, 100).description(""));
  add_duration(command, "--attempt-time", options.attempt_timeout,
               "The least time to wait for the response in each attempt; a slow radio link needs "
               "more than the protocol specifies")
      ->group(gimbal_group);
  add("--capture", options.capture, "FILE", "Record all traffic in this capture");
  command.add_flag("-v,--verbose", options.verbose, "Print each frame, decoded, on standard error")
      ->group(gimbal_group);
}

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
  if (!result.attempt_timeout) result.attempt_timeout = named.attempt_timeout;
  return result;
}

ConnectOptions connect_options(const GimbalOptions& options) {
  ConnectOptions result;
  if (options.timeout) result.timeout = *options.timeout;
  if (options.attempts) result.retries = *options.attempts - 1;
  if (options.attempt_timeout) result.attempt_timeout = *options.attempt_timeout;
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
