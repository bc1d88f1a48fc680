// The subcommands for builds without sbgc::io: those that need no gimbal.

#include <string_view>

#include "command/subcommand.hpp"

namespace sbgc::tools {

std::string front_page(const CLI::App& app) { return app.help(); }

bool stands_alone(std::string_view) { return false; }

void add_commands(CLI::App& app, CommandContext& context, std::string_view) {
  app.group("Look");  // the heading in the help
  add_describe(app, context);
  app.group("Bytes");
  add_decode(app, context);
  add_encode(app, context);
  app.footer(
      "This program was built without the commands that talk to a gimbal.\n"
      "\n"
      "The exit status is 0 for success, 1 for a failure, and 2 for wrong usage. With NO_COLOR, "
      "output has no colors. COLUMNS is the width of the help.");
}

std::optional<int> run_helper(int, char**) { return std::nullopt; }

}  // namespace sbgc::tools
