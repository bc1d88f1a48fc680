/// One axis as the host sees it: what it is told, where its target is, and the camera that follows.
#pragma once

#include <cstdint>
#include <optional>

#include <sbgc/emulator/gimbal.hpp>

#include "physics/axis_motion.hpp"
#include "physics/path.hpp"

namespace sbgc::emulator {

/// What is asked of an axis; changes only when somebody asks.
struct AxisOrders {
  AxisTuning tuning{};
  AxisGains gains = gains_of({});
  AxisCommand command{};
  std::optional<double> remote{};
  std::optional<double> followed{};  ///< an angle that somebody tells, instead of the frame
};

/// What an axis follows.
enum class Followed : std::uint8_t { nothing, frame, told };

/// What changes in each step. The target is the sum of the axis's own way and of that on which it
/// follows something; the latter is 0 unless it does.
struct AxisState {
  Path own{}, follow{};
  double goal{};  ///< of `own`, where the mode has one
  double lead{};  ///< so many seconds more the speed of `speed_angle` leads
  AxisMotion motion{};
  bool is_held = false;  ///< by its motor
  Followed follows = Followed::nothing;
  bool is_starting = true;  ///< has yet to go to the start angle

  double target() const { return own.position + follow.position; }
  double target_speed() const { return own.speed + follow.speed; }

  /// Has the orders carried out from now on. `has_power`: the motors are on. `is_new`: the command
  /// is, and what it refers to is found anew.
  void obey(const AxisOrders& orders, bool has_power, bool is_new, const AxisSurroundings& around);
  /// One step, of that length; `around` at its end.
  void step(const AxisOrders& orders, const AxisSurroundings& around, double seconds);
  /// To where it is after a long time, in which nothing has changed but the frame.
  void skip(const AxisOrders& orders, const AxisSurroundings& around, double seconds);
  /// The camera is there, at rest, and is to stay.
  void place(double angle, const AxisSurroundings& around);
  void push(double degrees);
  /// Turns are forgotten, the start is to come.
  void restart(const AxisSurroundings& around);

 private:
  /// The target is where the camera is.
  void stay();
  /// Moves the target by one step.
  void move(const AxisOrders& orders, const AxisSurroundings& around, double seconds);
  void move_own(const AxisOrders& orders, double acceleration, double seconds);
  void move_follow(const AxisOrders& orders, double to, double acceleration, double seconds);
  /// Where `own` may be, so that the joint keeps its limits; nothing if it has none.
  struct Room {
    double lowest{}, highest{};
  };
  std::optional<Room> room(const AxisTuning& tuning, const AxisSurroundings& around) const;
};

}  // namespace sbgc::emulator
