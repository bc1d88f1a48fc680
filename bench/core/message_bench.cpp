// Decoding, encoding and validating one message.

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>

#include <benchmark/benchmark.h>

#include <sbgc/checksum.hpp>
#include <sbgc/message.hpp>
#include <sbgc/messages/control.hpp>
#include <sbgc/messages/parameters.hpp>
#include <sbgc/messages/realtime.hpp>
#include <sbgc/meta/control.hpp>
#include <sbgc/meta/parameters.hpp>
#include <sbgc/meta/realtime.hpp>
#include <sbgc/validate.hpp>

#include "data.hpp"

namespace sbgc::bench {
namespace {

constexpr std::size_t overhead = sbgc::frame_size(0);

/// A body of `M` with random bytes.
template <class M>
std::array<std::uint8_t, M::min_size> some_body() {
  std::array<std::uint8_t, M::min_size> body{};
  std::mt19937 random(4);
  fill_randomly(body, random);
  return body;
}

/// Copies a frame, then computes the checksum of the copied body: the minimum work of writing a
/// frame.
template <std::size_t size>
void copy_and_sum(benchmark::State& state) {
  std::array<std::uint8_t, size> from{};
  std::array<std::uint8_t, size> to{};
  benchmark::DoNotOptimize(from.data());
  benchmark::DoNotOptimize(to.data());
  for (auto _ : state) {
    benchmark::ClobberMemory();
    std::memcpy(to.data(), from.data(), size);
    to[size - 1] = sbgc::byte_sum(to.data() + sbgc::frame_header_size, size - overhead);
    benchmark::ClobberMemory();
  }
}

template <class M>
void decode_one(benchmark::State& state) {
  const auto body = some_body<M>();
  M message;
  benchmark::DoNotOptimize(body.data());
  benchmark::DoNotOptimize(&message);
  for (auto _ : state) {
    benchmark::ClobberMemory();
    const bool ok(sbgc::decode(body, message));
    benchmark::DoNotOptimize(ok);
    benchmark::ClobberMemory();
  }
}

/// Encodes a message that is already in memory into a frame.
template <class M>
void encode_one(benchmark::State& state) {
  M message{};
  if (!sbgc::decode(some_body<M>(), message)) state.SkipWithError("the message does not decode");
  std::array<std::uint8_t, sbgc::max_frame_size> frame{};
  benchmark::DoNotOptimize(&message);
  benchmark::DoNotOptimize(frame.data());
  for (auto _ : state) {
    benchmark::ClobberMemory();
    const std::size_t size = sbgc::encode_frame(message, frame).size;
    benchmark::DoNotOptimize(size);
    benchmark::ClobberMemory();
  }
}

template <class M>
void validate_one(benchmark::State& state, M message) {
  int violations = 0;
  benchmark::DoNotOptimize(&message);
  for (auto _ : state) {
    benchmark::ClobberMemory();
    sbgc::validate(message, [&](const sbgc::Violation&) { ++violations; });
    benchmark::DoNotOptimize(violations);
  }
  state.counters["violations"] = benchmark::Counter(violations, benchmark::Counter::kAvgIterations);
}

/// A valid message.
template <class M>
void validate_typical(benchmark::State& state) {
  validate_one(state, typical<M>());
}

/// A message with random bytes, which breaks many rules.
template <class M>
void validate_random(benchmark::State& state) {
  M message{};
  if (!sbgc::decode(some_body<M>(), message)) state.SkipWithError("the message does not decode");
  validate_one(state, message);
}

/// Angles and speeds within their ranges.
void validate_control(benchmark::State& state) {
  sbgc::msg::ControlExt message;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    message.control_mode[axis].set_mode(sbgc::msg::ControlModeKind::angle);
    message.axes[axis].speed = sbgc::msg::ControlSpeed(100);
    message.axes[axis].angle = sbgc::msg::Angle14(100);
  }
  validate_one(state, message);
}

/// Copies and sums 20 bytes that were just assembled from values unknown to the compiler.
void copy_and_sum_fresh_control(benchmark::State& state) {
  std::array<std::int16_t, 6> values{1, 2, 3, 4, 5, 6};
  std::array<std::uint8_t, 3> modes{2, 2, 2};
  std::array<std::uint8_t, 20> to{};
  benchmark::DoNotOptimize(values.data());
  benchmark::DoNotOptimize(modes.data());
  benchmark::DoNotOptimize(to.data());
  for (auto _ : state) {
    benchmark::ClobberMemory();
    std::array<std::uint8_t, 20> from{'>', 67, 15, 82};
    std::memcpy(from.data() + 4, modes.data(), sizeof modes);
    std::memcpy(from.data() + 7, values.data(), sizeof values);
    std::memcpy(to.data(), from.data(), from.size());
    to[19] = sbgc::byte_sum(to.data() + 4, 15);
    benchmark::ClobberMemory();
  }
}

/// Sets the fields and then writes the frame, as a control loop does.
void encode_fresh_control(benchmark::State& state) {
  std::array<std::int16_t, 6> values{1, 2, 3, 4, 5, 6};
  std::array<std::uint8_t, 3> modes{2, 2, 2};
  std::array<std::uint8_t, 20> frame{};
  benchmark::DoNotOptimize(values.data());
  benchmark::DoNotOptimize(modes.data());
  benchmark::DoNotOptimize(frame.data());
  for (auto _ : state) {
    benchmark::ClobberMemory();
    sbgc::msg::ControlExt message;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      message.control_mode[axis] = sbgc::msg::ControlMode(modes[axis]);
      message.axes[axis].speed = sbgc::msg::ControlSpeed(values[2 * axis]);
      message.axes[axis].angle = sbgc::msg::Angle14(values[2 * axis + 1]);
    }
    const std::size_t size = sbgc::encode_frame(message, frame).size;
    benchmark::DoNotOptimize(size);
    benchmark::ClobberMemory();
  }
}

BENCHMARK(copy_bytes<124>)->Name("realtime/memcpy");
BENCHMARK(copy_bytes<124 + overhead>)->Name("realtime/copy_frame");
BENCHMARK(copy_and_sum<124 + overhead>)->Name("realtime/copy_frame_and_sum");
BENCHMARK(decode_one<sbgc::msg::RealtimeData4>)->Name("realtime/decode");
BENCHMARK(encode_one<sbgc::msg::RealtimeData4>)->Name("realtime/encode_frame");
BENCHMARK(validate_typical<sbgc::msg::RealtimeData4>)->Name("realtime/validate");
BENCHMARK(validate_random<sbgc::msg::RealtimeData4>)->Name("realtime/validate_random");

BENCHMARK(copy_bytes<20>)->Name("control/memcpy");
BENCHMARK(copy_and_sum<20>)->Name("control/copy_frame_and_sum");
BENCHMARK(encode_one<sbgc::msg::ControlExt>)->Name("control/encode_frame");
BENCHMARK(copy_and_sum_fresh_control)->Name("control/copy_and_sum_fresh");
BENCHMARK(encode_fresh_control)->Name("control/encode_frame_fresh");
BENCHMARK(decode_one<sbgc::msg::ControlExt>)->Name("control/decode");
BENCHMARK(validate_control)->Name("control/validate");

BENCHMARK(copy_bytes<134>)->Name("params/memcpy");
BENCHMARK(copy_bytes<134 + overhead>)->Name("params/copy_frame");
BENCHMARK(copy_and_sum<134 + overhead>)->Name("params/copy_frame_and_sum");
BENCHMARK(decode_one<sbgc::msg::ReadParams3>)->Name("params/decode");
BENCHMARK(encode_one<sbgc::msg::ReadParams3>)->Name("params/encode_frame");
BENCHMARK(validate_typical<sbgc::msg::ReadParams3>)->Name("params/validate");
BENCHMARK(validate_random<sbgc::msg::ReadParams3>)->Name("params/validate_random");

}  // namespace
}  // namespace sbgc::bench
