#include "look/monitor/live_values.hpp"

#include <cstdint>
#include <limits>

#include <sbgc/text.hpp>

namespace sbgc::tools {

namespace {

constexpr double missing = std::numeric_limits<double>::quiet_NaN();

template <class T>
PerAxis degrees(const Axes<T>& angles) {
  return {angles.roll.degrees(), angles.pitch.degrees(), angles.yaw.degrees()};
}

PerAxis shares(const Axes<std::uint8_t>& powers) {
  constexpr double full = std::numeric_limits<std::uint8_t>::max();
  return {powers.roll / full, powers.pitch / full, powers.yaw / full};
}

/// Copies the values that both messages have.
template <class M>
LiveValues common_values(const M& message) {
  LiveValues values{
      .angle = degrees(message.angle),
      .target = degrees(message.rc_angle),
      .frame_angle = degrees(message.frame_imu_angle),
      .joint = {missing, missing, missing},
      .balance = {missing, missing, missing},
      .power = shares(message.motor_power),
      .rate = {message.axes.roll.gyro_data.degrees_per_second(),
               message.axes.pitch.gyro_data.degrees_per_second(),
               message.axes.yaw.gyro_data.degrees_per_second()},
      .vibration = {missing, missing, missing},
      .battery = message.bat_level.real(),
      .current = missing,
      .temperature = missing,
      .cycle_us = message.cycle_time.real(),
      .profile = message.cur_profile + 1U,
      .i2c_errors = message.i2c_error_count,
      .serial_errors = message.serial_error_cnt,
      .motors_on = message.other_flags.has(msg::OtherFlag::motors_on),
  };
  for (const ValueInfo& error : EnumMeta<msg::SystemError>::info.values) {
    if (message.system_error.has(static_cast<msg::SystemError>(error.value))) {
      values.errors.push_back(&error);
    }
  }
  if (message.system_sub_error != msg::SystemSubError{}) {
    values.sub_error = to_string(message.system_sub_error);
  }
  return values;
}

}  // namespace

LiveValues values_of(const msg::RealtimeData3& message) { return common_values(message); }

LiveValues values_of(const msg::RealtimeData4& message) {
  LiveValues values = common_values(message);
  values.joint = degrees(message.rotor_angle);
  values.balance = {message.balance_error.roll.percent(), message.balance_error.pitch.percent(),
                    message.balance_error.yaw.percent()};
  values.current = message.current.real();
  values.temperature = message.imu_temperature.real();
  if (message.calib_mode != msg::CalibMode{}) values.task = to_string(message.calib_mode);
  return values;
}

}  // namespace sbgc::tools
