/// The attitude of the frame over time.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <sbgc/emulator/disturbance.hpp>
#include <sbgc/types.hpp>

namespace sbgc::emulator {

/// Advances in steps of the simulation; ahead() computes the state between them.
///
/// Synthetic motion is a sum of sines, rotated from step to step without trigonometry. A recording
/// is interpolated with continuous speed and without overshoot, then repeated: whole turns at its
/// end add up, any other difference is corrected within a second.
class FrameMotion {
 public:
  struct State {
    Axes<double> angles{}, speeds{};
  };

  /// Drops samples of the recording that are not finite or not later than their predecessors.
  FrameMotion(const Disturbance& disturbance, std::uint32_t seed);

  /// The state at the current step.
  const State& now() const { return now_; }
  /// The state `us` later; less than a step.
  State ahead(std::int64_t us) const;
  /// Advances by one step.
  void step();
  /// Jumps to a step. Precondition: steps >= 0.
  void jump(std::int64_t steps);

 private:
  static constexpr std::size_t sines_per_axis = 4;
  static constexpr std::size_t sines = 3 * sines_per_axis;
  /// The interval at which the sines are recomputed, so that errors do not add up.
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
  // Sines: angular speed, rotation per step, current real and imaginary part.
  std::array<double, sines> omega_{}, phase_{}, amplitude_{};
  std::array<double, sines> step_cosine_{}, step_sine_{};
  std::array<double, sines> real_{}, imaginary_{};
  // Recording: the last point repeats the first one.
  std::vector<Point> points_{};
  Axes<double> per_round_{};       ///< whole turns
  mutable std::size_t place_ = 0;  ///< the last position in the recording; saves a search
};

}  // namespace sbgc::emulator
