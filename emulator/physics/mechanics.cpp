#include "physics/mechanics.hpp"

#include <algorithm>
#include <cmath>

#include "physics/limits.hpp"

namespace sbgc::emulator {

namespace {

/// The update interval of slow quantities: slightly more than a second.
constexpr std::int64_t slow_steps = 256;
constexpr double slow_seconds = slow_steps * step_seconds;
/// Longer gaps are not simulated completely, so that a call takes a few milliseconds at most.
constexpr std::int64_t longest_gap = 60 * steps_per_second;
/// The simulated time before and after the skipped part.
constexpr std::int64_t settling_steps = 10 * steps_per_second;

constexpr double board_current = 0.15;  // amperes
constexpr double motor_current = 0.8;   // at full power
/// The torque of the imbalance option, which is a share of the motor torque at power 100.
constexpr double imbalance_strength = 3000;

/// Adds a vibration to the motion of the camera, if the motor that excites it is on.
void add_vibration(const Vibration& vibration, std::int64_t us, const Mechanics::AxisStates& axes,
                   Sample& sample) {
  constexpr double turn = 2 * 3.14159265358979323846;
  if (!axes[vibration.axis].is_held || !(vibration.frequency > 0)) return;
  const double phase = std::fmod(vibration.frequency * static_cast<double>(us) * 1e-6, 1) * turn;
  sample.speeds[vibration.axis] += vibration.rate * std::sin(phase);
  sample.angles[vibration.axis] -= vibration.rate / (turn * vibration.frequency) * std::cos(phase);
}

double motor_share(const AxisOrders& orders, const AxisState& axis) {
  if (!axis.is_held) return 0;
  const double set = within(orders.tuning.power, 0, 255) / 255;
  return std::min(1.0, set * (1 + 0.5 * std::abs(axis.motion.load)));
}

}  // namespace

Axes<double> minus(const Axes<double>& a, const Axes<double>& b) {
  return {a.roll - b.roll, a.pitch - b.pitch, a.yaw - b.yaw};
}

Axes<double> plus(const Axes<double>& a, const Axes<double>& b, double factor) {
  return {a.roll + b.roll * factor, a.pitch + b.pitch * factor, a.yaw + b.yaw * factor};
}

Mechanics::Mechanics(const Gimbal::Options& options, Instant at)
    : start(at),
      seed(options.seed),
      frame(options.frame, seed),
      main(options.seed, 1, options.noise, options.ambient, 14, options.gyro_drift),
      second(options.seed, 2, options.noise, options.ambient, 9, {}),
      battery(options.battery, options.capacity) {
  load(options);
  for (std::size_t i = 0; i < 3; ++i) {
    axes[i].motion.stick(around(i));
    axes[i].apply_orders(orders[i], false, true, around(i));
  }
  update_slow(0);
}

void Mechanics::load(const Gimbal::Options& options) {
  vibration = options.vibration;
  strain = options.strain;
  for (std::size_t i = 0; i < 3; ++i) {
    imbalance[i] = -imbalance_strength * within(options.imbalance[i], -1, 1);
  }
}

void Mechanics::change(const Gimbal::Options& options) {
  frame = FrameMotion(options.frame, seed);
  frame.jump(step);
  battery.change(options.battery, options.capacity);
  main.set_fault(options.gyro_drift);
  load(options);
  for (std::size_t i = 0; i < 3; ++i) {
    if (!axes[i].is_held) axes[i].motion.stick(around(i));
  }
  update_slow(0);
  check_battery();
}

AxisSurroundings Mechanics::around(std::size_t axis) const {
  return around(axis, frame.now(), main.error());
}

AxisSurroundings Mechanics::around(std::size_t axis, const FrameMotion::State& at,
                                   const Axes<double>& error) const {
  // Help from an external system makes half of the transmitted rotation predictable.
  return {at.angles[axis],
          at.speeds[axis],
          error[axis],
          main.error_speed()[axis],
          step < helped_until ? 0.5 : 1.0,
          imbalance[axis]};
}

void Mechanics::advance(Instant now) {
  const std::int64_t until = std::max<std::int64_t>(0, (now - start).us) / step_us;
  if (until - step > longest_gap) {
    advance_to(step + settling_steps);
    skip_to(until - settling_steps);
  }
  advance_to(until);
}

void Mechanics::advance_to(std::int64_t until) {
  while (step < until) {
    ++step;
    frame.step();
    main.step(step_seconds);
    second.step(step_seconds);
    for (std::size_t i = 0; i < 3; ++i) {
      axes[i].step(orders[i], around(i), step_seconds);
      if (axes[i].is_held) load_sum += motor_load(i, axes[i]);
    }
    if (step % slow_steps == 0) update_slow(slow_seconds);
  }
}

void Mechanics::skip_to(std::int64_t until) {
  const double seconds = static_cast<double>(until - step) * step_seconds;
  step = until;
  frame.jump(until);
  battery.draw(current(axes), seconds);
  load_sum = 0;
  main.skip(true_pose(), gyro_trust, step, seconds);
  second.skip(Pose(frame.now().angles, order), gyro_trust, step, seconds);
  for (std::size_t i = 0; i < 3; ++i) axes[i].skip(orders[i], around(i), seconds);
  check_battery();
}

void Mechanics::update_slow(double seconds) {
  if (seconds > 0) {
    battery.draw(board_current + motor_current * load_sum / slow_steps, seconds);
    load_sum = 0;
    check_battery();
  }
  main.slow(true_pose(), gyro_trust, step, seconds);
  second.slow(Pose(frame.now().angles, order), gyro_trust, step, seconds);
}

double Mechanics::motor_load(std::size_t i, const AxisState& axis) const {
  return orders[i].gains.strength / (2.55 * imbalance_strength) *
         (0.3 + 0.7 * std::abs(axis.motion.load));
}

double Mechanics::current(const AxisStates& at) const {
  double sum = board_current;
  for (std::size_t i = 0; i < 3; ++i) {
    if (at[i].is_held) sum += motor_current * motor_load(i, at[i]);
  }
  return sum;
}

void Mechanics::check_battery() {
  if (!is_on || battery_stop < 0 || battery.voltage(current(axes)) >= battery_stop) return;
  is_on = false;
  is_stopped = true;
  for (std::size_t i = 0; i < 3; ++i) apply_orders(i, false);
}

void Mechanics::apply_orders(std::size_t axis, bool is_new) {
  axes[axis].apply_orders(orders[axis], is_on, is_new, around(axis));
}

Axes<double> Mechanics::estimate() const {
  return {axes[0].motion.angle, axes[1].motion.angle, axes[2].motion.angle};
}

Pose Mechanics::true_pose() const { return {minus(estimate(), main.error()), order}; }

Sample Mechanics::measure(Instant now) const {
  const std::int64_t us = std::max<std::int64_t>(0, (now - start).us);
  const std::int64_t since_step = std::max<std::int64_t>(0, us - step * step_us);
  const double seconds = static_cast<double>(since_step) * 1e-6;

  const FrameMotion::State frame_now = frame.ahead(since_step);
  const Axes<double> error = plus(main.error(), main.error_speed(), seconds);
  const Axes<double> frame_error = plus(second.error(), second.error_speed(), seconds);
  // A partial step of a copy: the part of the next step until now.
  AxisStates moved = axes;
  if (since_step > 0) {
    for (std::size_t i = 0; i < 3; ++i) {
      moved[i].step(orders[i], around(i, frame_now, error), seconds);
    }
  }

  Sample sample;
  for (std::size_t i = 0; i < 3; ++i) {
    const AxisState& axis = moved[i];
    sample.angles[i] = axis.motion.angle;
    sample.speeds[i] = axis.motion.speed;
    sample.targets[i] = axis.target();
    sample.target_speeds[i] = axis.target_speed();
    sample.joints[i] = axis.motion.joint;
    sample.power[i] = axis.is_held ? within(motor_share(orders[i], axis) + strain[i], 0, 1) : 0;
    sample.imbalance[i] = axis.motion.balance;
  }
  if (vibration) add_vibration(*vibration, us, moved, sample);
  sample.frame = plus(frame_now.angles, frame_error);

  const Pose camera_estimate(sample.angles, order);
  const Pose frame_estimate(sample.frame, order);
  // Without errors the estimates are exact.
  const Pose camera =
      error == Axes<double>{} ? camera_estimate : Pose(minus(sample.angles, error), order);
  const Pose true_frame =
      frame_error == Axes<double>{} ? frame_estimate : Pose(frame_now.angles, order);
  sample.up = camera_estimate.rotation().up();
  sample.north = camera_estimate.rotation().north();
  sample.frame_up = frame_estimate.rotation().up();
  sample.frame_north = frame_estimate.rotation().north();
  sample.frame_speed = true_frame.rates(frame_now.speeds);

  const Imu::Readings main_readings =
      main.readings(camera, camera.rates(minus(sample.speeds, main.error_speed())), us);
  sample.gyro = main_readings.gyro;
  sample.acceleration = main_readings.acceleration;
  sample.magnetic = main_readings.magnetic;
  const Imu::Readings second_readings = second.readings(true_frame, sample.frame_speed, us);
  sample.frame_gyro = second_readings.gyro;
  sample.frame_acceleration = second_readings.acceleration;

  const double amperes = current(moved);
  sample.current = amperes;
  sample.battery = battery.voltage(amperes);
  sample.temperature = main.temperature();
  sample.frame_temperature = second.temperature();
  sample.gravity_error = main.gravity_error(step);
  sample.heading_error = main.heading_error(step);
  sample.frame_gravity_error = second.gravity_error(step);
  sample.frame_heading_error = second.heading_error(step);
  return sample;
}

namespace {

constexpr double resistance = 0.05;  // ohms, including the wires

}  // namespace

Battery::Battery(double full, double capacity)
    : full_(within(full, 0, 1000)), capacity_(within(capacity, 0, 1e6)) {}

void Battery::draw(double current, double seconds) {
  if (capacity_ > 0) drawn_ = std::min(capacity_, drawn_ + current * seconds / 3600);
}

double Battery::voltage(double current) const {
  if (set_) return *set_;
  const double charge = capacity_ > 0 ? 1 - drawn_ / capacity_ : 1;
  // Like lithium cells: a slow decrease, and a steep one at the end.
  double open = full_ * (0.84 + 0.16 * charge);
  if (charge < 0.1) open -= full_ * 0.14 * (1 - charge / 0.1);
  return std::max(0.0, open - resistance * current);
}

void Battery::set(double volts) { set_ = within(volts, 0, 1000); }

}  // namespace sbgc::emulator
