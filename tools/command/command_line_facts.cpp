#include "command/command_line_facts.hpp"

#include <algorithm>
#include <sstream>

#include <sbgc/internal/words.hpp>

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

}  // namespace sbgc::tools
