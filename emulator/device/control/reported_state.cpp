#include "device/control/reported_state.hpp"

#include <sbgc/meta/enums.hpp>

#include "device/calibration/auto_tuning.hpp"
#include "device/calibration/calibrations.hpp"
#include "device/calibration/frequency_response.hpp"
#include "device/control/menu.hpp"
#include "device/control/targets.hpp"
#include "device/control/tasks.hpp"
#include "device/features.hpp"
#include "device/realtime/streams.hpp"
#include "device/scripting/scripts.hpp"

namespace sbgc::emulator {

msg::StateFlags state_flags(Gimbal& gimbal, const Modes& modes, const Tuning& tuning, Instant now) {
  using enum msg::StateFlag;
  const Sample sample = gimbal.sample(now);
  msg::StateFlags flags = init_step1_done | init_step2_done;
  flags.set(startup_auto_routine_done);
  flags.set(is_frame_inverted, sample.frame_up.z < 0);
  flags.set(shake_gen_enabled, modes.shakes);
  flags.set(servo_mode_enabled, modes.servo);
  flags.set(follow_mode_roll, tuning.axes.roll.follows);
  flags.set(follow_mode_pitch, tuning.axes.pitch.follows);
  flags.set(follow_mode_yaw, tuning.axes.yaw.follows);
  flags.set(tripod_mode_enabled, modes.tripod);
  flags.set(retracted_position, modes.retracted);
  return flags;
}

msg::CalibMode calibration_mode(const ControlParts& control, const CalibrationParts& calibration) {
  if (control.tasks.is_stopping()) return msg::CalibMode::safe_stop;
  if (calibration.auto_tuning.is_running()) return msg::CalibMode::auto_pid;
  if (control.modes.is_writing_parameters) return msg::CalibMode::write_params;
  if (calibration.frequency_response.is_running()) return msg::CalibMode::bode_test;
  return calibration.calibrations.mode();
}

msg::PowerState power_state(const ControlParts& control) {
  if (control.tasks.is_stopping()) return msg::PowerState::on_safe_stop;
  return control.gimbal.motors_on() ? msg::PowerState::on : msg::PowerState::off;
}

namespace {

/// Assumption: the interval for detecting changes that no request causes.
constexpr Duration watch_period = milliseconds(20);

}  // namespace

void Events::emit(MenuParts& parts, msg::EventId id, msg::EventType type) {
  if (!knows(versions_of(parts.options), id)) return;
  msg::Event event;
  event.event_id = id;
  event.event_type = type;
  parts.streams.emit(parts.ports, event);
}

Events::State Events::state_of(const MenuParts& parts) {
  return {parts.gimbal.motors_on(), parts.gimbal.stopped_by_battery(), parts.modes.retracted,
          parts.scripts.running()};
}

void Events::watch(MenuParts& parts, Instant now) {
  next_ = parts.streams.wants_events() ? now + watch_period : Instant::never;
  const State before = state_;
  state_ = state_of(parts);
  if (next_ == Instant::never) return;
  const auto report = [&](msg::EventId id, bool was, bool is) {
    if (was != is) emit(parts, id, is ? msg::EventType::on : msg::EventType::off);
  };
  report(msg::EventId::motor_state, before.motors_on, state_.motors_on);
  report(msg::EventId::emergency_stop, before.stopped, state_.stopped);
  report(msg::EventId::retracted_position, before.retracted, state_.retracted);
  if (before.script == state_.script) return;
  if (before.script) emit(parts, msg::EventId::script, msg::EventType::off);
  if (state_.script) emit(parts, msg::EventId::script, msg::EventType::on);
}

void Events::advance(Instant now, MenuParts& parts) {
  // Detects that the battery is empty.
  static_cast<void>(parts.gimbal.sample(now));
  watch(parts, now);
}

}  // namespace sbgc::emulator
