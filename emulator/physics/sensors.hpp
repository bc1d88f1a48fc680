/// Inertial measurement units: sensor readings and estimation errors.
#pragma once

#include <cstdint>

#include <sbgc/emulator/gimbal.hpp>

#include "physics/attitude.hpp"

namespace sbgc::emulator {

/// One IMU. The drift of its gyroscope grows with temperature; gravity (and external references)
/// keep its attitude estimate close to the true attitude.
class Imu {
 public:
  /// `noise` is a factor of drift and noise. `number` distinguishes the IMUs of one gimbal. `fault`
  /// is a drift in deg/s that no calibration removes.
  Imu(std::uint32_t seed, std::uint32_t number, double noise, double ambient, double warming,
      const Vector& fault);

  /// The error of the estimated Euler angles (estimate minus true value), and its rate of change.
  const Axes<double>& error() const { return error_; }
  const Axes<double>& error_speed() const { return error_speed_; }
  double temperature() const { return temperature_; }

  /// Call once per step.
  void step(double seconds) {
    for (std::size_t axis = 0; axis < 3; ++axis) error_[axis] += error_speed_[axis] * seconds;
  }
  /// Call about once per second, and after each change: determines how temperature and estimate
  /// evolve until the next call. `pose` is the true one; `seconds` is the time since the last call.
  void slow(const Pose& pose, double gyro_trust, std::int64_t step, double seconds);

  /// Like slow(), but after a long time in which everything except the heading has settled.
  void skip(const Pose& pose, double gyro_trust, std::int64_t step, double seconds);

  /// Sets the error of the estimate and keeps it until the step `until`.
  void replace(const Axes<double>& error, std::int64_t until);
  bool is_replaced(std::int64_t step) const { return step < replaced_until_; }
  /// Sets a reference for the error that replaces gravity until the step `until`. `has_up` applies
  /// to roll and pitch, `has_heading` to yaw.
  void set_reference(const Axes<double>& error, bool has_up, bool has_heading, std::int64_t until);
  void correct_gyro(const Vector& offset, double heading);
  /// Replaces the drift that no calibration removes.
  void set_fault(const Vector& fault) { fault_ = fault; }
  void calibrate();
  void restart();

  /// The angle between the estimate and its reference, degrees.
  double gravity_error(std::int64_t step) const;
  double heading_error(std::int64_t step) const;

  struct Readings {
    Vector gyro{}, acceleration{}, magnetic{};
  };
  /// The readings `us` after the start. `rates` are the true rates of the body.
  Readings readings(const Pose& pose, const Vector& rates, std::int64_t us) const;

 private:
  /// The share of the error that is corrected per second; decreases with `gyro_trust`.
  static double correction(double gyro_trust);
  Vector drift() const;
  /// The speed at which the drift changes the angles. Assumption: the drift about the body axes
  /// acts on roll and pitch directly, which is exact if the camera is level.
  Axes<double> rates(const Pose& pose) const;
  double reference(std::size_t axis, std::int64_t step) const;

  std::uint64_t seed_;
  double noise_;
  double ambient_, warming_;
  double temperature_;
  Vector fault_;          ///< constant part of the drift, deg/s
  Vector bias_{};         ///< of the gyroscope, deg/s
  double calibrated_at_;  ///< Celsius
  Vector offset_{};       ///< correction of the gyroscope, deg/s
  double heading_ = 0;    ///< correction about the vertical, up, deg/s
  Axes<double> error_{}, error_speed_{};
  std::int64_t replaced_until_ = 0;
  Axes<double> reference_{};
  bool refers_up_ = false, refers_heading_ = false;
  std::int64_t refers_until_ = 0;
};

}  // namespace sbgc::emulator
