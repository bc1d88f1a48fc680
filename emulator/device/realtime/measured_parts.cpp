#include "device/realtime/measured_parts.hpp"

#include <cmath>

#include "device/calibration/calibrations.hpp"
#include "device/cycle.hpp"
#include "device/features.hpp"
#include "device/parameters/parameters.hpp"
#include "device/ports.hpp"
#include "device/system/restarts.hpp"

namespace sbgc::emulator {

namespace {

/// How often something happened since the board has started.
std::uint64_t count_of(double per_second, Instant started, Instant now) {
  const double seconds = static_cast<double>((now - started).us) * 1e-6;
  return static_cast<std::uint64_t>(std::llround(seconds * per_second));
}

}  // namespace

double battery_factor(const BoardOptions& options, const Memory& memory) {
  return has_battery_meter(options) ? memory.battery_factor : 0;
}

msg::MillisecondClock MeasuredParts::clock(Instant now) const {
  // NOLINTNEXTLINE(modernize-return-braced-init-list): the constructor is explicit
  return msg::MillisecondClock(static_cast<std::uint16_t>((now - restarts.started()).us / 1000));
}

Duration MeasuredParts::reported_cycle() const {
  return options.faults.cycle == Duration{} ? cycle : options.faults.cycle;
}

// The counters wrap.

std::uint16_t MeasuredParts::i2c_errors(Instant now) const {
  return static_cast<std::uint16_t>(count_of(options.faults.i2c_errors, restarts.started(), now));
}

std::uint16_t MeasuredParts::serial_errors(std::size_t port, Instant now) const {
  return static_cast<std::uint16_t>(
      ports.errors(port) + count_of(options.faults.serial_errors, restarts.started(), now));
}

double MeasuredParts::measured_battery(const Sample& sample) const {
  return sample.battery * battery_factor(options, memory);
}

Flags<msg::SystemError> MeasuredParts::errors(Instant now) const {
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
