#include "move/move_way.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>

#include <fmt/format.h>

#include <sbgc/axis_directions.hpp>

#include "values/axis_values.hpp"

namespace sbgc::tools {

namespace {

/// Resolution of angles in sentences: numbers that are rounded first still add up.
constexpr int tenths_of_degree = 10;
constexpr int half_turn = 180 * tenths_of_degree;
constexpr int two_turns = 720 * tenths_of_degree;

int tenths(msg::Angle14 angle) {
  return static_cast<int>(std::lround(angle.degrees() * tenths_of_degree));
}
std::string number(int tenths) {
  return fmt::format("{:g}", static_cast<double>(tenths) / tenths_of_degree);
}

/// Returns the turn from `from` to `to` that boards make.
int way(int from, int to) {
  const int difference = to - from;
  if (difference > two_turns) return difference - 2 * two_turns;
  if (difference < -two_turns) return difference + 2 * two_turns;
  return difference;
}

/// Describes an angle, such as "40 down"; a signed number if its direction is not known.
std::string place(std::size_t axis, int angle) {
  const AxisDirection& ways = axis_directions[axis];
  const char* const direction = angle < 0 ? ways.negative : ways.positive;
  if (angle == 0 || *direction == '\0') return number(angle);
  return number(std::abs(angle)) + ' ' + direction;
}

/// Returns, for example, "up by 30".
std::string turn(std::size_t axis, int by) {
  const AxisDirection& ways = axis_directions[axis];
  const char* const direction = by < 0 ? ways.negative : ways.positive;
  if (*direction == '\0') return fmt::format("by {}", number(by));
  return fmt::format("{} by {}", direction, number(std::abs(by)));
}

std::string target_of_axis(std::size_t axis, int angle) {
  const AxisDirection& ways = axis_directions[axis];
  const char* const direction = angle < 0 ? ways.negative : ways.positive;
  if (angle == 0 || *direction == '\0')
    return fmt::format("{} {} deg", axis_names[axis], number(angle));
  return fmt::format("{} deg {}", number(std::abs(angle)), direction);
}

}  // namespace

msg::Angle14 angle_after(msg::Angle14 from, msg::Angle14 way) {
  return msg::Angle14(static_cast<std::int16_t>(static_cast<std::uint16_t>(from.raw()) +
                                                static_cast<std::uint16_t>(way.raw())));
}

std::string target_text(const MoveTarget& target, const Axes<msg::Angle14>& angles,
                        std::string_view when) {
  std::string result;
  for (std::size_t i = 0; i < target.size(); ++i) {
    if (!target[i]) continue;
    const int from = tenths(angles[i]), to = tenths(*target[i]);
    if (!result.empty()) result += ", ";
    result += target_of_axis(i, to);
    result += from == to
                  ? " (it is there)"
                  : fmt::format(" ({} {}: {})", when, place(i, from), turn(i, way(from, to)));
  }
  return result;
}

std::string cable_warning(const MoveTarget& target, const Axes<msg::Angle14>& angles) {
  std::string result;
  for (std::size_t i = 0; i < target.size(); ++i) {
    if (!target[i]) continue;
    const int to = tenths(*target[i]), by = way(tenths(angles[i]), to);
    if (std::abs(by) > half_turn) {
      result += fmt::format(" Watch the cables: {} turns by {} deg.", axis_names[i],
                            number(std::abs(by)));
    } else if (std::abs(to) > half_turn) {
      result += fmt::format(" Watch the cables: {} ends {} deg from its zero.", axis_names[i],
                            number(std::abs(to)));
    }
  }
  return result;
}

std::chrono::milliseconds time_for_move(const MoveTarget& target, const Axes<msg::Angle14>& angles,
                                        msg::ControlSpeed speed) {
  int farthest = 0;
  for (std::size_t i = 0; i < target.size(); ++i) {
    if (!target[i]) continue;
    farthest = std::max(farthest, std::abs(way(tenths(angles[i]), tenths(*target[i]))));
  }
  constexpr std::chrono::seconds reserve{10};
  constexpr double allowance = 1.5;
  const double seconds = allowance * farthest / tenths_of_degree / speed.degrees_per_second();
  return reserve + std::chrono::milliseconds(static_cast<std::int64_t>(seconds * 1000));
}

Axes<msg::Angle14> angles_of(const msg::GetAngles& state) {
  Axes<msg::Angle14> result;
  for (std::size_t i = 0; i < result.size(); ++i) result[i] = state.axes[i].imu_angle;
  return result;
}

}  // namespace sbgc::tools
