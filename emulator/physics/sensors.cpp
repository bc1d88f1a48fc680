#include "physics/sensors.hpp"

#include <cmath>

#include "physics/limits.hpp"
#include "physics/noise.hpp"

namespace sbgc::emulator {

namespace {

// Typical data sheet values of common sensors, after the filters of the board.
constexpr double gyro_noise = 0.05;           // deg/s
constexpr double acceleration_noise = 0.002;  // g
constexpr double magnetic_noise = 0.003;
constexpr double largest_bias = 0.004;    // deg/s
constexpr double bias_per_degree = 2e-5;  // deg/s per Celsius
constexpr double warming_seconds = 400;

// A magnetic field that points north and down, as in central Europe.
constexpr double field_north = 0.4;
constexpr double field_down = 0.916515138991168;

constexpr std::size_t yaw_axis = 2;

Vector sum(const Vector& a, const Vector& b, double factor) {
  return {a.x + b.x * factor, a.y + b.y * factor, a.z + b.z * factor};
}

}  // namespace

Imu::Imu(std::uint32_t seed, std::uint32_t number, double noise, double ambient, double warming,
         const Vector& fault)
    : seed_(random_bits(seed, 100 + number)),
      noise_(within(noise, 0, 1000)),
      ambient_(within(ambient, -100, 200)),
      warming_(warming),
      temperature_(ambient_),
      fault_(fault),
      calibrated_at_(ambient_) {
  for (std::size_t i = 0; i < 3; ++i) {
    bias_[i] = noise_ * largest_bias * (2 * random_share(seed_, i) - 1);
  }
}

Vector Imu::drift() const {
  const double warmer = noise_ * bias_per_degree * (temperature_ - calibrated_at_);
  Vector result = sum(sum(bias_, fault_, 1), offset_, -1);
  for (std::size_t i = 0; i < 3; ++i) result[i] += warmer;
  return result;
}

double Imu::reference(std::size_t axis, std::int64_t step) const {
  const bool is_outside = step < refers_until_ && (axis == yaw_axis ? refers_heading_ : refers_up_);
  if (!is_outside && axis == yaw_axis)
    return error_[yaw_axis];  // an IMU does not measure the heading
  // Whole turns are not an error.
  return error_[axis] + wrapped((is_outside ? reference_[axis] : 0) - error_[axis]);
}

double Imu::correction(double gyro_trust) { return 1 / (1 + 0.1 * within(gyro_trust, 0, 255)); }

Axes<double> Imu::rates(const Pose& pose) const {
  const Vector drift = this->drift();
  Axes<double> rates = turning(drift);
  rates.yaw = turning({0, 0, dot(drift, pose.rotation().up()) - heading_}).yaw;
  return rates;
}

void Imu::slow(const Pose& pose, double gyro_trust, std::int64_t step, double seconds) {
  temperature_ += (ambient_ + warming_ - temperature_) * -std::expm1(-seconds / warming_seconds);
  if (is_replaced(step)) {
    error_speed_ = {};
    return;
  }
  const Axes<double> rates = this->rates(pose);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    error_speed_[axis] =
        rates[axis] + (reference(axis, step) - error_[axis]) * correction(gyro_trust);
  }
}

void Imu::skip(const Pose& pose, double gyro_trust, std::int64_t step, double seconds) {
  slow(pose, gyro_trust, step, seconds);
  const Axes<double> rates = this->rates(pose);
  for (std::size_t axis = 0; axis < yaw_axis; ++axis) {
    error_[axis] = reference(axis, step) + rates[axis] / correction(gyro_trust);
  }
  error_[yaw_axis] += rates[yaw_axis] * seconds;
  slow(pose, gyro_trust, step, 0);
}

void Imu::replace(const Axes<double>& error, std::int64_t until) {
  error_ = error;
  error_speed_ = {};
  replaced_until_ = until;
}

void Imu::set_reference(const Axes<double>& error, bool has_up, bool has_heading,
                        std::int64_t until) {
  reference_ = error;
  refers_up_ = has_up;
  refers_heading_ = has_heading;
  refers_until_ = until;
}

void Imu::correct_gyro(const Vector& offset, double heading) {
  for (std::size_t i = 0; i < 3; ++i) offset_[i] = within(offset[i], -top_speed, top_speed);
  heading_ = within(heading, -top_speed, top_speed);
}

void Imu::calibrate() {
  bias_ = {};
  offset_ = {};
  heading_ = 0;
  calibrated_at_ = temperature_;
}

void Imu::restart() {
  error_ = {};
  error_speed_ = {};
  replaced_until_ = 0;
  refers_until_ = 0;
}

double Imu::gravity_error(std::int64_t step) const {
  return std::hypot(reference(0, step) - error_[0], reference(1, step) - error_[1]);
}

double Imu::heading_error(std::int64_t step) const {
  return std::abs(wrapped(reference(yaw_axis, step) - error_[yaw_axis]));
}

Imu::Readings Imu::readings(const Pose& pose, const Vector& rates, std::int64_t us) const {
  const Vector& up = pose.rotation().up();
  const Vector& north = pose.rotation().north();
  Readings result;
  result.gyro = sum(sum(rates, drift(), 1), up, -heading_);
  result.acceleration = up;
  for (std::size_t i = 0; i < 3; ++i) {
    result.magnetic[i] = north[i] * field_north - up[i] * field_down;
  }
  if (noise_ == 0) return result;
  const auto time = static_cast<std::uint64_t>(us);
  for (std::size_t i = 0; i < 3; ++i) {
    result.gyro[i] += noise_ * gyro_noise * random_normal(seed_ + 1 + i, time);
    result.acceleration[i] += noise_ * acceleration_noise * random_normal(seed_ + 4 + i, time);
    result.magnetic[i] += noise_ * magnetic_noise * random_normal(seed_ + 7 + i, time);
  }
  return result;
}

}  // namespace sbgc::emulator
