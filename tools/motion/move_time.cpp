#include "motion/move_time.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace sbgc::tools {

std::chrono::milliseconds time_for_move(const MoveTarget& target, const msg::GetAngles& state,
                                        msg::ControlSpeed speed) {
  double farthest = 0;
  for (std::size_t i = 0; i < target.size(); ++i) {
    if (!target[i]) continue;
    farthest =
        std::max(farthest, std::abs((*target[i]).degrees() - state.axes[i].imu_angle.degrees()));
  }
  constexpr std::chrono::seconds reserve{10};
  constexpr double allowance = 1.5;
  const double seconds = allowance * farthest / speed.degrees_per_second();
  return reserve + std::chrono::milliseconds(static_cast<std::int64_t>(seconds * 1000));
}

}  // namespace sbgc::tools
