#include "factory.hpp"

#include <string>

namespace sbgc::board {
namespace {

constexpr std::size_t axes = Axes<int>::size();

void set_motors(ReadParams3& out) {
  constexpr std::uint8_t poles = 14;
  out.axes.roll = {.p = 12, .i = Hundredths(10), .d = 12, .power = 80, .invert = 0, .poles = poles};
  out.axes.pitch = {
      .p = 14, .i = Hundredths(12), .d = 14, .power = 90, .invert = 0, .poles = poles};
  out.axes.yaw = {.p = 18, .i = Hundredths(14), .d = 18, .power = 110, .invert = 0, .poles = poles};
  out.output = {MotorOutput::roll, MotorOutput::pitch, MotorOutput::yaw};
  out.pwm_freq = PwmFrequency::high;
  out.booster_power = {40, 40, 40};
}

void set_remote_control(ReadParams3& out) {
  for (std::size_t axis = 0; axis < axes; ++axis) {
    out.rc[axis].rc_lpf = 2;
    out.rc[axis].rc_speed = 50;
    out.follow_speed[axis] = 40;
    out.follow_lpf[axis] = 4;
  }
  out.rc.roll.rc_min_angle = Degrees::from_degrees(-30);
  out.rc.roll.rc_max_angle = Degrees::from_degrees(30);
  out.rc.pitch.rc_min_angle = Degrees::from_degrees(-90);
  out.rc.pitch.rc_max_angle = Degrees::from_degrees(45);
  out.rc.yaw.rc_min_angle = Degrees::from_degrees(-180);
  out.rc.yaw.rc_max_angle = Degrees::from_degrees(180);
  out.rc_map = {RcInput::rc_input_roll, RcInput::rc_input_pitch, RcInput::rc_input_yaw};
  out.rc_deadband = 10;
  out.follow_deadband = 2;
  out.follow_roll_mix_start = SmallDegrees::from_degrees(0);
  out.follow_roll_mix_range = SmallDegrees::from_degrees(90);
  out.menu_cmd = {MenuCommand::profile1, MenuCommand::profile2, MenuCommand::profile3,
                  MenuCommand::calib_acc, MenuCommand::calib_gyro};
  out.menu_cmd_long = MenuCommand::motor_toggle;
}

void set_sensors(ReadParams3& out) {
  out.gyro_trust = 120;
  out.axis_top = SensorAxis::z;
  out.axis_right = SensorAxis::x;
  out.frame_axis_top = SensorAxis::z;
  out.frame_axis_right = SensorAxis::x;
  out.frame_imu_pos = FrameImuPosition::below_yaw;
  out.i2c_internal_pullups = 1;
  out.skip_gyro_calib = SkipGyroCalibration::skip_always;
}

}  // namespace

template <>
ReadParams3 factory_settings(std::uint8_t copy) {
  ReadParams3 out;
  out.profile_id = copy;
  set_motors(out);
  set_remote_control(out);
  set_sensors(out);
  out.serial_speed = SerialSpeed::baud_115200;
  out.bat_threshold_alarm = VoltageThreshold::from_volts(14.0);
  out.bat_threshold_motors = VoltageThreshold::from_volts(13.2);
  out.bat_comp_ref = VoltageThreshold::from_volts(16.0);
  out.beeper_modes =
      BeeperMode::calibrate | BeeperMode::confirm | BeeperMode::error | BeeperMode::alarm;
  out.servo_rate = ServoRate::from_hertz(50);
  out.adaptive_pid_threshold = 10;
  out.adaptive_pid_rate = 10;
  out.adaptive_pid_recovery_factor = 5;
  out.cur_imu = SelectedImu::main;
  out.cur_profile_id = copy;
  return out;
}

template <>
ReadParamsExt factory_settings(std::uint8_t copy) {
  ReadParamsExt out;
  out.profile_id = copy;
  for (std::size_t axis = 0; axis < axes; ++axis) {
    out.lpf_freq[axis] = Frequency::from_hertz(120);
    out.filters_en[axis] = FilterSwitch::lpf;
    out.motor_mag_link[axis] = 100;
    out.motor_gearing[axis] = FixedPoint8::from_value(1);
    out.encoder_gear_ratio[axis] = Thousandths::from_value(1);
    out.outer_p[axis] = 100;
    out.outer_i[axis] = 10;
    out.d_term_lpf_freq[axis] = CoarseFrequency::from_hertz(200);
  }
  out.beeper_volume = 100;
  out.mag_axis_top = SensorAxis::z;
  out.mag_axis_right = SensorAxis::x;
  out.mag_trust = 50;
  out.acc_lpf_freq = FineFrequency::from_hertz(5);
  return out;
}

template <>
ReadParamsExt2 factory_settings(std::uint8_t copy) {
  ReadParamsExt2 out;
  out.profile_id = copy;
  for (std::size_t axis = 0; axis < axes; ++axis) {
    out.motor_mag_link_fine[axis] = LongHundredths::from_value(100);
    out.pid_gain[axis] = PidGain::from_value(1);
  }
  out.frame_imu_lpf_freq = SmallFrequency::from_hertz(60);
  out.auto_pid_cfg =
      AutoPidFlag::roll | AutoPidFlag::pitch | AutoPidFlag::yaw | AutoPidFlag::send_gui;
  out.auto_pid_gain = 127;
  return out;
}

template <>
ReadProfileNames factory_settings(std::uint8_t) {
  ReadProfileNames out;
  std::size_t number = 1;
  for (auto& name : out.profile_name) {
    static_cast<void>(name.assign("Profile " + std::to_string(number++)));  // short enough
  }
  return out;
}

template <>
ReadAdjVarsCfg factory_settings(std::uint8_t) {
  return {};
}

template <>
ReadExternalData factory_settings(std::uint8_t) {
  ReadExternalData out;
  out.data.fill(0xFF);  // as erased memory
  return out;
}

}  // namespace sbgc::board
