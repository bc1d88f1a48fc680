/// Text on a terminal: its lines, its colors, and the layout of the help.
#pragma once

#include <cstddef>
#include <cstdio>
#include <string>
#include <string_view>
#include <vector>

#include <CLI/CLI.hpp>

namespace sbgc::tools {

/// Returns the width of a line of standard output or standard error in characters: the environment
/// variable COLUMNS, else the width of the terminal, else 80; at least 40.
std::size_t line_width(std::FILE* file = stdout);

/// Wraps `text` between words to lines of at most `width` characters. The first line begins at
/// column `column`; the others are indented by `indent` spaces. Lines of `text` that begin with a
/// space stay unchanged.
std::string wrapped(std::string_view text, std::size_t width, std::size_t column = 0,
                    std::size_t indent = 0);

/// Returns a help for standard output: on a terminal, headings are bold and names are colored.
std::string colored_help(std::string_view help);

/// The formatter of CLI11, with lines wrapped between words.
class HelpFormatter : public CLI::Formatter {
 public:
  /// Unless `explains_gimbal`, one line stands for the options of a gimbal.
  explicit HelpFormatter(std::size_t width, bool explains_gimbal = false);

  std::string make_help(const CLI::App* app, std::string name,
                        CLI::AppFormatMode mode) const override;
  std::string make_description(const CLI::App* app) const override;
  std::string make_usage(const CLI::App* app, std::string name) const override;
  std::string make_group(std::string group, bool is_positional,
                         std::vector<const CLI::Option*> options) const override;
  std::string make_option_name(const CLI::Option* option, bool is_positional) const override;
  std::string make_option_usage(const CLI::Option* option) const override;
  std::string make_option(const CLI::Option* option, bool is_positional) const override;
  std::string make_option_opts(const CLI::Option* option) const override;
  std::string make_subcommand(const CLI::App* command) const override;
  std::string make_expanded(const CLI::App* command) const override;
  std::string make_footer(const CLI::App* app) const override;

 private:
  /// Returns a name, with its description in the next column or below.
  std::string entry(const std::string& name, const std::string& description,
                    std::size_t column) const;

  std::size_t width_;
  bool explains_gimbal_;
};

enum class Color : unsigned char { bold, dim, red, green, yellow, cyan };

/// True if TERM is "dumb": the terminal obeys no escape sequences.
bool is_dumb_terminal();

/// Colors text for one file, if it is a terminal and the environment variable NO_COLOR is unset or
/// empty.
class Colors {
 public:
  /// No colors.
  Colors() = default;
  explicit Colors(std::FILE* file);

  bool are_on() const noexcept { return are_on_; }
  std::string operator()(Color color, std::string_view text) const;
  /// The escape sequence that begins a color; "" without colors.
  std::string_view begin(Color color) const;
  std::string_view end() const;

 private:
  bool are_on_ = false;
};

}  // namespace sbgc::tools
