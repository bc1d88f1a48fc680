#include "device/device.hpp"

#include <cmath>
#include <utility>

#include <sbgc/roles.hpp>

#include "device/parameters/gimbal_tuning.hpp"

namespace sbgc::emulator {

Device::Device(BoardOptions of, Memory kept, Instant now)
    : options(std::move(of)),
      memory(std::move(kept)),
      eeprom(memory),
      parameters(memory, versions_of(options)),
      files(memory),
      gimbal(options.gimbal, now),
      ports(options),
      restarts(*this, now) {
  ports.on_sent = [this](std::size_t port, const Frame& frame) {
    debug_copies.copy(*this, port, frame, true, ports.now);
  };
}

bool Device::has_frame_imu() const {
  return options.has_frame_imu &&
         parameters.of<msg::ReadParams3>().frame_imu_pos != msg::FrameImuPosition::disabled;
}

double Device::gyro_unit() { return msg::GyroRate(1).degrees_per_second(); }

Duration Device::cycle() { return microseconds(roles::stream_cycle_us); }

double Device::battery_factor() const {
  return has_battery_meter(options) ? memory.battery_factor : 0;
}

double Device::measured_battery(const Sample& sample) const {
  return sample.battery * battery_factor();
}

void Device::save_profile_set(std::size_t slot) {
  memory.profile_sets[slot] = parameters.profiles();
  ++memory.revision;
}

void Device::clear_profile_set(std::size_t slot) {
  memory.profile_sets[slot].clear();
  ++memory.revision;
}

bool Device::load_profile_set(std::size_t slot, Instant now) {
  if (!parameters.restore_profiles(memory.profile_sets[slot])) return false;
  memory.profile_set = static_cast<std::uint8_t>(slot + 1);
  ++memory.revision;
  apply_parameters(now);
  return true;
}

void Device::select_profile(std::uint8_t profile, Instant now) {
  parameters.select_profile(profile);
  apply_parameters(now);
}

void Device::apply_parameters(Instant now) {
  if (!has_frame_imu()) cur_imu = msg::SelectedImu::main;
  if (is_writing_parameters) return;
  gimbal.tune(tuning(), now);
  correct_gyros(now);
  remote.apply(*this, now);
  slots.apply_parameters(*this, now);
}

Tuning Device::tuning() const {
  Tuning tuning =
      tuning_of(parameters, versions_of(options), has_encoders(options), battery_factor());
  for (std::size_t i = 0; i < tuning.axes.size(); ++i) {
    bool& follows = tuning.axes[i].follows;
    follows = (follows || modes.follows) && !modes.follow_off;
  }
  control_link.adjust(tuning);
  return tuning;
}

void Device::forget_calibrations() {
  memory.imus = {};
  memory.battery_factor = Memory{}.battery_factor;
  ++memory.revision;
  gyro_headings = {};
}

void Device::correct_gyros(Instant now) {
  const auto variable = parameters.variable(msg::VariableId::gyro_heading_correction);
  const double more =
      msg::GyroOffset(static_cast<std::int16_t>(variable.value_or(0))).gyro_units() * gyro_unit();
  for (const std::size_t imu : {0U, 1U}) {
    const double heading = gyro_headings[imu] + (imu == 0 ? more : 0);
    gimbal.correct_gyro(imu == 1, memory.imus[imu].gyro_offset, heading, now);
  }
}

void Device::set_motors(bool on, Instant now) {
  tasks.forget_stop();
  gimbal.set_motors(on, now);
}

void Device::calibrate_at_start(Instant now) {
  const msg::SkipGyroCalibration skip = parameters.of<msg::ReadParams3>().skip_gyro_calib;
  if (skip == msg::SkipGyroCalibration::skip_always) return;
  const Sample sample = gimbal.sample(now);
  // Assumption: a sensor that turns faster than this, in deg/s, is moving.
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

Flags<msg::SystemError> Device::errors(Instant now) {
  Flags<msg::SystemError> errors = calibrations.errors();
  if (has_battery_meter(options)) {
    const auto& thresholds = parameters.of<msg::ReadParams3>();
    const double volts = measured_battery(gimbal.sample(now));
    // A negative threshold disables the check: no voltage is below it.
    if (volts < thresholds.bat_threshold_alarm.volts()) errors.set(msg::SystemError::low_bat1);
    if (volts < thresholds.bat_threshold_motors.volts()) errors.set(msg::SystemError::low_bat2);
  }
  // Without motor current the voltage may have risen again.
  if (gimbal.stopped_by_battery()) errors.set(msg::SystemError::low_bat2);
  return errors;
}

}  // namespace sbgc::emulator
