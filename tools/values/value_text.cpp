#include "values/value_text.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <optional>

#include <fmt/format.h>

#include <sbgc/json/hex.hpp>
#include <sbgc/text.hpp>

#include "command/suggestions.hpp"
#include "command/wording.hpp"
#include "values/words.hpp"

namespace sbgc::tools {

namespace {

using detail::text_of;

std::vector<std::string_view> split(std::string_view text, std::string_view separators) {
  std::vector<std::string_view> parts;
  while (true) {
    const std::size_t end = text.find_first_of(separators);
    parts.push_back(trimmed(text.substr(0, end)));
    if (end == std::string_view::npos) return parts;
    text.remove_prefix(end + 1);
  }
}

/// Reads all of `text` as an integer, decimal or with 0x.
std::optional<std::int64_t> integer_of(std::string_view text) {
  const bool is_negative = text.starts_with('-');
  if (is_negative || text.starts_with('+')) text.remove_prefix(1);
  const bool is_hex = text.starts_with("0x") || text.starts_with("0X");
  if (is_hex) text.remove_prefix(2);
  std::uint64_t size = 0;
  const auto [end, error] =
      std::from_chars(text.data(), text.data() + text.size(), size, is_hex ? 16 : 10);
  if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  constexpr auto most = static_cast<std::uint64_t>(std::numeric_limits<std::int64_t>::max());
  if (size > most) return std::nullopt;
  const auto number = static_cast<std::int64_t>(size);
  return is_negative ? -number : number;
}

/// A number and the text after it.
struct Measure {
  double number{};
  std::string_view rest{};
};

std::optional<Measure> measure_of(std::string_view text) {
  if (text.starts_with('+') && !text.starts_with("+-")) text.remove_prefix(1);
  if (text.starts_with("0x") || text.starts_with("0X") || text.starts_with("-0x")) {
    const auto number = integer_of(text);
    if (!number) return std::nullopt;
    return Measure{static_cast<double>(*number), {}};
  }
  double number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc{}) return std::nullopt;
  const auto size = static_cast<std::size_t>(end - text.data());
  return Measure{number, trimmed(text.substr(size))};
}

/// True if a user means this unit: "°/s" for "deg/s", "bytes" for "byte".
bool is_unit(std::string_view text, std::string_view unit) {
  std::string plain(text);
  const auto replace = [&](std::string_view from, std::string_view to) {
    const std::size_t at = plain.find(from);
    if (at != std::string::npos) plain.replace(at, from.size(), to);
  };
  replace("°C", "degC");
  replace("°", "deg");
  replace("µ", "u");
  replace("²", "^2");
  replace("Ω", "ohm");
  return is_same_word(plain, unit) || is_same_word(plain, std::string(unit) + 's');
}

std::string in_unit(double raw, const UnitInfo* unit) {
  return text_of([&](TextOutput& out) { detail::put_limit(out, raw, unit); });
}

/// Throws ValueError if the field cannot have this raw value. `text` is what the user wrote.
void check_range(const FieldType& type, const UnitInfo* unit, std::string_view text, double raw) {
  const bool is_special =
      type.info != nullptr && std::ranges::any_of(type.info->special, [&](const Special& special) {
        return static_cast<double>(special.value) == raw;
      });
  if (is_special) return;
  auto lowest = static_cast<double>(type.lowest);
  auto highest = static_cast<double>(type.highest);
  if (type.info != nullptr && type.info->range != nullptr) {
    lowest = std::max(lowest, type.info->range->lowest);
    highest = std::min(highest, type.info->range->highest);
  }
  if (raw >= lowest && raw <= highest) return;
  throw ValueError(fmt::format("{} is outside of {} to {}", clipped(text), in_unit(lowest, unit),
                               in_unit(highest, unit)));
}

/// Throws ValueError if the wire cannot carry the integer.
std::int64_t fitting(const FieldType& type, std::string_view text,
                     std::optional<std::int64_t> raw) {
  if (!raw) throw ValueError(fmt::format("'{}' is not an integer", clipped(text)));
  if (*raw < type.lowest || (*raw > type.highest && !type.is_wide)) {
    throw ValueError(fmt::format("{} does not fit: {} to {}", *raw, type.lowest, type.highest));
  }
  return *raw;
}

/// Returns the nearest names, or all if there are few.
std::string near_or_all(std::string_view word, const std::vector<std::string>& known) {
  constexpr std::size_t few = 12;
  const bool is_short = !known.empty() && known.size() <= few;
  return did_you_mean(nearest(word, known), is_short ? "use " + alternatives(known, false) : "");
}

/// Returns the length of what all names begin with, up to an underscore.
std::size_t common_prefix(const EnumInfo& info) {
  if (info.values.size() < 2) return 0;
  std::string_view common = info.values.front().name;
  for (const ValueInfo& value : info.values) {
    const std::string_view name = value.name;
    std::size_t same = 0;
    while (same < std::min(common.size(), name.size()) && common[same] == name[same]) ++same;
    common = common.substr(0, same);
  }
  return common.rfind('_') + 1;
}

/// Returns the value with this name, also without what all names begin with.
std::optional<std::int64_t> value_named(const EnumInfo& info, std::string_view word) {
  const std::size_t prefix = common_prefix(info);
  for (const ValueInfo& value : info.values) {
    const std::string_view name = value.name;
    if (is_same_word(word, name) || (prefix != 0 && is_same_word(word, name.substr(prefix)))) {
      return value.value;
    }
  }
  return std::nullopt;
}

void add_names(const EnumInfo& info, std::vector<std::string>& names) {
  for (const ValueInfo& value : info.values) names.emplace_back(value.name);
}

[[noreturn]] void fail_name(std::string_view word, const char* of,
                            const std::vector<std::string>& known) {
  throw ValueError(fmt::format("'{}' is not a name of {}{}", clipped(word), of,
                               near_or_all(upper_case(word), known)));
}

std::uint64_t bits_of(const FieldType& type) {
  return type.size >= 8 ? ~std::uint64_t{0} : (std::uint64_t{1} << (8 * type.size)) - 1;
}

/// Gives the bits of an integer of the wire their sign.
std::int64_t with_sign(const FieldType& type, std::uint64_t bits) {
  if (type.lowest < 0 && bits > static_cast<std::uint64_t>(type.highest)) bits |= ~bits_of(type);
  return static_cast<std::int64_t>(bits);
}

std::uint64_t flags_of(const EnumInfo& info, std::string_view text) {
  std::uint64_t bits = 0;
  for (const std::string_view word : split(text, "|,+")) {
    if (const auto number = integer_of(word)) {
      bits |= static_cast<std::uint64_t>(*number);
    } else if (const auto flag = value_named(info, word)) {
      bits |= static_cast<std::uint64_t>(*flag);
    } else {
      std::vector<std::string> names;
      add_names(info, names);
      fail_name(word, info.name, names);
    }
  }
  return bits;
}

/// Replaces one part of a packed value.
std::uint64_t with_part(const PartInfo& part, std::uint64_t raw, std::int64_t value,
                        std::string_view text) {
  const auto fail = [&] {
    throw ValueError(fmt::format("{} does not fit into '{}'", clipped(text), part.name));
  };
  std::uint64_t number = 0;
  if (part.sign != 0) {
    number = static_cast<std::uint64_t>(value < 0 ? -value : value);
    raw = value < 0 ? raw | part.sign : raw & ~part.sign;
  } else if (part.divide != 1 || part.modulo != 0) {
    const std::int64_t present = detail::part_value(part, raw);
    if (value < 0 || (part.modulo != 0 && value >= part.modulo)) fail();
    number = ((raw & part.mask) >> part.shift) +
             static_cast<std::uint64_t>((value - present) * part.divide);
  } else {
    if (value < 0 && !part.is_signed) fail();
    number = static_cast<std::uint64_t>(value);
    if (part.is_signed) number &= part.mask >> part.shift;
  }
  if ((number & ~(part.mask >> part.shift)) != 0) fail();
  const std::uint64_t result = (raw & ~part.mask) | (number << part.shift);
  if (detail::part_value(part, result) != value) fail();
  return result;
}

/// Sets one part by its name and value: "mode:2", "inverted 1", or by the name of a value.
std::uint64_t with_word(const PackedInfo& info, std::uint64_t raw, std::string_view word) {
  const std::size_t end = std::min(word.find_first_of(": "), word.size());
  const std::string_view first = word.substr(0, end);
  std::vector<std::string> known;
  for (const PartInfo& part : info.parts) {
    known.emplace_back(part.name);
    if (end == word.size() || !is_same_word(first, part.name)) continue;
    const std::string_view text = trimmed(word.substr(end + 1));
    auto value = integer_of(text);
    if (!value && part.values != nullptr) value = value_named(*part.values, text);
    if (!value && part.unit != nullptr) {
      if (const auto measure = measure_of(text)) {
        value = std::llround((measure->number - part.unit->offset) * part.unit->denominator /
                             part.unit->numerator);
      }
    }
    if (!value)
      throw ValueError(fmt::format("'{}' is not a value of {}", clipped(text), part.name));
    return with_part(part, raw, *value, text);
  }
  for (const PartInfo& part : info.parts) {
    if (part.values == nullptr) continue;
    add_names(*part.values, known);
    const auto value = value_named(*part.values, word);
    if (!value) continue;
    // Flags are added to those already set; see packed_of().
    const std::int64_t present =
        part.values->is_flags ? detail::part_value(part, raw) : std::int64_t{0};
    return with_part(part, raw, present | *value, word);
  }
  if (info.names != nullptr) add_names(*info.names, known);
  fail_name(word, info.name, known);
}

std::uint64_t packed_of(const PackedInfo& info, std::string_view text, std::uint64_t present) {
  if (info.names != nullptr) {
    if (const auto whole = value_named(*info.names, text)) {
      return static_cast<std::uint64_t>(*whole);
    }
  }
  std::uint64_t raw = present;
  bool are_flags_cleared = false;
  for (const std::string_view word : split(text, "|,")) {
    for (const PartInfo& part : info.parts) {
      // A list of flags replaces all of them.
      const bool is_flag =
          part.values != nullptr && part.values->is_flags && value_named(*part.values, word);
      if (is_flag && !are_flags_cleared) raw = with_part(part, raw, 0, word);
      are_flags_cleared = are_flags_cleared || is_flag;
    }
    raw = with_word(info, raw, word);
  }
  return raw;
}

std::uint64_t present_bits(const FieldType& type, const Json& present) {
  if (present.is_number_integer()) {
    return static_cast<std::uint64_t>(present.get<std::int64_t>()) & bits_of(type);
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

Json parse_integer(const FieldType& type, const UnitInfo* unit, std::string_view text,
                   const Json& present) {
  if (text.empty()) throw ValueError("a value is needed");
  if (text.starts_with("raw:")) {
    const std::string_view number = trimmed(text.substr(4));
    return json_integer(type, fitting(type, number, integer_of(number)));
  }
  if (type.names != nullptr || type.packed != nullptr) {
    if (const auto number = integer_of(text)) {
      return json_integer(type, fitting(type, text, number));
    }
    return json_integer(type, parse_names(type, text, present_bits(type, present)));
  }
  if (unit != nullptr && !unit->is_plain()) {
    return json_integer(type, parse_quantity(type, *unit, text));
  }
  if (type.is_wide) {
    std::uint64_t number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error == std::errc{} && end == text.data() + text.size()) {
      return std::to_string(number);
    }
  }
  const auto number = integer_of(text);
  if (!number && measure_of(text) && !measure_of(text)->rest.empty()) {
    throw ValueError(fmt::format("it has no unit: write {}",
                                 text.substr(0, text.size() - measure_of(text)->rest.size())));
  }
  const std::int64_t raw = fitting(type, text, number);
  check_range(type, nullptr, text, static_cast<double>(raw));
  return json_integer(type, raw);
}

Json parse_real(const FieldType& type, const UnitInfo* unit, std::string_view text) {
  const bool is_raw = text.starts_with("raw:");
  const std::string_view number = is_raw ? trimmed(text.substr(4)) : text;
  const auto measure = measure_of(number);
  const bool has_unit = unit != nullptr && *unit->name != '\0';
  if (!measure || !std::isfinite(measure->number)) {
    throw ValueError(fmt::format("'{}' is not a number", clipped(text)));
  }
  if (!measure->rest.empty() && (is_raw || !has_unit || !is_unit(measure->rest, unit->name))) {
    throw ValueError(has_unit ? fmt::format("'{}' is not its unit, which is {}",
                                            clipped(measure->rest), unit->name)
                              : std::string("it has no unit"));
  }
  const bool is_scaled = unit != nullptr && !is_raw;
  const double raw = is_scaled
                         ? (measure->number - unit->offset) * unit->denominator / unit->numerator
                         : measure->number;
  const double most = type.size == sizeof(float)
                          ? static_cast<double>(std::numeric_limits<float>::max())
                          : std::numeric_limits<double>::max();
  if (std::abs(raw) > most) throw ValueError(fmt::format("{} does not fit", clipped(text)));
  if (type.info != nullptr && type.info->range != nullptr &&
      (raw < type.info->range->lowest || raw > type.info->range->highest)) {
    throw ValueError(fmt::format("{} is outside of {} to {}", clipped(text),
                                 in_unit(type.info->range->lowest, unit),
                                 in_unit(type.info->range->highest, unit)));
  }
  return raw;
}

Json parse_bytes(const FieldType& type, std::string_view text) {
  std::string hex;
  for (const char c : text) {
    if (c != ' ' && c != ':') hex += c;
  }
  if (hex.starts_with("0x") || hex.starts_with("0X")) hex.erase(0, 2);
  const auto bytes = detail::from_hex(hex);
  if (!bytes) {
    throw ValueError(
        fmt::format("'{}' is not a text of hex digits, two for each byte", clipped(text)));
  }
  const bool fits = type.has_count ? bytes->size() == type.count : bytes->size() <= type.count;
  if (!fits) {
    throw ValueError(fmt::format("it has {}{}, not {}", type.has_count ? "" : "at most ",
                                 counted(type.count, "byte"), bytes->size()));
  }
  return detail::to_hex(*bytes);
}

Json parse_text(const FieldType& type, std::string_view text) {
  for (std::string_view rest = text; !rest.empty();) {
    const std::size_t length = detail::utf8_length(rest);
    if (length == 0) throw ValueError("the text is not UTF-8");
    rest.remove_prefix(length);
  }
  if (text.size() > type.count) {
    throw ValueError(
        fmt::format("the text has {}; at most {} fit", counted(text.size(), "byte"), type.count));
  }
  return detail::to_utf8(text);
}

Json parse_announced(std::string_view text) {
  const std::size_t colon = text.find(':');
  if (colon != std::string_view::npos) {
    const std::string type(text.substr(0, colon));
    const std::string_view number = trimmed(text.substr(colon + 1));
    if (const auto raw = integer_of(number)) return Json{{type, *raw}};
    if (const auto measure = measure_of(number); measure && measure->rest.empty()) {
      return Json{{type, measure->number}};
    }
  }
  throw ValueError("write the number with its type, such as i16:-5");
}

/// Parses the elements of a list, or one for each axis.
Json parse_elements(const FieldType& type, const UnitInfo* unit, std::string_view text,
                    const Json& present) {
  const FieldType& element = type.members.front();
  if (element.shape == FieldShape::group || element.shape == FieldShape::axes ||
      element.shape == FieldShape::list) {
    throw ValueError(type.shape == FieldShape::axes ? "name one of its fields, for each axis"
                                                    : "name one of its elements and fields");
  }
  const std::vector<std::string_view> parts =
      trimmed(text).empty() ? std::vector<std::string_view>{} : split(text, ",");
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

std::int64_t parse_names(const FieldType& type, std::string_view text, std::uint64_t present) {
  std::uint64_t bits = 0;
  if (type.packed != nullptr) {
    bits = packed_of(*type.packed, text, present);
  } else if (type.names->is_flags) {
    bits = flags_of(*type.names, text);
  } else if (const auto value = value_named(*type.names, text)) {
    return *value;
  } else {
    std::vector<std::string> names;
    add_names(*type.names, names);
    fail_name(text, type.names->name, names);
  }
  if ((bits & ~bits_of(type)) != 0) {
    throw ValueError(
        fmt::format("{} does not fit into {}", clipped(text), counted(type.size, "byte")));
  }
  return with_sign(type, bits);
}

std::int64_t parse_quantity(const FieldType& type, const UnitInfo& unit, std::string_view text) {
  const auto measure = measure_of(text);
  const std::string of = *unit.name == '\0' ? "" : fmt::format(" in {}", unit.name);
  if (!measure || !std::isfinite(measure->number)) {
    throw ValueError(fmt::format("'{}' is not a number{}", clipped(text), of));
  }
  if (!measure->rest.empty() && !is_unit(measure->rest, unit.name)) {
    throw ValueError(*unit.name == '\0' ? std::string("it has no unit")
                                        : fmt::format("'{}' is not its unit, which is {}",
                                                      clipped(measure->rest), unit.name));
  }
  // A sentinel, such as 21000 for a pause, is written as the number on the wire.
  if (measure->rest.empty() && type.info != nullptr) {
    for (const Special& special : type.info->special) {
      if (static_cast<double>(special.value) == measure->number) return special.value;
    }
  }
  const double exact = (measure->number - unit.offset) * unit.denominator / unit.numerator;
  const double raw = std::round(exact);
  const double step = unit.numerator / unit.denominator;
  // The conversion is not exact.
  if (step >= 1 && std::abs(exact - raw) > 1e-6) {
    throw ValueError(fmt::format("{} is between two values, which are {} apart", clipped(text),
                                 detail::unit_text(step, unit)));
  }
  check_range(type, &unit, text, raw);
  const auto result = static_cast<std::int64_t>(raw);
  if (type.info != nullptr) {
    for (const Special& special : type.info->special) {
      if (special.value != result || unit.real(raw) == measure->number) continue;
      throw ValueError(fmt::format("{} is sent as {}, which means: {}; write raw:{} for that",
                                   clipped(text), result, special.meaning, result));
    }
  }
  return result;
}

Json parse_value(const FieldType& type, const UnitInfo* unit, std::string_view text,
                 const Json& present) {
  if (type.shape == FieldShape::text) return parse_text(type, text);
  text = trimmed(text);
  switch (type.shape) {
    case FieldShape::group: {
      std::vector<std::string> names;
      for (const FieldType& member : type.members) names.emplace_back(member.name);
      throw ValueError("it has fields of its own: " + alternatives(names, false));
    }
    case FieldShape::axes:
    case FieldShape::list: return parse_elements(type, unit, text, present);
    case FieldShape::integer: return parse_integer(type, unit, text, present);
    case FieldShape::real: return parse_real(type, unit, text);
    case FieldShape::bytes: return parse_bytes(type, text);
    case FieldShape::text: break;
    case FieldShape::announced: return parse_announced(text);
  }
  return {};
}

}  // namespace sbgc::tools
