// spec/control.yaml: camera motion, motors, menu, external motion data.

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <optional>

#include <sbgc/meta/enums.hpp>

#include "device/device.hpp"
#include "device/handlers.hpp"
#include "device/known_values.hpp"
#include "device/parts/live_data.hpp"
#include "device/parts/menu.hpp"

namespace sbgc::emulator {
namespace {

std::optional<AxisMode> mode_of(msg::ControlModeKind kind) {
  switch (kind) {
    case msg::ControlModeKind::no_control: return AxisMode::remote;
    case msg::ControlModeKind::speed: return AxisMode::speed;
    case msg::ControlModeKind::angle: return AxisMode::angle;
    case msg::ControlModeKind::speed_angle: return AxisMode::speed_angle;
    case msg::ControlModeKind::rc: return AxisMode::signal;
    case msg::ControlModeKind::angle_rel_frame: return AxisMode::relative_angle;
    case msg::ControlModeKind::rc_high_res: return AxisMode::signal;
    case msg::ControlModeKind::ignore: return AxisMode::remote;
    case msg::ControlModeKind::angle_shortest: return AxisMode::angle;
  }
  return {};
}

/// The speed in degrees per second. Firmware that does not know the unit flag ignores it.
template <class Request>
double speed_of(const Availability& versions, const Request& request, std::size_t axis) {
  return knows(versions, msg::ControlFlag::high_res_speed)
             ? request.real_speed(axis)
             : request.axes[axis].speed.degrees_per_second();
}

/// Returns nothing if there is no such mode.
std::optional<AxisCommand> command_of(msg::ControlMode mode, const msg::ControlAxis& target,
                                      double speed) {
  const auto axis_mode = mode_of(mode.mode());
  if (!axis_mode) return {};
  AxisCommand command{*axis_mode};
  command.speed = speed;
  // The angle determines the direction, so the sign of the speed is ignored.
  if (*axis_mode == AxisMode::angle || *axis_mode == AxisMode::relative_angle) {
    command.speed = std::abs(command.speed);
  }
  command.angle = target.angle.degrees();
  // "Should be in range -500...500": like the signal of a receiver, it saturates.
  command.signal = std::clamp(msg::CentredRcSignal(target.angle.raw()).fraction(), -1.0, 1.0);
  return command;
}

template <class Request>
Outcome control(RequestContext& context, const Request& request,
                const Axes<msg::ControlMode>& modes) {
  Axes<AxisCommand> commands;
  for (std::size_t axis = 0; axis < commands.size(); ++axis) {
    const auto command =
        command_of(modes[axis], request.axes[axis], speed_of(context.versions(), request, axis));
    if (!command) return context.refuse(msg::BoardErrorCode::wrong_params, modes[axis].raw());
    commands[axis] = *command;
    if (command->mode == AxisMode::signal) {
      commands[axis].signal = RemoteControl::shaped(
          context.device.parameters.of<msg::ReadParams3>(), axis, command->signal);
    }
  }
  for (std::size_t axis = 0; axis < commands.size(); ++axis) {
    context.device.gimbal.command(axis, commands[axis], context.now);
  }
  return context.confirm();
}

Outcome turn_motors(RequestContext& context, bool on) {
  context.device.set_motors(on, context.now);
  // An empty battery keeps the motors off.
  if (on && context.device.gimbal.stopped_by_battery())
    return context.refuse(msg::BoardErrorCode::wrong_state);
  return context.confirm();
}

Outcome execute(RequestContext& context, msg::MenuCommand action) {
  if (execute_menu(context.device, action, context.now)) return context.confirm();
  return context.refuse(msg::BoardErrorCode::wrong_params, static_cast<std::uint32_t>(action));
}

/// True if any value is nonzero, as zeros mean unused. The values themselves do not matter, because
/// the simulation knows the frame.
template <class Data>
bool is_help(const Data& data) {
  bool is_used = data.frame_acc != Xyz<msg::Acceleration>{} ||
                 data.frame_angle_roll != msg::Angle14{} ||
                 data.frame_angle_pitch != msg::Angle14{};
  if constexpr (requires { data.frame_speed; }) {
    is_used = is_used || data.frame_speed != Xyz<msg::GyroRate>{};
  }
  return is_used;
}

/// Assumption: an unknown COORD_SYS counts as the default one.
template <class Data>
Outcome help(RequestContext& context, const Data& data) {
  if (is_help(data)) context.device.gimbal.help(context.now);
  return context.confirm();
}

}  // namespace

Outcome handle(RequestContext& context, const msg::Control& request) {
  const msg::ControlMode mode = request.control_mode;
  return control(context, request, {mode, mode, mode});
}

Outcome handle(RequestContext& context, const msg::ControlExt& request) {
  return control(context, request, request.control_mode);
}

Outcome handle(RequestContext& context, const msg::GetAnglesRequest& /*request*/) {
  msg::GetAngles data;
  measure(context.device, context.now, data);
  return context.answer(data);
}

Outcome handle(RequestContext& context, const msg::GetAnglesExtRequest& /*request*/) {
  msg::GetAnglesExt data;
  measure(context.device, context.now, data);
  return context.answer(data);
}

Outcome handle(RequestContext& context, const msg::MotorsOn& /*request*/) {
  return turn_motors(context, true);
}

Outcome handle(RequestContext& context, const msg::MotorsOff& /*request*/) {
  return turn_motors(context, false);
}

// Assumption: braking and a safe stop end like a normal stop, without motor current.
Outcome handle(RequestContext& context, const msg::MotorsOffExt& request) {
  switch (request.mode) {
    case msg::MotorsOffMode::normal:
    case msg::MotorsOffMode::brake:
    case msg::MotorsOffMode::safe_stop: return turn_motors(context, false);
  }
  return context.refuse(msg::BoardErrorCode::wrong_params,
                        static_cast<std::uint32_t>(request.mode));
}

Outcome handle(RequestContext& context, const msg::ExecuteMenu& request) {
  return execute(context, request.cmd_id);
}

Outcome handle(RequestContext& context, const msg::ExecuteMenuExt& request) {
  return execute(context, request.cmd_id);
}

Outcome handle(RequestContext& context, const msg::HelperData& request) {
  return help(context, request);
}

Outcome handle(RequestContext& context, const msg::HelperDataExt& request) {
  return help(context, request);
}

}  // namespace sbgc::emulator
