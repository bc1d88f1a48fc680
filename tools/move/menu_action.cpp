#include "move/menu_action.hpp"

#include <algorithm>
#include <array>

#include <sbgc/client/profiles.hpp>
#include <sbgc/internal/words.hpp>
#include <sbgc/messages/control.hpp>
#include <sbgc/meta/enums.hpp>

namespace sbgc::tools {

namespace {

constexpr std::array profiles{msg::MenuCommand::profile1, msg::MenuCommand::profile2,
                              msg::MenuCommand::profile3, msg::MenuCommand::profile4,
                              msg::MenuCommand::profile5};

}  // namespace

std::span<const ValueInfo> menu_actions() { return EnumMeta<msg::MenuCommand>::info.values; }

std::string_view menu_prefix() {
  std::string_view prefix = menu_actions().front().name;
  for (const ValueInfo& action : menu_actions()) {
    const std::string_view name = action.name;
    const auto* const end =
        std::mismatch(prefix.begin(), prefix.end(), name.begin(), name.end()).first;
    prefix = prefix.substr(0, static_cast<std::size_t>(end - prefix.begin()));
  }
  return prefix.substr(0, prefix.rfind('_') + 1);
}

std::string short_name(const ValueInfo& action) {
  return detail::lower_case(std::string_view(action.name).substr(menu_prefix().size()));
}

std::string without_dashes(std::string word) {
  std::replace(word.begin(), word.end(), '-', '_');
  return word;
}

const ValueInfo* menu_action(std::string_view word) {
  const std::string bare = without_dashes(std::string(word));
  for (const ValueInfo& action : menu_actions()) {
    if (detail::is_same_word(bare, short_name(action)) || detail::is_same_word(word, action.name))
      return &action;
  }
  return nullptr;
}

Task<Result<void>> perform(msg::MenuCommand action, CallOptions options) {
  const TaskMachine& task = co_await tasks::this_task();
  Result<void> done;
  if (is_supported<msg::ExecuteMenuExt>(task.identity().versions())) {
    msg::ExecuteMenuExt request;
    request.cmd_id = action;
    request.param = msg::ExecuteMenuFlag::confirm;
    done = co_await tasks::call(request, confirming(options));
  } else {
    done = co_await tasks::call(msg::ExecuteMenu{.cmd_id = action}, confirming(options));
  }
  // It may have been done, even if a requested confirmation is missing.
  if (!done && done.error().code == ErrorCode::timeout) {
    done = ClientError{ErrorCode::unconfirmed, done.error().message};
  }
  const auto* const wanted = std::find(profiles.begin(), profiles.end(), action);
  const bool is_unknown = !done && done.error().code == ErrorCode::unconfirmed;
  if (!is_unknown || wanted == profiles.end()) co_return done;
  const Result<std::size_t> active = co_await tasks::active_profile();
  const bool is_it = active && *active == static_cast<std::size_t>(wanted - profiles.begin());
  co_return is_it ? Result<void>() : done;
}

std::vector<std::string> checked_command(msg::MenuCommand action) {
  switch (action) {
    case msg::MenuCommand::calib_acc: return {"calibrate", "acc"};
    case msg::MenuCommand::calib_acc_temp: return {"calibrate", "acc", "--temperature"};
    case msg::MenuCommand::calib_gyro: return {"calibrate", "gyro"};
    case msg::MenuCommand::calib_gyro_temp: return {"calibrate", "gyro", "--temperature"};
    case msg::MenuCommand::calib_mag: return {"calibrate", "mag"};
    case msg::MenuCommand::motor_on: return {"motors", "on"};
    case msg::MenuCommand::motor_off: return {"motors", "off"};
    case msg::MenuCommand::motor_toggle: return {"motors", "toggle"};
    case msg::MenuCommand::auto_pid: return {"tune"};
    case msg::MenuCommand::reset: return {"reset"};
    default: return {};
  }
}

}  // namespace sbgc::tools
