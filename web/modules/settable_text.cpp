#include "modules/settable_text.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>
#include <variant>

#include <sbgc/text.hpp>
#include <sbgc/value_text.hpp>

namespace sbgc::tools {

namespace {

/// Returns the shortest number for which `is_right` holds; "" if there is none.
template <class IsRight>
std::string shortest_number(double value, IsRight&& is_right) {
  if (value == 0) return "0";
  constexpr int most_digits = 17;
  for (const bool is_plain : {true, false}) {
    for (int digits = 0; digits <= most_digits; ++digits) {
      char text[400];
      const int size = is_plain ? std::snprintf(text, sizeof text, "%.*f", digits, value)
                                : std::snprintf(text, sizeof text, "%.*g", digits, value);
      if (size > 0 && is_right(std::string(text))) return text;
    }
  }
  return "";
}

/// Reads texts back to check that they encode the value.
class Reader {
 public:
  Reader(FieldType type, const Leaf& leaf, std::uint64_t present)
      : type_(std::move(type)), leaf_(leaf), present_(present) {
    type_.unit = leaf.unit;
    type_.names = leaf.names;
    type_.packed = leaf.packed;
  }

  bool reads(const std::string& text) const {
    const ParsedValue parsed = parse_value(type_, leaf_.unit, text, present_);
    if (!parsed) return false;
    if (const auto* const raw = std::get_if<std::int64_t>(&parsed.value)) {
      return *raw == leaf_.integer;
    }
    const auto* const real = std::get_if<double>(&parsed.value);
    if (real == nullptr) return false;
    if (leaf_.size == sizeof(float)) {
      return static_cast<float>(*real) == static_cast<float>(leaf_.real);
    }
    return *real == leaf_.real;
  }

 private:
  FieldType type_;
  const Leaf& leaf_;
  std::uint64_t present_;
};

/// Returns the parts that differ from those of a new message, by name.
std::string parts_text(const PackedInfo& info, std::uint64_t raw, std::uint64_t present) {
  std::string text;
  for (const PartInfo& part : info.parts) {
    const std::int64_t value = detail::part_value(part, raw);
    if (value == detail::part_value(part, present)) continue;
    const std::string one = settable_part(part, raw);
    const bool is_name = part.values != nullptr && one.find_first_not_of("-0123456789") == 0;
    text += (text.empty() ? "" : ",") + (is_name ? one : part.name + (':' + one));
  }
  return text;
}

std::string real_number(const Leaf& leaf, const Reader& reader) {
  const double real = leaf.unit == nullptr ? leaf.real : leaf.unit->real(leaf.real);
  const auto is_right = [&](const std::string& text) { return reader.reads(text); };
  const std::string text = shortest_number(real, is_right);
  return text.empty() ? "raw:" + raw_text(leaf) : text;
}

std::string integer_text(const Leaf& leaf, const Reader& reader, std::uint64_t present,
                         bool is_element) {
  const std::string number = raw_text(leaf);
  const auto is_right = [&](const std::string& text) { return reader.reads(text); };
  if (leaf.names != nullptr) {
    const std::string named =
        leaf.names->is_flags ? settable_flags(*leaf.names, static_cast<std::uint32_t>(leaf.integer))
                             : std::string(detail::value_name(*leaf.names, leaf.integer));
    return is_right(named) ? named : number;
  }
  if (leaf.packed != nullptr) {
    const auto raw = detail::low_bits(static_cast<std::uint64_t>(leaf.integer), leaf.size);
    const std::string parts = parts_text(*leaf.packed, raw, present);
    const bool has_comma = is_element && parts.find(',') != std::string::npos;
    return !has_comma && is_right(parts) ? parts : number;
  }
  if (leaf.unit == nullptr || leaf.unit->is_plain() || special_meaning(leaf) != nullptr) {
    return is_right(number) ? number : "raw:" + number;
  }
  const std::string text = shortest_number(leaf.unit->real(leaf.number()), is_right);
  return text.empty() ? "raw:" + number : text;
}

}  // namespace

std::string settable_flags(const EnumInfo& info, std::uint32_t bits) {
  std::string text = detail::flag_names(info, bits);
  std::erase(text, ' ');
  return text.empty() ? "0" : text;
}

std::string settable_part(const PartInfo& part, std::uint64_t raw) {
  const std::int64_t value = detail::part_value(part, raw);
  if (part.values != nullptr) {
    if (part.values->is_flags) {
      return settable_flags(*part.values, static_cast<std::uint32_t>(value));
    }
    const std::string_view named = detail::value_name(*part.values, value);
    return named.empty() ? std::to_string(value) : std::string(named);
  }
  if (part.unit == nullptr) return std::to_string(value);
  const auto is_right = [&](const std::string& text) {
    return std::llround(part.unit->raw(std::strtod(text.c_str(), nullptr))) == value;
  };
  return shortest_number(part.unit->real(static_cast<double>(value)), is_right);
}

std::string settable_text(const FieldType& type, const Leaf& leaf, std::uint64_t present,
                          bool is_element) {
  if (leaf.kind == LeafKind::text) return std::string(leaf.text);
  if (leaf.kind == LeafKind::bytes) {
    Leaf shown = leaf;
    shown.secrets = Secrets::shown;
    return raw_text(shown);
  }
  if (leaf.announced != NumberType::none) return name(leaf.announced) + (':' + raw_text(leaf));
  const Reader reader(type, leaf, present);
  return leaf.kind == LeafKind::real ? real_number(leaf, reader)
                                     : integer_text(leaf, reader, present, is_element);
}

}  // namespace sbgc::tools
