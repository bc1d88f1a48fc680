#include "command/arming.hpp"

#include <cstdio>
#include <iostream>

#include <fmt/format.h>

#include <sbgc/internal/words.hpp>

#include "command/background_output.hpp"
#include "command/colors.hpp"
#include "command/command_error.hpp"
#include "command/help_text.hpp"
#include "command/remark.hpp"
#include "command/system.hpp"

namespace sbgc::tools {

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
