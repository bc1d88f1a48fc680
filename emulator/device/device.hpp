/// The device: all parts of the board.
#pragma once

#include <cstdint>
#include <tuple>
#include <type_traits>

#include <sbgc/availability.hpp>
#include <sbgc/emulator/board.hpp>

#include "device/adjustable_variables/slots.hpp"
#include "device/calibration/auto_tuning.hpp"
#include "device/calibration/calibrations.hpp"
#include "device/calibration/frequency_response.hpp"
#include "device/control/control_link.hpp"
#include "device/control/menu.hpp"
#include "device/control/quaternion_control.hpp"
#include "device/control/reported_state.hpp"
#include "device/control/targets.hpp"
#include "device/control/tasks.hpp"
#include "device/debug/debugging.hpp"
#include "device/external_motors/external_motors.hpp"
#include "device/features.hpp"
#include "device/imu/imus.hpp"
#include "device/modules/modules.hpp"
#include "device/parameters/parameters.hpp"
#include "device/peripherals/i2c_bus.hpp"
#include "device/peripherals/outputs.hpp"
#include "device/peripherals/remote_control.hpp"
#include "device/ports.hpp"
#include "device/realtime/measured_parts.hpp"
#include "device/realtime/streams.hpp"
#include "device/scripting/scripts.hpp"
#include "device/storage/eeprom.hpp"
#include "device/storage/file_system.hpp"
#include "device/system/restarts.hpp"
#include "device/system/state_variables.hpp"

namespace sbgc::emulator {

/// The interface of a part of the board that acts on its own, as far as the part needs it:
///     Instant next() const;                        // Instant::never if nothing is due
///     void advance(Instant now, Part& part, ...);  // called when it is due, with what it uses
///     void restart(Instant now, Part& part, ...);  // without it, a restart loses the whole state
///     void drop_port(std::size_t port);            // the port closes: sends nothing more to it
/// Parts store ports by number; Ports::send() to a closed port does nothing.
struct Device {
  Device(BoardOptions of, Memory kept, Instant now);

  BoardOptions options;
  Memory memory;
  Eeprom eeprom;
  Parameters parameters;
  FileSystem files;
  Gimbal gimbal;
  Tuning tuning{};                       ///< of the gimbal, from the parameters in use
  Ports ports;                           ///< serial ports: buffers and sending
  Streams streams;                       ///< CMD_DATA_STREAM_INTERVAL
  RemoteControl remote;                  ///< RC inputs and virtual channels
  Slots slots;                           ///< RC signals that trigger actions and change variables
  Calibrations calibrations;             ///< calibrations that take time
  AutoTuning auto_tuning;                ///< CMD_AUTO_PID
  FrequencyResponse frequency_response;  ///< CMD_BODE_TEST_START_STOP
  Scripts scripts;
  Outputs outputs;  ///< pins, servos, sounds
  I2cBus i2c;
  ControlLink control_link;        ///< CMD_CONTROL_CONFIG
  QuaternionControl quaternions;   ///< CMD_CONTROL_QUAT
  Tasks tasks;                     ///< automatic tasks, safe stops
  ModuleFlash module_flash;        ///< CMD_MODULE_FLASH_*
  ExternalMotors external_motors;  ///< CMD_EXT_MOTORS_*
  StateVariables state_variables;  ///< CMD_READ_STATE_VARS
  Events events;                   ///< CMD_EVENT
  DebugCopies debug_copies;        ///< CMD_SET_DEBUG_PORT
  Modes modes;                     ///< switches until the board restarts
  Imus imus;
  ControlParts control{control_link, quaternions, tasks, modes, gimbal, parameters, tuning};
  CalibrationParts calibration{options,           memory, parameters, gimbal,       imus,
                               outputs,           ports,  restarts,   calibrations, auto_tuning,
                               frequency_response};
  MenuParts menu{calibration, options, parameters, files,        gimbal,      tuning,
                 ports,       streams, remote,     calibrations, auto_tuning, scripts,
                 quaternions, tasks,   modes,      imus,         restarts};
  MeasuredParts measured{options, memory,       parameters, gimbal,     tuning,          ports,
                         remote,  calibrations, scripts,    outputs,    external_motors, modes,
                         imus,    restarts,     control,    calibration};

  /// Passes changed parameters to the gimbal and the inputs, once the board runs.
  void apply_parameters(Instant now);
  /// Calibrates the gyroscopes at the start of the board if the parameters require it.
  void calibrate_at_start(Instant now);

  std::uint32_t baud_rate{};  ///< set by SERIAL_SPEED at the last start

  /// The parts that act on their own, in the order in which they do.
  auto acting_parts() {
    return std::tie(remote, slots, calibrations, auto_tuning, frequency_response, scripts, outputs,
                    control_link, quaternions, tasks, external_motors, module_flash,
                    state_variables, debug_copies, events, modes, imus, streams);
  }
  auto parts() {
    return std::tuple_cat(
        acting_parts(), std::tie(options, memory, eeprom, parameters, files, gimbal, tuning, ports,
                                 i2c, restarts, control, calibration, menu, measured));
  }
  /// A part by its type, for functions that take some parts.
  template <class Part>
  Part& part() {
    return std::get<std::remove_const_t<Part>&>(parts());
  }
  /// Calls a function of a part with the parts that it takes.
  template <class Part, class... Parts>
  void run(void (Part::*function)(Instant, Parts&...), Instant now) {
    (part<Part>().*function)(now, part<Parts>()...);
  }

  Restarts restarts;  ///< reset, boot mode, start; declared last, because it starts all other parts
};

/// Calls `use(part)` for each part that acts on its own.
template <class Use>
void for_each_part(Device& device, Use&& use) {
  std::apply([&](auto&... parts) { (use(parts), ...); }, device.acting_parts());
}

}  // namespace sbgc::emulator
