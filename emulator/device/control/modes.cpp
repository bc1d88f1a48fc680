#include "device/control/modes.hpp"

#include "device/calibration/auto_tuning.hpp"
#include "device/calibration/calibrations.hpp"
#include "device/calibration/frequency_response.hpp"
#include "device/control/targets.hpp"
#include "device/control/tasks.hpp"

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

}  // namespace sbgc::emulator
