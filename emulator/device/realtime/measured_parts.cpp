#include "device/realtime/measured_parts.hpp"

#include <cmath>

#include "device/calibration/calibrations.hpp"
#include "device/features.hpp"
#include "device/parameters/parameters.hpp"
#include "device/ports.hpp"
#include "device/realtime/streams.hpp"
#include "device/system/restarts.hpp"

namespace sbgc::emulator {

namespace {

std::uint64_t whole(double count) { return static_cast<std::uint64_t>(std::llround(count)); }

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

MeasuredParts::FaultCounts MeasuredParts::fault_counts(Instant now) const {
  const bool has_restarted = restarts.started() > counted_at;
  const FaultCounts before = has_restarted ? FaultCounts{} : counted;
  const Duration time = now - later(restarts.started(), counted_at);
  const double seconds = static_cast<double>(time.us) * 1e-6;
  return {before.i2c + seconds * options.faults.i2c_errors,
          before.serial + seconds * options.faults.serial_errors};
}

void MeasuredParts::count_faults(Instant now) {
  counted = fault_counts(now);
  counted_at = now;
}

// The counters wrap.

std::uint16_t MeasuredParts::i2c_errors(Instant now) const {
  return static_cast<std::uint16_t>(whole(fault_counts(now).i2c));
}

std::uint16_t MeasuredParts::serial_errors(std::size_t port, Instant now) const {
  return static_cast<std::uint16_t>(ports.errors(port) + whole(fault_counts(now).serial));
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
