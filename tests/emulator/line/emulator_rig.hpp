/// An emulated board with one host at the other end of its line, for tests.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sbgc/emulator/emulator.hpp>
#include <sbgc/message.hpp>
#include <sbgc/messages/realtime.hpp>
#include <sbgc/parser.hpp>

namespace sbgc::emulator::test {

using Bytes = std::vector<std::uint8_t>;

template <Message M>
Bytes frame_of(const M& message) {
  std::array<std::uint8_t, max_frame_size> frame{};
  const std::size_t size = encode_frame(message, frame).size;
  return {frame.begin(), frame.begin() + static_cast<std::ptrdiff_t>(size)};
}

inline Bytes stream_of(std::uint16_t interval_ms) {
  msg::DataStreamInterval request;
  request.cmd_id = msg::CommandFromBoard::realtime_data_4;
  request.interval_ms = msg::Milliseconds(interval_ms);
  return frame_of(request);
}

constexpr std::size_t sample_size = frame_size(msg::RealtimeData4::max_size);

/// One host on one port.
struct Bench {
  explicit Bench(const EmulatorOptions& options = {}, bool is_usb = false)
      : emulator(options, {}, now), port(emulator.connect(is_usb, now).value()) {
    listen(seconds(1));
  }

  /// Advances time; returns the bytes that arrive meanwhile.
  Bytes listen(Duration duration, Duration step = milliseconds(10)) {
    Bytes result;
    const Instant end = now + duration;
    while (now < end) {
      now = earlier(end, now + step);
      emulator.advance(now);
      const auto arrived = emulator.to_host(port);
      result.insert(result.end(), arrived.begin(), arrived.end());
      emulator.take(port, arrived.size(), now);
    }
    return result;
  }

  void send(const Bytes& bytes) { emulator.from_host(port, bytes, now); }

  Instant now{};
  Emulator emulator;
  std::size_t port;
};

inline std::size_t frames_in(const Bytes& bytes, msg::CommandFromBoard id) {
  std::size_t result = 0;
  ParserOfAll parser;
  parser.feed(bytes, [&](const Frame& frame) {
    result += frame.id == static_cast<std::uint8_t>(id) ? 1U : 0U;
  });
  return result;
}

}  // namespace sbgc::emulator::test
