/// The state of the board that flags report.
#pragma once

#include <sbgc/emulator/gimbal.hpp>
#include <sbgc/enums.hpp>
#include <sbgc/time.hpp>

namespace sbgc::emulator {

struct CalibrationParts;
struct ControlParts;

/// Switches of hosts and of menu actions, valid until the board restarts.
struct Modes {
  bool servo = false;                  ///< angles are those of the motors
  bool tripod = false;                 ///< the tripod mode
  bool shakes = false;                 ///< the shake generator
  bool retracted = false;              ///< the camera is in the retracted position
  bool follow_off = false;             ///< no axis follows the frame
  bool follows = false;                ///< every axis follows the frame
  bool is_writing_parameters = false;  ///< between the two requests of CMD_WRITE_PARAMS_SET
};

/// The flags of live data; those of CMD_BOARD_INFO are the lowest ones.
msg::StateFlags state_flags(Gimbal& gimbal, const Modes& modes, const Tuning& tuning, Instant now);
/// The calibration or other task that is running.
msg::CalibMode calibration_mode(const ControlParts& control, const CalibrationParts& calibration);
/// The state of the motor power.
msg::PowerState power_state(const ControlParts& control);

}  // namespace sbgc::emulator
