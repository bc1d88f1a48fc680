// spec/control.yaml: camera motion, motors, menu, external motion data.

#include "device/handlers.hpp"

#include <algorithm>
#include <array>
#include <initializer_list>
#include <optional>

#include <sbgc/meta/control.hpp>
#include <sbgc/validate.hpp>

#include "device/control/control_link.hpp"
#include "device/control/menu.hpp"
#include "device/control/quaternion_control.hpp"
#include "device/control/reported_state.hpp"
#include "device/control/targets.hpp"
#include "device/control/tasks.hpp"
#include "device/imu/imus.hpp"
#include "device/parameters/parameters.hpp"
#include "device/realtime/live_data.hpp"

namespace sbgc::emulator {
namespace {

/// Moves the axes that have a target.
Reaction control(RequestContext& context, ControlParts& parts, const AxisTargets& targets) {
  if (!parts.control_link.admits(context.port)) return RequestContext::ignore();
  Axes<std::optional<AxisCommand>> commands;
  bool has_task = false;
  for (std::size_t axis = 0; axis < targets.size(); ++axis) {
    const auto& target = targets[axis];
    if (!target || target->mode.mode() == msg::ControlModeKind::ignore) continue;
    commands[axis] = command_of(parts, axis, *target, context.now);
    if (!commands[axis]) {
      return context.refuse(msg::BoardErrorCode::wrong_params, target->mode.raw());
    }
    has_task = has_task || is_task(*target);
  }
  parts.quaternions.end();
  parts.modes.retracted = false;
  parts.control_link.commanded(context.now);
  for (std::size_t axis = 0; axis < commands.size(); ++axis) {
    if (commands[axis]) parts.gimbal.command(axis, *commands[axis], context.now);
  }
  if (has_task) {
    parts.tasks.confirm_end(context.port, context.command, Tasks::Kind::motion, context.now);
  }
  return parts.control_link.confirms() ? context.confirm() : Reaction::executed;
}

constexpr double degrees_per_radian = 180 / 3.14159265358979323846;

Vector in_degrees(const Xyz<msg::RadianRate>& speed) {
  return {speed.x.radians_per_second() * degrees_per_radian,
          speed.y.radians_per_second() * degrees_per_radian,
          speed.z.radians_per_second() * degrees_per_radian};
}

Quaternion quaternion(const std::array<float, 4>& wire) {
  Quaternion out{};
  for (std::size_t i = 0; i < out.size(); ++i) out[i] = static_cast<double>(wire[i]);
  return out;
}
Quaternion quaternion(msg::PackedQuaternion wire) { return unpacked(wire); }

/// Executes a form of CMD_CONTROL_QUAT if its mode is one of that form.
template <class Request>
Reaction control_attitude(RequestContext& context, ControlParts& parts, const Request& request,
                          std::initializer_list<msg::ControlQuatMode> modes) {
  if (std::find(modes.begin(), modes.end(), request.mode) == modes.end()) {
    return context.refuse(msg::BoardErrorCode::wrong_params,
                          static_cast<std::uint32_t>(request.mode));
  }
  if (!parts.control_link.admits(context.port)) return RequestContext::ignore();
  QuaternionControl::Target target{.mode = request.mode, .flags = request.flags};
  if constexpr (requires { request.target_attitude; }) {
    target.attitude = rotation_of(quaternion(request.target_attitude));
    if (!target.attitude) return context.refuse(msg::BoardErrorCode::wrong_params);
  }
  if constexpr (requires { request.target_speed; }) {
    target.speed = in_degrees(request.target_speed);
  }
  parts.control_link.commanded(context.now);
  parts.quaternions.command(parts.gimbal, parts.tuning, target, context.now);
  using Flag = msg::ControlQuatFlag;
  const bool is_attitude = request.mode == msg::ControlQuatMode::attitude;
  if (is_attitude && request.flags.has(Flag::auto_task)) {
    parts.tasks.confirm_end(context.port, context.command, Tasks::Kind::attitude, context.now);
  }
  return request.flags.has(Flag::confirm) ? context.confirm() : Reaction::executed;
}

/// True if any value is nonzero, as zeros mean unused. The values themselves do not matter, because
/// the simulation knows the frame. Assumption: an unknown COORD_SYS counts as the default one.
bool is_help(const msg::HelperDataExt& data) {
  return data.frame_acc != Xyz<msg::Acceleration>{} || data.frame_angle_roll != msg::Angle14{} ||
         data.frame_angle_pitch != msg::Angle14{} || data.frame_speed != Xyz<msg::GyroRate>{} ||
         data.coord_sys.flags().has(msg::HelperDataFlag::use_frame_heading);
}

}  // namespace

Reaction handle(RequestContext& context, const msg::ControlExt& request, ControlParts& parts) {
  AxisTargets targets;
  for (std::size_t axis = 0; axis < targets.size(); ++axis) {
    const msg::Angle14 angle = request.axes[axis].angle;
    targets[axis] = {request.control_mode[axis], request.real_speed(axis), angle.degrees(),
                     angle.raw()};
  }
  return control(context, parts, targets);
}

Reaction handle(RequestContext& context, const msg::ControlExtCommand& request,
                ControlParts& parts) {
  return control(context, parts, targets_of(request));
}

Reaction handle(RequestContext& context, const msg::ControlConfig& request,
                ControlLink& control_link, Modes& modes, Parameters& parameters) {
  if (!is_valid(request)) return context.refuse(msg::BoardErrorCode::wrong_params);
  control_link.configure(modes, request, context.port, context.now);
  parameters.apply_later();
  // Confirms the configuration itself unless the host wants no confirmations.
  return control_link.confirms() ? context.confirm() : Reaction::executed;
}

Reaction handle(RequestContext& context, const msg::ControlQuatDisabled& request,
                QuaternionControl&, ControlParts& parts) {
  return control_attitude(context, parts, request, {msg::ControlQuatMode::disabled});
}
Reaction handle(RequestContext& context, const msg::ControlQuatSpeed& request, QuaternionControl&,
                ControlParts& parts) {
  return control_attitude(context, parts, request,
                          {msg::ControlQuatMode::speed, msg::ControlQuatMode::speed_limited});
}
Reaction handle(RequestContext& context, const msg::ControlQuatAttitude& request,
                QuaternionControl&, ControlParts& parts) {
  return control_attitude(context, parts, request, {msg::ControlQuatMode::attitude});
}
Reaction handle(RequestContext& context, const msg::ControlQuatAttitudePacked& request,
                QuaternionControl&, ControlParts& parts) {
  return control_attitude(context, parts, request, {msg::ControlQuatMode::attitude});
}
Reaction handle(RequestContext& context, const msg::ControlQuatSpeedAttitude& request,
                QuaternionControl&, ControlParts& parts) {
  return control_attitude(context, parts, request, {msg::ControlQuatMode::speed_attitude});
}
Reaction handle(RequestContext& context, const msg::ControlQuatSpeedAttitudePacked& request,
                QuaternionControl&, ControlParts& parts) {
  return control_attitude(context, parts, request, {msg::ControlQuatMode::speed_attitude});
}
Reaction handle(RequestContext& context, const msg::ControlQuatStatusRequest& request,
                const QuaternionControl& quaternions, Gimbal& gimbal, const Tuning& tuning) {
  return context.answer(quaternions.status(gimbal, tuning, request.data_set, context.now));
}
Reaction handle(RequestContext& context, const msg::ControlQuatConfig& request,
                QuaternionControl& quaternions) {
  quaternions.configure(request);
  return context.confirm();
}

Reaction handle(RequestContext& context, const msg::GetAnglesRequest&, Gimbal& gimbal) {
  return context.answer(angles(gimbal, context.now));
}

Reaction handle(RequestContext& context, const msg::GetAnglesExtRequest&, Gimbal& gimbal,
                const Imus& imus, const BoardOptions& options) {
  return context.answer(angles(gimbal, knows_joints(options, imus), context.now));
}

Reaction handle(RequestContext& context, const msg::MotorsOn&, Tasks& tasks, Gimbal& gimbal) {
  tasks.set_motors(gimbal, true, context.now);
  // An empty battery keeps the motors off.
  if (gimbal.stopped_by_battery()) return context.refuse(msg::BoardErrorCode::wrong_state);
  return context.confirm();
}

// Assumption: brakes are as strong as the friction of a motor without current.
Reaction handle(RequestContext& context, const msg::MotorsOffExt& request, Tasks& tasks,
                Gimbal& gimbal) {
  switch (request.mode) {
    case msg::MotorsOffMode::normal:
    case msg::MotorsOffMode::brake: tasks.set_motors(gimbal, false, context.now); break;
    case msg::MotorsOffMode::safe_stop: tasks.stop_safely(gimbal, context.now); break;
    default:
      return context.refuse(msg::BoardErrorCode::wrong_params,
                            static_cast<std::uint32_t>(request.mode));
  }
  return context.confirm();
}

Reaction handle(RequestContext& context, const msg::ExecuteMenuExt& request, MenuParts& parts) {
  if (!execute_menu(parts, request.cmd_id, context.now)) {
    return context.refuse(msg::BoardErrorCode::wrong_params,
                          static_cast<std::uint32_t>(request.cmd_id));
  }
  using Flag = msg::ExecuteMenuFlag;
  const bool confirms_end = request.param.has(Flag::confirm_on_finish);
  if (confirms_end) {
    parts.tasks.confirm_end(context.port, context.command, Tasks::Kind::action, context.now);
  }
  return request.param.has(Flag::confirm) || !confirms_end ? context.confirm() : Reaction::executed;
}

Reaction handle(RequestContext& context, const msg::SyncMotors& request, Tasks& tasks,
                Gimbal& gimbal) {
  const auto axis = static_cast<std::size_t>(request.axis);
  if (axis >= Axes<int>::size()) return context.refuse(msg::BoardErrorCode::wrong_params);
  // Assumption: the unit of ANGLE, which no source gives, is that of Angle14.
  const double degrees = request.angle * msg::LongAngle14(1).degrees();
  tasks.synchronize(gimbal, axis, degrees, milliseconds(request.time_ms.raw()), context.now);
  return context.confirm();
}

Reaction handle(RequestContext& context, const msg::HelperDataExt& request, Gimbal& gimbal) {
  if (is_help(request)) gimbal.help(context.now);
  return context.confirm();
}

}  // namespace sbgc::emulator
