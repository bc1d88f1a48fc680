/// Decimal digits, written two at a time.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

#include <sbgc/internal/compiler.hpp>

namespace sbgc::detail {

/// "00", "01" to "99".
inline constexpr auto digit_pairs = [] {
  std::array<char, 200> pairs{};
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    pairs[i] = static_cast<char>('0' + (i % 2 == 0 ? i / 20 : i / 2 % 10));
  }
  return pairs;
}();

/// Writes a number below 100 as two digits.
inline void write_pair(char* out, std::uint64_t number) noexcept {
  copy_memory(out, &digit_pairs[static_cast<std::size_t>(2 * number)], 2);
}

/// 1, 10, 100 …
inline constexpr auto powers_of_ten = [] {
  std::array<std::uint64_t, 20> powers{1};
  for (std::size_t i = 1; i < powers.size(); ++i) powers[i] = 10 * powers[i - 1];
  return powers;
}();

/// Returns the number of digits of a number that is not 0.
constexpr std::size_t digit_count(std::uint64_t number) noexcept {
  const auto bits = static_cast<std::size_t>(std::bit_width(number));
  const std::size_t least = bits * 1233 / 4096;  // 1233 / 4096 is the logarithm of 2
  return least + static_cast<std::size_t>(number >= powers_of_ten[least]);
}

/// Writes a number in decimal. Returns the end.
inline char* write_digits(char* out, std::uint64_t number) noexcept {
  if (number < 10) {
    *out = static_cast<char>('0' + number);
    return out + 1;
  }
  char* const end = out + digit_count(number);
  char* at = end;
  for (; number >= 100; number /= 100) write_pair(at -= 2, number % 100);
  if (number >= 10) {
    write_pair(out, number);
  } else {
    *out = static_cast<char>('0' + number);
  }
  return end;
}

}  // namespace sbgc::detail
