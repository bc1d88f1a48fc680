/// All parts of the board, for handlers and for parts that work with others.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include <sbgc/availability.hpp>
#include <sbgc/emulator/board.hpp>

#include "device/parts/auto_tuning.hpp"
#include "device/parts/calibrations.hpp"
#include "device/parts/debug_variables.hpp"
#include "device/parts/eeprom.hpp"
#include "device/parts/file_system.hpp"
#include "device/parts/i2c_bus.hpp"
#include "device/parts/outputs.hpp"
#include "device/parts/parameters.hpp"
#include "device/parts/ports.hpp"
#include "device/parts/remote_control.hpp"
#include "device/parts/restarts.hpp"
#include "device/parts/scripts.hpp"
#include "device/parts/slots.hpp"
#include "device/parts/streams.hpp"

namespace sbgc::emulator {

/// What goes on by itself in a part P of the board:
///     Instant next() const;                        // Instant::never if nothing does
///     void advance(Device& device, Instant now); // does what is due at `now`
///     void restart(Device& device, Instant now); // the board has restarted
/// Parts keep ports by number; Ports::send() to one that has closed does nothing.
struct Device {
  Device(BoardOptions of, Memory kept, Instant now);

  BoardOptions options;
  Memory memory;
  Eeprom eeprom;
  Parameters parameters;
  FileSystem files;
  Gimbal gimbal;
  Ports ports;                ///< of hosts: buffers, sending
  Streams streams;            ///< CMD_DATA_STREAM_INTERVAL
  RemoteControl remote;       ///< RC inputs and virtual channels, and what they control
  Slots slots;                ///< RC signals that start actions and change variables
  Calibrations calibrations;  ///< those that take time
  AutoTuning auto_tuning;     ///< CMD_AUTO_PID
  Scripts scripts;
  Outputs outputs;  ///< pins, servos, sounds
  I2cBus i2c;
  DebugVariables debug_variables;

  /// Switches to another profile. Precondition: there is one.
  void select_profile(std::uint8_t profile, Instant now);
  /// Hands the parameters in use to gimbal and inputs; after each change of them.
  void apply_parameters(Instant now);
  /// Those in the main EEPROM, which has been erased. Parameters are to be applied then.
  void forget_calibrations();
  /// Hands the corrections of the gyroscopes to the gimbal; after each change of them.
  void correct_gyros(Instant now);
  void set_motors(bool on, Instant now);
  /// Errors as live data show them.
  Flags<msg::SystemError> errors(Instant now);

  /// What the board is.
  Availability versions() const;
  /// Whether there is an IMU on the frame, and the parameters use it.
  bool has_frame_imu() const;
  /// Of the controller.
  static Duration cycle();
  /// In deg/s. Ours: the unit in which offsets of a gyroscope count is that of its readings.
  static double gyro_unit();
  /// Whether there are encoders, which measure the angles of the joints.
  bool has_encoders() const;
  /// Whether there is a sensor for the battery's voltage.
  bool has_battery_meter() const;
  /// What that sensor shows of one volt; 0 without it.
  double battery_factor() const;
  /// Volts, as the calibrated sensor shows them; 0 without it.
  double measured_battery(const Sample& sample) const;
  /// The gyroscopes find their zero when the board starts, if the parameters want that.
  void calibrate_at_start(Instant now);

  std::uint32_t baud_rate{};  ///< that SERIAL_SPEED has set at the last start

  msg::SelectedImu cur_imu =
      msg::SelectedImu::main;  ///< that hosts have chosen, of those that are used
  /// Corrections of the heading of main and frame IMU, deg/s, besides GYRO_HEADING_CORRECTION.
  /// Until the board restarts: ours.
  std::array<double, 2> gyro_headings{};
  Restarts restarts;  ///< reset, boot mode, start; last, it starts all the others
};

/// Calls `use(part)` for each part that does something by itself, in a fixed order.
template <class Use>
void for_each_part(Device& device, Use&& use) {
  use(device.remote);
  use(device.slots);
  use(device.calibrations);
  use(device.auto_tuning);
  use(device.scripts);
  use(device.outputs);
  use(device.i2c);
  use(device.debug_variables);
  use(device.streams);
}

}  // namespace sbgc::emulator
