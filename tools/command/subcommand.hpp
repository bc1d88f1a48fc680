/// The subcommands of sbgc. Each adds itself to the command line and stores its exit status.
#pragma once

#include <initializer_list>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>

#include <CLI/CLI.hpp>

#include "command/command_error.hpp"
#include "command/common_options.hpp"

namespace sbgc::tools {

/// Shared state of the subcommands.
struct CommandContext {
  int status = success;
  GimbalOptions gimbal{};
};

/// Returns what `sbgc` alone prints; it fits on a small terminal.
std::string front_page(const CLI::App& app);

/// True if this is the name of a subcommand that works without the others.
bool stands_alone(std::string_view name);

/// Adds the subcommands that this program has, those of all_commands.cpp or offline_commands.cpp,
/// or the one of this name.
void add_commands(CLI::App& app, CommandContext& context, std::string_view only);

/// If this process is a helper that a subcommand started, does its work and returns the exit
/// status.
std::optional<int> run_helper(int argc, char** argv);

/// The type of the functions that add a subcommand.
using AddCommand = void(CLI::App& app, CommandContext& context);
AddCommand add_ports, add_info, add_monitor, add_stream, add_plot, add_describe;
AddCommand add_params, add_vars;
AddCommand add_params_show, add_params_get, add_params_set, add_params_profiles, add_params_rename,
    add_params_backup, add_params_restore, add_params_diff, add_params_reset;
AddCommand add_move, add_speed, add_jog, add_stop, add_motors, add_menu, add_bode;
AddCommand add_doctor, add_tune, add_calibrate, add_eeprom, add_files, add_script, add_module;
AddCommand add_reset;
AddCommand add_send, add_record, add_replay, add_decode, add_encode, add_emulate;
AddCommand add_bridge, add_gateway;
AddCommand add_shell, add_help, add_completion, add_manual;

/// The options of a subcommand that has none.
struct NoOptions {};

/// The types of a subcommand determine its needs: if its Options have an `arming`, it asks before
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
