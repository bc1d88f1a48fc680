#include "serving/new_board.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>

#include <sbgc/internal/parse_number.hpp>
#include <sbgc/meta/enums.hpp>

namespace sbgc::serving {

std::optional<double> read_share(std::string_view text, double least, double most) {
  const bool is_percent = text.ends_with('%');
  if (is_percent) text.remove_suffix(1);
  const auto number = sbgc::detail::parse_number<double>(text);
  if (!number || (least >= 0 && text.front() == '-')) return {};
  const double share = is_percent ? *number / 100 : *number;
  return share >= least && share <= most ? std::optional(share) : std::nullopt;  // NaN is neither
}

std::optional<emulator::Disturbance::Kind> motion_named(std::string_view name) {
  using Kind = emulator::Disturbance::Kind;
  static constexpr std::array<std::pair<std::string_view, Kind>, 4> kinds{
      {{"rest", Kind::rest},
       {"handheld", Kind::handheld},
       {"drone", Kind::drone},
       {"vehicle", Kind::vehicle}}};
  const auto* const found =
      std::find_if(kinds.begin(), kinds.end(), [&](const auto& one) { return one.first == name; });
  return found == kinds.end() ? std::nullopt : std::optional(found->second);
}

emulator::Memory new_memory(const emulator::BoardOptions& board) {
  emulator::Memory memory;
  if (board.faults.errors.has(msg::SystemError::calib_acc)) return memory;
  for (emulator::ImuCalibration& imu : memory.imus) {
    for (const ValueInfo& position : EnumMeta<msg::CalibratedLimit>::info.values) {
      imu.acc_limits |= static_cast<std::uint8_t>(position.value);
    }
  }
  return memory;
}

}  // namespace sbgc::serving
