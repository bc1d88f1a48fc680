#include "device/calibration/auto_tuning.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <sbgc/parameters.hpp>

#include "device/calibration/frequency_response.hpp"
#include "device/parameters/parameters.hpp"
#include "device/ports.hpp"
#include "physics/noise.hpp"

namespace sbgc::emulator {
namespace {

constexpr std::array axis_flags{msg::AutoPidFlag::roll, msg::AutoPidFlag::pitch,
                                msg::AutoPidFlag::yaw};

/// Assumption: the interval of rounds and reports, and the rounds per axis.
constexpr Duration round_time = milliseconds(500);
constexpr unsigned rounds_per_axis = 20;
constexpr unsigned rounds_for_filter = 5;
/// The amplitude with which the board shakes the camera, in degrees.
constexpr double shake = 0.3;

constexpr std::uint64_t seed_of(const CalibrationParts& parts) {
  return parts.options.gimbal.seed + 0xA1D;
}

/// The remaining fraction of the way to the goal: 1 at the start, 0 after the last round.
double rest_of_way(unsigned round, unsigned rounds) {
  if (round >= rounds) return 0;
  return std::exp(-4.0 * round / rounds);
}

std::uint8_t byte(double value) {
  return static_cast<std::uint8_t>(std::lround(std::clamp(value, 0.0, 255.0)));
}

}  // namespace

bool AutoTuning::start(CalibrationParts& parts, std::uint8_t profile, msg::AutoPidFlags config,
                       std::uint8_t gain, std::optional<std::size_t> port, Instant now) {
  if (run_ || parts.calibrations.under_way() || parts.frequency_response.is_running()) return false;
  if (!parts.gimbal.motors_on()) return false;
  if (profile != parts.parameters.profile()) parts.parameters.select_profile(profile);

  Run run{.profile = profile, .config = config};
  if (config.has(msg::AutoPidFlag::send_gui)) run.port = port;
  const auto parameters = parts.parameters.read<msg::ReadParams3>(profile);
  const auto filters = parts.parameters.read<msg::ReadParamsExt>(profile);
  const bool tunes_filter = config.has(msg::AutoPidFlag::tune_lpf_freq);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const msg::AxisPid& pid = parameters.axes[axis];
    const Gains present{static_cast<double>(pid.p), static_cast<double>(pid.i.raw()),
                        static_cast<double>(pid.d),
                        static_cast<double>(filters.lpf_freq[axis].raw())};
    run.begin[axis] = run.goal[axis] = present;
    if (!config.has(axis_flags[axis])) continue;
    const auto random = [&](std::uint64_t counter) {
      return 0.8 + 0.4 * random_share(seed_of(parts), 4 * axis + counter);
    };
    // Assumption: gains that suit this gimbal; less stability means higher gains.
    const double aggressiveness = 0.6 + 0.8 * gain / 255;
    Gains& goal = run.goal[axis];
    goal = {15 * aggressiveness * random(0), 10 * aggressiveness * random(1),
            20 * aggressiveness * random(2), present.lpf};
    if (tunes_filter) goal.lpf = std::round(120 * aggressiveness * random(3));
    if (!config.has(msg::AutoPidFlag::keep_current)) {
      run.begin[axis] = {goal.p / 4, goal.i / 4, goal.d / 4, tunes_filter ? 60 : present.lpf};
    }
    run.rounds += rounds_per_axis + (tunes_filter ? rounds_for_filter : 0);
  }
  const Duration length =
      Calibrations::scaled(parts.options, round_time * static_cast<std::int32_t>(run.rounds));
  run.rounds = static_cast<unsigned>(std::max<std::int64_t>(1, length.us / round_time.us));
  run.interval = microseconds(std::max<std::int64_t>(1, length.us / run.rounds));
  run.due = now + run.interval;
  run_ = run;
  return true;
}

bool AutoTuning::start(CalibrationParts& parts, Instant now) {
  const auto& parameters = parts.parameters.of<msg::ReadParamsExt2>();
  const msg::AutoPidFlags config = parameters.auto_pid_cfg;
  const bool names_axis = std::any_of(axis_flags.begin(), axis_flags.end(),
                                      [&](msg::AutoPidFlag axis) { return config.has(axis); });
  return names_axis && start(parts, parts.parameters.profile(), config, parameters.auto_pid_gain,
                             std::nullopt, now);
}

void AutoTuning::stop() { run_.reset(); }

Instant AutoTuning::next() const { return run_ ? run_->due : Instant::never; }

void AutoTuning::advance(Instant now, CalibrationParts& parts) {
  while (run_ && run_->due <= now) {
    // Tuning requires running motors.
    if (!parts.gimbal.motors_on()) return run_.reset();
    ++run_->round;
    run_->due = run_->due + run_->interval;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (!run_->config.has(axis_flags[axis])) continue;
      const double noise = 0.8 + 0.4 * random_share(seed_of(parts), 100 + shakes_++);
      run_->error[axis] = (0.1 + 1.9 * rest_of_way(run_->round, run_->rounds)) * noise;
      parts.gimbal.push(axis, shakes_ % 2 == 0 ? shake : -shake, now);
    }
    report(parts, *run_);
    if (run_->round == run_->rounds) {
      store(parts, *run_);
      run_.reset();
    }
  }
}

void AutoTuning::drop_port(std::size_t port) {
  if (run_ && run_->port == port) run_->port.reset();
}

void AutoTuning::restart(Instant) { run_.reset(); }

AutoTuning::Gains AutoTuning::gains(const Run& run, std::size_t axis) const {
  const double rest = rest_of_way(run.round, run.rounds);
  const Gains& begin = run.begin[axis];
  const Gains& goal = run.goal[axis];
  const auto between = [&](double a, double b) { return b + (a - b) * rest; };
  return {between(begin.p, goal.p), between(begin.i, goal.i), between(begin.d, goal.d),
          between(begin.lpf, goal.lpf)};
}

void AutoTuning::report(CalibrationParts& parts, const Run& run) const {
  if (!run.port) return;
  msg::AutoPid progress;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const Gains now = gains(run, axis);
    progress.p[axis] = byte(now.p);
    progress.i[axis] = byte(now.i);
    progress.d[axis] = byte(now.d);
    progress.lpf_freq[axis] = static_cast<std::uint16_t>(std::lround(now.lpf));
    progress.axes[axis].tracking_error = static_cast<float>(run.error[axis]);
  }
  progress.iter_num = static_cast<std::uint16_t>(run.round);
  parts.ports.send(*run.port, progress);
}

/// Stores the tuned values in the profile of the run or in all profiles.
void AutoTuning::store(CalibrationParts& parts, const Run& run) const {
  const auto set_gains = [&](msg::ReadParams3& parameters) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (!run.config.has(axis_flags[axis])) continue;
      const Gains found = gains(run, axis);
      parameters.axes[axis].p = byte(found.p);
      parameters.axes[axis].i = msg::Hundredths(byte(found.i));
      parameters.axes[axis].d = byte(found.d);
    }
  };
  const auto set_filters = [&](msg::ReadParamsExt& parameters) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (!run.config.has(axis_flags[axis])) continue;
      const double frequency = gains(run, axis).lpf;
      parameters.lpf_freq[axis] =
          msg::Frequency(static_cast<std::uint16_t>(std::lround(frequency)));
    }
  };
  for (std::uint8_t profile = 0; profile < ParametersOf<msg::ReadParams3>::copies; ++profile) {
    if (profile != run.profile && !run.config.has(msg::AutoPidFlag::all_profiles)) continue;
    // The length does not change, so the bodies fit.
    static_cast<void>(parts.parameters.change<msg::ReadParams3>(profile, set_gains));
    if (run.config.has(msg::AutoPidFlag::tune_lpf_freq)) {
      static_cast<void>(parts.parameters.change<msg::ReadParamsExt>(profile, set_filters));
    }
  }
}

}  // namespace sbgc::emulator
