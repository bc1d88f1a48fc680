#include "leaves.hpp"

#include <fmt/format.h>

namespace sbgc::detail {

std::string physical_text(double value, const char* unit) {
  return *unit == '\0' ? fmt::format("{:.6g}", value) : fmt::format("{:.6g} {}", value, unit);
}

std::string value_text(const EnumInfo& info, std::int64_t value) {
  for (const ValueInfo& known : info.values) {
    if (known.value == value) return known.name;
  }
  return "";
}

std::string flags_text(const EnumInfo& info, std::uint32_t bits) {
  std::string result;
  const auto add = [&](const std::string& text) { result += (result.empty() ? "" : " | ") + text; };
  for (const ValueInfo& flag : info.values) {
    const auto mask = static_cast<std::uint32_t>(flag.value);
    if (mask == 0 || (bits & mask) != mask) continue;
    add(flag.name);
    bits &= ~mask;
  }
  if (bits != 0) add(fmt::format("{:#x}", bits));
  return result;
}

std::string packed_text(const PackedInfo& info, std::uint32_t raw) {
  if (info.names != nullptr) {
    std::string known = value_text(*info.names, raw);
    if (!known.empty()) return known;
  }
  std::string result;
  for (const PartInfo& part : info.parts) {
    const std::uint32_t digits = ((raw & part.mask) >> part.shift) / part.divide;
    const std::uint32_t value = part.modulo != 0 ? digits % part.modulo : digits;
    std::string text;
    if (part.values != nullptr) {
      text = part.values->is_flags ? flags_text(*part.values, raw & part.mask)
                                   : value_text(*part.values, value);
    }
    if (text.empty() && value != 0) text = fmt::format("{} {}", part.name, value);
    if (!text.empty()) result += (result.empty() ? "" : ", ") + text;
  }
  return result;
}

void LeafCollector::number(std::int64_t raw, const FieldInfo& field, const std::string& path,
                           std::string meaning) {
  for (const Special& special : field.special) {
    if (special.value == raw) meaning = special.meaning;
  }
  leaves_.push_back({path, std::to_string(raw), std::move(meaning)});
}

}  // namespace sbgc::detail
