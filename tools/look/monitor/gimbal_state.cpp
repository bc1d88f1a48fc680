#include "look/monitor/gimbal_state.hpp"

#include <cstdint>
#include <limits>
#include <utility>

#include <sbgc/analysis/vibration.hpp>
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

/// Takes what both messages have.
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

/// Adds the vibration in the rates of the gyroscope, `rate` of them per second. They are taken for
/// evenly distributed.
void add_vibration(LiveValues& values, const std::deque<PerAxis>& rates, double rate) {
  std::vector<double> samples(rates.size());
  for (std::size_t axis = 0; axis < values.vibration.size(); ++axis) {
    for (std::size_t i = 0; i < rates.size(); ++i) samples[i] = rates[i][axis];
    const analysis::Vibration found = analysis::vibration_of(samples, rate);
    if (!found.is_known()) return;
    values.vibration[axis] = found.rms;
    values.slowest_vibration = found.slowest;
    values.fastest_vibration = found.fastest;
  }
}

}  // namespace

void GimbalState::add(const LiveMessage& message) {
  using Clock = std::chrono::steady_clock;
  constexpr std::chrono::seconds window{4};
  LiveValues values = std::visit([](const auto& one) { return values_of(one); }, message);
  const auto now = Clock::now();
  const std::lock_guard lock(mutex_);
  arrivals_.push_back(now);
  rates_.push_back(values.rate);
  while (arrivals_.front() + window < now) {
    arrivals_.pop_front();
    rates_.pop_front();
  }
  if (arrivals_.size() > 1 && now > arrivals_.front()) {
    const std::chrono::duration<double> span = now - arrivals_.front();
    state_.rate = static_cast<double>(arrivals_.size() - 1) / span.count();
    add_vibration(values, rates_, state_.rate);
  }
  for (std::size_t i = 0; i < state_.angles.size(); ++i) {
    state_.angles[i].add(values.angle[i]);
    state_.powers[i].add(values.power[i]);
  }
  state_.battery.add(values.battery);
  state_.current.add(values.current);
  state_.values = std::move(values);
  state_.message = message;
}

void GimbalState::add(const Notice& notice) {
  if (notice.kind == NoticeKind::link_lost) return;  // a change of the link reports it as well
  const std::lock_guard lock(mutex_);
  log(notice.message);
}

void GimbalState::add(const LinkChange& change) {
  const std::lock_guard lock(mutex_);
  state_.is_connected = change.state == LinkState::connected;
  state_.rate = 0;
  arrivals_.clear();
  rates_.clear();
  log(change.message);
}

void GimbalState::add(const ClientError& error) {
  const std::lock_guard lock(mutex_);
  log(error.message);
}

void GimbalState::log(std::string text) {
  constexpr std::size_t most = 200;
  state_.log.push_back({std::chrono::system_clock::now(), std::move(text)});
  if (state_.log.size() > most) state_.log.pop_front();
}

GimbalSnapshot GimbalState::snapshot() const {
  const std::lock_guard lock(mutex_);
  return state_;
}

}  // namespace sbgc::tools
