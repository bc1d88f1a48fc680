/// The frame's attitude over time.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <sbgc/emulator/disturbance.hpp>
#include <sbgc/types.hpp>

namespace sbgc::emulator {

/// Moves in steps of the simulation; between them it looks ahead.
///
/// Synthetic motion is a sum of sines, turned on from step to step without trigonometry. A
/// recording is interpolated with continuous speed and without overshoot, then repeated: whole
/// turns at its end are kept, any other difference is corrected within a second.
class FrameMotion {
 public:
  struct State {
    Axes<double> angles{}, speeds{};
  };

  /// Samples of the recording that are not finite or not later than those before are left out.
  FrameMotion(const Disturbance& disturbance, std::uint32_t seed);

  /// At the present step.
  const State& now() const { return now_; }
  /// That much later, less than a step.
  State ahead(std::int64_t us) const;
  /// Takes one step.
  void step();
  /// Jumps to that step. Precondition: steps >= 0.
  void jump(std::int64_t steps);

 private:
  static constexpr std::size_t sines_per_axis = 4;
  static constexpr std::size_t sines = 3 * sines_per_axis;
  /// Interval at which the sines are computed anew, so that errors do not add up.
  static constexpr std::int64_t steps_between_anchors = 256;

  struct Point {
    std::int64_t us{};
    Axes<double> angles{}, slopes{};
  };

  void plan_sines(const Disturbance& disturbance, std::uint32_t seed);
  void plan_recording(const std::vector<FrameAngles>& recording);
  void anchor();
  void sum_sines();
  State played(std::int64_t us) const;

  bool has_sines_ = false;
  std::int64_t step_ = 0;
  State now_{};
  // Sines: angular speed, rotation in a step, present real and imaginary part.
  std::array<double, sines> omega_{}, phase_{}, amplitude_{};
  std::array<double, sines> step_cosine_{}, step_sine_{};
  std::array<double, sines> real_{}, imaginary_{};
  // Recording: the last point is the first one again.
  std::vector<Point> points_{};
  Axes<double> per_round_{};       ///< whole turns
  mutable std::size_t place_ = 0;  ///< the last place in it; saves a search
};

}  // namespace sbgc::emulator
