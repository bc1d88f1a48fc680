/// How the help of the command looks.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include <CLI/CLI.hpp>

namespace sbgc::tools {

/// Characters in a line of the standard output: the environment variable COLUMNS, else what the
/// terminal says, else 80; never less than 40.
std::size_t line_width();

/// `text` in lines of at most `width` characters, broken between words. The first line begins at
/// column `column`; the others get `indent` spaces in front. Lines of `text` that begin with a
/// space stay as they are.
std::string wrapped(std::string_view text, std::size_t width, std::size_t column = 0,
                    std::size_t indent = 0);

/// The formatter of CLI11, with lines that are broken between words.
class HelpFormatter : public CLI::Formatter {
 public:
  explicit HelpFormatter(std::size_t width);

  std::string make_help(const CLI::App* app, std::string name,
                        CLI::AppFormatMode mode) const override;
  std::string make_description(const CLI::App* app) const override;
  std::string make_usage(const CLI::App* app, std::string name) const override;
  std::string make_option(const CLI::Option* option, bool is_positional) const override;
  std::string make_subcommand(const CLI::App* command) const override;
  std::string make_expanded(const CLI::App* command) const override;
  std::string make_footer(const CLI::App* app) const override;

 private:
  /// A name and, in the column beside it or below, what it is for.
  std::string entry(const std::string& name, const std::string& description) const;

  std::size_t width_;
};

}  // namespace sbgc::tools
