/// One axis as a host sees it: orders, target and camera.
#pragma once

#include <cstdint>
#include <optional>

#include <sbgc/emulator/gimbal.hpp>

#include "physics/axis_motion.hpp"

namespace sbgc::emulator {

/// The orders of an axis; they change only on request.
struct AxisOrders {
  AxisTuning tuning{};
  AxisGains gains = gains_of({});
  AxisCommand command{};
  std::optional<double> remote{};
  std::optional<double> followed{};  ///< an angle to follow in place of the frame
};

/// The object that an axis follows.
enum class Followed : std::uint8_t { nothing, frame, reported };

/// The state that changes in each step. The target is the sum of the axis's own path and the follow
/// path; the latter is 0 if the axis follows nothing.
struct AxisState {
  Path own{}, follow{};
  double goal{};  ///< of `own`, in modes that have a goal
  double lead{};  ///< remaining seconds in which the speed of `speed_angle` dominates
  AxisMotion motion{};
  bool is_held = false;  ///< by its motor
  Followed follows = Followed::nothing;
  bool is_starting = true;  ///< true until the start angle is reached

  double target() const { return own.position + follow.position; }
  double target_speed() const { return own.speed + follow.speed; }

  /// Applies the orders from now on. `has_power`: the motors are on. `is_new`: the command is new,
  /// and its reference angles are determined again.
  void apply_orders(const AxisOrders& orders, bool has_power, bool is_new,
                    const AxisSurroundings& around);
  /// Advances by one step of `seconds`; `around` is the state at its end.
  void step(const AxisOrders& orders, const AxisSurroundings& around, double seconds);
  /// Skips a long time in which only the frame has changed.
  void skip(const AxisOrders& orders, const AxisSurroundings& around, double seconds);
  /// Places the camera at `angle`, at rest, and makes it stay there.
  void place(double angle, const AxisSurroundings& around);
  void push(double degrees);
  /// Drops whole turns and prepares the start.
  void restart(const AxisSurroundings& around);

 private:
  /// Sets the target to the current camera angle.
  void hold_position();
  /// Moves the target by one step.
  void move(const AxisOrders& orders, const AxisSurroundings& around, double seconds);
  void move_own(const AxisOrders& orders, double acceleration, double seconds);
  void move_follow(const AxisOrders& orders, double to, double acceleration, double seconds);
  /// The range of `own` that keeps the joint within its limits; empty if there are none.
  struct Room {
    double lowest{}, highest{};
  };
  std::optional<Room> room(const AxisTuning& tuning, const AxisSurroundings& around) const;
};

}  // namespace sbgc::emulator
