/// How the frame that carries a gimbal moves.
#pragma once

#include <cstdint>
#include <vector>

#include <sbgc/time.hpp>
#include <sbgc/types.hpp>

namespace sbgc::emulator {

/// The frame's attitude at one moment, Euler angles in degrees.
struct FrameAngles {
  Instant at{};
  Axes<double> angles{};
};

/// At rest, a synthetic motion, or a recorded one that is repeated.
///
/// A recording is interpolated smoothly, the shorter way from one angle to the next. If it does not
/// end where it began (whole turns do not count, they add up), it goes back there within a second.
/// Samples whose angles are not finite or whose times do not ascend are left out; without any the
/// frame is at rest.
struct Disturbance {
  enum class Kind : std::uint8_t { rest, handheld, drone, vehicle, recorded };

  Kind kind = Kind::rest;
  double strength = 1;                   ///< factor on synthetic motion, 0..100
  std::vector<FrameAngles> recording{};  ///< times ascend from 0; for `recorded`
};

}  // namespace sbgc::emulator
