/// The implementation of Gimbal: frame, IMUs, axes and battery, advanced in fixed steps.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include <sbgc/emulator/gimbal.hpp>

#include "physics/attitude.hpp"
#include "physics/axis_state.hpp"
#include "physics/disturbance_motion.hpp"
#include "physics/sensors.hpp"

namespace sbgc::emulator {

/// The voltage decreases with the charge drawn and with the current.
class Battery {
 public:
  /// `full` is the full voltage; `capacity` is in ampere hours, 0 means that it never runs empty.
  Battery(double full, double capacity);

  /// Replaces both values; the charge drawn stays drawn.
  void change(double full, double capacity) {
    const double drawn = drawn_;
    *this = Battery(full, capacity);
    drawn_ = drawn;
  }
  /// Draws a current for some time.
  void draw(double current, double seconds);
  /// Returns the voltage at this current.
  double voltage(double current) const;
  /// Fixes the voltage, regardless of load.
  void set(double volts);

 private:
  double full_;
  double capacity_;
  double drawn_ = 0;  ///< ampere hours
  std::optional<double> set_{};
};

struct Mechanics {
  using AxisStates = std::array<AxisState, 3>;

  Mechanics(const Gimbal::Options& options, Instant at);

  /// See Gimbal::change().
  void change(const Gimbal::Options& options);
  /// Executes all steps until `now`.
  void advance(Instant now);
  /// Applies the orders of an axis from now on. `is_new`: there is a new command.
  void apply_orders(std::size_t axis, bool is_new);
  /// Updates the slow quantities; `seconds` is the time since the last update.
  void update_slow(double seconds);
  /// Turns the motors off if the battery voltage is too low.
  void check_battery();
  /// Returns all measurable quantities. Precondition: advanced to `now`.
  Sample measure(Instant now) const;

  AxisSurroundings around(std::size_t axis) const;
  /// The camera angles as estimated by the main IMU.
  Axes<double> estimate() const;

  Instant start;
  std::int64_t step = 0;
  std::uint32_t seed;
  FrameMotion frame;
  Imu main, second;
  Battery battery;
  Axes<double> imbalance{};
  std::optional<Vibration> vibration{};
  Axes<double> strain{};
  RotationOrder order = valid_order({1, 0, 2});
  double gyro_trust = 100;
  double battery_stop = -1;
  bool is_on = false;
  bool is_stopped = false;
  std::int64_t helped_until = 0;
  double load_sum = 0;  ///< over motors and steps, for the battery charge
  std::array<AxisOrders, 3> orders{};
  AxisStates axes{};

 private:
  void load(const Gimbal::Options& options);
  void advance_to(std::int64_t until);
  void skip_to(std::int64_t until);
  AxisSurroundings around(std::size_t axis, const FrameMotion::State& at,
                          const Axes<double>& error) const;
  /// A value proportional to the current of a motor.
  double motor_load(std::size_t i, const AxisState& axis) const;
  double current(const AxisStates& at) const;
  Pose true_pose() const;
};

/// Returns a - b and a + b * factor.
Axes<double> minus(const Axes<double>& a, const Axes<double>& b);
Axes<double> plus(const Axes<double>& a, const Axes<double>& b, double factor = 1);

}  // namespace sbgc::emulator
