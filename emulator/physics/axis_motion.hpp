/// One axis of the gimbal: its motor, its joint and the loop that holds the camera.
#pragma once

#include <sbgc/emulator/gimbal.hpp>

#include "physics/path.hpp"

namespace sbgc::emulator {

/// The control gains of an axis. Accelerations represent torques: the camera's inertia is 1.
struct AxisGains {
  double stiffness{};         ///< 1/s^2
  double damping{};           ///< 1/s
  double integral{};          ///< 1/s^3
  double strength{};          ///< of the motor, deg/s^2; 0: it holds nothing
  double acceleration{1000};  ///< limit of the target, deg/s^2
};

AxisGains gains_of(const AxisTuning& tuning);

/// The frame at the end of a step, and what the IMU makes of it.
struct AxisSurroundings {
  double frame{}, frame_speed{};  ///< degrees, deg/s
  double error{}, error_speed{};  ///< of the estimated angle
  double coupling{};              ///< how much of the frame's rotation the joint passes on, 1/s
  double imbalance{};             ///< acceleration that the motor has to hold against, deg/s^2
};

/// The camera about one axis. `angle` is what the IMU estimates:
/// angle = frame + joint + error of the estimate.
struct AxisMotion {
  double angle{}, speed{};
  double joint{}, joint_speed{};
  double integral{};  ///< of the angle's error, deg s
  double load{};      ///< of the motor, -1..1
  double balance{};   ///< the load of the last second
  bool is_jammed = false;

  /// The loop holds the target `path`, which has been moved with `acceleration` in this step.
  void hold(const AxisGains& gains, const Path& path, double acceleration,
            const AxisSurroundings& around, double seconds);
  /// Nothing holds it but friction.
  void coast(const AxisSurroundings& around, double seconds);
  /// The joint does not move: angle and speed are those of the frame.
  void stick(const AxisSurroundings& around);
};

}  // namespace sbgc::emulator
