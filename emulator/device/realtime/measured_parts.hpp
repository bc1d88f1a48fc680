/// The parts that live data read, and values computed from several of them.
#pragma once

#include <cstddef>
#include <cstdint>

#include <sbgc/emulator/board_options.hpp>
#include <sbgc/emulator/gimbal.hpp>
#include <sbgc/emulator/memory.hpp>
#include <sbgc/messages/realtime.hpp>
#include <sbgc/time.hpp>

namespace sbgc::emulator {

class Calibrations;
class ExternalMotors;
class Outputs;
class Parameters;
class Ports;
class RemoteControl;
class Restarts;
class Scripts;
struct CalibrationParts;
struct ControlParts;
struct Imus;
struct Modes;

struct MeasuredParts {
  const BoardOptions& options;
  const Memory& memory;
  const Parameters& parameters;
  Gimbal& gimbal;
  const Tuning& tuning;
  Ports& ports;
  const RemoteControl& remote;
  const Calibrations& calibrations;
  const Scripts& scripts;
  const Outputs& outputs;
  ExternalMotors& external_motors;
  const Modes& modes;
  const Imus& imus;
  const Restarts& restarts;
  const ControlParts& control;
  const CalibrationParts& calibration;

  /// Errors that faults of the board have caused.
  struct FaultCounts {
    double i2c = 0, serial = 0;
  };
  FaultCounts counted{};  ///< until `counted_at`; the current faults began then
  Instant counted_at{};

  /// The time since the start, which wraps every 65.5 s.
  msg::MillisecondClock clock(Instant now) const;
  Duration reported_cycle() const;
  /// Records the errors so far; call this before the faults change.
  void count_faults(Instant now);
  FaultCounts fault_counts(Instant now) const;
  std::uint16_t i2c_errors(Instant now) const;
  std::uint16_t serial_errors(std::size_t port, Instant now) const;
  /// The reading of the calibrated battery sensor in volts; 0 without a sensor.
  double measured_battery(const Sample& sample) const;
  Flags<msg::SystemError> errors(Instant now) const;
};

/// The reading of the battery sensor per volt; 0 without a sensor.
double battery_factor(const BoardOptions& options, const Memory& memory);

}  // namespace sbgc::emulator
