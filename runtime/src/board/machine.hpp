/// All parts of the board, for handlers and for parts that work with others.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include <sbgc/board/board.hpp>
#include <sbgc/message.hpp>

#include "auto_tuning.hpp"
#include "calibrations.hpp"
#include "debug_variables.hpp"
#include "eeprom.hpp"
#include "files.hpp"
#include "i2c_bus.hpp"
#include "outputs.hpp"
#include "ports.hpp"
#include "remote.hpp"
#include "restarts.hpp"
#include "scripts.hpp"
#include "settings.hpp"
#include "slots.hpp"
#include "streams.hpp"

namespace sbgc::board {

/// What goes on by itself in a part P of the board:
///     Instant next() const;                        // Instant::never if nothing does
///     void advance(Machine& machine, Instant now); // does what is due at `now`
///     void restart(Machine& machine, Instant now); // the board has restarted
/// Parts keep ports by number; Ports::send() to one that has closed does nothing.
struct Machine {
  Machine(const Options& options, Memory memory, Instant now);

  Options options;
  Memory memory;
  Eeprom eeprom;
  Settings settings;
  FileSystem files;
  Gimbal gimbal;
  Ports ports;                ///< of hosts: buffers, sending
  Streams streams;            ///< CMD_DATA_STREAM_INTERVAL
  Restarts restarts;          ///< reset, boot mode, start
  Remote remote;              ///< RC inputs and virtual channels, and what they control
  Slots slots;                ///< RC signals that start actions and change variables
  Calibrations calibrations;  ///< those that take time
  AutoTuning auto_tuning;     ///< CMD_AUTO_PID
  Scripts scripts;
  Outputs outputs;  ///< pins, servos, sounds
  I2cBus i2c;
  DebugVariables debug_variables;

  /// Carries out an action of the menu (menu.cpp). False if there is no such action.
  bool execute(MenuCommand action, Instant now);
  /// Switches to another profile. Precondition: there is one.
  void select_profile(std::uint8_t profile, Instant now);
  /// Hands the settings in use to gimbal and inputs; after each change of them.
  void apply_settings(Instant now);
  void set_motors(bool on, Instant now);
  /// Errors as live data show them.
  Flags<SystemError> errors(Instant now);

  std::uint32_t cur_imu = 1;  ///< SelectedImu that hosts have chosen
};

}  // namespace sbgc::board
