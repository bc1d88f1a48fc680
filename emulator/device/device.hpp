/// The device: all parts of the board, for handlers and for parts that use each other.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include <sbgc/availability.hpp>
#include <sbgc/emulator/board.hpp>

#include "device/parts/auto_tuning.hpp"
#include "device/parts/calibrations.hpp"
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

/// What a part of the board does by itself:
///     Instant next() const;                        // Instant::never if nothing is due
///     void advance(Device& device, Instant now);   // does what is due at `now`
///     void restart(Device& device, Instant now);   // the board has restarted
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
  RemoteControl remote;       ///< RC inputs and virtual channels
  Slots slots;                ///< RC signals that start actions and change variables
  Calibrations calibrations;  ///< calibrations that take time
  AutoTuning auto_tuning;     ///< CMD_AUTO_PID
  Scripts scripts;
  Outputs outputs;  ///< pins, servos, sounds
  I2cBus i2c;

  /// Switches to another profile. Precondition: it exists.
  void select_profile(std::uint8_t profile, Instant now);
  /// Passes the parameters in use to gimbal and inputs; call it after each change.
  void apply_parameters(Instant now);
  /// Forgets the calibrations in the main EEPROM, which was erased. Call apply_parameters()
  /// afterwards.
  void forget_calibrations();
  /// Passes the corrections of the gyroscopes to the gimbal; call it after each change.
  void correct_gyros(Instant now);
  void set_motors(bool on, Instant now);
  /// Errors as live data report them.
  Flags<msg::SystemError> errors(Instant now);

  /// Versions of the board and its firmware.
  Availability versions() const;
  /// Whether there is an IMU on the frame and the parameters use it.
  bool has_frame_imu() const;
  /// Cycle time of the controller.
  static Duration cycle();
  /// Unit of gyroscope offsets, in deg/s. Assumption: that of its readings.
  static double gyro_unit();
  /// Whether there are encoders, which measure the angles of the joints.
  bool has_encoders() const;
  /// Whether there is a sensor for the battery's voltage.
  bool has_battery_meter() const;
  /// What that sensor reads for one volt; 0 without it.
  double battery_factor() const;
  /// Volts, as the calibrated sensor reads them; 0 without it.
  double measured_battery(const Sample& sample) const;
  /// Calibrates the gyroscopes at the start of the board, if the parameters say so.
  void calibrate_at_start(Instant now);

  std::uint32_t baud_rate{};  ///< set by SERIAL_SPEED at the last start

  msg::SelectedImu cur_imu = msg::SelectedImu::main;  ///< chosen by hosts
  /// Heading corrections of main and frame IMU, deg/s, besides GYRO_HEADING_CORRECTION. Assumption:
  /// until the board restarts.
  std::array<double, 2> gyro_headings{};
  Restarts restarts;  ///< reset, boot mode, start; last, because it starts all the others
};

/// Calls `use(part)` for each part that acts by itself, in a fixed order.
template <class Use>
void for_each_part(Device& device, Use&& use) {
  use(device.remote);
  use(device.slots);
  use(device.calibrations);
  use(device.auto_tuning);
  use(device.scripts);
  use(device.outputs);
  use(device.i2c);
  use(device.streams);
}

}  // namespace sbgc::emulator
