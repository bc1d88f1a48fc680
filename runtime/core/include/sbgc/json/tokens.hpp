/// JSON strings and integers, as sources provide them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace sbgc::detail {

/// Returns the value of 4 hex digits; -1 if the text does not begin with them.
inline std::int32_t hex4(std::string_view text) {
  if (text.size() < 4) return -1;
  std::int32_t value = 0;
  for (const char c : text.substr(0, 4)) {
    const int digit = c >= '0' && c <= '9'   ? c - '0'
                      : c >= 'a' && c <= 'f' ? c - 'a' + 10
                      : c >= 'A' && c <= 'F' ? c - 'A' + 10
                                             : -1;
    if (digit < 0) return -1;
    value = value << 4 | digit;
  }
  return value;
}

/// A JSON integer. Integers beyond 64 bits become real numbers.
struct JsonInteger {
  std::int64_t value{};  ///< the nearest if it does not fit
  std::string_view text{};
};

/// A valid JSON string: the text between its quotes, in which escapes may remain.
struct JsonString {
  std::string_view raw{};
  bool has_escapes{};
};

/// Iterates over the bytes of a string.
class JsonBytes {
 public:
  static constexpr int end = -1;

  explicit JsonBytes(const JsonString& string)
      : rest_(string.raw), has_escapes_(string.has_escapes) {}

  /// Returns the next byte, or `end`.
  int next() {
    if (pending_ != 0) {
      const auto byte = static_cast<int>(pending_ & 0xFF);
      pending_ >>= 8;
      return byte;
    }
    if (rest_.empty()) return end;
    const char c = take();
    if (c != '\\' || !has_escapes_) return static_cast<std::uint8_t>(c);
    switch (const char escaped = take()) {
      case 'b': return '\b';
      case 'f': return '\f';
      case 'n': return '\n';
      case 'r': return '\r';
      case 't': return '\t';
      case 'u': return unicode();
      default: return escaped;
    }
  }

 private:
  char take() {
    const char c = rest_.front();
    rest_.remove_prefix(1);
    return c;
  }

  int unicode() {
    auto code = static_cast<std::uint32_t>(hex4(rest_));
    rest_.remove_prefix(4);
    if (code >= 0xD800 && code < 0xDC00) {
      code = 0x10000 +
             ((code & 0x3FFU) << 10 | (static_cast<std::uint32_t>(hex4(rest_.substr(2))) & 0x3FFU));
      rest_.remove_prefix(6);
    }
    const auto more = [&](unsigned shift) { return 0x80U | ((code >> shift) & 0x3FU); };
    if (code < 0x80) return static_cast<int>(code);
    if (code < 0x800) {
      pending_ = more(0);
      return static_cast<int>(0xC0U | code >> 6);
    }
    if (code < 0x10000) {
      pending_ = more(6) | more(0) << 8;
      return static_cast<int>(0xE0U | code >> 12);
    }
    pending_ = more(12) | more(6) << 8 | more(0) << 16;
    return static_cast<int>(0xF0U | code >> 18);
  }

  std::string_view rest_;
  std::uint32_t pending_ = 0;  // the bytes of a character after its first, none of which is 0
  bool has_escapes_;
};

inline bool operator==(const JsonString& string, const char* text) {
  if (!string.has_escapes) return string.raw == text;
  JsonBytes bytes(string);
  for (; *text != '\0'; ++text) {
    if (bytes.next() != static_cast<std::uint8_t>(*text)) return false;
  }
  return bytes.next() == JsonBytes::end;
}

inline std::string to_string(const JsonString& string) {
  if (!string.has_escapes) return std::string(string.raw);
  std::string result;
  JsonBytes bytes(string);
  for (int byte = bytes.next(); byte != JsonBytes::end; byte = bytes.next()) {
    result += static_cast<char>(byte);
  }
  return result;
}

}  // namespace sbgc::detail
