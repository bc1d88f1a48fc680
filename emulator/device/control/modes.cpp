#include "device/control/modes.hpp"

#include "device/device.hpp"

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

msg::CalibMode calibration_mode(const Device& device) {
  using Kind = Calibrations::Kind;
  if (device.tasks.is_stopping()) return msg::CalibMode::safe_stop;
  if (device.auto_tuning.is_running()) return msg::CalibMode::auto_pid;
  if (device.modes.is_writing_parameters) return msg::CalibMode::write_params;
  const auto kind = device.calibrations.under_way();
  if (!kind) return msg::CalibMode::none;
  switch (*kind) {
    case Kind::gyro:
    case Kind::gyro_from_sensor:
    case Kind::gyro_to_sensor: return msg::CalibMode::gyro;
    case Kind::acc:
    case Kind::acc_from_sensor:
    case Kind::acc_to_sensor: return msg::CalibMode::acc;
    case Kind::gyro_temperature: return msg::CalibMode::gyro_temp;
    case Kind::acc_temperature: return msg::CalibMode::acc_temp;
    case Kind::mag: return msg::CalibMode::mag;
    case Kind::ext_gain: return msg::CalibMode::ext_gain;
    case Kind::poles: return msg::CalibMode::poles;
    case Kind::encoder_offset: return msg::CalibMode::encoder_offset;
    case Kind::encoder_field: return msg::CalibMode::encoder_fld_offset;
    case Kind::orientation: return msg::CalibMode::imu_orientation_corr;
    case Kind::cogging: return msg::CalibMode::cogging;
    case Kind::acc_reference: return msg::CalibMode::acc_ext_ref;
    case Kind::momentum: return msg::CalibMode::momentum;
  }
  return msg::CalibMode::none;
}

msg::PowerState power_state(const Device& device) {
  if (device.tasks.is_stopping()) return msg::PowerState::on_safe_stop;
  return device.gimbal.motors_on() ? msg::PowerState::on : msg::PowerState::off;
}

}  // namespace sbgc::emulator
