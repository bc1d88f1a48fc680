/// Faults of an emulated board, apart from its gimbal and its line.
#pragma once

#include <sbgc/messages/realtime.hpp>
#include <sbgc/time.hpp>
#include <sbgc/types.hpp>

namespace sbgc::emulator {

/// Faults that live data report. They do not affect the behavior of the board.
struct BoardFaults {
  Flags<msg::SystemError> errors{};  ///< in addition to errors that the board detects itself
  msg::SystemSubError sub_error{};   ///< what the board reports; 0: none
  double i2c_errors = 0;             ///< per second
  double serial_errors = 0;          ///< per second, besides those of the line
  Duration cycle{};                  ///< of the controller; zero selects the usual one
};

}  // namespace sbgc::emulator
