#include "machine.hpp"

#include <cmath>
#include <utility>

#include <sbgc/roles.hpp>

#include "tuning.hpp"

namespace sbgc::board {

Machine::Machine(const Options& of, Memory kept, Instant now)
    : options(of),
      memory(std::move(kept)),
      eeprom(memory),
      settings(memory),
      files(memory),
      gimbal(options.gimbal, now),
      ports(options),
      restarts(*this, now) {
  for (const std::size_t imu : {0U, 1U}) {
    gimbal.correct_gyro(imu == 1, memory.imus[imu].gyro_offset, 0, now);
  }
}

Availability Machine::versions() const { return {options.firmware.raw(), options.board.raw()}; }

Duration Machine::cycle() { return microseconds(roles::stream_cycle_us); }

double Machine::measured_battery(const Sample& sample) const {
  return sample.battery * memory.battery_factor;
}

void Machine::select_profile(std::uint8_t profile, Instant now) {
  settings.select_profile(profile);
  apply_settings(now);
}

void Machine::apply_settings(Instant now) {
  gimbal.tune(tuning_of(settings, versions(), home, memory.battery_factor), now);
  remote.apply(*this, now);
  slots.apply_settings(*this, now);
}

void Machine::set_motors(bool on, Instant now) { gimbal.set_motors(on, now); }

void Machine::calibrate_at_start(Instant now) {
  const SkipGyroCalibration skip = settings.of<ReadParams3>().skip_gyro_calib;
  if (skip == SkipGyroCalibration::skip_always) return;
  const Sample sample = gimbal.sample(now);
  // Ours: with that speed, in deg/s, it counts as moving.
  constexpr double still = 1;
  for (const bool of_frame : {false, true}) {
    const Vector& gyro = of_frame ? sample.frame_gyro : sample.gyro;
    const bool moves = std::hypot(gyro.x, gyro.y, gyro.z) > still;
    if (moves && skip == SkipGyroCalibration::skip_if_moving) continue;
    gimbal.gyro_calibrated(of_frame, now);
  }
}

Flags<SystemError> Machine::errors(Instant now) {
  Flags<SystemError> errors = calibrations.errors();
  const double alarm = settings.of<ReadParams3>().bat_threshold_alarm.volts();
  if (options.features.has(BoardFeature::bat_monitoring) && alarm >= 0 &&
      measured_battery(gimbal.sample(now)) < alarm) {
    errors.set(SystemError::low_bat1);
  }
  if (gimbal.stopped_by_battery()) errors.set(SystemError::low_bat2);
  return errors;
}

}  // namespace sbgc::board
