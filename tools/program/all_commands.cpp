// The subcommands for builds with sbgc::io and sbgc::client: all.

#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "command/command_line.hpp"
#include "command/subcommand.hpp"
#include "move/guard.hpp"

namespace sbgc::tools {

namespace {

struct Command {
  const char* name;
  AddCommand* add;
  bool uses_others = false;  ///< runs or describes other commands
};

/// The subcommands by their headings in the help.
struct Heading {
  const char* name;
  std::vector<Command> commands;
};
const std::vector<Heading> headings{
    {"Look",
     {{"ports", add_ports},
      {"info", add_info},
      {"monitor", add_monitor},
      {"stream", add_stream},
      {"plot", add_plot},
      {"describe", add_describe}}},
    {"Parameters", {{"params", add_params}, {"vars", add_vars}}},
    {"Move",
     {{"move", add_move},
      {"speed", add_speed},
      {"jog", add_jog},
      {"stop", add_stop},
      {"motors", add_motors},
      {"menu", add_menu, true},
      {"bode", add_bode}}},
    {"Care",
     {{"doctor", add_doctor},
      {"tune", add_tune},
      {"calibrate", add_calibrate},
      {"eeprom", add_eeprom},
      {"files", add_files},
      {"script", add_script},
      {"module", add_module},
      {"reset", add_reset}}},
    {"Bytes",
     {{"send", add_send},
      {"record", add_record},
      {"replay", add_replay},
      {"decode", add_decode},
      {"encode", add_encode},
      {"emulate", add_emulate}}},
    {"Share", {{"bridge", add_bridge}, {"gateway", add_gateway}}},
    {"Shell",
     {{"shell", add_shell, true},
      {"help", add_help, true},
      {"completion", add_completion, true},
      {"manual", add_manual, true}}},
};

/// Rejects options of a gimbal before a command that does not talk to one.
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

bool stands_alone(std::string_view name) {
  for (const Heading& heading : headings) {
    for (const Command& command : heading.commands) {
      if (command.name == name) return !command.uses_others;
    }
  }
  return false;
}

void add_commands(CLI::App& app, CommandContext& context, std::string_view only) {
  add_gimbal_options(app, context.gimbal);
  for (const auto& [name, commands] : headings) {
    app.group(name);  // the subcommands inherit it
    for (const Command& command : commands) {
      if (only.empty() || command.name == only) command.add(app, context);
    }
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
