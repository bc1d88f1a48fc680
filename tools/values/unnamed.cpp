#include "values/unnamed.hpp"

#include <cstdint>
#include <cstdlib>

#include <fmt/format.h>

namespace sbgc::tools {

namespace {

/// "; the nearest are CMD_REALTIME_DATA_3 (23) and CMD_REALTIME_DATA_4 (25)".
std::string nearest_text(const EnumInfo& names, std::int64_t value) {
  const ValueInfo* nearest[2] = {nullptr, nullptr};  // below and above
  for (const ValueInfo& one : names.values) {
    const ValueInfo*& best = nearest[one.value > value ? 1 : 0];
    if (best == nullptr || std::abs(one.value - value) < std::abs(best->value - value)) best = &one;
  }
  const auto [below, above] = nearest;
  const auto text = [](const ValueInfo& one) {
    return fmt::format("{} ({})", one.name, one.value);
  };
  if (below == nullptr && above == nullptr) return "";
  const std::int64_t down = below == nullptr ? INT64_MAX : value - below->value;
  const std::int64_t up = above == nullptr ? INT64_MAX : above->value - value;
  if (up == down) return fmt::format("; the nearest are {} and {}", text(*below), text(*above));
  return fmt::format("; the nearest is {}", text(up < down ? *above : *below));
}

bool is_unnamed(const EnumInfo& names, std::int64_t value, bool takes_zero) {
  if (names.is_flags || (takes_zero && value == 0)) return false;
  return detail::value_name(names, value).empty();
}

}  // namespace

std::string unnamed_text(const Leaf& leaf, bool takes_zero) {
  if (leaf.kind != LeafKind::integer || special_meaning(leaf) != nullptr) return "";
  if (leaf.names != nullptr && is_unnamed(*leaf.names, leaf.integer, takes_zero)) {
    return "has no name" + nearest_text(*leaf.names, leaf.integer);
  }
  if (leaf.packed == nullptr) return "";
  const PackedInfo& packed = *leaf.packed;
  if (packed.names != nullptr && !detail::value_name(*packed.names, leaf.integer).empty())
    return "";
  const std::uint64_t raw = detail::low_bits(static_cast<std::uint64_t>(leaf.integer), leaf.size);
  for (const PartInfo& part : packed.parts) {
    if (part.values == nullptr) continue;
    const std::int64_t value = detail::part_value(part, raw);
    if (!is_unnamed(*part.values, value, true)) continue;
    return fmt::format("has no name for {} {}{}", part.name, value,
                       nearest_text(*part.values, value));
  }
  return "";
}

}  // namespace sbgc::tools
