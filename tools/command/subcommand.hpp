/// A subcommand while it is added to the command line.
#pragma once

#include <initializer_list>
#include <memory>
#include <string>
#include <type_traits>
#include <utility>

#include <CLI/CLI.hpp>

#include "command/arming.hpp"
#include "command/commands.hpp"

namespace sbgc::tools {

/// The options of a subcommand that has none.
struct NoOptions {};

/// What a subcommand needs follows from its types: if its Options have an `arming`, it asks before
/// it acts (--yes); if its function takes the CommandContext, it talks to a gimbal.
template <class Options>
class Subcommand {
 public:
  Subcommand(CLI::App& parent, CommandContext& context, std::string name,
             const std::string& summary = "")
      : command_(*parent.add_subcommand(std::move(name), summary)), context_(context) {}

  CLI::App& operator*() const { return command_; }
  CLI::App* operator->() const { return &command_; }
  /// They live as long as the command.
  Options& options() const { return *options_; }

  /// Adds examples to the end of the help. A test runs them.
  void examples(std::initializer_list<const char*> lines) const {
    std::string text = command_.get_footer();
    text += text.empty() ? "" : "\n\n";
    text += lines.size() == 1 ? "Example:" : "Examples:";
    for (const char* const line : lines) text += std::string("\n  ") + line;
    command_.footer(text);
  }

  /// Adds the options that follow from the types, after the others. `run` does the work and returns
  /// the exit status.
  template <class Run>
  void runs(Run run) const {
    constexpr bool has_gimbal = std::is_invocable_v<Run, Options&, CommandContext&>;
    if constexpr (requires(Options & options) { options.arming; }) {
      add_arming(command_, options_->arming);
    }
    if constexpr (has_gimbal) add_gimbal_options(command_, context_.gimbal);
    command_.callback([run, options = options_, &context = context_] {
      if constexpr (has_gimbal) {
        context.status = run(*options, context);
      } else {
        context.status = run(*options);
      }
    });
  }

 private:
  CLI::App& command_;
  CommandContext& context_;
  std::shared_ptr<Options> options_ = std::make_shared<Options>();
};

}  // namespace sbgc::tools
