// sbgc script: starts and stops the scripts of the board.

#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include <fmt/format.h>

#include <sbgc/messages/scripting.hpp>

#include "board/connection.hpp"
#include "command/background_output.hpp"
#include "command/common_options.hpp"
#include "command/remark.hpp"
#include "command/subcommand.hpp"
#include "command/wording.hpp"

namespace sbgc::tools {

namespace {

// Slots count from 1, as in the board's menu.
struct ScriptToStart {
  unsigned slot{};
  Arming arming{};
};

struct ScriptToStop {
  unsigned slot{};
};

void set_mode(Client& client, unsigned slot, msg::ScriptMode mode, const CommandContext& context) {
  msg::RunScript request;
  request.mode = mode;
  request.slot = static_cast<std::uint8_t>(slot - 1);
  value_of(Result<void>(client.call(request, confirming(call_options(context.gimbal)))));
}

/// Returns the sizes of the scripts by slot, 0 for an empty one; empty if the board does not report
/// them.
std::vector<std::size_t> script_sizes(const Client& client) {
  std::vector<std::size_t> sizes;
  const std::optional<msg::BoardInfo3>& details = client.identity().details;
  if (!details) return sizes;
  for (const auto& size : details->script_slot_size) sizes.push_back(size.raw());
  for (const auto& size : details->script_slot_6_to_10_size) sizes.push_back(size.raw());
  return sizes;
}

void require_script(const Client& client, unsigned slot) {
  const std::vector<std::size_t> sizes = script_sizes(client);
  if (sizes.empty() || (slot <= sizes.size() && sizes[slot - 1] != 0)) return;
  throw CommandError(
      fmt::format("there is no script in slot {}; `sbgc script list` shows the scripts", slot));
}

int start_script(const ScriptToStart& options, const CommandContext& context) {
  Client client = connect(context.gimbal);
  require_possible(client, msg::RunScript{});
  require_script(client, options.slot);
  arm(options.arming,
      fmt::format("The board runs the script in slot {}. It can do whatever a command can do: move "
                  "the camera, change parameters, restart the board. It goes on after this command "
                  "has ended; `sbgc script stop {}` stops it.",
                  options.slot, options.slot));
  set_mode(client, options.slot, msg::ScriptMode::start, context);
  remark("the script in slot {} has started\n", options.slot);
  return success;
}

int stop_script(const ScriptToStop& options, const CommandContext& context) {
  remark_in_background();
  Client client = connect(context.gimbal);
  set_mode(client, options.slot, msg::ScriptMode::stop, context);
  remark("the script in slot {} has stopped; what it set in motion goes on until `sbgc stop`\n",
         options.slot);
  return success;
}

int list_scripts(const NoOptions& /*none*/, const CommandContext& context) {
  const std::vector<std::size_t> sizes = script_sizes(connect(context.gimbal));
  if (sizes.empty()) throw CommandError("the board does not tell about its scripts");
  constexpr std::size_t always_shown = 5;  // only later firmware has more slots
  for (std::size_t i = 0; i < sizes.size(); ++i) {
    if (i >= always_shown && sizes[i] == 0) continue;
    fmt::print("{}  {}\n", i + 1, counted(sizes[i], "byte"));
  }
  return success;
}

}  // namespace

void add_script(CLI::App& app, CommandContext& context) {
  auto* const script = app.add_subcommand("script", "Start and stop the scripts of the board");
  script->require_subcommand(1);
  const auto add_slot = [](const auto& command) {
    constexpr unsigned slots = std::numeric_limits<std::uint8_t>::max();
    command->add_option("slot", command.options().slot, "The slot of the script, counted from 1")
        ->required()
        ->check(CLI::Range(1U, slots).description(""));
  };
  const Subcommand<NoOptions> listing(*script, context, "list", "Show the sizes of the scripts");
  listing.examples({"sbgc script list"});
  listing.runs(list_scripts);
  const Subcommand<ScriptToStart> starting(*script, context, "start", "Start a script");
  add_slot(starting);
  starting.examples({"sbgc script start 1"});
  starting.runs(start_script);
  const Subcommand<ScriptToStop> stopping(*script, context, "stop",
                                          "Stop a script, without asking");
  add_slot(stopping);
  stopping.examples({"sbgc script stop 1"});
  stopping.runs(stop_script);
  script->footer(
      "The specification does not say which file holds a script; `sbgc files` copies files by "
      "their "
      "number.\n"
      "\n"
      "The exit status is 0 if the board accepted it, 1 if not, 2 for wrong usage, 3 if it was "
      "sent "
      "but not confirmed.");
}

}  // namespace sbgc::tools
