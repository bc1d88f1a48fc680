/// External motors, which are not axes of the camera.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include <sbgc/emulator/board_options.hpp>
#include <sbgc/messages/external_motors.hpp>
#include <sbgc/time.hpp>

namespace sbgc::emulator {

/// Seven motors, each of which follows its setpoint with the delay of a first-order system, within
/// its limits. Assumption: the motors are alike, and their home position is 0.
class ExternalMotors {
 public:
  static constexpr std::size_t count = 7;

  static bool are_supported(const BoardOptions& options);

  /// Returns false, without effect, if there is no such action.
  bool act(std::size_t motor, msg::ExtMotorActionKind action, Instant now);
  /// Returns false, without effect, if the mode does not exist.
  bool configure(std::size_t motor, const msg::ExtMotorsControlConfig& config, Instant now);
  /// Raw setpoint and parameter of CMD_EXT_MOTORS_CONTROL. `wraps`: they have 16 bits.
  struct Setpoint {
    std::int32_t value{};
    bool wraps{};
    std::int32_t param{};
    bool has_param{};
  };
  void control(std::size_t motor, const Setpoint& setpoint, Instant now);
  msg::ExtMotorsState state(Gimbal& gimbal, std::size_t motor, msg::ExtMotorsStateFields fields,
                            Instant now);
  /// Speed in deg/s and load, -1..1.
  struct Motion {
    double speed{}, load{};
  };
  Motion motion(std::size_t motor, Instant now);

  void restart(Instant now);

 private:
  struct Motor {
    msg::ExtMotorPower power = msg::ExtMotorPower::off_floating;
    msg::ExtMotorMode mode{};
    double angle{}, speed{}, torque{};           ///< degrees, deg/s, -1..1
    double goal{};                               ///< of the mode
    double top{};                                ///< speed limit of the last setpoint; 0: none
    double max_speed = 360, acceleration = 720;  ///< deg/s, deg/s^2
    std::uint16_t jerk_slope{};                  ///< ms
    std::uint16_t max_torque = 0xFFFF;
    Instant at{};

    void run(Instant now);
    void step(double seconds);
  };

  Motor& moved(std::size_t motor, Instant now);

  std::array<Motor, count> motors_{};
};

}  // namespace sbgc::emulator
