/// A gimbal for tests, with time in milliseconds since power-on.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include <gtest/gtest.h>

#include <sbgc/emulator/gimbal.hpp>

namespace sbgc::emulator::test {

constexpr std::size_t roll = 0, pitch = 1, yaw = 2;

constexpr Instant ms(std::int64_t n) { return {n * 1000}; }

inline Gimbal::Options quiet() {
  Gimbal::Options options;
  options.noise = 0;
  return options;
}

inline Gimbal::Options moving(Disturbance::Kind kind, double strength = 1) {
  Gimbal::Options options = quiet();
  options.frame.kind = kind;
  options.frame.strength = strength;
  return options;
}

/// Returns a gimbal with motors on and a level camera.
inline Gimbal ready(const Gimbal::Options& options = quiet(), const Tuning& tuning = {}) {
  Gimbal gimbal(options, ms(0));
  gimbal.tune(tuning, ms(0));
  gimbal.set_motors(true, ms(0));
  return gimbal;
}

/// Returns the largest |camera - target| of all axes, sampled every 5 ms.
inline double worst_error(Gimbal& gimbal, std::int64_t from, std::int64_t until) {
  double worst = 0;
  for (std::int64_t t = from; t < until; t += 5) {
    const Sample sample = gimbal.sample(ms(t));
    for (std::size_t axis = 0; axis < 3; ++axis) {
      worst = std::max(worst, std::abs(sample.angles[axis] - sample.targets[axis]));
    }
  }
  return worst;
}

}  // namespace sbgc::emulator::test
