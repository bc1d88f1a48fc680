/// Text of single values: numbers, units, names. Requires a hosted standard library.
#pragma once

#include <algorithm>
#include <bit>
#include <charconv>
#include <clocale>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>
#include <string_view>

#include <sbgc/detail/part.hpp>
#include <sbgc/internal/characters.hpp>
#include <sbgc/json/hex.hpp>
#include <sbgc/json/values.hpp>
#include <sbgc/meta.hpp>
#include <sbgc/text_output.hpp>

namespace sbgc::detail {

/// Formats like printf("%.*g"), but with a decimal point in any locale.
inline std::string printed(double value, int digits) {
  char buffer[32];
  std::snprintf(buffer, sizeof buffer, "%.*g", digits, value);
  std::string result = buffer;
  const char* const point = std::localeconv()->decimal_point;
  const std::size_t at = result.find(point);
  if (at == std::string::npos) return result;
  result.erase(at + 1, std::strlen(point) - 1);
  result[at] = '.';
  return result;
}

struct Appender {
  std::string& text;

  void operator()(std::string_view piece) const { text += piece; }
};

/// Calls `use` with an output, and returns the text written to it.
template <class Use>
std::string text_of(Use&& use) {
  std::string result;
  const Appender append{result};
  PiecewiseOutput out(append);
  use(out);
  out.finish();
  return result;
}

/// Writes a number below 1,000,000 as six digits.
inline void write_six(char* out, std::uint32_t number) noexcept {
  write_pair(out, number / 10'000);
  write_pair(out + 2, number / 100 % 100);
  write_pair(out + 4, number % 100);
}

/// Formats like printf("%.6g"): a number with six significant digits. (std::to_chars would enlarge
/// the WebAssembly decoder by a third.)
inline void put_general(TextOutput& out, double value) {
  static constexpr double powers[] = {1e-4, 1e-3, 1e-2, 1e-1, 1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6};
  constexpr int one = 4;  // the index of 1e0
  const double size = value < 0 ? -value : value;
  if (size < 1e6 && size == static_cast<std::int32_t>(size) &&
      std::bit_cast<std::uint64_t>(value) != std::bit_cast<std::uint64_t>(-0.0)) {
    return out.put(static_cast<std::int32_t>(value));
  }
  if (!(size >= 1e-4 && size < 1e6)) return out.put(printed(value, 6));
  // The exponent of the first digit, from the binary one: 1233 / 4096 is the logarithm of 2.
  const auto binary = static_cast<int>(std::bit_cast<std::uint64_t>(size) >> 52) - 1023;
  int exponent = (binary * 1233) >> 12;
  if (size >= powers[one + exponent + 1]) ++exponent;
  static constexpr double scales[] = {1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9};
  const double scale = scales[5 - exponent];
  const double scaled = size * scale;
  auto digits = static_cast<std::uint32_t>(scaled);
  const double rest = scaled - digits;
  // The product is accurate to 1e-10. Where that does not suffice, an exact half is rounded to an
  // even digit, and the exact value decides the rest.
  if (rest > 0.5 - 1e-9 && rest < 0.5 + 1e-9) {
    if (rest != 0.5 || std::fma(size, scale, -scaled) != 0) return out.put(printed(value, 6));
    digits += digits & 1U;
  } else if (rest > 0.5) {
    ++digits;
  }
  if (digits == 1'000'000) {
    if (exponent == 5) return out.put(printed(value, 6));
    digits /= 10;
    ++exponent;
  }
  char* at = out.room(TextOutput::longest_number);
  *at = '-';
  if (value < 0) ++at;
  if (exponent < 0) {
    std::memset(at, '0', 5);
    at[1] = '.';
    at += 1 - exponent;
    write_six(at, digits);
  } else {
    write_six(at + 1, digits);
    for (int i = 0; i <= exponent; ++i, ++at) *at = at[1];
    *at = '.';
    at -= exponent;
  }
  char* end = at + 6;
  while (end[-1] == '0') --end;
  if (end[-1] == '.') --end;
  out.advance(end);
}

/// Formats a number: integers in full, others with six significant digits.
inline void put_number(TextOutput& out, double value) {
  const bool is_integer = value > -1e15 && value < 1e15 &&
                          value == static_cast<double>(static_cast<std::int64_t>(value));
  if (is_integer) return out.put(static_cast<std::int64_t>(value));
  out.put(printed(value, 6));
}

/// Formats a float (`size` 4) or double with as many digits as needed to distinguish it from its
/// neighbors, and six if fewer suffice.
inline std::string real_text(double value, std::size_t size) {
  const int most = size == sizeof(float) ? 9 : 17;
  for (int digits = 6; digits < most; ++digits) {
    char buffer[320];  // because g++ assumes that the precision can be any
    std::snprintf(buffer, sizeof buffer, "%.*g", digits, value);
    const double again = size == sizeof(float) ? static_cast<double>(std::strtof(buffer, nullptr))
                                               : std::strtod(buffer, nullptr);
    if (again == value) return printed(value, digits);
  }
  return printed(value, most);
}

/// Returns the bits of a number of `size` bytes, without its sign extension.
constexpr std::uint64_t low_bits(std::uint64_t bits, std::size_t size) noexcept {
  return size >= sizeof bits ? bits : bits & ((std::uint64_t{1} << (8 * size)) - 1);
}

/// Formats a value in its unit with six significant digits: "-30 deg".
inline void put_in_unit(TextOutput& out, double value, const UnitInfo& unit) {
  put_general(out, value);
  if (*unit.name == '\0') return;
  out.put(' ');
  out.put(unit.name);
}
inline std::string unit_text(double value, const UnitInfo& unit) {
  return text_of([&](TextOutput& out) { put_in_unit(out, value, unit); });
}

/// Returns the name of a value, or "" if it has none.
inline std::string_view value_name(const EnumInfo& info, std::int64_t value) {
  for (const ValueInfo& known : info.values) {
    if (known.value == value) return known.name;
  }
  return "";
}

/// Formats a flag set: "NAME | NAME | 0x40"; nothing if no bit is set.
inline void put_flags(TextOutput& out, const EnumInfo& info, std::uint32_t bits) {
  bool is_first = true;
  const auto separate = [&] {
    if (!is_first) out.put(" | ");
    is_first = false;
  };
  for (const ValueInfo& flag : info.values) {
    const auto mask = static_cast<std::uint32_t>(flag.value);
    if (mask == 0 || (bits & mask) != mask) continue;
    separate();
    out.put(flag.name);
    bits &= ~mask;
  }
  if (bits == 0) return;
  separate();
  out.put("0x");
  char* const start = out.room(TextOutput::longest_number);
  out.advance(std::to_chars(start, start + TextOutput::longest_number, bits, 16).ptr);
}
inline std::string flag_names(const EnumInfo& info, std::uint32_t bits) {
  return text_of([&](TextOutput& out) { put_flags(out, info, bits); });
}

inline std::int64_t part_value(const PartInfo& part, std::uint64_t raw) {
  const std::int64_t number = part_number(raw, {part.mask, part.shift, part.sign, part.is_signed});
  const std::int64_t digits = number / part.divide;
  return part.modulo != 0 ? digits % part.modulo : digits;
}

/// Replaces {part} and {part:02} in `pattern`, a section of the display text of a packed value.
/// Sets `is_zero` to true if every part in it is 0.
inline std::string filled_in(const PackedInfo& info, std::uint64_t raw, std::string_view pattern,
                             bool& is_zero) {
  std::string result;
  is_zero = true;
  while (!pattern.empty()) {
    const std::size_t open = pattern.find('{');
    result += pattern.substr(0, open);
    if (open == std::string_view::npos) break;
    const std::size_t close = pattern.find('}', open);
    std::string_view name = pattern.substr(open + 1, close - open - 1);
    pattern.remove_prefix(close + 1);
    std::size_t width = 0;
    if (const std::size_t colon = name.find(':'); colon != std::string_view::npos) {
      width = static_cast<std::size_t>(std::atoi(name.data() + colon + 1));
      name = name.substr(0, colon);
    }
    for (const PartInfo& part : info.parts) {
      if (name != part.name) continue;
      const std::int64_t value = part_value(part, raw);
      const std::string digits = std::to_string(value);
      result.append(width - std::min(width, digits.size()), '0');
      result += digits;
      is_zero = is_zero && value == 0;
    }
  }
  return result;
}

/// Returns the display text of a packed value. A section in brackets is omitted if all its parts
/// are 0: "{major}.{minor:02}[b{beta}]" yields 2.43b9, but 2.59 if beta is 0.
inline std::string displayed(const PackedInfo& info, std::uint64_t raw) {
  std::string result;
  const bool is_later = *info.later_display != '\0' && raw >= info.later_from;
  std::string_view pattern = is_later ? info.later_display : info.display;
  bool is_zero = false;
  while (!pattern.empty()) {
    const std::size_t open = pattern.find('[');
    result += filled_in(info, raw, pattern.substr(0, open), is_zero);
    if (open == std::string_view::npos) break;
    const std::size_t close = pattern.find(']', open);
    const std::string part =
        filled_in(info, raw, pattern.substr(open + 1, close - open - 1), is_zero);
    if (!is_zero) result += part;
    pattern.remove_prefix(close + 1);
  }
  return result;
}

/// Formats a part: "RC_MODE_ANGLE", "inverted 1", or "" for an unnamed 0 of an enum.
inline std::string part_text(const PartInfo& part, std::uint64_t raw) {
  const std::int64_t value = part_value(part, raw);
  const auto plain = [&] {
    const bool has_unit = part.unit != nullptr;
    return std::string(part.name) + ' ' +
           (has_unit ? unit_text(part.unit->real(static_cast<double>(value)), *part.unit)
                     : std::to_string(value));
  };
  if (part.values == nullptr) return plain();
  std::string named = part.values->is_flags
                          ? flag_names(*part.values, static_cast<std::uint32_t>(value))
                          : std::string(value_name(*part.values, value));
  return named.empty() && value != 0 ? plain() : named;
}

/// Formats a packed value: "2.43b9", "RC_MODE_ANGLE, inverted 0".
inline std::string packed_text(const PackedInfo& info, std::uint64_t raw) {
  if (*info.display != '\0') return displayed(info, raw);
  if (info.names != nullptr) {
    if (const std::string_view named = value_name(*info.names, static_cast<std::int64_t>(raw));
        !named.empty()) {
      return std::string(named);
    }
  }
  std::string result;
  for (const PartInfo& part : info.parts) {
    const std::string text = part_text(part, raw);
    if (!text.empty()) result += (result.empty() ? "" : ", ") + text;
  }
  return result;
}

/// Writes quoted text, with characters that are unsafe on a terminal escaped.
inline void put_quoted(TextOutput& out, std::string_view bytes) {
  out.put('"');
  for_each_character(bytes, [&](std::string_view character) {
    switch (character[0]) {
      case '"':
      case '\\': out.put('\\'); break;
      case '\n': return out.put("\\n");
      case '\t': return out.put("\\t");
      case '\r': return out.put("\\r");
      default: break;
    }
    if (const char32_t c = code_point(character); is_control(c)) return out.put(escaped(c));
    out.put(character);
  });
  out.put('"');
}
inline std::string quoted(std::string_view bytes) {
  return text_of([&](TextOutput& out) { put_quoted(out, bytes); });
}

}  // namespace sbgc::detail
