/// The confirmation of commands that move a camera or write to a board.
#pragma once

#include <string>

#include <CLI/CLI.hpp>

namespace sbgc::tools {

struct Arming {
  bool yes = false;  ///< --yes
};

/// Adds --yes to a command. Its remarks wait for no reader.
void add_arming(CLI::App& command, Arming& arming);

/// Says what will happen, in sentences, and asks the user unless --yes was given. Throws
/// CommandError if the user does not agree, or cannot be asked because there is no terminal. What
/// can fail without the user's consent is done before.
void arm(const Arming& arming, const std::string& what_will_happen);

/// Asks the user, who is at a terminal. Anything but a yes is a no.
bool agrees(const std::string& question);

}  // namespace sbgc::tools
