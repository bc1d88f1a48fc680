#include <array>
#include <string>
#include <utility>

#include <sbgc/client/calibration.hpp>

namespace sbgc {

namespace {

constexpr std::array directions{
    std::pair{msg::CalibratedLimit::plus_x, "+X"}, std::pair{msg::CalibratedLimit::minus_x, "-X"},
    std::pair{msg::CalibratedLimit::plus_y, "+Y"}, std::pair{msg::CalibratedLimit::minus_y, "-Y"},
    std::pair{msg::CalibratedLimit::plus_z, "+Z"}, std::pair{msg::CalibratedLimit::minus_z, "-Z"}};

std::string positions(const msg::CalibInfo& state, bool are_done) {
  std::string names;
  for (const auto& [limit, name] : directions) {
    if (state.acc_limits_info.has(limit) != are_done) continue;
    names += (names.empty() ? "" : ", ") + std::string(name);
  }
  return names;
}

}  // namespace

std::string calibrated_positions(const msg::CalibInfo& state) {
  const std::string done = positions(state, true);
  return done.empty() ? "none" : done;
}

std::string missing_positions(const msg::CalibInfo& state) { return positions(state, false); }

}  // namespace sbgc
