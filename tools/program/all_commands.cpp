// The subcommands where sbgc::io and sbgc::client exist: all.

#include <string>
#include <vector>

#include <fmt/format.h>

#include "command/command_line.hpp"
#include "command/subcommand.hpp"
#include "move/guard.hpp"

namespace sbgc::tools {

namespace {

/// The subcommands by their headings in the help.
struct Heading {
  const char* name;
  std::vector<AddCommand*> commands;
};
const std::vector<Heading> headings{
    {"Look", {add_ports, add_info, add_monitor, add_stream, add_plot, add_describe}},
    {"Parameters", {add_params, add_vars}},
    {"Move", {add_move, add_speed, add_jog, add_stop, add_motors, add_menu, add_bode}},
    {"Care",
     {add_doctor, add_tune, add_calibrate, add_eeprom, add_files, add_script, add_module,
      add_reset}},
    {"Bytes", {add_send, add_record, add_replay, add_decode, add_encode, add_emulate}},
    {"Share", {add_bridge, add_gateway}},
    {"Shell", {add_shell, add_help, add_completion, add_manual}},
};

/// Options of a gimbal before the command are for commands that talk to one.
void require_use_of_gimbal_options(const CLI::App& app) {
  const CLI::App& command = chosen_command(app);
  for (const CLI::Option* const option : app.get_options()) {
    const bool is_of_gimbal = option->get_group() == gimbal_group && option->count() != 0;
    if (is_of_gimbal && command.get_option_no_throw("--port") == nullptr) {
      throw CommandError(fmt::format("{} is not for `{}`, which does not talk to a gimbal",
                                     option->get_name(), full_name(command)),
                         wrong_usage);
    }
  }
}

}  // namespace

#ifdef SBGC_GATEWAY_MISSING
void add_gateway(CLI::App& app, CommandContext& context) {
  const Subcommand<NoOptions> command(app, context, "gateway",
                                      "Not in this sbgc, which was built without it");
  command->allow_extras();
  command->footer("To have it, install from Debian, and build sbgc again: " SBGC_GATEWAY_MISSING
                  ".");
  command.runs([](const NoOptions&) -> int {
    throw CommandError(
        "this sbgc was built without the gateway; to have it, install from Debian, and build sbgc "
        "again: " SBGC_GATEWAY_MISSING);
  });
}
#endif

std::string front_page(const CLI::App& app) {
  std::string text = "To begin with:\n";
  for (const std::string line : {"ports", "info", "monitor", "move --tilt 10down", "doctor"}) {
    const CLI::App* const command = app.get_subcommand(line.substr(0, line.find(' ')));
    text += fmt::format("  sbgc {:<20} {}\n", line, command->get_description());
  }
  text += "\nWithout a gimbal: `sbgc emulate --link ./gimbal &`, then `sbgc -p ./gimbal info`\n";
  text += "\nAll commands:\n";
  for (const auto& [name, _] : headings) {
    std::vector<std::string> names;
    for (const CLI::App* const command : subcommands_of(app)) {
      if (command->get_group() == name) names.push_back(command->get_name());
    }
    text += fmt::format("  {:<11} {}\n", name, fmt::join(names, ", "));
  }
  return text + "\n`sbgc help` describes them; `sbgc help COMMAND` has all options of one.\n";
}

void add_commands(CLI::App& app, CommandContext& context) {
  add_gimbal_options(app, context.gimbal);
  for (const auto& [name, commands] : headings) {
    app.group(name);  // the subcommands inherit it
    for (AddCommand* const add : commands) add(app, context);
  }
  app.footer(
      "`sbgc help COMMAND` and the manual pages have the details; `sbgc help connection` "
      "explains how commands find their gimbal, `sbgc describe` the protocol.\n"
      "\n"
      "A command that moves the camera or writes to the board says what will happen and asks; "
      "--yes agrees in advance. After Ctrl-C or another signal, a stop may take 8 s and a write "
      "60 s. Results go to standard output, everything else to standard error.\n"
      "\n"
      "The exit status is 0 for success; 1 for a failure or a negative answer; 2 for wrong "
      "usage; 3 if the board did not confirm a command, or `params diff` could not compare; 130 "
      "if Ctrl-C or another signal interrupted the command.\n"
      "\n"
      "SBGC_TOKEN is the token of `sbgc bridge --ws`. With NO_COLOR, output has no colors. "
      "COLUMNS is the width of the help.");
  app.parse_complete_callback([&app] { require_use_of_gimbal_options(app); });
}

std::optional<int> run_helper(int argc, char** argv) {
  if (!is_guard(argc, argv)) return std::nullopt;
  return run_guard();
}

}  // namespace sbgc::tools
