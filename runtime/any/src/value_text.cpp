#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include <sbgc/internal/parse_number.hpp>
#include <sbgc/internal/parse_real.hpp>
#include <sbgc/internal/suggestions.hpp>
#include <sbgc/internal/words.hpp>
#include <sbgc/json/hex.hpp>
#include <sbgc/text.hpp>
#include <sbgc/value_text.hpp>

namespace sbgc {

namespace {

using namespace detail;  // NOLINT(google-build-using-namespace): of the same library

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
  const auto size = parse_number<std::uint64_t>(text, is_hex ? 16 : 10);
  constexpr auto most = static_cast<std::uint64_t>(std::numeric_limits<std::int64_t>::max());
  if (!size || *size > most) return std::nullopt;
  const auto number = static_cast<std::int64_t>(*size);
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
  const auto [end, error] = parse_real(text.data(), text.data() + text.size(), number);
  if (error != std::errc{}) return std::nullopt;
  const auto size = static_cast<std::size_t>(end - text.data());
  if (text.substr(size).starts_with(',')) return std::nullopt;  // 1,5 is not 1 of something
  return Measure{number, trimmed(text.substr(size))};
}

/// True if the text denotes this unit: "°/s" for "deg/s", "bytes" for "byte".
bool is_unit(std::string_view text, std::string_view unit) {
  std::string plain(text);
  const auto replace = [&](std::string_view from, std::string_view to) {
    const std::size_t at = plain.find(from);
    if (at != std::string::npos) plain.replace(at, from.size(), to);
  };
  replace("degrees", "deg");
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

/// Returns the nearest names, or all of them if there are few.
std::string near_or_all(std::string_view word, const std::vector<std::string>& known) {
  constexpr std::size_t few = 12;
  const bool is_short = !known.empty() && known.size() <= few;
  return did_you_mean(nearest(word, known), is_short ? "use " + alternatives(known, false) : "");
}

/// Returns the length of the common prefix of all names, up to an underscore.
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

/// Returns the value with this name, whose common prefix may be omitted.
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

std::uint64_t bits_of(const FieldType& type) {
  return type.size >= 8 ? ~std::uint64_t{0} : (std::uint64_t{1} << (8 * type.size)) - 1;
}

/// Sign-extends the bits of a raw integer.
std::int64_t with_sign(const FieldType& type, std::uint64_t bits) {
  if (bits > static_cast<std::uint64_t>(type.highest)) bits |= ~bits_of(type);
  return static_cast<std::int64_t>(bits);
}

std::string counted(std::size_t number, const char* thing) {
  return std::to_string(number) + ' ' + thing + (number == 1 ? "" : "s");
}

/// Returns the user's text as shown in a message.
std::string shown(std::string_view text) {
  constexpr std::size_t longest = 1000;
  const std::string result = without_controls(text.substr(0, longest));
  return text.size() > longest ? result + "..." : result;
}
std::string quoted(std::string_view text) { return '\'' + shown(text) + '\''; }

/// Parses one value. After the first problem, results are meaningless.
class ValueParser {
 public:
  ValueParser(const FieldType& type, const UnitInfo* unit, std::uint64_t present)
      : type_(type), unit_(unit), present_(present) {}

  ParsedValue parse(std::string_view text) {
    AnyValue value = value_of(text);
    if (!problem_.empty()) return {{}, std::move(problem_)};
    return {std::move(value), {}};
  }

 private:
  AnyValue value_of(std::string_view text) {
    if (type_.shape == FieldShape::text) return text_of_field(text);
    text = trimmed(text);
    switch (type_.shape) {
      case FieldShape::integer: return integer(text);
      case FieldShape::real: return real(text);
      case FieldShape::bytes: return bytes(text);
      case FieldShape::announced: return announced(text);
      default: fail("it is not a single value"); return {};
    }
  }

  void fail(std::string problem) {
    if (problem_.empty()) problem_ = std::move(problem);
  }

  // Integers

  std::int64_t integer(std::string_view text) {
    if (text.empty()) return fail("a value is needed"), 0;
    if (text.starts_with("raw:")) {
      const std::string_view number = trimmed(text.substr(4));
      return fitting(number, on_wire(number));
    }
    if (type_.names != nullptr || type_.packed != nullptr) {
      if (const auto number = on_wire(text)) return fitting(text, number);
      return names(text);
    }
    if (unit_ != nullptr && !unit_->is_plain()) return quantity(text);
    const auto number = on_wire(text);
    const auto measure = number ? std::nullopt : measure_of(text);
    // The number of a percentage is a different value.
    if (measure && !measure->rest.empty() && measure->rest != "%") {
      const auto size = text.size() - measure->rest.size();
      fail("it has no unit: write " + std::string(trimmed(text.substr(0, size))));
    }
    return fitting(text, number);
  }

  /// Parses a raw integer; for an unsigned one of 64 bits, returns the bits.
  std::optional<std::int64_t> on_wire(std::string_view text) const {
    if (type_.is_wide) {
      if (const auto number = parse_number<std::uint64_t>(text)) {
        return static_cast<std::int64_t>(*number);
      }
    }
    return integer_of(text);
  }

  /// Fails if the wire cannot carry the integer.
  std::int64_t fitting(std::string_view text, std::optional<std::int64_t> raw) {
    if (!raw) return fail(quoted(text) + " is not an integer"), 0;
    // It holds the bits of an unsigned 64-bit integer.
    const bool fits =
        type_.is_wide ? !text.starts_with('-') : *raw >= type_.lowest && *raw <= type_.highest;
    if (!fits) {
      fail(shown(text) + " does not fit: " + std::to_string(type_.lowest) + " to " +
           (type_.is_wide ? std::to_string(std::numeric_limits<std::uint64_t>::max())
                          : std::to_string(type_.highest)));
    }
    return *raw;
  }

  /// Returns the raw value nearest to a physical one.
  std::int64_t quantity(std::string_view text) {
    const UnitInfo& unit = *unit_;
    const auto measure = measure_of(text);
    const bool has_name = *unit.name != '\0';
    if (!measure || !std::isfinite(measure->number)) {
      fail(quoted(text) + " is not a number" + (has_name ? std::string(" in ") + unit.name : ""));
      return 0;
    }
    if (!measure->rest.empty() && !is_unit(measure->rest, unit.name)) {
      fail(has_name ? quoted(measure->rest) + " is not its unit, which is " + unit.name
                    : "it has no unit");
    }
    // A sentinel, such as 21000 for a pause, is written as a raw number.
    if (measure->rest.empty()) {
      for (const Special& special : specials()) {
        if (static_cast<double>(special.value) == measure->number) return special.value;
      }
    }
    const double exact = unit.raw(measure->number);
    const double raw = std::round(exact);
    const double step = unit.numerator / unit.denominator;
    // The conversion is not exact.
    if (step >= 1 && std::abs(exact - raw) > 1e-6) {
      fail(shown(text) + " is between two values, which are " + unit_text(step, unit) + " apart");
    }
    // 0 may mean something else, such as full speed.
    const bool is_scaled = unit.growth == 0 && unit.offset == 0 && !measure->rest.empty();
    if (is_scaled && raw == 0 && std::abs(exact) > 1e-6) {
      fail(shown(text) + " is too small; the least is " + unit_text(step, unit));
    }
    const auto lowest = static_cast<double>(type_.lowest);
    const auto highest = type_.is_wide
                             ? static_cast<double>(std::numeric_limits<std::uint64_t>::max())
                             : static_cast<double>(type_.highest);
    // Rounded to a double, the highest 64-bit integer is too large by one.
    if (raw < lowest || raw > highest || (type_.size == 8 && raw == highest)) {
      fail(shown(text) + " does not fit: " + in_unit(lowest, &unit) + " to " +
           in_unit(highest, &unit));
      return 0;
    }
    const auto result = type_.is_wide ? static_cast<std::int64_t>(static_cast<std::uint64_t>(raw))
                                      : static_cast<std::int64_t>(raw);
    for (const Special& special : specials()) {
      if (special.value != result || unit.real(raw) == measure->number) continue;
      const std::string number = std::to_string(result);
      std::string problem = shown(text) + " is sent as " + number;
      problem += std::string(", which means: ") + special.meaning;
      problem += "; write raw:" + number + " for that";
      fail(std::move(problem));
    }
    return result;
  }
  std::span<const Special> specials() const {
    return type_.info == nullptr ? std::span<const Special>() : type_.info->special;
  }

  // Names

  std::int64_t names(std::string_view text) {
    std::uint64_t bits = 0;
    if (type_.packed != nullptr) {
      bits = packed(*type_.packed, text);
    } else if (type_.names->is_flags) {
      bits = flags(*type_.names, text);
    } else if (const auto value = value_named(*type_.names, text)) {
      return *value;
    } else {
      std::vector<std::string> known;
      add_names(*type_.names, known);
      fail_name(text, type_.names->name, known);
    }
    if ((bits & ~bits_of(type_)) != 0) {
      fail(shown(text) + " does not fit into " + counted(type_.size, "byte"));
    }
    return with_sign(type_, bits);
  }

  void fail_name(std::string_view word, const char* of, const std::vector<std::string>& known) {
    fail(quoted(word) + " is not a name of " + of + near_or_all(upper_case(word), known));
  }

  std::uint64_t flags(const EnumInfo& info, std::string_view text) {
    std::uint64_t bits = 0;
    for (const std::string_view word : split(text, "|,+")) {
      if (!problem_.empty()) break;
      if (const auto number = integer_of(word)) {
        bits |= static_cast<std::uint64_t>(*number);
      } else if (const auto flag = value_named(info, word)) {
        bits |= static_cast<std::uint64_t>(*flag);
      } else {
        std::vector<std::string> known;
        add_names(info, known);
        fail_name(word, info.name, known);
      }
    }
    return bits;
  }

  std::uint64_t packed(const PackedInfo& info, std::string_view text) {
    if (info.names != nullptr) {
      if (const auto whole = value_named(*info.names, text)) {
        return static_cast<std::uint64_t>(*whole);
      }
    }
    std::uint64_t raw = present_;
    bool are_flags_cleared = false;
    for (const std::string_view word : split(text, "|,")) {
      if (!problem_.empty()) break;
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
          value = std::llround(part.unit->raw(measure->number));
        }
      }
      if (value) return with_part(part, raw, *value, text);
      fail(quoted(text) + " is not a value of " + part.name);
      return raw;
    }
    for (const PartInfo& part : info.parts) {
      if (part.values == nullptr) continue;
      add_names(*part.values, known);
      const auto value = value_named(*part.values, word);
      if (!value) continue;
      // Flags are added to those already set; see packed().
      const std::int64_t present = part.values->is_flags ? part_value(part, raw) : std::int64_t{0};
      return with_part(part, raw, present | *value, word);
    }
    if (info.names != nullptr) add_names(*info.names, known);
    fail_name(word, info.name, known);
    return raw;
  }

  /// Replaces one part of a packed value.
  std::uint64_t with_part(const PartInfo& part, std::uint64_t raw, std::int64_t value,
                          std::string_view text) {
    auto number = static_cast<std::uint64_t>(value);
    if (part.sign != 0) {
      const bool is_negative = value < 0;
      raw = is_negative ? raw | part.sign : raw & ~part.sign;
      if (is_negative) number = -number;
    } else if (part.divide != 1 || part.modulo != 0) {
      // Decimal digits of the whole number.
      number = raw + static_cast<std::uint64_t>(value - part_value(part, raw)) * part.divide;
    } else if (part.is_signed) {
      number &= part.mask >> part.shift;
    }
    const bool fits = (number & ~(part.mask >> part.shift)) == 0;
    const std::uint64_t result = (raw & ~part.mask) | (number << part.shift & part.mask);
    if (!fits || part_value(part, result) != value) {
      fail(shown(text) + " does not fit into '" + part.name + "'");
    }
    return result;
  }

  // Other values

  double real(std::string_view text) {
    const bool is_raw = text.starts_with("raw:");
    const auto measure = measure_of(is_raw ? trimmed(text.substr(4)) : text);
    const bool has_unit = unit_ != nullptr && *unit_->name != '\0';
    if (!measure || !std::isfinite(measure->number)) {
      return fail(quoted(text) + " is not a number"), double{};
    }
    if (!measure->rest.empty() && (is_raw || !has_unit || !is_unit(measure->rest, unit_->name))) {
      fail(has_unit ? quoted(measure->rest) + " is not its unit, which is " + unit_->name
                    : "it has no unit");
    }
    const bool is_scaled = unit_ != nullptr && !is_raw;
    const double raw = is_scaled ? unit_->raw(measure->number) : measure->number;
    const double most = type_.size == sizeof(float)
                            ? static_cast<double>(std::numeric_limits<float>::max())
                            : std::numeric_limits<double>::max();
    if (std::abs(raw) > most) fail(shown(text) + " does not fit");
    return raw;
  }

  std::vector<std::uint8_t> bytes(std::string_view text) {
    std::string hex;
    for (const char c : text) {
      if (c != ' ' && c != ':') hex += c;
    }
    const auto bytes = from_hex(hex);
    if (!bytes) {
      return fail(quoted(text) + " is not a text of hex digits, two for each byte"),
             std::vector<std::uint8_t>();
    }
    const bool fits = type_.has_count ? bytes->size() == type_.count : bytes->size() <= type_.count;
    if (!fits) {
      fail((type_.has_count ? "it has " : "it has at most ") + counted(type_.count, "byte") +
           ", not " + std::to_string(bytes->size()));
    }
    return *bytes;
  }

  std::string text_of_field(std::string_view text) {
    for (std::string_view rest = text; !rest.empty();) {
      const std::size_t length = utf8_length(rest);
      if (length == 0) return fail("the text is not UTF-8"), std::string();
      rest.remove_prefix(length);
    }
    if (text.size() > type_.count) {
      fail("the text has " + counted(text.size(), "byte") + "; at most " +
           std::to_string(type_.count) + " fit");
    }
    return std::string(text);
  }

  Number announced(std::string_view text) {
    const std::size_t colon = std::min(text.find(':'), text.size());
    const std::string_view number = trimmed(text.substr(std::min(colon + 1, text.size())));
    for (const NumberType type : {NumberType::u8, NumberType::i8, NumberType::u16, NumberType::i16,
                                  NumberType::u32, NumberType::i32, NumberType::f32}) {
      if (text.substr(0, colon) != name(type)) continue;
      if (type == NumberType::f32) {
        const auto measure = measure_of(number);
        if (!measure || !measure->rest.empty()) break;
        return {type, std::bit_cast<std::uint32_t>(static_cast<float>(measure->number))};
      }
      const auto raw = integer_of(number);
      if (!raw) break;
      const Number result{
          type, static_cast<std::uint32_t>(*raw & ((std::int64_t{1} << 8 * size_of(type)) - 1))};
      if (result.integer() != *raw) fail(shown(text) + " does not fit");
      return result;
    }
    fail("write the number with its type, such as i16:-5");
    return {};
  }

  const FieldType& type_;
  const UnitInfo* unit_;
  std::uint64_t present_;
  std::string problem_{};
};

}  // namespace

ParsedValue parse_value(const FieldType& type, const UnitInfo* unit, std::string_view text,
                        std::uint64_t present) {
  return ValueParser(type, unit, present).parse(text);
}

std::vector<std::string_view> parse_elements(std::string_view text) {
  if (trimmed(text).empty()) return {};
  return split(text, ",");
}

}  // namespace sbgc
