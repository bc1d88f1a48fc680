/// The motion of one axis of the gimbal: its target with limited speed and acceleration; motor,
/// joint and control loop.
#pragma once

#include <sbgc/emulator/gimbal.hpp>

namespace sbgc::emulator {

/// A moving point, in degrees and seconds.
struct Path {
  double position{};
  double speed{};
};

/// Changes the speed to `speed` and holds it.
void turn(Path& path, double speed, double acceleration, double seconds);

/// Moves to `goal` and stops exactly there, without overshoot if the current speed allows it. Then
/// the speed is exactly 0.
void go(Path& path, double goal, double fastest, double acceleration, double seconds);

/// Turns with `speed` while being pulled to `angle`: it stops `speed` / 10 s^-1 past it, where both
/// balance. `top_pull` limits the speed of the pull.
void pull(Path& path, double angle, double speed, double top_pull, double acceleration,
          double seconds);

/// The control gains of an axis. Torques are given as accelerations: the inertia of the camera is
/// 1.
struct AxisGains {
  double stiffness{};         ///< 1/s^2
  double damping{};           ///< 1/s
  double integral{};          ///< 1/s^3
  double strength{};          ///< of the motor, deg/s^2; 0 means no holding torque
  double acceleration{1000};  ///< limit of the target, deg/s^2
};

AxisGains gains_of(const AxisTuning& tuning);

/// The frame at the end of a step, and the error of the IMU's estimate.
struct AxisSurroundings {
  double frame{}, frame_speed{};  ///< degrees, deg/s
  double error{}, error_speed{};  ///< error of the estimated angle
  double coupling{};              ///< how strongly the joint transmits frame rotation, 1/s
  double imbalance{};             ///< acceleration that the motor must compensate, deg/s^2
};

/// The camera about one axis. `angle` is the estimate of the IMU: angle = frame + joint + error of
/// the estimate.
struct AxisMotion {
  double angle{}, speed{};
  double joint{}, joint_speed{};
  double integral{};  ///< integral of the angle error, deg s
  double load{};      ///< motor load, -1..1
  double balance{};   ///< motor load, averaged over the last second
  bool is_jammed = false;

  /// Makes the loop hold the target `path`, which moved with `acceleration` in this step.
  void hold(const AxisGains& gains, const Path& path, double acceleration,
            const AxisSurroundings& around, double seconds);
  /// Moves the axis without motor power: only friction acts on it.
  void coast(const AxisSurroundings& around, double seconds);
  /// Blocks the joint: angle and speed follow the frame.
  void stick(const AxisSurroundings& around);
};

}  // namespace sbgc::emulator
