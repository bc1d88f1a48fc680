/// The simulation behind Gimbal: frame, IMUs, axes and battery, moved in equal steps.
#pragma once

#include <array>
#include <cstdint>

#include <sbgc/emulator/gimbal.hpp>

#include "physics/attitude.hpp"
#include "physics/axis_state.hpp"
#include "physics/battery.hpp"
#include "physics/disturbance_motion.hpp"
#include "physics/sensors.hpp"

namespace sbgc::emulator {

struct Mechanics {
  using AxisStates = std::array<AxisState, 3>;

  Mechanics(const Gimbal::Options& options, Instant at);

  /// Takes all steps up to that time.
  void advance(Instant now);
  /// Has an axis carry out its orders from now on. `is_new`: there is a new command.
  void obey(std::size_t axis, bool is_new);
  /// Updates what changes slowly; `seconds` have passed since the last time.
  void update_slow(double seconds);
  /// Turns the motors off if the battery is too low for them.
  void check_battery();
  /// Everything that can be measured. Precondition: advanced to `now`.
  Sample measure(Instant now) const;

  AxisSurroundings around(std::size_t axis) const;
  /// The angles of the camera as the main IMU estimates them.
  Axes<double> estimate() const;

  Instant start;
  std::int64_t step = 0;
  FrameMotion frame;
  Imu main, second;
  Battery battery;
  Axes<double> imbalance{};
  RotationOrder order = valid_order({1, 0, 2});
  double gyro_trust = 100;
  double battery_stop = -1;
  bool is_on = false;
  bool is_stopped = false;
  std::int64_t helped_until = 0;
  double load_sum = 0;  ///< of motors and steps, for the charge
  std::array<AxisOrders, 3> orders{};
  AxisStates axes{};

 private:
  void advance_to(std::int64_t until);
  void skip_to(std::int64_t until);
  AxisSurroundings around(std::size_t axis, const FrameMotion::State& at,
                          const Axes<double>& error) const;
  /// What the current of a motor is proportional to.
  double motor_load(std::size_t i, const AxisState& axis) const;
  double current(const AxisStates& at) const;
  Pose true_pose() const;
};

/// a - b, and a + b * factor.
Axes<double> minus(const Axes<double>& a, const Axes<double>& b);
Axes<double> plus(const Axes<double>& a, const Axes<double>& b, double factor = 1);

}  // namespace sbgc::emulator
