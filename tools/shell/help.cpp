// sbgc help: the help of a command, and of the options of a gimbal.

#include <memory>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <sbgc/internal/suggestions.hpp>

#include "command/command_line.hpp"
#include "command/subcommand.hpp"
#include "command/terminal_text.hpp"
#include "command/wording.hpp"

namespace sbgc::tools {

namespace {

constexpr const char* connection_topic = "connection";

std::string help_of_connection() {
  CLI::App page(
      "How commands find and talk to their gimbal. The options may stand before or after the "
      "command.");
  page.set_help_flag();
  GimbalOptions options;
  add_gimbal_options(page, options);
  page.footer(
      "Without -p and -g, sbgc asks all serial ports, or only USB adapters if there are any. If "
      "several gimbals answer, it lists them.\n"
      "\n"
      "The configuration file, ~/.config/sbgc/config.toml or $SBGC_CONFIG, names gimbals for "
      "--gimbal:\n"
      "  [gimbal.front]\n"
      "  port = \"/dev/ttyUSB0\"\n"
      "  attempts = 5\n"
      "  attempt-time = 0.5\n"
      "\n"
      "SBGC_PORTS names a file that replaces the list of ports, in the format of `sbgc ports "
      "--format json`.");
  page.formatter(std::make_shared<HelpFormatter>(line_width(), true));
  return page.help();
}

struct HelpOptions {
  std::vector<std::string> words{};
};

int print_help(const CLI::App& app, const HelpOptions& options) {
  if (options.words == std::vector<std::string>{connection_topic}) {
    fmt::print("{}", colored_help(help_of_connection()));
    return success;
  }
  const CLI::App* command = &app;
  for (const std::string& word : options.words) {
    const CLI::App* const nested = find_subcommand(*command, word);
    if (nested == nullptr) {
      std::vector<std::string> names{connection_topic};
      for (const CLI::App* const one : subcommands_of(*command)) names.push_back(one->get_name());
      throw CommandError(fmt::format("there is no help for '{}'{}", clipped(word),
                                     detail::did_you_mean(detail::nearest(word, names))),
                         wrong_usage);
    }
    command = nested;
  }
  // App::help() would print that of `help`, which the command line selected.
  fmt::print("{}", colored_help(command->get_formatter()->make_help(command, full_name(*command),
                                                                    CLI::AppFormatMode::Normal)));
  return success;
}

}  // namespace

void add_help(CLI::App& app, CommandContext& context) {
  const Subcommand<HelpOptions> command(app, context, "help",
                                        "Print the help of a command, or of connections");
  auto& options = command.options();
  command
      ->add_option("words", options.words,
                   "The command, or 'connection' for the options of a gimbal; by default sbgc "
                   "itself")
      ->type_name("COMMAND");
  command.examples({"sbgc help connection", "sbgc help params set"});
  command.runs([&app](const HelpOptions& chosen) { return print_help(app, chosen); });
}

}  // namespace sbgc::tools
