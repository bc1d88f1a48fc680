#include "move/motor_state.hpp"

#include <sbgc/messages/realtime.hpp>
#include <sbgc/meta/enums.hpp>

#include "board/connection.hpp"

namespace sbgc::tools {

Result<bool> are_motors_on(Client& client) {
  const Result<msg::RealtimeData3> state = client.call(msg::RealtimeData3Request{});
  if (!state) return state.error();
  return state->other_flags.has(msg::OtherFlag::motors_on);
}

void require_motors(Client& client) {
  if (value_of(are_motors_on(client))) return;
  throw CommandError("the motors are off; `sbgc motors on` turns them on");
}

std::string current_errors(Client& client) {
  const Result<msg::RealtimeData3> state = client.call(msg::RealtimeData3Request{});
  if (!state) return "";
  std::string names;
  for (const ValueInfo& error : EnumMeta<msg::SystemError>::info.values) {
    if (!state->system_error.has(static_cast<msg::SystemError>(error.value))) continue;
    names += (names.empty() ? "" : ", ") + std::string(error.name);
  }
  return names;
}

}  // namespace sbgc::tools
