#include "command/terminal_text.hpp"

#include <algorithm>
#include <cstdlib>
#include <utility>

#include <fmt/format.h>

#include <sbgc/internal/parse_number.hpp>

#include "command/command_line.hpp"
#include "command/common_options.hpp"
#include "command/system.hpp"

namespace sbgc::tools {

namespace {

constexpr std::size_t usual_width = 80;
constexpr std::size_t least_width = 40;
constexpr std::size_t widest_names = 30;  // with the spaces around them
constexpr std::size_t width_of_commands = 14;

std::size_t width_from_environment() {
  const char* const text = std::getenv("COLUMNS");
  if (text == nullptr) return 0;
  return detail::parse_number<std::size_t>(text).value_or(0);
}

/// Removes the text up to `separator` from the front of `text` and returns it.
std::string_view take(std::string_view& text, char separator) {
  const std::size_t size = std::min(text.find(separator), text.size());
  const std::string_view result = text.substr(0, size);
  text.remove_prefix(std::min(size + 1, text.size()));
  return result;
}

}  // namespace

std::size_t line_width(std::FILE* file) {
  std::size_t width = width_from_environment();
  if (width == 0) width = width_of_terminal(file);
  if (width == 0) width = usual_width;
  return std::max(width, least_width);
}

std::string wrapped(std::string_view text, std::size_t width, std::size_t column,
                    std::size_t indent) {
  std::string result;
  const auto break_line = [&] {
    result += '\n';
    column = 0;
  };
  for (bool is_first = true; !text.empty(); is_first = false) {
    std::string_view line = take(text, '\n');
    if (!is_first) break_line();
    if (line.starts_with(' ')) {
      result += line;
      continue;
    }
    for (bool is_begin = true; !line.empty();) {
      const std::string_view word = take(line, ' ');
      if (word.empty()) continue;
      if (!is_begin && column + 1 + word.size() > width) {
        break_line();
        is_begin = true;
      }
      const bool needs_indent = is_begin && column < indent;
      const std::size_t spaces = needs_indent ? indent - column : (is_begin ? 0 : 1);
      result.append(spaces, ' ');
      result += word;
      column += spaces + word.size();
      is_begin = false;
    }
  }
  return result;
}

std::string colored_help(std::string_view help) {
  const Colors colors(stdout);
  if (!colors.are_on()) return std::string(help);
  std::string result;
  bool is_after_gap = true;
  bool has_names = false;  // the lines below this heading
  while (!help.empty()) {
    const std::string_view line = take(help, '\n');
    const bool is_heading = is_after_gap && line.ends_with(':') && line.find('.') == line.npos;
    const bool is_entry = has_names && line.starts_with("  ") && !line.starts_with("   ");
    is_after_gap = line.empty();
    if (is_heading) has_names = !line.starts_with("Example");
    if (is_heading) {
      result += colors(Color::bold, line);
    } else if (is_entry) {
      const std::size_t end = std::min(line.find("  ", 2), line.size());
      result += colors(Color::cyan, line.substr(0, end)).append(line.substr(end));
    } else {
      result += line;
    }
    result += '\n';
  }
  return result;
}

HelpFormatter::HelpFormatter(std::size_t width, bool explains_gimbal)
    : width_(width), explains_gimbal_(explains_gimbal) {
  column_width(std::min(widest_names, width * 3 / 8));
  label("SUBCOMMAND", "COMMAND");
}

std::string HelpFormatter::make_help(const CLI::App* app, std::string name,
                                     CLI::AppFormatMode mode) const {
  // One empty line between option groups instead of two.
  return CLI::detail::find_and_replace(Formatter::make_help(app, std::move(name), mode), "\n\n\n",
                                       "\n\n");
}

std::string HelpFormatter::make_description(const CLI::App* app) const {
  const std::string text = wrapped(Formatter::make_description(app), width_);
  return text.empty() ? text : text + '\n';
}

std::string HelpFormatter::make_usage(const CLI::App* app, std::string name) const {
  if (app->get_name().empty()) return "";  // no command
  return wrapped(Formatter::make_usage(app, std::move(name)), width_) + '\n';
}

std::string HelpFormatter::make_group(std::string group, bool is_positional,
                                      std::vector<const CLI::Option*> options) const {
  if (group != gimbal_group || explains_gimbal_) {
    return Formatter::make_group(std::move(group), is_positional, std::move(options));
  }
  return '\n' + group + ":\n" +
         entry("-p ADDRESS, -g GIMBAL", "and others: `sbgc help connection`", get_column_width());
}

std::string HelpFormatter::make_option_name(const CLI::Option* option, bool is_positional) const {
  return is_positional ? argument_name(*option) : Formatter::make_option_name(option, false);
}

std::string HelpFormatter::make_option_usage(const CLI::Option* option) const {
  // A name such as "[ADDRESS] FILE" describes all values.
  std::string values = value_name(*option);
  if (option->get_expected_max() > 1 && values.find(' ') != std::string::npos) return values;
  std::string text = make_option_name(option, true);
  if (option->get_expected_max() > 1) text += "...";
  return option->get_required() ? text : '[' + text + ']';
}

std::string HelpFormatter::make_option(const CLI::Option* option, bool is_positional) const {
  return entry(make_option_name(option, is_positional) + make_option_opts(option),
               make_option_desc(option), get_column_width());
}

std::string HelpFormatter::make_option_opts(const CLI::Option* option) const {
  if (!takes_value(*option)) return "";
  const std::vector<std::string> choices = choices_of(*option);
  std::string result = choices.empty() ? "" : fmt::format(" {}", fmt::join(choices, "|"));
  // The value of an argument is what the argument is called.
  if (choices.empty() && !option->get_positional()) result = ' ' + value_name(*option);
  if (!option->get_default_str().empty()) result += " (" + option->get_default_str() + ")";
  return result;
}

std::string HelpFormatter::make_subcommand(const CLI::App* command) const {
  return entry(command->get_display_name(true), command->get_description(),
               std::min(width_of_commands, get_column_width()));
}

std::string HelpFormatter::make_expanded(const CLI::App* command) const {
  constexpr std::size_t indent = 2;  // added by Formatter afterwards
  HelpFormatter narrower(*this);
  narrower.width_ -= indent;
  return narrower.Formatter::make_expanded(command);
}

std::string HelpFormatter::make_footer(const CLI::App* app) const {
  const std::string text = wrapped(app->get_footer(), width_);
  return text.empty() ? text : text + '\n';
}

std::string HelpFormatter::entry(const std::string& name, const std::string& description,
                                 std::size_t column) const {
  constexpr std::size_t indent = 2;
  std::string result = std::string(indent, ' ') + name;
  if (!description.empty()) {
    const bool is_below = result.size() + 1 >= column;
    if (is_below) result += '\n';
    result += wrapped(description, width_, is_below ? 0 : result.size(), column);
  }
  return result + '\n';
}

bool is_dumb_terminal() {
  const char* const term = std::getenv("TERM");
  return term != nullptr && std::string_view(term) == "dumb";
}

Colors::Colors(std::FILE* file) {
  const char* const no_color = std::getenv("NO_COLOR");
  are_on_ = is_terminal(file) && (no_color == nullptr || *no_color == '\0') && !is_dumb_terminal();
}

std::string_view Colors::begin(Color color) const {
  if (!are_on_) return "";
  switch (color) {
    case Color::bold: return "\033[1m";
    case Color::dim: return "\033[2m";
    case Color::red: return "\033[31m";
    case Color::green: return "\033[32m";
    case Color::yellow: return "\033[33m";
    case Color::cyan: return "\033[36m";
  }
  return "";
}

std::string_view Colors::end() const { return are_on_ ? "\033[0m" : ""; }

std::string Colors::operator()(Color color, std::string_view text) const {
  return std::string(begin(color)).append(text).append(end());
}

}  // namespace sbgc::tools
