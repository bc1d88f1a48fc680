/// The motion of the frame that carries a gimbal.
#pragma once

#include <cstdint>
#include <vector>

#include <sbgc/time.hpp>
#include <sbgc/types.hpp>

namespace sbgc::emulator {

/// The attitude of the frame at one time, as Euler angles in degrees.
struct FrameAngles {
  Instant at{};
  Axes<double> angles{};
};

/// No motion, a synthetic motion, or a recorded one that repeats.
///
/// A recording is interpolated smoothly, along the shorter way between two angles. If it does not
/// end at its initial angles (ignoring whole turns, which add up), it returns to them within a
/// second. Samples with non-finite angles or non-ascending times are dropped. A recording without
/// samples means no motion.
struct Disturbance {
  /// The carrier of the gimbal.
  enum class Kind : std::uint8_t { rest, handheld, drone, vehicle, recorded };

  Kind kind = Kind::rest;
  double strength = 1;                   ///< factor of synthetic motion, 0..100
  std::vector<FrameAngles> recording{};  ///< times ascend from 0; for `recorded`
};

}  // namespace sbgc::emulator
