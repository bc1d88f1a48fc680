#include <algorithm>
#include <cmath>
#include <limits>

#include <sbgc/doctor/measurements.hpp>

namespace sbgc::doctor {

template <class M>
void Measurements::add_common(const M& data) {
  errors = errors | data.system_error;
  if (data.system_sub_error != msg::SystemSubError{}) sub_error = data.system_sub_error;
  i2c.add(data.i2c_error_count);
  serial.add(data.serial_error_cnt);
  constexpr double full = std::numeric_limits<std::uint8_t>::max();
  for (std::size_t axis = 0; axis < power.size(); ++axis) {
    power[axis].add(100 * data.motor_power[axis] / full);
  }
  cycle.add(data.cycle_time.real());
  const double volts = data.bat_level.volts();
  lowest_battery = std::min(lowest_battery.value_or(volts), volts);
  const bool is_on = data.other_flags.has(msg::OtherFlag::motors_on);
  has_motors_on = messages == 0 ? is_on : has_motors_on && is_on;
  profile = data.cur_profile + 1U;
  ++messages;
}

template void Measurements::add_common(const msg::RealtimeData3& data);

void Measurements::add(const msg::RealtimeData4& data) {
  add_common(data);
  for (std::size_t axis = 0; axis < balance.size(); ++axis) {
    balance[axis].add(std::abs(data.balance_error[axis].percent()));
  }
  gravity_error.add(data.imu_g_err.degrees());
  if (data.calib_mode != msg::CalibMode{}) task = data.calib_mode;
}

void Measurements::add(const SessionStatistics& session) {
  damaged_share = line_quality(session).damaged;
  unanswered = session.timeouts;
}

std::optional<Axes<AxisVibration>> Measurements::vibration() const {
  if (!gyro || !gyro->is_usable()) return {};
  Axes<AxisVibration> result;
  for (std::size_t axis = 0; axis < result.size(); ++axis) {
    const analysis::Vibration first = analysis::vibration_of(gyro->axis(axis), gyro->rate());
    if (!first.is_known()) return {};
    analysis::Vibration second;
    if (again && again->is_usable())
      second = analysis::vibration_of(again->axis(axis), again->rate());
    result[axis] = {first.rms, frequencies_of(first, second)};
  }
  return result;
}

}  // namespace sbgc::doctor
