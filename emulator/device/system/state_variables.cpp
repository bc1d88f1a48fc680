#include "device/system/state_variables.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "device/features.hpp"
#include "device/parameters/parameters.hpp"
#include "physics/quantities.hpp"

namespace sbgc::emulator {
namespace {

/// Assumption: the intervals for reading the sensors for this purpose, and for storing the result.
constexpr Duration count_period = seconds(5);
constexpr Duration store_period = seconds(60);

/// Assumption: the microcontroller is this much warmer than the IMU, in degrees.
constexpr double mcu_warmth = 12;

template <class Q>
void track(Q& lowest, Q& highest, double value, bool is_first) {
  const auto measured = saturated<Q>(std::max(value, 0.0));
  lowest = is_first ? measured : std::min(lowest, measured);
  highest = std::max(highest, measured);
}

msg::LongSeconds whole_seconds(double time) { return saturated<msg::LongSeconds>(time * 1000); }

}  // namespace

bool StateVariables::are_supported(const BoardOptions& options) {
  return features_ext_of(options).has(msg::BoardFeaturesExtBit::state_vars);
}

void StateVariables::count(Gimbal& gimbal, Instant now) {
  const double passed = std::max(0.0, static_cast<double>((now - counted_).us) * 1e-6);
  counted_ = now;
  const Sample sample = gimbal.sample(now);
  const double milliamperes = sample.current * 1000;
  work_time_ += passed;
  energy_time_ += passed;
  energy_ += sample.battery * sample.current * passed / 3600;
  if (current_time_ + passed > 0) {
    current_ += (milliamperes - current_) * passed / (current_time_ + passed);
  }
  current_time_ += passed;
  const bool is_first = values_.imu_temp_max.raw() == 0;
  track(values_.imu_temp_min, values_.imu_temp_max, sample.temperature, is_first);
  track(values_.mcu_temp_min, values_.mcu_temp_max, sample.temperature + mcu_warmth, is_first);
  values_.max_current = std::max(values_.max_current, saturated<msg::Current>(milliamperes));
  const Vector& a = sample.acceleration;
  values_.max_acc =
      std::max(values_.max_acc, saturated<msg::AccelerationPeak>(std::hypot(a.x, a.y, a.z)));
  values_.work_time = whole_seconds(work_time_);
  values_.energy_time = whole_seconds(energy_time_);
  values_.avg_current_time = whole_seconds(current_time_);
  values_.energy = saturated<msg::WattHours>(energy_);
  values_.avg_current = saturated<msg::AverageCurrent>(current_);
}

msg::ReadStateVars StateVariables::values(Gimbal& gimbal, Instant now) {
  count(gimbal, now);
  return values_;
}

void StateVariables::set(const msg::ReadStateVars& values, Instant now) {
  values_ = values;
  work_time_ = values.work_time.milliseconds() / 1000;
  energy_time_ = values.energy_time.milliseconds() / 1000;
  current_time_ = values.avg_current_time.milliseconds() / 1000;
  energy_ = values.energy.watt_hours();
  current_ = values.avg_current.milliamperes();
  counted_ = now;
}

void StateVariables::write(Memory& memory, const msg::ReadStateVars& values, Instant now) {
  set(values, now);
  store(memory);
}

void StateVariables::store(Memory& memory) const {
  std::array<std::uint8_t, max_body_size> body{};
  const WriteResult written = encode(values_, body);
  memory.state_variables.assign(body.begin(),
                                body.begin() + static_cast<std::ptrdiff_t>(written.size));
  ++memory.revision;
}

void StateVariables::advance(Instant now, Gimbal& gimbal, const Parameters& parameters,
                             Memory& memory) {
  count(gimbal, now);
  next_ = now + count_period;
  const auto flags = parameters.of<msg::ReadParamsExt2>().general_flags2;
  if (!flags.has(msg::GeneralFlags2Bit::save_system_stat) || now < stored_ + store_period) return;
  stored_ = now;
  store(memory);
}

void StateVariables::start(const BoardOptions& options, Memory& memory,
                           const Parameters& parameters, Instant now) {
  *this = {};
  if (!are_supported(options)) return;
  msg::ReadStateVars stored;
  const bool is_stored = !memory.state_variables.empty() &&
                         decode(std::span<const std::uint8_t>(memory.state_variables), stored);
  if (!is_stored) stored = {};
  set(stored, now);
  if (values_.startup_cnt < 0xFFFF) ++values_.startup_cnt;
  const auto flags = parameters.of<msg::ReadParamsExt2>().general_flags2;
  if (flags.has(msg::GeneralFlags2Bit::save_system_stat)) store(memory);
  stored_ = now;
  next_ = now + count_period;
}

}  // namespace sbgc::emulator
