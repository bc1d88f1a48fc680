/// Helpers shared by the tests of a line: bytes to send, and their arrivals.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sbgc/emulator/line.hpp>
#include <sbgc/message.hpp>
#include <sbgc/messages/realtime.hpp>

#include "physics/noise.hpp"

namespace sbgc::emulator::test {

using Bytes = std::vector<std::uint8_t>;
using Way = Line::Way;

constexpr Instant start = Instant{} + seconds(100);

inline Bytes noise(std::size_t size) {
  Bytes result(size);
  for (std::size_t i = 0; i < size; ++i) result[i] = static_cast<std::uint8_t>(random_bits(7, i));
  return result;
}

inline Bytes frames(std::size_t number) {
  Bytes result;
  for (std::size_t i = 0; i < number; ++i) {
    std::array<std::uint8_t, max_frame_size> frame{};
    msg::RealtimeData3 data;
    data.cycle_time = msg::Microseconds(static_cast<std::uint16_t>(i));
    const std::size_t size = encode_frame(data, frame).size;
    result.insert(result.end(), frame.begin(), frame.begin() + static_cast<std::ptrdiff_t>(size));
  }
  return result;
}

inline Bytes received(Line& line, Instant now) {
  Bytes result;
  line.receive(now, result);
  return result;
}

/// A byte with its time of arrival.
struct Arrived {
  Instant at{};
  std::uint8_t byte{};
  bool operator==(const Arrived&) const = default;
};

inline std::vector<Arrived> arrivals(Line& line, Instant until) {
  std::vector<Arrived> result;
  while (line.next() <= until) {
    const Instant at = line.next();
    for (const std::uint8_t byte : received(line, at)) result.push_back({at, byte});
  }
  return result;
}

inline Bytes bytes_of(const std::vector<Arrived>& arrived) {
  Bytes result;
  for (const Arrived& one : arrived) result.push_back(one.byte);
  return result;
}

constexpr Instant later_on = start + seconds(3600);

}  // namespace sbgc::emulator::test
