#include "command/command_line.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdio>
#include <initializer_list>
#include <optional>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include <sbgc/internal/suggestions.hpp>
#include <sbgc/internal/words.hpp>

#include "command/command_error.hpp"
#include "command/remark.hpp"
#include "command/wording.hpp"

namespace sbgc::tools {

std::vector<const CLI::App*> subcommands_of(const CLI::App& command) {
  std::vector<const CLI::App*> result;
  for (const CLI::App* const one : command.get_subcommands({})) {
    if (!one->get_name().empty() && !one->get_group().empty()) result.push_back(one);
  }
  return result;
}

std::vector<const CLI::Option*> options_of(const CLI::App& command) {
  std::vector<const CLI::Option*> result;
  for (const CLI::Option* const option : command.get_options()) {
    if (!option->get_positional() && !option->get_group().empty()) result.push_back(option);
  }
  return result;
}

std::vector<const CLI::Option*> arguments_of(const CLI::App& command) {
  std::vector<const CLI::Option*> result;
  for (const CLI::Option* const option : command.get_options()) {
    if (option->get_positional()) result.push_back(option);
  }
  return result;
}

const CLI::App* find_subcommand(const CLI::App& command, const std::string& name) {
  for (const CLI::App* const one : command.get_subcommands({})) {
    if (one->get_name() == name) return one;
  }
  return nullptr;
}

bool takes_value(const CLI::Option& option) { return option.get_items_expected_max() > 0; }

std::vector<std::string> choices_of(const CLI::Option& option) {
  // CLI11 appends the description of a validator to the name of the type: "TEXT:{text,jsonl}", or
  // "TEXT:value in {text->0,jsonl->1} OR {0,1}".
  const std::string type = option.get_type_name();
  const std::size_t begin = type.find('{');
  const std::size_t end = type.find('}');
  if (begin == std::string::npos || end == std::string::npos) return {};
  std::istringstream list(type.substr(begin + 1, end - begin - 1));
  std::vector<std::string> result;
  for (std::string choice; std::getline(list, choice, ',');) {
    result.push_back(choice.substr(0, choice.find("->")));
  }
  return result;
}

std::string value_name(const CLI::Option& option) {
  const std::string type = option.get_type_name();
  // The names that CLI11 gives to numbers, which may be followed by a validator.
  for (const char* const number : {"INT", "UINT", "FLOAT"}) {
    if (type == number || type.starts_with(std::string(number) + ':')) return "NUMBER";
  }
  // CLI11 appends the description of a validator, "N:INT in [1 - 10]"; a colon in "[HOST:]PORT" is
  // part of the name.
  std::size_t end = type.size();
  for (const char* const validator : {":INT", ":UINT", ":FLOAT", ":TEXT", ":value in"}) {
    end = std::min(end, type.find(validator));
  }
  if (type.starts_with("TEXT:")) return "TEXT";
  return type.substr(0, end);
}

std::string argument_name(const CLI::Option& argument) {
  const std::string value = value_name(argument);
  const bool is_general = value == "TEXT" || value == "NUMBER" || !choices_of(argument).empty();
  return is_general ? detail::upper_case(argument.get_name()) : value;
}

namespace {

std::vector<std::string> command_names(const CLI::App& command) {
  std::vector<std::string> result;
  for (const CLI::App* const one : subcommands_of(command)) result.push_back(one->get_name());
  return result;
}

std::vector<std::string> option_names(const CLI::App& command) {
  std::vector<std::string> result;
  for (const CLI::Option* const option : command.get_options()) {
    for (const std::string& name : option->get_lnames()) result.push_back("--" + name);
  }
  for (const CLI::App* const group : command.get_subcommands({})) {
    if (!group->get_name().empty()) continue;
    for (const std::string& name : option_names(*group)) result.push_back(name);
  }
  return result;
}

/// Returns the names after `before`, unless they are too many to choose from in a message.
std::string choice(const std::string& before, const std::vector<std::string>& names) {
  constexpr std::size_t most = 12;
  return names.size() > most ? "" : before + detail::alternatives(names, false);
}

/// Words that people use for a command.
constexpr std::array<std::pair<std::string_view, const char*>, 8> other_words{{
    {"home", "menu home_position"},
    {"goto", "move"},
    {"turn", "move"},
    {"rotate", "move"},
    {"halt", "stop"},
    {"restart", "reset"},
    {"reboot", "reset"},
    {"autotune", "tune"},
}};

/// True if a command is what somebody meant to write, and not only a name that looks alike: a
/// command can move the camera. A mistyped word begins with the right letters, and a short one with
/// another letter is another word, as "mode" is not "move".
bool is_mistyped(std::string_view word, std::string_view name) {
  if (name.starts_with(word) || word.starts_with(name)) return true;
  const bool begins_alike =
      word[0] == name[0] || (word.size() > 1 && word[0] == name[1] && word[1] == name[0]);
  constexpr std::size_t short_word = 4;
  if (!begins_alike || word.size() > short_word || word.size() != name.size()) return begins_alike;
  std::string letters(word), others(name);
  std::ranges::sort(letters);
  std::ranges::sort(others);
  return letters == others;
}

/// Returns the commands, and options, that somebody may have meant by a word.
std::vector<std::string> meant_by(const CLI::App& command, const std::string& word) {
  const std::vector<std::string> commands = command_names(command);
  const auto is_command = [&](const std::string& name) {
    return std::ranges::find(commands, name) != commands.end();
  };
  for (const auto& [other, meant] : other_words) {
    const std::string_view text = meant;
    if (word == other && is_command(std::string(text.substr(0, text.find(' '))))) return {meant};
  }
  std::vector<std::string> known = commands;
  for (const std::string& option : option_names(command)) known.push_back(option);
  std::vector<std::string> near = detail::nearest(word, known);
  std::erase_if(
      near, [&](const std::string& name) { return is_command(name) && !is_mistyped(word, name); });
  return near;
}

/// Returns the error message for an unexpected word that was passed to `command`.
std::string unknown_word(const CLI::App& command, const std::string& word) {
  const std::string shown = clipped(word);
  if (word.starts_with('-')) {
    const std::string name = word.substr(0, word.find('='));
    return fmt::format("unknown option '{}'{}", shown,
                       detail::did_you_mean(detail::nearest(name, option_names(command))));
  }
  const std::vector<std::string> commands = command_names(command);
  if (commands.empty()) return fmt::format("unexpected argument '{}'", shown);
  const std::vector<std::string> near = meant_by(command, detail::lower_case(word));
  return fmt::format("unknown command '{}'{}", shown,
                     near.empty() ? choice("; use ", commands) : detail::did_you_mean(near));
}

/// Returns what a user calls an option: its own name, or for an argument the type in the help.
std::string shown_name(const CLI::App& command, const std::string& name) {
  if (name.starts_with('-')) return name;
  const CLI::Option* const option = command.get_option_no_throw(name);
  return option == nullptr ? detail::upper_case(name) : argument_name(*option);
}

/// The number without trailing zeros.
std::string plain_number(std::string text) {
  if (text.find('.') == std::string::npos) return text;
  while (text.ends_with('0')) text.pop_back();
  if (text.ends_with('.')) text.pop_back();
  return text;
}

/// Returns what stands between these parts of a text, of which the first begins it and the last
/// ends it. What comes first has no spaces; the rest may contain the parts.
std::optional<std::vector<std::string>> between(std::string_view text,
                                                std::initializer_list<std::string_view> parts) {
  std::vector<std::string_view> left(parts);
  if (!text.starts_with(left.front()) || !text.ends_with(left.back())) return {};
  text.remove_prefix(std::min(left.front().size(), text.size()));
  text.remove_suffix(std::min(left.back().size(), text.size()));
  const std::size_t end = left.size() > 2 ? text.find(left[1]) : text.size();
  if (end == std::string_view::npos) return {};
  std::vector<std::string> found{std::string(text.substr(0, end))};
  if (found.front().empty() || found.front().find(' ') != std::string::npos) return {};
  if (left.size() == 2) return found;
  text.remove_prefix(end + left[1].size());
  for (std::size_t i = left.size() - 2; i > 1; --i) {
    const std::size_t at = text.rfind(left[i]);
    if (at == std::string_view::npos) return {};
    found.insert(found.begin() + 1, std::string(text.substr(at + left[i].size())));
    text = text.substr(0, at);
  }
  found.insert(found.begin() + 1, std::string(text));
  return found;
}

/// Puts a message of the parser of the command line into words: "NAME is missing", "--timeout must
/// be from 0.001 to 86400", "--format must be text or json, not xml".
std::string in_words(const CLI::App& command, const std::string& message) {
  if (const auto found = between(message, {"", " is required"})) {
    return shown_name(command, found->at(0)) + " is missing";
  }
  if (const auto found = between(message, {"Could not convert: ", " = ", ""})) {
    return fmt::format("{} must be a number, not '{}'", shown_name(command, found->at(0)),
                       found->at(1));
  }
  if (const auto found = between(message, {"", ": ", " required ", " missing"})) {
    return shown_name(command, found->at(0)) + " needs a value";
  }
  if (const auto found = between(message, {"", ": Value ", " not in range ", " to ", ""})) {
    return fmt::format("{} must be from {} to {}, not '{}'", shown_name(command, found->at(0)),
                       plain_number(found->at(2)), plain_number(found->at(3)), found->at(1));
  }
  if (const auto found = between(message, {"", ": ", " not in {", "}"})) {
    std::vector<std::string> words;
    std::istringstream list(found->at(2));
    for (std::string word; std::getline(list, word, ',');) words.push_back(word);
    return fmt::format("{} must be {}, not '{}'", shown_name(command, found->at(0)),
                       detail::alternatives(words, false), found->at(1));
  }
  if (const auto found = between(message, {"", ": At Most ", " required but received ", ""})) {
    return fmt::format("{} is given {}{}", shown_name(command, found->at(0)),
                       found->at(2) == "2" ? "twice" : found->at(2) + " times",
                       found->at(1) == "1" ? "" : ", at most " + found->at(1) + " are possible");
  }
  if (const auto found = between(message, {"", ": must ", ""})) {
    return fmt::format("{} must {}", shown_name(command, found->at(0)), found->at(1));
  }
  return message;
}

}  // namespace

const CLI::App& chosen_command(const CLI::App& app) {
  for (const CLI::App* const command : app.get_subcommands()) {
    if (!command->get_name().empty()) return chosen_command(*command);
  }
  return app;
}

std::string full_name(const CLI::App& command) {
  const CLI::App* const parent = command.get_parent();
  return parent == nullptr ? command.get_name() : full_name(*parent) + ' ' + command.get_name();
}

int report_usage_error(const CLI::App& app, const CLI::ParseError& error) {
  const CLI::App& command = chosen_command(app);
  // In `params help show`, the unknown word stands before the chosen command.
  for (const CLI::App* one = &command; one != nullptr; one = one->get_parent()) {
    const std::vector<std::string> unknown = one->remaining();
    if (!unknown.empty()) return report_usage_error(*one, unknown_word(*one, unknown.front()));
  }
  // All missing commands, but not missing arguments, are reported by the names of the commands.
  if (const auto names = command_names(command); !names.empty()) {
    return report_usage_error(command, "expected a command" + choice(": ", names));
  }
  return report_usage_error(command, in_words(command, clipped(error.what())));
}

int report_usage_error(const CLI::App& command, const std::string& problem) {
  remark_failure(problem, fmt::format("Run `{} --help` for help.\n", full_name(command)));
  return wrong_usage;
}

}  // namespace sbgc::tools
