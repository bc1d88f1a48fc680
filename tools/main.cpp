// The sbgc command: see `sbgc --help`.

#include <cstdio>
#include <exception>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include "commands.hpp"
#include "help_text.hpp"
#include "suggestions.hpp"
#include "wording.hpp"

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

std::vector<std::string> command_names(const CLI::App& app) {
  std::vector<std::string> result;
  for (const CLI::App* const command : app.get_subcommands({})) {
    result.push_back(command->get_name());
  }
  return result;
}

std::vector<std::string> option_names(const CLI::App& command) {
  std::vector<std::string> result;
  for (const CLI::Option* const option : command.get_options()) {
    for (const std::string& name : option->get_lnames()) result.push_back("--" + name);
  }
  return result;
}

std::string did_you_mean(const std::vector<std::string>& words) {
  return words.empty() ? "" : "; did you mean " + alternatives(words, true) + "?";
}

/// Returns the error message for an unexpected word. `command` is the subcommand that it was passed
/// to, or `app`.
std::string unknown_word(const CLI::App& app, const CLI::App& command, const std::string& word) {
  const std::string shown = clipped(word);
  if (word.starts_with('-')) {
    const std::string name = word.substr(0, word.find('='));
    return fmt::format("unknown option '{}'{}", shown,
                       did_you_mean(nearest(name, option_names(command))));
  }
  if (&command != &app) return fmt::format("unexpected argument '{}'", shown);
  std::vector<std::string> known = command_names(app);
  for (const std::string& option : option_names(app)) known.push_back(option);
  const std::vector<std::string> near = nearest(word, known);
  return fmt::format(
      "unknown command '{}'{}", shown,
      near.empty() ? "; use " + alternatives(command_names(app), false) : did_you_mean(near));
}

int report_usage_error(const CLI::App& app, const CLI::ParseError& error) {
  const std::vector<CLI::App*> chosen = app.get_subcommands();
  const CLI::App& command = chosen.empty() ? app : *chosen.back();
  const std::vector<std::string> unknown = command.remaining();
  std::string problem;
  if (!unknown.empty()) {
    problem = unknown_word(app, command, unknown.front());
  } else if (chosen.empty()) {
    problem = "expected a command: " + alternatives(command_names(app), false);
  } else {
    problem = clipped(error.what());
  }
  fmt::print(stderr, "sbgc: {}\nRun '{}{} --help' for help.\n", problem,
             chosen.empty() ? "" : "sbgc ", command.get_name());
  return wrong_usage;
}

int run(int argc, char** argv) {
  int status = success;
  CLI::App app("Tools for SimpleBGC gimbals and their serial protocol.", "sbgc");
  app.formatter(std::make_shared<HelpFormatter>(line_width()));
  app.require_subcommand(1);
  app.set_help_all_flag("--help-all", "Print the help of all commands");
  app.set_version_flag("--version", "sbgc " SBGC_VERSION, "Print the version");
  add_decode(app, status);
  add_emulate(app, status);
  add_encode(app, status);
  add_ports(app, status);
  add_record(app, status);
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
  return status;
}

}  // namespace
}  // namespace sbgc::tools

int main(int argc, char** argv) {
  namespace tools = sbgc::tools;
  tools::hold_standard_files();
  try {
    const int status = tools::run(argc, argv);
    // An earlier failed write sets the error flag even if there is nothing left to flush.
    if (std::fflush(stdout) == 0 && std::ferror(stdout) == 0) return status;
    std::fputs("sbgc: cannot write to the standard output\n", stderr);
    return status == tools::success ? tools::failure : status;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "sbgc: %s\n", error.what());
    return tools::failure;
  }
}
