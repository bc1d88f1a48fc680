// sbgc menu: performs an action of the menu button.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <sbgc/internal/suggestions.hpp>
#include <sbgc/internal/words.hpp>
#include <sbgc/messages/control.hpp>
#include <sbgc/meta/enums.hpp>
#include <sbgc/text.hpp>

#include "board/connection.hpp"
#include "command/common_options.hpp"
#include "command/remark.hpp"
#include "command/subcommand.hpp"
#include "command/terminal_text.hpp"
#include "command/wording.hpp"
#include "move/menu_action.hpp"
#include "values/axis_values.hpp"

namespace sbgc::tools {

namespace {

struct MenuOptions {
  std::string action{};
  bool list = false;
  Arming arming{};
};

const ValueInfo& action_of(const std::string& word) {
  if (const ValueInfo* const action = menu_action(word)) return *action;
  std::vector<std::string> names;
  for (const ValueInfo& action : menu_actions()) names.push_back(short_name(action));
  const auto near = detail::nearest(without_dashes(detail::lower_case(word)), names);
  throw CommandError(fmt::format("unknown menu action '{}'{}", clipped(word),
                                 detail::did_you_mean(near, "`sbgc menu --list` lists them")),
                     wrong_usage);
}

void list_actions() {
  std::size_t width = 0;
  for (const ValueInfo& action : menu_actions()) width = std::max(width, short_name(action).size());
  for (const ValueInfo& action : menu_actions()) {
    const std::size_t column = width + 2;
    std::string text = action.summary;
    if (action.since.firmware != 0) {
      text += fmt::format(" Since firmware {}.",
                          to_string(msg::FirmwareVersion(action.since.firmware)));
    }
    fmt::print("{:{}}{}\n", short_name(action), column,
               wrapped(text, line_width(), column, column));
  }
}

/// Runs another command with the gimbal options of this one.
int run_instead(CLI::App& app, const std::vector<std::string>& words, const Arming& arming,
                const CommandContext& context) {
  remark("This is `sbgc {}`.\n", fmt::join(words, " "));
  std::vector<std::string> reversed(words.rbegin(), words.rend() - 1);
  if (arming.yes) reversed.insert(reversed.begin(), "--yes");
  app.get_subcommand(words.front())->parse(reversed);
  return context.status;
}

/// Returns the position of the camera before an action with an end that only the board knows.
std::string place_text(Client& client) {
  const Result<msg::GetAngles> state(client.get_angles());
  if (!state) return "";
  AxisNumbers angles;
  for (std::size_t i = 0; i < axis_names.size(); ++i) {
    angles[i] = std::round(state->axes[i].imu_angle.degrees());
  }
  return fmt::format(" It is now at {}; the board knows where it ends.", axes_text(angles, "deg"));
}

int menu(const MenuOptions& command, CLI::App& app, const CommandContext& context) {
  if (command.list) {
    list_actions();
    return success;
  }
  if (command.action.empty()) {
    throw CommandError("say which action; `sbgc menu --list` lists them", wrong_usage);
  }
  const ValueInfo& action = action_of(command.action);
  const auto words = checked_command(static_cast<msg::MenuCommand>(action.value));
  if (!words.empty()) return run_instead(app, words, command.arming, context);
  msg::ExecuteMenu request;
  request.cmd_id = static_cast<msg::MenuCommand>(action.value);
  Client client = connect(context.gimbal);
  require_possible(client, request);
  arm(command.arming,
      fmt::format("The board performs the menu action {}: {} The camera can move.{}",
                  short_name(action), action.summary, place_text(client)));
  value_of(client.run(perform(request.cmd_id, call_options(context.gimbal))));
  remark("The board has accepted {}.\n", short_name(action));
  return success;
}

}  // namespace

void add_menu(CLI::App& app, CommandContext& context) {
  const Subcommand<MenuOptions> command(app, context, "menu",
                                        "Perform an action of the menu button");
  auto& options = command.options();
  command
      ->add_option("action", options.action,
                   "Name of the action, with or without " + std::string(menu_prefix()))
      ->type_name("ACTION");
  command->add_flag("--list", options.list, "List the actions");
  command->footer(
      "Some actions belong to commands with checks: calib-acc, calib-gyro and calib-mag to `sbgc "
      "calibrate`, motor-on, motor-off and motor-toggle to `sbgc motors`, auto-pid to `sbgc "
      "tune`, and reset to `sbgc reset`.\n"
      "\n"
      "If this command dies, an action that moves the camera continues; `sbgc stop` stops it.\n"
      "\n"
      "Example:\n"
      "  sbgc menu profile2\n"
      "\n"
      "The exit status is 0 if the board accepted the action, 1 if not, 2 for wrong usage, 3 if "
      "it was sent but not confirmed.");
  command.runs([&app](const MenuOptions& given, const CommandContext& shared) {
    return menu(given, app, shared);
  });
}

}  // namespace sbgc::tools
