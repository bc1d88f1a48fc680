/// The state of the board that flags and events report.
#pragma once

#include <cstdint>
#include <optional>

#include <sbgc/emulator/gimbal.hpp>
#include <sbgc/enums.hpp>
#include <sbgc/messages/control.hpp>
#include <sbgc/time.hpp>

namespace sbgc::emulator {

struct CalibrationParts;
struct ControlParts;
struct MenuParts;

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

/// Watches the state of the board and sends CMD_EVENT when it changes, to the hosts that have
/// started a stream of such events.
class Events {
 public:
  /// Sends an event now.
  static void emit(MenuParts& parts, msg::EventId id, msg::EventType type);
  /// Sends the events of the changes since the last call.
  void watch(MenuParts& parts, Instant now);

  Instant next() const { return next_; }
  void advance(Instant now, MenuParts& parts);

 private:
  struct State {
    bool motors_on{}, stopped{}, retracted{};
    std::optional<std::uint8_t> script{};
  };

  static State state_of(const MenuParts& parts);

  State state_{};
  Instant next_ = Instant::never;
};

}  // namespace sbgc::emulator
