#include "physics/disturbance_motion.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "physics/limits.hpp"
#include "physics/noise.hpp"

namespace sbgc::emulator {

namespace {

struct Sine {
  double degrees, hertz;
};

/// The motion of one axis of a frame.
using Spectrum = std::array<Sine, 4>;

/// Plausible, not measured: slow sway, footsteps, tremor.
constexpr std::array<Spectrum, 3> handheld{
    Spectrum{Sine{1.2, 0.23}, Sine{0.8, 0.9}, Sine{0.4, 1.8}, Sine{0.05, 7.5}},
    Spectrum{Sine{1.5, 0.27}, Sine{1.0, 1.0}, Sine{0.5, 2.0}, Sine{0.06, 8.0}},
    Spectrum{Sine{2.5, 0.15}, Sine{1.2, 0.5}, Sine{0.4, 1.9}, Sine{0.04, 7.0}}};
/// Position-hold tilts, corrections of the flight controller, propellers.
constexpr std::array<Spectrum, 3> drone{
    Spectrum{Sine{3.0, 0.16}, Sine{1.5, 0.6}, Sine{0.4, 3.1}, Sine{0.02, 31}},
    Spectrum{Sine{4.0, 0.13}, Sine{1.5, 0.55}, Sine{0.4, 2.9}, Sine{0.02, 33}},
    Spectrum{Sine{2.0, 0.07}, Sine{0.6, 0.4}, Sine{0.2, 2.1}, Sine{0.01, 30}}};
/// Road bends, suspension, wheels, engine.
constexpr std::array<Spectrum, 3> vehicle{
    Spectrum{Sine{1.5, 0.06}, Sine{1.2, 1.1}, Sine{0.4, 3.5}, Sine{0.04, 14}},
    Spectrum{Sine{1.0, 0.05}, Sine{1.4, 1.3}, Sine{0.5, 4.0}, Sine{0.05, 15}},
    Spectrum{Sine{25, 0.021}, Sine{6, 0.05}, Sine{0.3, 1.2}, Sine{0.02, 13}}};

constexpr double seconds_per_us = 1e-6;
/// About 30 years.
constexpr std::int64_t longest_recording_us = 1'000'000'000'000'000;

double square(double x) { return x * x; }

}  // namespace

FrameMotion::FrameMotion(const Disturbance& disturbance, std::uint32_t seed) {
  if (disturbance.kind == Disturbance::Kind::recorded) {
    plan_recording(disturbance.recording);
  } else if (disturbance.kind != Disturbance::Kind::rest) {
    plan_sines(disturbance, seed);
  }
  jump(0);
}

void FrameMotion::plan_sines(const Disturbance& disturbance, std::uint32_t seed) {
  const auto& spectra = disturbance.kind == Disturbance::Kind::handheld ? handheld
                        : disturbance.kind == Disturbance::Kind::drone  ? drone
                                                                        : vehicle;
  const double strength = within(disturbance.strength, 0, 100);
  has_sines_ = true;
  for (std::size_t i = 0; i < sines; ++i) {
    const Sine& sine = spectra[i / sines_per_axis][i % sines_per_axis];
    // Frequencies vary by up to 10 %, so that the sum does not repeat.
    const double hertz = sine.hertz * (0.9 + 0.2 * random_share(seed, 1000 + 2 * i));
    omega_[i] = 2 * std::numbers::pi * hertz;
    phase_[i] = 2 * std::numbers::pi * random_share(seed, 1001 + 2 * i);
    amplitude_[i] = sine.degrees * strength;
    step_cosine_[i] = std::cos(omega_[i] * step_seconds);
    step_sine_[i] = std::sin(omega_[i] * step_seconds);
  }
}

void FrameMotion::plan_recording(const std::vector<FrameAngles>& recording) {
  for (const FrameAngles& sample : recording) {
    Point point{sample.at.us, sample.angles, {}};
    bool is_good = point.us >= 0 && point.us <= longest_recording_us &&
                   (points_.empty() || point.us > points_.back().us);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      is_good = is_good && std::isfinite(point.angles[axis]);
    }
    if (!is_good) continue;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      // Take the shorter way between two samples.
      double& angle = point.angles[axis];
      const double before = points_.empty() ? 0 : points_.back().angles[axis];
      angle = before + std::remainder(angle - before, 360);
    }
    points_.push_back(point);
  }
  if (points_.empty()) return;
  const std::int64_t first = points_.front().us;
  for (Point& point : points_) point.us -= first;

  // Return to the first sample.
  Point last = points_.front();
  bool is_closed = points_.size() > 1;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double end = points_.back().angles[axis];
    last.angles[axis] = end + std::remainder(last.angles[axis] - end, 360);
    is_closed = is_closed && std::abs(last.angles[axis] - end) < 1e-6;
    per_round_[axis] = last.angles[axis] - points_.front().angles[axis];
  }
  constexpr std::int64_t way_back_us = 1'000'000;
  last.us = points_.back().us + way_back_us;
  if (is_closed) {
    points_.back().angles = last.angles;
  } else {
    points_.push_back(last);
  }

  // Slopes that never overshoot: the harmonic mean of both neighbors if their signs agree.
  const std::size_t n = points_.size() - 1;
  const auto slope = [&](std::size_t i, std::size_t axis) {
    const Point& a = points_[i];
    const Point& b = points_[i + 1];
    return (b.angles[axis] - a.angles[axis]) / (static_cast<double>(b.us - a.us) * seconds_per_us);
  };
  for (std::size_t i = 0; i <= n; ++i) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double before = slope((i + n - 1) % n, axis);
      const double after = slope(i % n, axis);
      if (before * after > 0) {
        points_[i].slopes[axis] = 2 / (1 / before + 1 / after);
      }
    }
  }
}

FrameMotion::State FrameMotion::played(std::int64_t us) const {
  const std::int64_t period = points_.back().us;
  const std::int64_t round = us / period;
  const std::int64_t at = us % period;
  const auto holds = [&](std::size_t i) {
    return i + 1 < points_.size() && points_[i].us <= at && at < points_[i + 1].us;
  };
  if (!holds(place_)) ++place_;
  if (!holds(place_)) {
    const auto next = std::upper_bound(points_.begin(), points_.end(), at,
                                       [](std::int64_t t, const Point& p) { return t < p.us; });
    place_ = static_cast<std::size_t>(next - points_.begin()) - 1;
  }
  const Point& a = points_[place_];
  const Point& b = points_[place_ + 1];
  const double length = static_cast<double>(b.us - a.us) * seconds_per_us;
  const double x = static_cast<double>(at - a.us) * seconds_per_us / length;
  State state;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    // Cubic Hermite polynomial.
    const double rise = b.angles[axis] - a.angles[axis];
    const double start = a.slopes[axis] * length;
    const double end = b.slopes[axis] * length;
    const double c2 = 3 * rise - 2 * start - end;
    const double c3 = start + end - 2 * rise;
    state.angles[axis] = a.angles[axis] + x * (start + x * (c2 + x * c3)) +
                         per_round_[axis] * static_cast<double>(round);
    state.speeds[axis] = (start + x * (2 * c2 + 3 * x * c3)) / length;
  }
  return state;
}

void FrameMotion::anchor() {
  const double seconds = static_cast<double>(step_) * step_seconds;
  for (std::size_t i = 0; i < sines; ++i) {
    const double angle = omega_[i] * seconds + phase_[i];
    real_[i] = amplitude_[i] * std::cos(angle);
    imaginary_[i] = amplitude_[i] * std::sin(angle);
  }
}

void FrameMotion::sum_sines() {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    double angle = 0;
    double speed = 0;
    for (std::size_t i = axis * sines_per_axis; i < (axis + 1) * sines_per_axis; ++i) {
      angle += imaginary_[i];
      speed += real_[i] * omega_[i];
    }
    now_.angles[axis] = angle;
    now_.speeds[axis] = speed;
  }
}

void FrameMotion::step() {
  ++step_;
  if (has_sines_) {
    if (step_ % steps_between_anchors == 0) {
      anchor();
    } else {
      for (std::size_t i = 0; i < sines; ++i) {
        const double real = real_[i];
        real_[i] = real * step_cosine_[i] - imaginary_[i] * step_sine_[i];
        imaginary_[i] = real * step_sine_[i] + imaginary_[i] * step_cosine_[i];
      }
    }
    sum_sines();
  } else if (!points_.empty()) {
    now_ = played(step_ * step_us);
  }
}

void FrameMotion::jump(std::int64_t steps) {
  if (has_sines_) {
    // Start from the last anchor, to get the same result as step().
    step_ = steps - steps % steps_between_anchors;
    anchor();
    sum_sines();
    while (step_ < steps) step();
    return;
  }
  step_ = steps;
  if (!points_.empty()) now_ = played(step_ * step_us);
}

FrameMotion::State FrameMotion::ahead(std::int64_t us) const {
  if (us == 0) return now_;
  if (!has_sines_) return points_.empty() ? now_ : played(step_ * step_us + us);
  State state;
  const double seconds = static_cast<double>(us) * seconds_per_us;
  for (std::size_t i = 0; i < sines; ++i) {
    // The rotation is less than 1 rad, so a few terms of the series suffice.
    const double x = omega_[i] * seconds;
    const double xx = square(x);
    const double cosine = 1 - xx / 2 * (1 - xx / 12 * (1 - xx / 30 * (1 - xx / 56)));
    const double sine = x * (1 - xx / 6 * (1 - xx / 20 * (1 - xx / 42 * (1 - xx / 72))));
    state.angles[i / sines_per_axis] += real_[i] * sine + imaginary_[i] * cosine;
    state.speeds[i / sines_per_axis] += (real_[i] * cosine - imaginary_[i] * sine) * omega_[i];
  }
  return state;
}

}  // namespace sbgc::emulator
