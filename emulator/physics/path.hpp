/// Motion of a target with limited speed and acceleration.
#pragma once

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

}  // namespace sbgc::emulator
