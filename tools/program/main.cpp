// The sbgc command: see `sbgc --help`.

#include <cstdio>
#include <exception>
#include <memory>
#include <optional>
#include <sstream>
#include <string>
#include <string_view>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <sbgc/text.hpp>
#include <sbgc/version.hpp>

#include "command/command_line.hpp"
#include "command/remark.hpp"
#include "command/subcommand.hpp"
#include "command/system.hpp"
#include "command/terminal_text.hpp"
#include "command/wording.hpp"

namespace sbgc::tools {

namespace {

/// Returns the version of the library and the command, the protocol, and the fingerprint of its
/// model.
std::string version_text() {
  return fmt::format(
      "sbgc {}\n"
      "protocol: {}, revision {} ({}) and firmware up to {}\n"
      "model: {:016x}",
      SBGC_VERSION_TEXT, protocol_name, protocol_revision, protocol_date,
      to_string(msg::FirmwareVersion(newest_firmware)), model_fingerprint);
}

/// Runs the command line. With `only`, there is no other command, and errors or requests for help
/// return no status: their text needs all commands.
std::optional<int> run(int argc, char** argv, std::string_view only) {
  CommandContext context;
  CLI::App app("Tools for SimpleBGC gimbals and their serial protocol.", "sbgc");
  app.formatter(std::make_shared<HelpFormatter>(line_width()));
  app.require_subcommand(1);
  app.allow_windows_style_options(false);  // "/name" is a file
  app.set_help_all_flag("--help-all", "Print the help of all commands");
  app.set_version_flag("--version", version_text,
                       "Print the version, the protocol and the fingerprint of its model");
  add_commands(app, context, only);
  if (argc == 1) {
    fmt::print("{}", colored_help(front_page(app)));
    return success;
  }
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& asked_for) {  // help or version
    if (!only.empty()) return std::nullopt;
    if (!app.remaining().empty()) return report_usage_error(app, asked_for);
    std::ostringstream text;
    app.exit(asked_for, text, text);
    fmt::print("{}", colored_help(text.str()));
  } catch (const CLI::ParseError& error) {
    if (!only.empty()) return std::nullopt;
    return report_usage_error(app, error);
  }
  // The user requested all traffic.
  const bool is_complete = !*context.gimbal.is_incomplete;
  return context.status != success || is_complete ? context.status : failure;
}

int run(int argc, char** argv) {
  // For a short command, the options of all commands would take four fifths of the time.
  if (argc > 1 && stands_alone(argv[1])) {
    if (const auto status = run(argc, argv, argv[1])) return *status;
  }
  return *run(argc, argv, {});
}

}  // namespace

}  // namespace sbgc::tools

int main(int argc, char** argv) {
  namespace tools = sbgc::tools;
  if (const auto status = tools::run_helper(argc, argv)) return *status;
  tools::prepare_standard_files();
  int status = tools::failure;
  try {
    status = tools::run(argc, argv);
  } catch (const tools::CommandError& error) {
    tools::remark_failure(tools::as_message(error.what()));
    status = error.status();
  } catch (const std::exception& error) {
    // A failed write to the standard output is reported below.
    if (std::ferror(stdout) == 0) tools::remark_failure(error.what());
  }
  // An earlier failed write sets the error flag even if there is nothing left to flush.
  if (std::fflush(stdout) == 0 && std::ferror(stdout) == 0) return status;
  tools::remark_failure("cannot write to the standard output");
  return status == tools::success ? tools::failure : status;
}
