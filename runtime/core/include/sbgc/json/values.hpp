/// Lossless JSON representations of texts and non-finite floats.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>

#include <sbgc/internal/characters.hpp>
#include <sbgc/internal/parse_number.hpp>

namespace sbgc::detail {

// Bytes that are not UTF-8 are escaped as U+F780 to U+F7FF, in a private use area. If a text from a
// board contains these characters itself, their bytes are escaped one by one, to avoid ambiguity.

/// Returns true if `sequence` is one of the escape characters.
inline bool is_escape(std::string_view sequence) {
  return sequence.size() == 3 && sequence[0] == '\xEF' &&
         (sequence[1] == '\x9E' || sequence[1] == '\x9F');
}

/// Converts any bytes to well-formed UTF-8, and calls `use(std::string_view)` for each character.
template <class Use>
void for_each_character(std::string_view bytes, Use&& use) {
  for_each_sequence(bytes, [&](std::string_view sequence, bool is_utf8) {
    if (is_utf8 && !is_escape(sequence)) return use(sequence);
    for (const char c : sequence) {
      const auto byte = static_cast<std::uint8_t>(c);
      const char escape[] = {'\xEF', static_cast<char>(0x9C | byte >> 6),
                             static_cast<char>(0x80 | (byte & 0x3F))};
      use(std::string_view(escape, sizeof escape));
    }
  });
}

/// Converts any bytes to well-formed UTF-8.
inline std::string to_utf8(std::string_view bytes) {
  std::string result;
  for_each_character(bytes, [&](std::string_view character) { result += character; });
  return result;
}

/// The unsigned integer with the bits of a float or double.
template <class Float>
using FloatBits = std::conditional_t<sizeof(Float) == 4, std::uint32_t, std::uint64_t>;

template <class Float>
bool is_finite(Float value) {
  using Limits = std::numeric_limits<Float>;
  return value >= Limits::lowest() && value <= Limits::max();
}

/// Returns true for the bits of a NaN. (<cmath> takes long to compile.)
template <class Float>
constexpr bool is_nan(FloatBits<Float> bits) noexcept {
  constexpr auto infinity = std::bit_cast<FloatBits<Float>>(std::numeric_limits<Float>::infinity());
  constexpr auto magnitude = static_cast<FloatBits<Float>>(~FloatBits<Float>{0}) >> 1;
  return (bits & magnitude) > infinity;
}

/// The name of an infinity or a NaN, for which JSON has no numbers: "inf", "-inf" or "nan:<hex
/// bits>".
class FloatName {
 public:
  template <class Float>
  explicit FloatName(Float value) {
    add(value > 0 ? "inf" : value < 0 ? "-inf" : "nan:");
    const auto bits = std::bit_cast<FloatBits<Float>>(value);
    if (!is_nan<Float>(bits)) return;
    for (std::size_t shift = 8 * sizeof value; shift != 0; shift -= 4) {
      name_[size_++] = "0123456789abcdef"[bits >> (shift - 4) & 15U];
    }
  }
  std::string_view text() const { return {name_.data(), size_}; }

 private:
  void add(std::string_view text) {
    for (const char c : text) name_[size_++] = c;
  }

  std::array<char, 20> name_{};
  std::size_t size_ = 0;
};

/// The inverse of FloatName. Returns nullopt for any other text.
template <class Float>
std::optional<Float> float_of_name(std::string_view text) {
  if (text == "inf") return std::numeric_limits<Float>::infinity();
  if (text == "-inf") return -std::numeric_limits<Float>::infinity();
  if (!text.starts_with("nan:") || text.size() != 4 + 2 * sizeof(Float)) return std::nullopt;
  const auto bits = parse_number<FloatBits<Float>>(text.substr(4), 16);
  if (!bits || !is_nan<Float>(*bits)) return std::nullopt;
  return std::bit_cast<Float>(*bits);
}

}  // namespace sbgc::detail
