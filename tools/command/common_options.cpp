#include "command/common_options.hpp"

#include <cstdio>
#include <iostream>
#include <vector>

#include <fmt/format.h>

#include <sbgc/internal/suggestions.hpp>
#include <sbgc/internal/words.hpp>
#include <sbgc/io/open.hpp>

#include "command/background_output.hpp"
#include "command/command_error.hpp"
#include "command/option_values.hpp"
#include "command/remark.hpp"
#include "command/system.hpp"
#include "command/terminal_text.hpp"
#include "command/wording.hpp"

namespace sbgc::tools {

namespace {

std::string address_syntax() {
  std::vector<std::string> result{"/dev/ttyUSB0"};
  for (const io::AddressKind& kind : io::address_kinds) {
    if (kind.leads_to_gimbal) result.emplace_back(kind.syntax);
  }
  return detail::alternatives(result, false);
}

}  // namespace

std::string why_not_empty(const std::string& value) {
  return value.empty() ? "must not be empty, as an unset variable of a shell is" : "";
}

std::string words_of(const GimbalOptions& options) {
  std::string words;
  const auto add = [&](const char* name, const std::string& value) {
    if (!value.empty()) words += std::string(" ") + name + ' ' + quoted_for_shell(value);
  };
  add("-p", options.port);
  add("-g", options.name);
  add("--password-file", options.password_file);
  return words;
}

void add_gimbal_options(CLI::App& command, GimbalOptions& options) {
  const auto add = [&](const char* name, auto& value, const char* type, const std::string& help) {
    return command.add_option(name, value, help)->type_name(type)->group(gimbal_group);
  };
  add("-p,--port", options.port, "ADDRESS",
      "Address of the gimbal: " + address_syntax() +
          ". By default, the only gimbal found on the serial ports")
      ->check(why_not_empty);
  add("-g,--gimbal", options.name, "GIMBAL", "Name of the gimbal in the configuration file")
      ->check(why_not_empty);
  add_duration(command, "--timeout", options.timeout,
               "The longest time to connect (20s), and to wait for a response (as specified for "
               "the command)")
      ->group(gimbal_group);
  add("--attempts", options.attempts, "NUMBER",
      "How often to send a request that may be repeated, if no response arrives (3)")
      ->check(CLI::Range(1, 100).description(""));
  add_duration(command, "--attempt-time", options.attempt_timeout,
               "The shortest time to wait for a response in each attempt; a slow radio link "
               "needs more than the protocol specifies")
      ->group(gimbal_group);
  add("--password-file", options.password_file, "FILE",
      "File of mode 0600 with the password of the port; - asks for it");
  add("--capture", options.capture, "FILE", "Record all traffic in this capture");
  command.add_flag("-v,--verbose", options.verbose, "Print each frame, decoded, to standard error")
      ->group(gimbal_group);
}

void add_arming(CLI::App& command, Arming& arming) {
  command.add_flag("-y,--yes", arming.yes, "Do it without asking");
  command.parse_complete_callback(remark_in_background);
}

void arm(const Arming& arming, const std::string& what_will_happen) {
  remark("{}\n", wrapped(what_will_happen, line_width()));
  if (arming.yes) return;
  if (!is_terminal(stdin) || !is_terminal(stderr)) {
    throw CommandError("not confirmed: there is no terminal to ask on; add --yes");
  }
  if (!agrees("Continue? [y/N] ")) throw CommandError("not confirmed");
}

bool agrees(const std::string& question) {
  remark_as_is(Colors(stderr)(Color::bold, question));
  background_stderr().wait();  // nothing moves yet
  std::string answer;
  std::getline(std::cin, answer);
  return detail::is_same_word(answer, "y") || detail::is_same_word(answer, "yes");
}

}  // namespace sbgc::tools
