/// A sink that writes JSON text.
#pragma once

#include <bit>
#include <charconv>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <span>
#include <string_view>
#include <version>

#include <sbgc/internal/characters.hpp>
#include <sbgc/internal/compiler.hpp>
#include <sbgc/json/values.hpp>
#include <sbgc/text_output.hpp>

namespace sbgc::detail {

/// The shortest digits that distinguish a double from its neighbors: 0.d1d2d3... * 10^exponent.
struct Digits {
  explicit Digits(double value) {
    char text[32];
    char* const end = scientific(text, text + sizeof text, value);
    const char* at = text;
    for (; at != end && *at != 'e'; ++at) {
      if (*at != '.') digits[size++] = *at;
    }
    const bool is_small = at + 1 < end && at[1] == '-';
    for (at += 2; at < end; ++at) exponent = 10 * exponent + (*at - '0');
    exponent = (is_small ? -exponent : exponent) + 1;
    while (size > 1 && digits[size - 1] == '0') --size;
  }

  char digits[17] = {};
  int size = 0;
  int exponent = 0;

 private:
  /// Writes the number as in "1.5e-07". Returns the end of the text.
  static char* scientific(char* begin, char* end, double value) {
#if defined(__cpp_lib_to_chars)
    return std::to_chars(begin, end, value, std::chars_format::scientific).ptr;
#else
    // All numbers of 15 digits are distinct, except subnormal ones.
    for (int digits = value < std::numeric_limits<double>::min() ? 0 : 14;; ++digits) {
      const int size =
          std::snprintf(begin, static_cast<std::size_t>(end - begin), "%.*e", digits, value);
      if (digits == 16 || std::strtod(begin, nullptr) == value) return begin + size;
      // A power of two is nearer to its lower neighbor: only the digits above it may be right.
      char& last = begin[digits == 0 ? 0 : digits + 1];
      if (last == '9') continue;
      ++last;
      if (std::strtod(begin, nullptr) == value) return begin + size;
    }
#endif
  }
};

/// Writes a finite number so that it is read as a real number with the same value: "0.5", "2.0",
/// "1e-07".
inline void put_real(TextOutput& out, double value) {
  if (std::bit_cast<std::uint64_t>(value) >> 63U != 0) {
    out.put('-');
    value = -value;
  }
  if (value == 0) return out.put("0.0");
  const Digits number(value);
  const std::string_view digits(number.digits, static_cast<std::size_t>(number.size));
  const auto point = static_cast<std::size_t>(number.exponent);
  constexpr int most_digits = 15;  // before the point
  constexpr int most_zeros = 3;    // after the point
  if (number.exponent > most_digits || number.exponent < -most_zeros) {
    const int exponent = number.exponent - 1;
    const int size = exponent < 0 ? -exponent : exponent;
    out.put(digits[0]);
    if (digits.size() > 1) out.put('.');
    out.put(digits.substr(1));
    out.put(exponent < 0 ? "e-" : "e+");
    if (size < 10) out.put('0');
    out.put(size);
  } else if (number.exponent <= 0) {
    out.put("0.");
    for (int i = number.exponent; i < 0; ++i) out.put('0');
    out.put(digits);
  } else if (digits.size() <= point) {
    out.put(digits);
    for (std::size_t i = digits.size(); i < point; ++i) out.put('0');
    out.put(".0");
  } else {
    out.put(digits.substr(0, point));
    out.put('.');
    out.put(digits.substr(point));
  }
}

/// Writes a character inside a JSON string, escaped if it is unsafe on a terminal.
inline void put_escaped(TextOutput& out, std::string_view character) {
  switch (character[0]) {
    case '"': return out.put("\\\"");
    case '\\': return out.put("\\\\");
    case '\b': return out.put("\\b");
    case '\f': return out.put("\\f");
    case '\n': return out.put("\\n");
    case '\r': return out.put("\\r");
    case '\t': return out.put("\\t");
    default: break;
  }
  if (const char32_t c = code_point(character); is_control(c)) return out.put(escaped(c));
  out.put(character);
}

/// A sink of JsonWriter that writes compact text.
class JsonTextSink {
 public:
  explicit JsonTextSink(TextOutput& out) : out_(out) {}

  void begin_object() { begin('{'); }
  void end_object() { end('}'); }
  void begin_list() { begin('['); }
  void end_list() { end(']'); }
  /// Names are short, and need no escapes.
  SBGC_NOINLINE void key(const char* name) {
    const std::size_t size = std::char_traits<char>::length(name);
    char* at = out_.room(size + 4);
    *at = ',';
    at += is_first_ ? 0 : 1;
    is_first_ = false;
    *at++ = '"';
    std::memcpy(at, name, size);
    at += size;
    *at++ = '"';
    *at++ = ':';
    out_.advance(at);
  }
  void element() {
    if (!is_first_) out_.put(',');
    is_first_ = false;
  }

  template <class T>
  void integer(T number) {
    out_.put(number);
  }
  void real(double number) { put_real(out_, number); }
  template <class T>
  void decimal(T number) {
    out_.put('"');
    out_.put(number);
    out_.put('"');
  }
  void word(std::string_view text) {
    out_.put('"');
    out_.put(text);
    out_.put('"');
  }
  void hex(std::span<const std::uint8_t> bytes) {
    out_.put('"');
    out_.put_hex(bytes);
    out_.put('"');
  }
  void text(std::string_view bytes) {
    out_.put('"');
    for_each_character(bytes, [this](std::string_view text) { put_escaped(out_, text); });
    out_.put('"');
  }

 private:
  void begin(char bracket) {
    out_.put(bracket);
    is_first_ = true;
  }
  void end(char bracket) {
    out_.put(bracket);
    is_first_ = false;
  }

  TextOutput& out_;
  bool is_first_ = true;
};

}  // namespace sbgc::detail
