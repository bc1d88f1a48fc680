// sbgc manual: the manual pages, from the same source as the help.

#include <filesystem>
#include <sstream>
#include <string>
#include <string_view>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <sbgc/internal/suggestions.hpp>
#include <sbgc/io/internal/atomic_file.hpp>
#include <sbgc/version.hpp>

#include "command/command_line.hpp"
#include "command/common_options.hpp"
#include "command/subcommand.hpp"
#include "command/wording.hpp"

namespace sbgc::tools {

namespace {

/// Escapes text for roff.
std::string escaped(std::string_view text) {
  std::string result;
  for (const char c : text) {
    if (c == '\\') {
      result += "\\e";
    } else if (c == '-') {
      result += "\\-";
    } else {
      result += c;
    }
  }
  // A line that begins with a control character would be a request.
  if (result.starts_with('.') || result.starts_with('\'')) result.insert(0, "\\&");
  return result;
}

/// Writes paragraphs. Lines that begin with a space remain unchanged.
void put_text(std::string& page, const std::string& text) {
  std::istringstream lines(text);
  bool is_literal = false;
  const auto set_literal = [&](bool on) {
    if (on != is_literal) page += on ? ".PP\n.nf\n" : ".fi\n.PP\n";
    is_literal = on;
  };
  for (std::string line; std::getline(lines, line);) {
    if (line.empty()) {
      set_literal(false);
      page += ".PP\n";
      continue;
    }
    set_literal(line.starts_with(' '));
    page += escaped(line) + "\n";
    if (!is_literal) page += ".PP\n";
  }
  set_literal(false);
}

std::string value_of(const CLI::Option& option) {
  const std::vector<std::string> choices = choices_of(option);
  if (choices.empty()) return "\\fI" + escaped(value_name(option)) + "\\fR";
  std::string result;
  for (const std::string& choice : choices) {
    result += (result.empty() ? "\\fB" : "|\\fB") + escaped(choice) + "\\fR";
  }
  return result;
}

void put_option(std::string& page, const CLI::Option& option) {
  std::string names;
  const auto add = [&](const std::string& name) {
    names += (names.empty() ? "\\fB" : ", \\fB") + escaped(name) + "\\fR";
  };
  for (const std::string& name : option.get_snames()) add("-" + name);
  for (const std::string& name : option.get_lnames()) add("--" + name);
  if (option.get_positional()) names = "\\fI" + escaped(argument_name(option)) + "\\fR";
  if (!option.get_positional() && takes_value(option)) names += " " + value_of(option);
  page += ".TP\n" + names + "\n" + escaped(option.get_description());
  if (!option.get_default_str().empty()) {
    page += escaped(" (default: " + option.get_default_str() + ")");
  }
  page += "\n";
}

void put_synopsis(std::string& page, const CLI::App& command) {
  page += "\\fB" + escaped(full_name(command)) + R"(\fR [\fIOPTIONS\fR])";
  for (const CLI::Option* const argument : arguments_of(command)) {
    const std::string value = argument_name(*argument);
    std::string name = "\\fI" + escaped(value) + "\\fR";
    // A name such as "[ADDRESS] FILE" describes all values.
    const bool describes_all = value.find(' ') != std::string::npos;
    if (argument->get_items_expected_max() > 1 && !describes_all) name += "...";
    page += argument->get_required() ? " " + name : " [" + name + "]";
  }
  if (!subcommands_of(command).empty()) page += " \\fICOMMAND\\fR";
  page += "\n";
}

void put_options(std::string& page, const CLI::App& command) {
  for (const CLI::Option* const argument : arguments_of(command)) put_option(page, *argument);
  bool has_gimbal = false;
  for (const CLI::Option* const option : options_of(command)) {
    // The page of sbgc explains them.
    has_gimbal = option->get_group() == gimbal_group;
    if (!has_gimbal || command.get_parent() == nullptr) put_option(page, *option);
  }
  if (has_gimbal && command.get_parent() != nullptr) {
    page +=
        ".PP\nThe options of a gimbal, \\fB\\-p\\fR \\fIADDRESS\\fR and others, are in "
        "\\fBsbgc\\fR(1).\n";
  }
}

void put_nested(std::string& page, const CLI::App& command) {
  for (const CLI::App* const nested : subcommands_of(command)) {
    page += ".SS " + escaped(full_name(*nested)) + "\n";
    page += escaped(nested->get_description()) + ".\n.PP\n";
    put_synopsis(page, *nested);
    put_options(page, *nested);
    if (!nested->get_footer().empty()) {
      page += ".PP\n";
      put_text(page, nested->get_footer());
    }
  }
}

/// Returns "sbgc" or "sbgc-decode".
std::string page_name(const CLI::App& command) {
  const CLI::App* const parent = command.get_parent();
  return parent == nullptr ? command.get_name() : parent->get_name() + '-' + command.get_name();
}

/// Returns the page of the command itself or of one of its subcommands.
std::string page_of(const CLI::App& command) {
  const bool is_program = command.get_parent() == nullptr;
  std::string page = fmt::format(
      ".TH \"{}\" 1 \"\" \"sbgc " SBGC_VERSION_TEXT "\" \"sbgc manual\"\n", page_name(command));
  page += ".SH NAME\n" + escaped(page_name(command)) + " \\- " +
          escaped(command.get_description()) + "\n.SH SYNOPSIS\n";
  put_synopsis(page, command);
  page += ".SH OPTIONS\n";
  put_options(page, command);
  if (is_program) {
    page += ".SH COMMANDS\n";
    for (const CLI::App* const one : subcommands_of(command)) {
      page += ".TP\n\\fB" + escaped(page_name(*one)) + "\\fR(1)\n" +
              escaped(one->get_description()) + "\n";
    }
  } else if (!subcommands_of(command).empty()) {
    page += ".SH COMMANDS\n";
    put_nested(page, command);
  }
  if (!command.get_footer().empty()) {
    page += ".SH NOTES\n";
    put_text(page, command.get_footer());
  }
  page += ".SH SEE ALSO\n";
  page += is_program ? "\\fBsbgc COMMAND \\-\\-help\\fR\n" : "\\fBsbgc\\fR(1)\n";
  return page;
}

void write_page(const CLI::App& command, const std::filesystem::path& folder) {
  const auto written = detail::write_file_atomically(folder / (page_name(command) + ".1"),
                                                     page_of(command), Existing::replace);
  if (!written) throw CommandError(written.error().message);
}

struct ManualOptions {
  std::string command{};
  std::string folder{};
};

int print_manual(const CLI::App& app, const ManualOptions& options) {
  if (!options.folder.empty()) {
    write_page(app, options.folder);
    for (const CLI::App* const one : subcommands_of(app)) write_page(*one, options.folder);
    return success;
  }
  const CLI::App* const command =
      options.command.empty() ? &app : find_subcommand(app, options.command);
  if (command == nullptr) {
    std::vector<std::string> names;
    for (const CLI::App* const one : subcommands_of(app)) names.push_back(one->get_name());
    throw CommandError(fmt::format("there is no command '{}'{}", clipped(options.command),
                                   detail::did_you_mean(detail::nearest(options.command, names))),
                       wrong_usage);
  }
  fmt::print("{}", page_of(*command));
  return success;
}

}  // namespace

void add_manual(CLI::App& app, CommandContext& context) {
  const Subcommand<ManualOptions> command(app, context, "manual",
                                          "Print a manual page in the format of man");
  auto& options = command.options();
  command->add_option("command", options.command, "The command; by default sbgc itself")
      ->type_name("COMMAND");
  command->add_option("--folder", options.folder, "Write all pages to this folder")
      ->type_name("FOLDER");
  command->footer("`sbgc manual decode | man -l -` shows a page. An installed sbgc has all pages.");
  command.examples({"sbgc manual params"});
  command.runs([&app](const ManualOptions& chosen) { return print_manual(app, chosen); });
}

}  // namespace sbgc::tools
