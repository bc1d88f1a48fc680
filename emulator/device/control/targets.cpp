#include "device/control/targets.hpp"

#include <algorithm>
#include <cmath>

#include "device/control/reported_state.hpp"
#include "device/parameters/parameters.hpp"
#include "device/peripherals/remote_control.hpp"

namespace sbgc::emulator {
namespace {

/// Returns the mode that a command sets. MODE_IGNORE sets none and is handled before.
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
    default: return {};
  }
}

/// Sets the signal of modes that control an axis like a receiver.
void set_signal(const msg::ReadParams3& parameters, std::size_t axis, const AxisTarget& target,
                AxisCommand& command) {
  const auto raw =
      static_cast<std::int16_t>(std::clamp<std::int32_t>(target.signal, -32768, 32767));
  const bool is_fine = target.mode.mode() == msg::ControlModeKind::rc_high_res;
  const double signal =
      is_fine ? msg::FineRcSignal(raw).fraction() : msg::CentredRcSignal(raw).fraction();
  // The same values as those of virtual channels.
  command.is_lost =
      raw == (is_fine ? msg::ApiVirtChHighRes::undefined : msg::ApiVirtChControl::undefined);
  // "Should be in range -500...500": like the signal of a receiver, it saturates.
  command.signal = RemoteControl::shaped(parameters, axis, std::clamp(signal, -1.0, 1.0));
  // FORCE_RC_SPEED, which has the bit of AUTO_TASK.
  if (!target.mode.flags().has(msg::ControlFlag::auto_task) || command.is_lost) return;
  command.mode = AxisMode::speed;
  command.speed = command.signal * parameters.rc[axis].rc_speed;
}

/// One axis of CMD_CONTROL_EXT; nothing if the request has no data for it.
std::optional<AxisTarget> target_of(const msg::ControlExtAxis& axis) {
  if (!axis.mode) return {};
  AxisTarget target{.mode = *axis.mode};
  if (axis.speed) {
    target.speed = axis.mode->flags().has(msg::ControlFlag::high_res_speed)
                       ? msg::FineSpeed(axis.speed->raw()).degrees_per_second()
                       : axis.speed->degrees_per_second();
  }
  if (axis.speed_32) target.speed = axis.speed_32->degrees_per_second();
  if (axis.angle) {
    target.angle = axis.angle->degrees();
    target.signal = axis.angle->raw();
  }
  if (axis.angle_32) {
    target.angle = axis.angle_32->degrees();
    target.signal = axis.angle_32->raw();
  }
  return target;
}

}  // namespace

AxisTargets targets_of(const msg::ControlExtCommand& r) {
  return {target_of(r.axes.roll), target_of(r.axes.pitch), target_of(r.axes.yaw)};
}

std::optional<AxisCommand> command_of(const ControlParts& parts, std::size_t axis,
                                      const AxisTarget& target, Instant now) {
  const auto axis_mode = mode_of(target.mode.mode());
  if (!axis_mode) return {};
  AxisCommand command{*axis_mode};
  command.speed = target.speed;
  command.angle = target.angle;
  if (target.mode.mode() == msg::ControlModeKind::angle_shortest) {
    constexpr double turn = 360;
    const double from = parts.gimbal.sample(now).targets[axis];
    command.angle = from + std::remainder(target.angle - from, turn);
  }
  // In servo mode, angles are those of the motors.
  if (command.mode == AxisMode::angle && parts.modes.servo) command.mode = AxisMode::relative_angle;
  // The angle determines the direction, so the sign of the speed is ignored.
  if (command.mode == AxisMode::angle || command.mode == AxisMode::relative_angle) {
    command.speed = std::abs(command.speed);
    if (target.mode.flags().has(msg::ControlFlag::auto_task)) {
      command.speed = parts.parameters.of<msg::ReadParamsExt2>().auto_speed;
    }
  }
  if (command.mode == AxisMode::signal)
    set_signal(parts.parameters.of<msg::ReadParams3>(), axis, target, command);
  return command;
}

bool is_task(const AxisTarget& target) {
  const msg::ControlModeKind mode = target.mode.mode();
  return target.mode.flags().has(msg::ControlFlag::auto_task) &&
         (mode == msg::ControlModeKind::angle || mode == msg::ControlModeKind::angle_rel_frame);
}

}  // namespace sbgc::emulator
