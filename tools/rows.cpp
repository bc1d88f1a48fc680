#include "rows.hpp"

#include <algorithm>
#include <array>

namespace sbgc::tools::rows_detail {

namespace {

std::int64_t part_value(const PartInfo& part, std::uint32_t raw) {
  const std::uint32_t bits = (raw & part.mask) >> part.shift;
  const std::uint32_t digits = bits / part.divide;
  return part.modulo != 0 ? digits % part.modulo : digits;
}

/// `display` with each {part} or {part:02} replaced.
std::string fill_in(const PackedInfo& info, std::uint32_t raw) {
  std::string result = info.display;
  for (const PartInfo& part : info.parts) {
    for (const bool padded : {false, true}) {
      const std::string place = fmt::format("{{{}{}}}", part.name, padded ? ":02" : "");
      const std::size_t at = result.find(place);
      if (at == std::string::npos) continue;
      const std::int64_t value = part_value(part, raw);
      result.replace(at, place.size(),
                     padded ? fmt::format("{:02}", value) : fmt::format("{}", value));
    }
  }
  return result;
}

std::string part_text(const PartInfo& part, std::uint32_t raw) {
  const std::int64_t value = part_value(part, raw);
  if (part.values == nullptr) return fmt::format("{} {}", part.name, value);
  std::string named = part.values->is_flags
                          ? flag_names(*part.values, static_cast<std::uint32_t>(value))
                          : value_name(*part.values, value);
  if (!named.empty()) return named;
  return value == 0 ? "" : fmt::format("{} {}", part.name, value);
}

}  // namespace

std::string value_name(const EnumInfo& info, std::int64_t value) {
  for (const ValueInfo& known : info.values) {
    if (known.value == value) return known.name;
  }
  return "";
}

std::string flag_names(const EnumInfo& info, std::uint32_t bits) {
  std::string result;
  const auto add = [&](const std::string& name) { result += (result.empty() ? "" : " | ") + name; };
  for (const ValueInfo& flag : info.values) {
    const auto mask = static_cast<std::uint32_t>(flag.value);
    if (mask == 0 || (bits & mask) != mask) continue;
    add(flag.name);
    bits &= ~mask;
  }
  if (bits != 0) add(fmt::format("0x{:x}", bits));
  return result;
}

std::string packed_text(const PackedInfo& info, std::uint32_t raw) {
  if (*info.display != '\0') return fill_in(info, raw);
  if (info.names != nullptr) {
    std::string named = value_name(*info.names, raw);
    if (!named.empty()) return named;
  }
  std::string result;
  for (const PartInfo& part : info.parts) {
    const std::string text = part_text(part, raw);
    if (!text.empty()) result += (result.empty() ? "" : ", ") + text;
  }
  return result;
}

std::string quoted(std::string_view bytes) {
  const std::string json = Json(detail::to_utf8(bytes)).dump();
  std::string result;
  for (std::size_t i = 0; i < json.size(); ++i) {
    const auto c = static_cast<std::uint8_t>(json[i]);
    const auto next = static_cast<std::uint8_t>(i + 1 < json.size() ? json[i + 1] : '\0');
    if (c == 0x7F) {
      result += "\\u007f";
    } else if (c == 0xC2 && next < 0xA0) {
      result += fmt::format("\\u{:04x}", next);
      ++i;
    } else {
      result += json[i];
    }
  }
  return result;
}

std::string physical(double value, const char* unit) {
  return *unit == '\0' ? fmt::format("{:.6g}", value) : fmt::format("{:.6g} {}", value, unit);
}

std::string variable_text(const VariableInfo& variable, std::int64_t raw) {
  const bool plain = variable.numerator == variable.denominator && variable.offset == 0;
  if (plain && *variable.unit == '\0') return "";
  const auto value = static_cast<double>(raw);
  return physical(value * variable.numerator / variable.denominator + variable.offset,
                  variable.unit);
}

void RowCollector::bytes(std::span<const std::uint8_t> bytes, const FieldInfo& field) {
  const bool zero = std::all_of(bytes.begin(), bytes.end(), [](std::uint8_t b) { return b == 0; });
  if ((zero && field.reserved) || (bytes.empty() && &field == &tail_field)) {
    offset_ += bytes.size();
  } else {
    add(detail::to_hex(bytes), "", bytes.size());
  }
}

void RowCollector::number(std::int64_t raw, const FieldInfo& field, std::string meaning,
                          std::size_t size) {
  for (const Special& special : field.special) {
    if (special.value == raw) meaning = special.meaning;
  }
  numbers_.emplace_back(rows_.size(), raw);
  add(fmt::format("{}", raw), std::move(meaning), size);
}

void RowCollector::add(std::string raw, std::string meaning, std::size_t size) {
  rows_.push_back({.path = path_,
                   .raw = std::move(raw),
                   .meaning = std::move(meaning),
                   .objection = {},
                   .offset = offset_,
                   .size = size});
  offset_ += size;
}

void RowCollector::variable_value(const VariableInfo* variable, std::int64_t raw,
                                  const FieldInfo& field) {
  if (field.is_variable_value && variable != nullptr) {
    rows_.back().meaning = variable_text(*variable, raw);
  }
}

std::size_t RowCollector::enter(std::string_view name) {
  const std::size_t outer = path_.size();
  if (outer != 0) path_ += '.';
  path_ += name;
  return outer;
}

bool RowCollector::is_alternative(const FieldInfo& field) const {
  if (field.alternative == nullptr) return false;
  for (const char* axis : {"", ".roll", ".pitch", ".yaw"}) {
    if (path_.find(axis) == std::string::npos) continue;
    const std::string wanted = std::string(field.alternative->of) + axis;
    for (const auto& [row, raw] : numbers_) {
      if (rows_[row].path == wanted) return (raw & field.alternative->mask) != 0;
    }
  }
  return false;
}

void Marker::operator()(const Violation& violation) const {
  std::array<char, 128> path{};
  violation.path.write(path.data(), path.size());
  for (Row& row : rows) {
    if (row.path != path.data()) continue;
    row.objection += fmt::format("{}{} is {}", row.objection.empty() ? "" : ", ",
                                 name(violation.rule), violation.limit);
  }
}

}  // namespace sbgc::tools::rows_detail
