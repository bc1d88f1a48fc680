// Moving the camera.

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <optional>

#include <sbgc/meta/enums.hpp>

#include "device/known_values.hpp"
#include "device/handlers.hpp"
#include "device/device.hpp"

namespace sbgc::board {
namespace {

std::optional<AxisMode> mode_of(msg::ControlModeKind kind) {
  switch (kind) {
    case msg::ControlModeKind::no_control: return AxisMode::remote;
    case msg::ControlModeKind::speed: return AxisMode::speed;
    case msg::ControlModeKind::angle: return AxisMode::angle;
    case msg::ControlModeKind::speed_angle: return AxisMode::speed_angle;
    case msg::ControlModeKind::rc: return AxisMode::signal;
    case msg::ControlModeKind::angle_rel_frame: return AxisMode::relative_angle;
  }
  return {};
}

/// Nothing if there is no such mode.
std::optional<AxisCommand> command_of(const Availability& versions, msg::ControlMode mode,
                                      const msg::ControlAxis& target) {
  const auto axis_mode = mode_of(mode.mode());
  if (!axis_mode) return {};
  // Firmware that does not know the flag does not look at it.
  const bool is_fine = mode.flags().has(msg::ControlFlag::high_res_speed) &&
                       knows(versions, msg::ControlFlag::high_res_speed);
  AxisCommand command{*axis_mode};
  command.speed = is_fine ? msg::FineSpeed(target.speed.raw()).degrees_per_second()
                          : target.speed.degrees_per_second();
  // Where the angle says the direction, the speed is a size.
  if (*axis_mode == AxisMode::angle || *axis_mode == AxisMode::relative_angle) {
    command.speed = std::abs(command.speed);
  }
  command.angle = target.angle.degrees();
  // "Should be in range -500...500": beyond it the signal stays at its end, as that of a receiver.
  command.signal = std::clamp(msg::CentredRcSignal(target.angle.raw()).fraction(), -1.0, 1.0);
  return command;
}

Outcome control(Turn& turn, const Axes<msg::ControlMode>& modes,
                const Axes<msg::ControlAxis>& targets) {
  Axes<AxisCommand> commands;
  for (std::size_t axis = 0; axis < commands.size(); ++axis) {
    const auto command = command_of(turn.versions(), modes[axis], targets[axis]);
    if (!command) return turn.refuse(msg::BoardErrorCode::wrong_params, modes[axis].raw());
    commands[axis] = *command;
    if (command->mode == AxisMode::signal) {
      commands[axis].signal =
          Remote::bent(turn.machine.settings.of<msg::ReadParams3>(), axis, command->signal);
    }
  }
  for (std::size_t axis = 0; axis < commands.size(); ++axis) {
    turn.machine.gimbal.command(axis, commands[axis], turn.now);
  }
  return turn.confirm();
}

Outcome turn_motors(Turn& turn, bool on) {
  turn.machine.set_motors(on, turn.now);
  // An empty battery keeps them off.
  if (on && turn.machine.gimbal.stopped_by_battery())
    return turn.refuse(msg::BoardErrorCode::wrong_state);
  return turn.confirm();
}

Outcome execute(Turn& turn, msg::MenuCommand action) {
  if (turn.machine.execute(action, turn.now)) return turn.confirm();
  return turn.refuse(msg::BoardErrorCode::wrong_params, static_cast<std::uint32_t>(action));
}

/// Zeros are not used, so that a message of zeros is no help. Nothing else of what it tells matters
/// to the simulation, which knows the frame.
template <class Data>
bool is_help(const Data& data) {
  bool tells = data.frame_acc != Xyz<msg::Acceleration>{} ||
               data.frame_angle_roll != msg::Angle14{} || data.frame_angle_pitch != msg::Angle14{};
  if constexpr (requires { data.frame_speed; }) {
    tells = tells || data.frame_speed != Xyz<msg::GyroRate>{};
  }
  return tells;
}

/// Ours: an unknown COORD_SYS counts as the usual one.
template <class Data>
Outcome help(Turn& turn, const Data& data) {
  if (is_help(data)) turn.machine.gimbal.help(turn.now);
  return turn.confirm();
}

}  // namespace

Outcome handle(Turn& turn, const msg::Control& request) {
  const msg::ControlMode mode = request.control_mode;
  return control(turn, {mode, mode, mode}, request.axes);
}

Outcome handle(Turn& turn, const msg::ControlExt& request) {
  return control(turn, request.control_mode, request.axes);
}

Outcome handle(Turn& turn, const msg::MotorsOn& /*request*/) { return turn_motors(turn, true); }

Outcome handle(Turn& turn, const msg::MotorsOff& /*request*/) { return turn_motors(turn, false); }

// Ours: braking and a safe stop end as turning them off does, with motors without current.
Outcome handle(Turn& turn, const msg::MotorsOffExt& request) {
  switch (request.mode) {
    case msg::MotorsOffMode::normal:
    case msg::MotorsOffMode::brake:
    case msg::MotorsOffMode::safe_stop: return turn_motors(turn, false);
  }
  return turn.refuse(msg::BoardErrorCode::wrong_params, static_cast<std::uint32_t>(request.mode));
}

Outcome handle(Turn& turn, const msg::ExecuteMenu& request) {
  return execute(turn, request.cmd_id);
}

Outcome handle(Turn& turn, const msg::ExecuteMenuExt& request) {
  return execute(turn, request.cmd_id);
}

Outcome handle(Turn& turn, const msg::HelperData& request) { return help(turn, request); }

Outcome handle(Turn& turn, const msg::HelperDataExt& request) { return help(turn, request); }

Outcome handle(Turn& turn, const msg::ApiVirtChControl& request) {
  turn.machine.remote.set_channels(turn.machine, request, turn.now);
  return turn.confirm();
}

}  // namespace sbgc::board
