#include "device/device.hpp"

#include <cmath>
#include <utility>

#include "device/cycle.hpp"
#include "device/parameters/gimbal_tuning.hpp"

namespace sbgc::emulator {

namespace {

/// How often something happened since the board has started.
std::uint64_t count_of(double per_second, Instant started, Instant now) {
  const double seconds = static_cast<double>((now - started).us) * 1e-6;
  return static_cast<std::uint64_t>(std::llround(seconds * per_second));
}

}  // namespace

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
    debug_copies.copy(ports, clock(ports.now), port, frame, true);
  };
}

msg::MillisecondClock Device::clock(Instant now) const {
  // NOLINTNEXTLINE(modernize-return-braced-init-list): the constructor is explicit
  return msg::MillisecondClock(static_cast<std::uint16_t>((now - restarts.started()).us / 1000));
}

Duration Device::reported_cycle() const {
  return options.faults.cycle == Duration{} ? cycle : options.faults.cycle;
}

// The counters wrap.

std::uint16_t Device::i2c_errors(Instant now) const {
  return static_cast<std::uint16_t>(count_of(options.faults.i2c_errors, restarts.started(), now));
}

std::uint16_t Device::serial_errors(std::size_t port, Instant now) const {
  return static_cast<std::uint16_t>(
      ports.errors(port) + count_of(options.faults.serial_errors, restarts.started(), now));
}

double Device::battery_factor() const {
  return has_battery_meter(options) ? memory.battery_factor : 0;
}

double Device::measured_battery(const Sample& sample) const {
  return sample.battery * battery_factor();
}

void Device::apply_parameters(Instant now) {
  if (!restarts.is_listening() || !parameters.take_changes()) return;
  imus.has_frame = options.has_frame_imu && parameters.of<msg::ReadParams3>().frame_imu_pos !=
                                                msg::FrameImuPosition::disabled;
  if (!imus.has_frame) imus.selected = msg::SelectedImu::main;
  tuning = tuning_of(parameters, versions_of(options), has_encoders(options), battery_factor());
  for (std::size_t i = 0; i < tuning.axes.size(); ++i) {
    bool& follows = tuning.axes[i].follows;
    follows = (follows || modes.follows) && !modes.follow_off;
  }
  control_link.adjust(tuning);
  if (modes.is_writing_parameters) return;
  gimbal.tune(tuning, now);
  imus.correct(gimbal, memory, parameters, now);
  remote.apply(parameters, gimbal, now);
  slots.apply_parameters(parameters, now);
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
  Flags<msg::SystemError> errors = calibrations.errors() | options.faults.errors;
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
