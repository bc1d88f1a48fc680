#include "physics/path.hpp"

#include <algorithm>
#include <cmath>

namespace sbgc::emulator {

namespace {

/// A smaller distance counts as arrived, degrees.
constexpr double arrived = 1e-9;

/// Changes the speed with constant acceleration.
void move(Path& path, double speed, double seconds) {
  path.position += (path.speed + speed) / 2 * seconds;
  path.speed = speed;
}

}  // namespace

void turn(Path& path, double speed, double acceleration, double seconds) {
  const double change = acceleration * seconds;
  move(path, std::clamp(speed, path.speed - change, path.speed + change), seconds);
}

void go(Path& path, double goal, double fastest, double acceleration, double seconds) {
  const double change = acceleration * seconds;
  // Computed as if the goal were in the positive direction.
  const double sign = goal < path.position ? -1 : 1;
  const double distance = (goal - path.position) * sign;
  const double speed = path.speed * sign;
  const double stopping_distance = speed * seconds / 2;
  const bool can_stop = std::abs(speed) <= change * (1 + 1e-6);
  if (can_stop && (distance <= arrived || (speed > 0 && distance <= stopping_distance))) {
    path = {goal, 0};
    return;
  }
  // The speed after this step at which braking ends exactly at the goal:
  // distance - (speed + next) / 2 * seconds = next^2 / (2 * acceleration).
  double next = 0;
  if (distance > stopping_distance) {
    next = acceleration *
           (std::sqrt(seconds * seconds / 4 + 2 * (distance - stopping_distance) / acceleration) -
            seconds / 2);
  }
  next = std::clamp(std::min(next, fastest), speed - change, speed + change);
  move(path, next * sign, seconds);
}

void pull(Path& path, double angle, double speed, double top_pull, double acceleration,
          double seconds) {
  constexpr double strength = 10;  // 1/s
  if (speed == 0) {
    go(path, angle, top_pull, acceleration, seconds);
    return;
  }
  const double end = angle + speed / strength;
  const double distance = std::abs(end - path.position);
  const double sign = end < path.position ? -1 : 1;
  // Brake with half of the acceleration; the rest is for following a moving end.
  double wanted = std::min(
      {strength * distance, std::sqrt(acceleration * distance), top_pull + std::abs(speed)});
  if (distance < 1e-4 && std::abs(path.speed) <= acceleration * seconds) {
    path = {end, 0};
    return;
  }
  wanted *= sign;
  turn(path, wanted, acceleration, seconds);
}

}  // namespace sbgc::emulator
