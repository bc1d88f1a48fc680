/// The settings and timing of a serial line.
#pragma once

#include <cstddef>
#include <cstdint>

#include <sbgc/time.hpp>

namespace sbgc {

/// The parity bit of each byte.
enum class Parity : std::uint8_t { none, even };

/// The settings of a serial line with 8 data bits and 1 stop bit.
struct LineSettings {
  std::uint32_t baud_rate{};  ///< bits per second; 0: unlimited, as over USB or TCP
  Parity parity{};

  constexpr bool operator==(const LineSettings&) const = default;
};

/// Returns the number of bits of a byte on the line: start bit, data, parity, stop bit.
constexpr std::uint32_t bits_per_byte(Parity parity) noexcept {
  return parity == Parity::none ? 10 : 11;
}

/// Returns the bandwidth of the line in bytes per second; 0: unlimited.
constexpr std::uint32_t bytes_per_second(const LineSettings& line) noexcept {
  return line.baud_rate / bits_per_byte(line.parity);
}

/// Returns the time that `bytes` bytes take on the line, rounded up; 0 if it is unlimited.
constexpr Duration wire_time(const LineSettings& line, std::size_t bytes) noexcept {
  if (line.baud_rate == 0) return {};
  const std::uint64_t bits = std::uint64_t{bytes} * bits_per_byte(line.parity);
  return {static_cast<std::int64_t>((bits * 1'000'000 + line.baud_rate - 1) / line.baud_rate)};
}

}  // namespace sbgc
