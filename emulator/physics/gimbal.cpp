#include <sbgc/emulator/gimbal.hpp>

#include "physics/limits.hpp"
#include "physics/mechanics.hpp"

namespace sbgc::emulator {

namespace {

// External reports are valid for this long.
constexpr std::int64_t help_steps = steps_per_second;
constexpr std::int64_t replace_steps = steps_per_second;
constexpr std::int64_t refer_steps = 2 * steps_per_second;

/// Returns the externally reported attitude; unreported parts keep their value.
std::optional<Rotation> reported_attitude(const Gimbal::Attitude& attitude,
                                          const Rotation& before) {
  if (!attitude.up) return rotation_of(before.up(), attitude.north.value_or(before.north()));
  if (attitude.north) return rotation_of(*attitude.up, *attitude.north);
  // A tilt does not turn the camera about its vertical.
  const std::optional<Vector> up = unit(*attitude.up);
  if (!up || dot(*up, before.up()) < -0.999) return {};
  return rotation_of(*up, turned(before.north(), before.up(), *up));
}

}  // namespace

Gimbal::Gimbal(const Options& options, Instant start)
    : mechanics_(std::make_unique<Mechanics>(options, start)) {}
Gimbal::Gimbal(Gimbal&&) noexcept = default;
Gimbal& Gimbal::operator=(Gimbal&&) noexcept = default;
Gimbal::~Gimbal() = default;

void Gimbal::restart(Instant now) {
  Mechanics& mechanics = *mechanics_;
  mechanics.advance(now);
  mechanics.is_on = false;
  mechanics.is_stopped = false;
  mechanics.helped_until = 0;
  mechanics.main.restart();
  mechanics.second.restart();
  for (std::size_t i = 0; i < 3; ++i) {
    mechanics.orders[i].command = {};
    mechanics.orders[i].remote.reset();
    mechanics.orders[i].followed.reset();
    mechanics.axes[i].restart(mechanics.around(i));
  }
  mechanics.update_slow(0);
}

void Gimbal::tune(const Tuning& tuning, Instant now) {
  Mechanics& mechanics = *mechanics_;
  mechanics.advance(now);
  mechanics.order = valid_order(tuning.rotation_order);
  mechanics.gyro_trust = tuning.gyro_trust;
  mechanics.battery_stop = tuning.battery_stop;
  for (std::size_t i = 0; i < 3; ++i) {
    mechanics.orders[i].tuning = tuning.axes[i];
    mechanics.orders[i].gains = gains_of(tuning.axes[i]);
    mechanics.apply_orders(i, false);
  }
  mechanics.check_battery();
}

void Gimbal::change(const Options& options, Instant now) {
  mechanics_->advance(now);
  mechanics_->change(options);
}

void Gimbal::set_motors(bool on, Instant now) {
  Mechanics& mechanics = *mechanics_;
  mechanics.advance(now);
  mechanics.is_on = on;
  if (on) mechanics.is_stopped = false;
  for (std::size_t i = 0; i < 3; ++i) mechanics.apply_orders(i, false);
  mechanics.check_battery();
}

bool Gimbal::motors_on() const { return mechanics_->is_on; }
bool Gimbal::stopped_by_battery() const { return mechanics_->is_stopped; }

void Gimbal::command(std::size_t axis, const AxisCommand& command, Instant now) {
  Mechanics& mechanics = *mechanics_;
  mechanics.advance(now);
  mechanics.orders[axis].command = {command.mode, within(command.speed, -top_speed, top_speed),
                                    within(command.angle, -top_angle, top_angle),
                                    within(command.signal, -1, 1), command.is_lost};
  mechanics.apply_orders(axis, true);
}

const AxisCommand& Gimbal::command(std::size_t axis) const {
  return mechanics_->orders[axis].command;
}

void Gimbal::set_remote(std::size_t axis, std::optional<double> signal, Instant now) {
  Mechanics& mechanics = *mechanics_;
  mechanics.advance(now);
  if (signal) signal = within(*signal, -1, 1);
  mechanics.orders[axis].remote = signal;
  mechanics.apply_orders(axis, false);
}

void Gimbal::set_followed(std::size_t axis, std::optional<double> angle, Instant now) {
  Mechanics& mechanics = *mechanics_;
  mechanics.advance(now);
  if (angle) angle = within(*angle, -top_angle, top_angle);
  mechanics.orders[axis].followed = angle;
  mechanics.apply_orders(axis, false);
}

void Gimbal::help(Instant now) {
  mechanics_->advance(now);
  mechanics_->helped_until = mechanics_->step + help_steps;
}

void Gimbal::correct(const Attitude& attitude, Instant now) {
  Mechanics& mechanics = *mechanics_;
  mechanics.advance(now);
  Imu& imu = attitude.of_frame ? mechanics.second : mechanics.main;
  Imu& other = attitude.of_frame ? mechanics.main : mechanics.second;
  const Axes<double> estimate = attitude.of_frame
                                    ? plus(mechanics.frame.now().angles, mechanics.second.error())
                                    : mechanics.estimate();
  const auto reported = reported_attitude(attitude, Pose(estimate, mechanics.order).rotation());
  if (!reported) return;
  const Axes<double> off = minus(angles_of(*reported, mechanics.order, estimate), estimate);
  const Axes<double> error = plus(imu.error(), off);
  const auto refer = [&](Imu& to) {
    to.set_reference(error, attitude.up.has_value(), attitude.north.has_value(),
                     mechanics.step + refer_steps);
  };
  // The joints are known exactly, so the error is the same for both IMUs.
  if (attitude.translates) refer(other);
  if (attitude.reference_only) {
    refer(imu);
  } else {
    imu.replace(error, mechanics.step + replace_steps);
    if (!attitude.of_frame) {
      for (std::size_t i = 0; i < 3; ++i) {
        mechanics.axes[i].motion.angle += off[i];
        mechanics.apply_orders(i, false);
      }
    }
  }
  mechanics.update_slow(0);
}

bool Gimbal::is_frame_reported(Instant now) {
  mechanics_->advance(now);
  return mechanics_->second.is_replaced(mechanics_->step);
}

void Gimbal::correct_gyro(bool of_frame, const Vector& offset, double heading, Instant now) {
  mechanics_->advance(now);
  (of_frame ? mechanics_->second : mechanics_->main).correct_gyro(offset, heading);
  mechanics_->update_slow(0);
}

void Gimbal::gyro_calibrated(bool of_frame, Instant now) {
  mechanics_->advance(now);
  (of_frame ? mechanics_->second : mechanics_->main).calibrate();
  mechanics_->update_slow(0);
}

void Gimbal::push(std::size_t axis, double degrees, Instant now) {
  mechanics_->advance(now);
  mechanics_->axes[axis].push(within(degrees, -top_angle, top_angle));
}

void Gimbal::jam(std::size_t axis, bool is_jammed, Instant now) {
  mechanics_->advance(now);
  mechanics_->axes[axis].motion.is_jammed = is_jammed;
}

void Gimbal::set_battery(double volts, Instant now) {
  mechanics_->advance(now);
  mechanics_->battery.set(volts);
  mechanics_->check_battery();
}

void Gimbal::place(const Axes<double>& angles, Instant now) {
  Mechanics& mechanics = *mechanics_;
  mechanics.advance(now);
  for (std::size_t i = 0; i < 3; ++i) {
    mechanics.orders[i].command = {};
    mechanics.axes[i].place(within(angles[i], -top_angle, top_angle), mechanics.around(i));
    mechanics.apply_orders(i, false);
  }
}

Sample Gimbal::sample(Instant now) {
  mechanics_->advance(now);
  return mechanics_->measure(now);
}

}  // namespace sbgc::emulator
