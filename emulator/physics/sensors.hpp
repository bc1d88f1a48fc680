/// Inertial measurement units: readings of the sensors, and errors of the estimates.
#pragma once

#include <cstdint>

#include <sbgc/emulator/gimbal.hpp>

#include "physics/attitude.hpp"

namespace sbgc::emulator {

/// One IMU. Its gyroscope has a drift that grows with the temperature; gravity (and references from
/// outside) keep the estimate of its attitude near the truth.
class Imu {
 public:
  /// `noise`: factor on drift and noise. `number` distinguishes the IMUs of one gimbal.
  Imu(std::uint32_t seed, std::uint32_t number, double noise, double ambient, double warming);

  /// By how much the estimated Euler angles are too large, and how fast that grows.
  const Axes<double>& error() const { return error_; }
  const Axes<double>& error_speed() const { return error_speed_; }
  double temperature() const { return temperature_; }

  /// Once per step.
  void step(double seconds) {
    for (std::size_t axis = 0; axis < 3; ++axis) error_[axis] += error_speed_[axis] * seconds;
  }
  /// About once a second, and after each change: determines the course of temperature and estimate
  /// until the next time. `pose` is the true one; `seconds` since the last time.
  void slow(const Pose& pose, double gyro_trust, std::int64_t step, double seconds);

  /// Like slow(), after a time so long that everything except the heading has settled.
  void skip(const Pose& pose, double gyro_trust, std::int64_t step, double seconds);

  /// Sets the error of the estimate, and keeps it until that step.
  void replace(const Axes<double>& error, std::int64_t until);
  bool is_replaced(std::int64_t step) const { return step < replaced_until_; }
  /// Sets a reference for the error that replaces gravity until that step. `has_up`, `has_heading`:
  /// of roll and pitch, of yaw.
  void refer(const Axes<double>& error, bool has_up, bool has_heading, std::int64_t until);
  void correct_gyro(const Vector& offset, double heading);
  void calibrate();
  void restart();

  /// Degrees between the estimate and its reference.
  double gravity_error(std::int64_t step) const;
  double heading_error(std::int64_t step) const;

  struct Readings {
    Vector gyro{}, acceleration{}, magnetic{};
  };
  /// At that time since the start. `rates`: true ones of the body.
  Readings readings(const Pose& pose, const Vector& rates, std::int64_t us) const;

 private:
  /// Share of the error that is corrected per second: less, the more the gyroscope is trusted.
  static double correction(double gyro_trust);
  Vector drift() const;
  /// How fast the drift changes the angles. Assumption: the drift about the body's own axes is that
  /// of roll and pitch, which is exact when the camera is level.
  Axes<double> rates(const Pose& pose) const;
  double reference(std::size_t axis, std::int64_t step) const;

  std::uint64_t seed_;
  double noise_;
  double ambient_, warming_;
  double temperature_;
  Vector bias_{};         ///< of the gyroscope, deg/s
  double calibrated_at_;  ///< Celsius
  Vector offset_{};       ///< by which it is corrected, deg/s
  double heading_ = 0;    ///< about the vertical, deg/s
  Axes<double> error_{}, error_speed_{};
  std::int64_t replaced_until_ = 0;
  Axes<double> reference_{};
  bool refers_up_ = false, refers_heading_ = false;
  std::int64_t refers_until_ = 0;
};

}  // namespace sbgc::emulator
