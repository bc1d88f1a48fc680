#include "values/value_text.hpp"

#include <charconv>
#include <cstdint>

#include <fmt/format.h>

#include <sbgc/detail/suggestions.hpp>
#include <sbgc/json/hex.hpp>
#include <sbgc/json/values.hpp>
#include <sbgc/text.hpp>
#include <sbgc/value_text.hpp>

#include "command/wording.hpp"

namespace sbgc::tools {

namespace {

std::uint64_t present_bits(const FieldType& type, const Json& present) {
  if (present.is_number_integer()) {
    return detail::low_bits(static_cast<std::uint64_t>(present.get<std::int64_t>()), type.size);
  }
  std::uint64_t bits = 0;
  if (present.is_string()) {
    const auto& text = present.get_ref<const std::string&>();
    std::from_chars(text.data(), text.data() + text.size(), bits);
  }
  return bits;
}

/// An integer of 64 bits is text in JSON.
Json json_integer(const FieldType& type, std::int64_t raw) {
  if (type.size != sizeof(std::uint64_t)) return raw;
  return type.is_wide ? Json(std::to_string(static_cast<std::uint64_t>(raw)))
                      : Json(std::to_string(raw));
}

/// Returns the JSON of a single value.
struct ToJson {
  const FieldType& type;

  Json operator()(std::int64_t raw) const { return json_integer(type, raw); }
  Json operator()(double raw) const { return raw; }
  Json operator()(const std::vector<std::uint8_t>& bytes) const { return detail::to_hex(bytes); }
  Json operator()(const std::string& text) const { return detail::to_utf8(text); }
  Json operator()(const Number& number) const {
    const bool is_real = number.type == NumberType::f32;
    return {{name(number.type), is_real ? Json(number.real()) : Json(number.integer())}};
  }
};

/// Parses the elements of a list, or one for each axis.
Json parse_elements(const FieldType& type, const UnitInfo* unit, std::string_view text,
                    const Json& present) {
  const FieldType& element = type.members.front();
  if (element.shape == FieldShape::group || element.shape == FieldShape::axes ||
      element.shape == FieldShape::list) {
    throw ValueError(type.shape == FieldShape::axes ? "name one of its fields, for each axis"
                                                    : "name one of its elements and fields");
  }
  const std::vector<std::string_view> parts = sbgc::parse_elements(text);
  if (type.shape == FieldShape::axes) {
    if (parts.size() != 1 && parts.size() != type.axes.size()) {
      throw ValueError(
          fmt::format("write one value, or {} with commas between them", type.axes.size()));
    }
    Json result = Json::object();
    for (std::size_t i = 0; i < type.axes.size(); ++i) {
      const Json before = present.is_object() ? present.value(type.axes[i], Json()) : Json();
      result[type.axes[i]] = parse_value(element, unit, parts[parts.size() == 1 ? 0 : i], before);
    }
    return result;
  }
  const bool fits = type.has_count ? parts.size() == type.count : parts.size() <= type.count;
  if (!fits) {
    throw ValueError(fmt::format("it has {}{}, not {}", type.has_count ? "" : "at most ",
                                 counted(type.count, "element"), parts.size()));
  }
  Json result = Json::array();
  for (const std::string_view part : parts) {
    result.push_back(parse_value(element, unit, part, Json()));
  }
  return result;
}

}  // namespace

Json parse_value(const FieldType& type, const UnitInfo* unit, std::string_view text,
                 const Json& present) {
  if (type.shape == FieldShape::group) {
    std::vector<std::string> names;
    for (const FieldType& member : type.members) names.emplace_back(member.name);
    throw ValueError("it has fields of its own: " + detail::alternatives(names, false));
  }
  if (type.has_elements()) return parse_elements(type, unit, text, present);
  const ParsedValue parsed = sbgc::parse_value(type, unit, text, present_bits(type, present));
  if (!parsed) throw ValueError(parsed.problem);
  return std::visit(ToJson{type}, parsed.value);
}

}  // namespace sbgc::tools
