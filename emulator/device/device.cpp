#include "device/device.hpp"

#include <cmath>
#include <utility>

#include <sbgc/roles.hpp>

#include "device/parts/gimbal_tuning.hpp"

namespace sbgc::board {

Machine::Machine(Options of, Memory kept, Instant now)
    : options(std::move(of)),
      memory(std::move(kept)),
      eeprom(memory),
      settings(memory),
      files(memory),
      gimbal(options.gimbal, now),
      ports(options),
      restarts(*this, now) {}

Availability Machine::versions() const { return {options.firmware.raw(), options.board.raw()}; }

bool Machine::has_frame_imu() const {
  return options.has_frame_imu &&
         settings.of<msg::ReadParams3>().frame_imu_pos != msg::FrameImuPosition::disabled;
}

double Machine::gyro_unit() { return msg::GyroRate(1).degrees_per_second(); }

Duration Machine::cycle() { return microseconds(roles::stream_cycle_us); }

bool Machine::has_encoders() const { return options.features.has(msg::BoardFeature::encoders); }

bool Machine::has_battery_meter() const {
  return options.features.has(msg::BoardFeature::bat_monitoring);
}

double Machine::battery_factor() const { return has_battery_meter() ? memory.battery_factor : 0; }

double Machine::measured_battery(const Sample& sample) const {
  return sample.battery * battery_factor();
}

void Machine::select_profile(std::uint8_t profile, Instant now) {
  settings.select_profile(profile);
  apply_settings(now);
}

void Machine::apply_settings(Instant now) {
  if (!has_frame_imu()) cur_imu = msg::SelectedImu::main;
  gimbal.tune(tuning_of(settings, versions(), has_encoders(), battery_factor()), now);
  correct_gyros(now);
  remote.apply(*this, now);
  slots.apply_settings(*this, now);
}

void Machine::forget_calibrations() {
  memory.imus = {};
  memory.battery_factor = Memory{}.battery_factor;
  ++memory.revision;
  gyro_headings = {};
}

void Machine::correct_gyros(Instant now) {
  const auto variable = settings.variable(msg::VariableId::gyro_heading_correction);
  const double more =
      msg::GyroOffset(static_cast<std::int16_t>(variable.value_or(0))).gyro_units() * gyro_unit();
  for (const std::size_t imu : {0U, 1U}) {
    const double heading = gyro_headings[imu] + (imu == 0 ? more : 0);
    gimbal.correct_gyro(imu == 1, memory.imus[imu].gyro_offset, heading, now);
  }
}

void Machine::set_motors(bool on, Instant now) { gimbal.set_motors(on, now); }

void Machine::calibrate_at_start(Instant now) {
  const msg::SkipGyroCalibration skip = settings.of<msg::ReadParams3>().skip_gyro_calib;
  if (skip == msg::SkipGyroCalibration::skip_always) return;
  const Sample sample = gimbal.sample(now);
  // Ours: with that speed, in deg/s, it counts as moving.
  constexpr double still = 1;
  for (const bool of_frame : {false, true}) {
    const Vector& gyro = of_frame ? sample.frame_gyro : sample.gyro;
    const bool moves = std::hypot(gyro.x, gyro.y, gyro.z) > still;
    if (moves && skip == msg::SkipGyroCalibration::skip_if_moving) continue;
    gimbal.gyro_calibrated(of_frame, now);
    Vector& offset = memory.imus[of_frame ? 1 : 0].gyro_offset;
    if (offset != Vector{}) ++memory.revision;
    offset = {};
  }
}

Flags<msg::SystemError> Machine::errors(Instant now) {
  Flags<msg::SystemError> errors = calibrations.errors();
  if (has_battery_meter()) {
    const auto& thresholds = settings.of<msg::ReadParams3>();
    const double volts = measured_battery(gimbal.sample(now));
    // A negative threshold is none, and no voltage is below it.
    if (volts < thresholds.bat_threshold_alarm.volts()) errors.set(msg::SystemError::low_bat1);
    if (volts < thresholds.bat_threshold_motors.volts()) errors.set(msg::SystemError::low_bat2);
  }
  // Without the motors' current the voltage may be higher again.
  if (gimbal.stopped_by_battery()) errors.set(msg::SystemError::low_bat2);
  return errors;
}

}  // namespace sbgc::board
