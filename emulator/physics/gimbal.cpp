#include <algorithm>
#include <cmath>

#include <sbgc/emulator/gimbal.hpp>

#include "physics/attitude.hpp"
#include "physics/axis_state.hpp"
#include "physics/battery.hpp"
#include "physics/disturbance_motion.hpp"
#include "physics/limits.hpp"
#include "physics/sensors.hpp"

namespace sbgc::emulator {

namespace {

constexpr std::int64_t steps_per_second = 250;
/// So often what changes slowly is looked at: a little more than a second.
constexpr std::int64_t slow_steps = 256;
constexpr double slow_seconds = slow_steps * step_seconds;
/// A longer gap is not simulated in full, so that who asks after it does not wait. Some ms of the
/// processor.
constexpr std::int64_t longest_gap = 60 * steps_per_second;
/// What is simulated before and behind what is left out.
constexpr std::int64_t settling_steps = 10 * steps_per_second;

// What is told from outside is valid so long.
constexpr std::int64_t help_steps = steps_per_second;
constexpr std::int64_t replace_steps = steps_per_second;
constexpr std::int64_t refer_steps = 2 * steps_per_second;

constexpr double board_current = 0.15;  // amperes
constexpr double motor_current = 0.8;   // at full power
/// Torque of the options' imbalance: a share of what a motor does at power 100.
constexpr double imbalance_strength = 3000;

double motor_share(const AxisOrders& orders, const AxisState& axis) {
  if (!axis.is_held) return 0;
  const double set = within(orders.tuning.power, 0, 255) / 255;
  return std::min(1.0, set * (1 + 0.5 * std::abs(axis.motion.load)));
}

Axes<double> minus(const Axes<double>& a, const Axes<double>& b) {
  return {a.roll - b.roll, a.pitch - b.pitch, a.yaw - b.yaw};
}

Axes<double> plus(const Axes<double>& a, const Axes<double>& b, double factor = 1) {
  return {a.roll + b.roll * factor, a.pitch + b.pitch * factor, a.yaw + b.yaw * factor};
}

/// The attitude that an outside source tells, with what it does not tell as before.
std::optional<Rotation> attitude_told(const Gimbal::Attitude& attitude, const Rotation& before) {
  if (!attitude.up) return rotation_of(before.up(), attitude.north.value_or(before.north()));
  if (attitude.north) return rotation_of(*attitude.up, *attitude.north);
  // A tilt does not turn the camera about its vertical.
  const std::optional<Vector> up = unit(*attitude.up);
  if (!up || dot(*up, before.up()) < -0.999) return {};
  return rotation_of(*up, turned(before.north(), before.up(), *up));
}

}  // namespace

struct Gimbal::State {
  State(const Options& options, Instant at)
      : start(at),
        frame(options.frame, options.seed),
        main(options.seed, 1, options.noise, options.ambient, 14),
        second(options.seed, 2, options.noise, options.ambient, 9),
        battery(options.battery, options.capacity) {
    for (std::size_t i = 0; i < 3; ++i) {
      imbalance[i] = -imbalance_strength * within(options.imbalance[i], -1, 1);
      axes[i].motion.stick(around(i));
      axes[i].obey(orders[i], false, true, around(i));
    }
    slow(0);
  }

  using AxisStates = std::array<AxisState, 3>;

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

  AxisSurroundings around(std::size_t axis) const {
    return around(axis, frame.now(), main.error());
  }
  AxisSurroundings around(std::size_t axis, const FrameMotion::State& at,
                          const Axes<double>& error) const {
    // What an outer system tells makes half of what the joints hand on predictable.
    return {at.angles[axis],
            at.speeds[axis],
            error[axis],
            main.error_speed()[axis],
            step < helped_until ? 0.5 : 1.0,
            imbalance[axis]};
  }

  void advance(Instant now) {
    const std::int64_t until = std::max<std::int64_t>(0, (now - start).us) / step_us;
    if (until - step > longest_gap) {
      advance_to(step + settling_steps);
      skip_to(until - settling_steps);
    }
    advance_to(until);
  }

  void advance_to(std::int64_t until) {
    while (step < until) {
      ++step;
      frame.step();
      main.step(step_seconds);
      second.step(step_seconds);
      for (std::size_t i = 0; i < 3; ++i) {
        axes[i].step(orders[i], around(i), step_seconds);
        if (axes[i].is_held) load_sum += motor_load(i, axes[i]);
      }
      if (step % slow_steps == 0) slow(slow_seconds);
    }
  }

  void skip_to(std::int64_t until) {
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

  /// What changes slowly, after so many seconds.
  void slow(double seconds) {
    if (seconds > 0) {
      battery.draw(board_current + motor_current * load_sum / slow_steps, seconds);
      load_sum = 0;
      check_battery();
    }
    main.slow(true_pose(), gyro_trust, step, seconds);
    second.slow(Pose(frame.now().angles, order), gyro_trust, step, seconds);
  }

  /// What the current of a motor is proportional to.
  double motor_load(std::size_t i, const AxisState& axis) const {
    return orders[i].gains.strength / (2.55 * imbalance_strength) *
           (0.3 + 0.7 * std::abs(axis.motion.load));
  }

  double current(const AxisStates& at) const {
    double sum = board_current;
    for (std::size_t i = 0; i < 3; ++i) {
      if (at[i].is_held) sum += motor_current * motor_load(i, at[i]);
    }
    return sum;
  }

  void check_battery() {
    if (!is_on || battery_stop < 0 || battery.voltage(current(axes)) >= battery_stop) return;
    is_on = false;
    is_stopped = true;
    for (std::size_t i = 0; i < 3; ++i) obey(i, false);
  }

  void obey(std::size_t axis, bool is_new) {
    axes[axis].obey(orders[axis], is_on, is_new, around(axis));
  }

  Axes<double> estimate() const {
    return {axes[0].motion.angle, axes[1].motion.angle, axes[2].motion.angle};
  }

  Pose true_pose() const { return {minus(estimate(), main.error()), order}; }
};

Gimbal::Gimbal(const Options& options, Instant start)
    : state_(std::make_unique<State>(options, start)) {}
Gimbal::Gimbal(Gimbal&&) noexcept = default;
Gimbal& Gimbal::operator=(Gimbal&&) noexcept = default;
Gimbal::~Gimbal() = default;

void Gimbal::restart(Instant now) {
  State& state = *state_;
  state.advance(now);
  state.is_on = false;
  state.is_stopped = false;
  state.helped_until = 0;
  state.main.restart();
  state.second.restart();
  for (std::size_t i = 0; i < 3; ++i) {
    state.orders[i].command = {};
    state.orders[i].remote.reset();
    state.orders[i].followed.reset();
    state.axes[i].restart(state.around(i));
  }
  state.slow(0);
}

void Gimbal::tune(const Tuning& tuning, Instant now) {
  State& state = *state_;
  state.advance(now);
  state.order = valid_order(tuning.rotation_order);
  state.gyro_trust = tuning.gyro_trust;
  state.battery_stop = tuning.battery_stop;
  for (std::size_t i = 0; i < 3; ++i) {
    state.orders[i].tuning = tuning.axes[i];
    state.orders[i].gains = gains_of(tuning.axes[i]);
    state.obey(i, false);
  }
  state.check_battery();
}

void Gimbal::set_motors(bool on, Instant now) {
  State& state = *state_;
  state.advance(now);
  state.is_on = on;
  if (on) state.is_stopped = false;
  for (std::size_t i = 0; i < 3; ++i) state.obey(i, false);
  state.check_battery();
}

bool Gimbal::motors_on() const { return state_->is_on; }
bool Gimbal::stopped_by_battery() const { return state_->is_stopped; }

void Gimbal::command(std::size_t axis, const AxisCommand& command, Instant now) {
  State& state = *state_;
  state.advance(now);
  state.orders[axis].command = {command.mode, within(command.speed, -top_speed, top_speed),
                                within(command.angle, -top_angle, top_angle),
                                within(command.signal, -1, 1)};
  state.obey(axis, true);
}

const AxisCommand& Gimbal::command(std::size_t axis) const { return state_->orders[axis].command; }

void Gimbal::set_remote(std::size_t axis, std::optional<double> signal, Instant now) {
  State& state = *state_;
  state.advance(now);
  if (signal) signal = within(*signal, -1, 1);
  state.orders[axis].remote = signal;
  state.obey(axis, false);
}

void Gimbal::set_followed(std::size_t axis, std::optional<double> angle, Instant now) {
  State& state = *state_;
  state.advance(now);
  if (angle) angle = within(*angle, -top_angle, top_angle);
  state.orders[axis].followed = angle;
  state.obey(axis, false);
}

void Gimbal::help(Instant now) {
  state_->advance(now);
  state_->helped_until = state_->step + help_steps;
}

void Gimbal::correct(const Attitude& attitude, Instant now) {
  State& state = *state_;
  state.advance(now);
  Imu& imu = attitude.of_frame ? state.second : state.main;
  Imu& other = attitude.of_frame ? state.main : state.second;
  const Axes<double> estimate =
      attitude.of_frame ? plus(state.frame.now().angles, state.second.error()) : state.estimate();
  const auto told = attitude_told(attitude, Pose(estimate, state.order).rotation());
  if (!told) return;
  const Axes<double> off = minus(angles_of(*told, state.order, estimate), estimate);
  const Axes<double> error = plus(imu.error(), off);
  const auto refer = [&](Imu& to) {
    to.refer(error, attitude.up.has_value(), attitude.north.has_value(), state.step + refer_steps);
  };
  // The joints are known as they are: what is told is as far from the truth for both.
  if (attitude.translates) refer(other);
  if (attitude.reference_only) {
    refer(imu);
  } else {
    imu.replace(error, state.step + replace_steps);
    if (!attitude.of_frame) {
      for (std::size_t i = 0; i < 3; ++i) {
        state.axes[i].motion.angle += off[i];
        state.obey(i, false);
      }
    }
  }
  state.slow(0);
}

bool Gimbal::is_frame_told(Instant now) {
  state_->advance(now);
  return state_->second.is_replaced(state_->step);
}

void Gimbal::correct_gyro(bool of_frame, const Vector& offset, double heading, Instant now) {
  state_->advance(now);
  (of_frame ? state_->second : state_->main).correct_gyro(offset, heading);
  state_->slow(0);
}

void Gimbal::gyro_calibrated(bool of_frame, Instant now) {
  state_->advance(now);
  (of_frame ? state_->second : state_->main).calibrate();
  state_->slow(0);
}

void Gimbal::push(std::size_t axis, double degrees, Instant now) {
  state_->advance(now);
  state_->axes[axis].push(within(degrees, -top_angle, top_angle));
}

void Gimbal::jam(std::size_t axis, bool is_jammed, Instant now) {
  state_->advance(now);
  state_->axes[axis].motion.is_jammed = is_jammed;
}

void Gimbal::set_battery(double volts, Instant now) {
  state_->advance(now);
  state_->battery.set(volts);
  state_->check_battery();
}

void Gimbal::place(const Axes<double>& angles, Instant now) {
  State& state = *state_;
  state.advance(now);
  for (std::size_t i = 0; i < 3; ++i) {
    state.orders[i].command = {};
    state.axes[i].place(within(angles[i], -top_angle, top_angle), state.around(i));
    state.obey(i, false);
  }
}

Sample Gimbal::sample(Instant now) {
  State& state = *state_;
  state.advance(now);
  const std::int64_t us = std::max<std::int64_t>(0, (now - state.start).us);
  const std::int64_t since_step = std::max<std::int64_t>(0, us - state.step * step_us);
  const double seconds = static_cast<double>(since_step) * 1e-6;

  const FrameMotion::State frame = state.frame.ahead(since_step);
  const Axes<double> error = plus(state.main.error(), state.main.error_speed(), seconds);
  const Axes<double> frame_error = plus(state.second.error(), state.second.error_speed(), seconds);
  // A shorter step of a copy: what the next step will do, up to now.
  State::AxisStates axes = state.axes;
  if (since_step > 0) {
    for (std::size_t i = 0; i < 3; ++i) {
      axes[i].step(state.orders[i], state.around(i, frame, error), seconds);
    }
  }

  Sample sample;
  for (std::size_t i = 0; i < 3; ++i) {
    const AxisState& axis = axes[i];
    sample.angles[i] = axis.motion.angle;
    sample.speeds[i] = axis.motion.speed;
    sample.targets[i] = axis.target();
    sample.target_speeds[i] = axis.target_speed();
    sample.joints[i] = axis.motion.joint;
    sample.power[i] = motor_share(state.orders[i], axis);
    sample.imbalance[i] = axis.motion.balance;
  }
  sample.frame = plus(frame.angles, frame_error);

  const Pose estimate(sample.angles, state.order);
  const Pose frame_estimate(sample.frame, state.order);
  // Estimates are true where there are no errors.
  const Pose camera =
      error == Axes<double>{} ? estimate : Pose(minus(sample.angles, error), state.order);
  const Pose true_frame =
      frame_error == Axes<double>{} ? frame_estimate : Pose(frame.angles, state.order);
  sample.up = estimate.rotation().up();
  sample.north = estimate.rotation().north();
  sample.frame_up = frame_estimate.rotation().up();
  sample.frame_north = frame_estimate.rotation().north();
  sample.frame_speed = true_frame.rates(frame.speeds);

  const Imu::Readings main =
      state.main.readings(camera, camera.rates(minus(sample.speeds, state.main.error_speed())), us);
  sample.gyro = main.gyro;
  sample.acceleration = main.acceleration;
  sample.magnetic = main.magnetic;
  const Imu::Readings second = state.second.readings(true_frame, sample.frame_speed, us);
  sample.frame_gyro = second.gyro;
  sample.frame_acceleration = second.acceleration;

  const double current = state.current(axes);
  sample.current = current;
  sample.battery = state.battery.voltage(current);
  sample.temperature = state.main.temperature();
  sample.frame_temperature = state.second.temperature();
  sample.gravity_error = state.main.gravity_error(state.step);
  sample.heading_error = state.main.heading_error(state.step);
  sample.frame_gravity_error = state.second.gravity_error(state.step);
  sample.frame_heading_error = state.second.heading_error(state.step);
  return sample;
}

}  // namespace sbgc::emulator
