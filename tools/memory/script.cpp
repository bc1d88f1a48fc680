// sbgc script: starts and stops the scripts of the board.

#include <cstdint>
#include <limits>
#include <memory>
#include <string>

#include <fmt/format.h>

#include <sbgc/messages/scripting.hpp>

#include "board/arming.hpp"
#include "board/connection.hpp"
#include "command/background_output.hpp"
#include "command/commands.hpp"
#include "command/remark.hpp"
#include "command/wording.hpp"

namespace sbgc::tools {

namespace {

struct ScriptOptions {
  unsigned slot{};  // from 1, as the board's menu counts
  Arming arming{};
};

void run(Client& client, const ScriptOptions& options, msg::ScriptMode mode,
         const CommandContext& context) {
  CallOptions call = call_options(context.gimbal);
  call.expect_confirmation = true;
  msg::RunScript request;
  request.mode = mode;
  request.slot = static_cast<std::uint8_t>(options.slot - 1);
  value_of(Result<void>(client.call(request, call)));
}

int start(const ScriptOptions& options, const CommandContext& context) {
  arm(options.arming,
      fmt::format("The board runs the script in slot {}. It can do whatever a command can do: move "
                  "the camera, change parameters, restart the board. It goes on after this command "
                  "has ended; `sbgc script stop {}` stops it.",
                  options.slot, options.slot));
  Client client = connect(context.gimbal);
  run(client, options, msg::ScriptMode::start, context);
  remark("the script in slot {} has started\n", options.slot);
  return success;
}

int stop(const ScriptOptions& options, const CommandContext& context) {
  remark_in_background();
  Client client = connect(context.gimbal);
  run(client, options, msg::ScriptMode::stop, context);
  remark("the script in slot {} has stopped; what it set in motion goes on until `sbgc stop`\n",
         options.slot);
  return success;
}

int list(const CommandContext& context) {
  Client client = connect(context.gimbal);
  if (!client.identity().details) throw CommandError("the board does not tell about its scripts");
  unsigned slot = 1;
  for (const auto& size : client.identity().details->script_slot_size) {
    fmt::print("{}  {}\n", slot++, counted(size.raw(), "byte"));
  }
  return success;
}

}  // namespace

void add_script(CLI::App& app, CommandContext& context) {
  auto* const command =
      app.add_subcommand("script", "Start and stop the scripts of the board")->group(heading::care);
  command->require_subcommand(1);
  auto options = std::make_shared<ScriptOptions>();
  const auto add = [&](const char* name, const char* text) {
    auto* const part = command->add_subcommand(name, text);
    add_gimbal_options(*part, context.gimbal);
    return part;
  };
  const auto add_slot = [&](CLI::App* part) {
    constexpr unsigned slots = std::numeric_limits<std::uint8_t>::max();
    part->add_option("slot", options->slot, "The slot of the script, counted from 1")
        ->required()
        ->check(CLI::Range(1U, slots).description(""));
  };
  auto* const listing = add("list", "Show the sizes of the scripts");
  listing->callback([&context] { context.status = list(context); });
  auto* const starting = add("start", "Start a script");
  add_slot(starting);
  add_arming(*starting, options->arming);
  starting->callback([options, &context] { context.status = start(*options, context); });
  auto* const stopping = add("stop", "Stop a script, without asking");
  add_slot(stopping);
  stopping->callback([options, &context] { context.status = stop(*options, context); });
  command->footer(
      "The specification does not say which file holds a script; `sbgc files` copies files by "
      "their "
      "number.\n"
      "\n"
      "The exit status is 0 if the board accepted it, 1 if not, 2 for wrong usage.");
}

}  // namespace sbgc::tools
