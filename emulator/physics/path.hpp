/// How a target moves: speed and acceleration have limits.
#pragma once

namespace sbgc::emulator {

/// A moving point. Degrees, seconds.
struct Path {
  double position{};
  double speed{};
};

/// Brings the speed to `speed` and holds it.
void turn(Path& path, double speed, double acceleration, double seconds);

/// Goes to `goal` and stops exactly there, without overshoot if the present speed allows that. Then
/// the speed is exactly 0.
void go(Path& path, double goal, double fastest, double acceleration, double seconds);

/// Turns with `speed` while it is pulled to `angle`: it stops `speed` / 10 s^-1 behind it, where
/// both balance. `top_pull` limits the speed of the pull.
void pull(Path& path, double angle, double speed, double top_pull, double acceleration,
          double seconds);

}  // namespace sbgc::emulator
