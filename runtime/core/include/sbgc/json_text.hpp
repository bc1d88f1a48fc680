/// Lossless JSON representations of bytes, texts and non-finite floats.
#pragma once

#include <bit>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace sbgc::detail {

/// Returns lowercase hex, two digits per byte.
inline std::string to_hex(std::span<const std::uint8_t> bytes) {
  constexpr const char* digits = "0123456789abcdef";
  std::string result;
  result.reserve(2 * bytes.size());
  for (const std::uint8_t byte : bytes) {
    result += digits[byte >> 4];
    result += digits[byte & 15];
  }
  return result;
}

/// Parses hex digits in upper or lower case; returns nullopt if `text` is not pairs of them.
inline std::optional<std::vector<std::uint8_t>> from_hex(std::string_view text) {
  if (text.size() % 2 != 0) return std::nullopt;
  std::vector<std::uint8_t> result(text.size() / 2);
  for (std::size_t i = 0; i < result.size(); ++i) {
    const char* const digits = text.data() + 2 * i;
    const auto [end, error] = std::from_chars(digits, digits + 2, result[i], 16);
    if (error != std::errc{} || end != digits + 2) return std::nullopt;
  }
  return result;
}

/// Returns the length of the well-formed UTF-8 sequence at the start of `text`; 0 if there is none.
inline std::size_t utf8_length(std::string_view text) {
  const auto byte = [&](std::size_t i) {
    return i < text.size() ? static_cast<std::uint8_t>(text[i]) : std::uint8_t{0};
  };
  const auto follows = [&](std::size_t i, std::uint8_t low = 0x80, std::uint8_t high = 0xBF) {
    return byte(i) >= low && byte(i) <= high;
  };
  const std::uint8_t first = byte(0);
  if (text.empty()) return 0;
  if (first < 0x80) return 1;
  if (first >= 0xC2 && first <= 0xDF) return follows(1) ? 2 : 0;
  if (first >= 0xE0 && first <= 0xEF) {
    const std::uint8_t low = first == 0xE0 ? 0xA0 : 0x80;
    const std::uint8_t high = first == 0xED ? 0x9F : 0xBF;
    return follows(1, low, high) && follows(2) ? 3 : 0;
  }
  if (first >= 0xF0 && first <= 0xF4) {
    const std::uint8_t low = first == 0xF0 ? 0x90 : 0x80;
    const std::uint8_t high = first == 0xF4 ? 0x8F : 0xBF;
    return follows(1, low, high) && follows(2) && follows(3) ? 4 : 0;
  }
  return 0;
}

// Bytes that are not UTF-8 are escaped as U+F780 to U+F7FF, in a private use area. If a text from a
// board contains these characters itself, their bytes are escaped one by one, to avoid ambiguity.

/// Returns true if `sequence` is one of the escape characters.
inline bool is_escape(std::string_view sequence) {
  return sequence.size() == 3 && sequence[0] == '\xEF' &&
         (sequence[1] == '\x9E' || sequence[1] == '\x9F');
}

/// Converts any bytes to well-formed UTF-8.
inline std::string to_utf8(std::string_view bytes) {
  std::string result;
  while (!bytes.empty()) {
    const std::size_t length = utf8_length(bytes);
    if (length != 0 && !is_escape(bytes.substr(0, length))) {
      result += bytes.substr(0, length);
      bytes.remove_prefix(length);
      continue;
    }
    const auto byte = static_cast<std::uint8_t>(bytes[0]);
    result += '\xEF';
    result += static_cast<char>(0x9C | byte >> 6);
    result += static_cast<char>(0x80 | (byte & 0x3F));
    bytes.remove_prefix(1);
  }
  return result;
}

/// The inverse of to_utf8().
inline std::string from_utf8(std::string_view text) {
  std::string result;
  while (!text.empty()) {
    const std::string_view sequence = text.substr(0, 3);
    if (is_escape(sequence)) {
      const auto second = static_cast<std::uint8_t>(sequence[1]);
      const auto third = static_cast<std::uint8_t>(sequence[2]);
      result += static_cast<char>((second & 0x03) << 6 | (third & 0x3F));
      text.remove_prefix(3);
    } else {
      result += text[0];
      text.remove_prefix(1);
    }
  }
  return result;
}

/// The unsigned integer with the bits of a float or double.
template <class Float>
using FloatBits = std::conditional_t<sizeof(Float) == 4, std::uint32_t, std::uint64_t>;

/// Converts a float or double to a number. JSON has no infinities and NaN; they become "inf",
/// "-inf" and "nan:<hex bits>".
template <class Json, class Float>
Json float_to_json(Float value) {
  if (std::isfinite(value)) return value;
  if (std::isinf(value)) return value > 0 ? "inf" : "-inf";
  auto bits = std::bit_cast<FloatBits<Float>>(value);
  std::string digits(2 * sizeof(Float), '0');
  for (auto digit = digits.rbegin(); digit != digits.rend(); ++digit, bits >>= 4U) {
    *digit = "0123456789abcdef"[bits & 15U];
  }
  return "nan:" + digits;
}

/// The inverse of float_to_json(). Also accepts any other number in the range of Float; returns
/// nullopt for anything else.
template <class Float, class Json>
std::optional<Float> float_from_json(const Json& json) {
  if (json.is_number()) {
    const auto value = json.template get<double>();
    const auto narrowed = static_cast<Float>(value);
    return std::isfinite(narrowed) ? std::optional(narrowed) : std::nullopt;
  }
  if (!json.is_string()) return std::nullopt;
  const auto& text = json.template get_ref<const std::string&>();
  if (text == "inf") return std::numeric_limits<Float>::infinity();
  if (text == "-inf") return -std::numeric_limits<Float>::infinity();
  if (!text.starts_with("nan:") || text.size() != 4 + 2 * sizeof(Float)) return std::nullopt;
  FloatBits<Float> bits = 0;
  const char* const all = text.data() + text.size();
  const auto [end, error] = std::from_chars(text.data() + 4, all, bits, 16);
  const auto value = std::bit_cast<Float>(bits);
  if (error != std::errc{} || end != all || !std::isnan(value)) return std::nullopt;
  return value;
}

}  // namespace sbgc::detail
