// The sbgc command: see `sbgc --help`.

#include <cstdio>
#include <exception>
#include <memory>
#include <sstream>

#include <CLI/CLI.hpp>
#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include "command/commands.hpp"
#include "command/help_text.hpp"
#include "command/remark.hpp"
#include "command/usage.hpp"
#include "command/version_text.hpp"
#include "command/wording.hpp"
#include "motion/guard.hpp"
#include "shell/command_line_facts.hpp"

namespace sbgc::tools {

namespace {

/// Opens closed standard files, so that files opened later do not take their place. Reading the
/// input, or writing the others, still fails.
void hold_standard_files() {
  for (const int fd : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    const bool is_open = fcntl(fd, F_GETFD) != -1;
    // The lowest free number is this one.
    if (!is_open && ::open("/dev/null", fd == STDIN_FILENO ? O_WRONLY : O_RDONLY) == -1) return;
  }
}

void add_commands(CLI::App& app, CommandContext& context) {
  add_ports(app, context);
  add_info(app, context);
  add_monitor(app, context);
  add_stream(app, context);
  add_describe(app, context);
  add_params(app, context);
  add_vars(app, context);
  add_move(app, context);
  add_speed(app, context);
  add_jog(app, context);
  add_stop(app, context);
  add_motors(app, context);
  add_menu(app, context);
  add_calibrate(app, context);
  add_eeprom(app, context);
  add_files(app, context);
  add_script(app, context);
  add_reset(app, context);
  add_send(app, context);
  add_record(app, context);
  add_replay(app, context);
  add_decode(app, context);
  add_encode(app, context);
  add_emulate(app, context);
  add_bridge(app, context);
  add_completion(app, context);
  add_manual(app, context);
}

/// Options of a gimbal before the command are for commands that talk to one.
void require_use_of_gimbal_options(const CLI::App& app) {
  const CLI::App& command = chosen_command(app);
  for (const CLI::Option* const option : app.get_options()) {
    const bool is_of_gimbal = option->get_group() == gimbal_group && option->count() != 0;
    if (is_of_gimbal && find_option(command, "--port") == nullptr) {
      throw CommandError(fmt::format("{} is not for `{}`, which does not talk to a gimbal",
                                     option->get_name(), full_name(command)),
                         wrong_usage);
    }
  }
}

int run(int argc, char** argv) {
  CommandContext context;
  CLI::App app("Tools for SimpleBGC gimbals and their serial protocol.", "sbgc");
  app.formatter(std::make_shared<HelpFormatter>(line_width()));
  app.require_subcommand(1);
  app.set_help_all_flag("--help-all", "Print the help of all commands");
  app.set_version_flag("--version", version_text,
                       "Print the version, the protocol and the fingerprint of its model");
  add_gimbal_options(app, context.gimbal);
  add_commands(app, context);
  app.footer(
      "`sbgc COMMAND --help` and the manual pages have the details; `sbgc describe` explains the "
      "protocol. Options of a gimbal stand before or after the command.\n"
      "\n"
      "A command that moves the camera or writes to the board says what will happen and asks; "
      "--yes agrees beforehand. Results go to standard output, everything else to standard "
      "error.\n"
      "\n"
      "The exit status is 0 for success; 1 for a failure, a missing confirmation, or if what was "
      "asked is not so; 2 for wrong usage; 3 if `params diff` could not compare; 130 if Ctrl-C or "
      "another signal ended the command before it was done.\n"
      "\n"
      "The configuration file, ~/.config/sbgc/config.toml or $SBGC_CONFIG, names gimbals for "
      "--gimbal:\n"
      "  [gimbal.front]\n"
      "  port = \"/dev/ttyUSB0\"\n"
      "  attempts = 5\n"
      "  attempt-time = 0.5\n"
      "\n"
      "SBGC_PORTS names a file with a list of ports, as `sbgc ports --format json` prints it, in "
      "place of those of the system. SBGC_TOKEN is the token of `sbgc bridge --ws`. With NO_COLOR, "
      "output has no colors. COLUMNS is the width of "
      "the help.");
  app.parse_complete_callback([&app] { require_use_of_gimbal_options(app); });
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& asked_for) {  // help or version
    if (!app.remaining().empty()) return report_usage_error(app, asked_for);
    std::ostringstream text;
    app.exit(asked_for, text, text);
    fmt::print("{}", text.str());
  } catch (const CLI::ParseError& error) {
    return report_usage_error(app, error);
  }
  return context.status;
}

}  // namespace
}  // namespace sbgc::tools

int main(int argc, char** argv) {
  namespace tools = sbgc::tools;
  if (tools::is_guard(argc, argv)) return tools::run_guard();
  tools::hold_standard_files();
  int status = tools::failure;
  try {
    status = tools::run(argc, argv);
  } catch (const tools::CommandError& error) {
    tools::remark("sbgc: {}\n", tools::as_message(error.what()));
    status = error.status();
  } catch (const std::exception& error) {
    std::fprintf(stderr, "sbgc: %s\n", error.what());
  }
  // An earlier failed write sets the error flag even if there is nothing left to flush.
  if (std::fflush(stdout) == 0 && std::ferror(stdout) == 0) return status;
  std::fputs("sbgc: cannot write to the standard output\n", stderr);
  return status == tools::success ? tools::failure : status;
}
