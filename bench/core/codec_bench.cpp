// Benchmarks of decoding, encoding and validation. stream/: one iteration frames and decodes 16 MB.
// The other groups: one iteration handles one message.

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <random>
#include <span>
#include <vector>

#include <benchmark/benchmark.h>

#include <sbgc/checksum.hpp>
#include <sbgc/message.hpp>
#include <sbgc/messages/control.hpp>
#include <sbgc/messages/parameters.hpp>
#include <sbgc/messages/realtime.hpp>
#include <sbgc/meta/control.hpp>
#include <sbgc/meta/parameters.hpp>
#include <sbgc/meta/realtime.hpp>
#include <sbgc/parser.hpp>
#include <sbgc/validate.hpp>

namespace {

using ByteVector = std::vector<std::uint8_t>;

constexpr std::size_t stream_size = std::size_t{16} << 20;

void fill_randomly(std::span<std::uint8_t> bytes, std::mt19937& random) {
  std::ranges::generate(bytes, [&] { return static_cast<std::uint8_t>(random()); });
}

// ---- streams ----

/// CMD_REALTIME_DATA_4 frames with random bodies, back to back.
const ByteVector& clean_stream() {
  static const ByteVector stream = [] {
    std::mt19937 random(1);
    ByteVector bytes;
    bytes.reserve(stream_size + sbgc::max_frame_size);
    std::array<std::uint8_t, sbgc::max_frame_size> frame{};
    while (bytes.size() < stream_size) {
      fill_randomly(std::span(sbgc::frame_body(frame.data()), sbgc::msg::RealtimeData4::min_size),
                    random);
      const std::size_t size = sbgc::finish_frame(
          frame.data(), static_cast<std::uint8_t>(sbgc::msg::RealtimeData4::command),
          sbgc::msg::RealtimeData4::min_size);
      bytes.insert(bytes.end(), frame.data(), frame.data() + size);
    }
    return bytes;
  }();
  return stream;
}

/// The clean stream with 1 % of its bytes, on average, replaced by a different value.
const ByteVector& corrupt_stream() {
  static const ByteVector stream = [] {
    std::mt19937 random(2);
    ByteVector bytes = clean_stream();
    for (std::uint8_t& byte : bytes) {
      if (random() % 100 == 0) byte = static_cast<std::uint8_t>(byte + 1 + random() % 255);
    }
    return bytes;
  }();
  return stream;
}

const ByteVector& noise() {
  static const ByteVector stream = [] {
    std::mt19937 random(3);
    ByteVector bytes(clean_stream().size());
    fill_randomly(bytes, random);
    return bytes;
  }();
  return stream;
}

void count_bytes(benchmark::State& state, std::size_t bytes) {
  state.SetBytesProcessed(static_cast<std::int64_t>(bytes) * state.iterations());
}

void copy_stream(benchmark::State& state) {
  const ByteVector& bytes = clean_stream();
  ByteVector copy(bytes.size());
  for (auto _ : state) {
    std::memcpy(copy.data(), bytes.data(), bytes.size());
    benchmark::ClobberMemory();
  }
  count_bytes(state, bytes.size());
}

/// Parses and decodes `stream` in chunks of `chunk_size`. Every message is stored to memory.
template <const ByteVector& (*stream)(), std::size_t chunk_size = stream_size * 2>
void decode_stream(benchmark::State& state) {
  const ByteVector& bytes = stream();
  std::uint64_t decoded = 0;
  for (auto _ : state) {
    sbgc::Parser parser;
    sbgc::msg::RealtimeData4 message;
    benchmark::DoNotOptimize(&message);
    const auto sink = [&](const sbgc::Frame& frame) {
      if (frame.id != static_cast<std::uint8_t>(sbgc::msg::RealtimeData4::command)) return;
      if (!sbgc::decode(frame.body, message)) return;
      benchmark::ClobberMemory();
      ++decoded;
    };
    std::span<const std::uint8_t> rest(bytes);
    while (rest.size() >= chunk_size) {
      parser.feed(rest.first(chunk_size), sink);
      rest = rest.subspan(chunk_size);
    }
    parser.feed(rest, sink);
    parser.flush(sink);
  }
  count_bytes(state, bytes.size());
  state.counters["messages"] =
      benchmark::Counter(static_cast<double>(decoded), benchmark::Counter::kAvgIterations);
}

BENCHMARK(copy_stream)->Name("stream/memcpy");
BENCHMARK(decode_stream<clean_stream>)->Name("stream/clean");
BENCHMARK(decode_stream<clean_stream, 4096>)->Name("stream/clean_chunk4096");
BENCHMARK(decode_stream<clean_stream, 64>)->Name("stream/clean_chunk64");
BENCHMARK(decode_stream<clean_stream, 1>)->Name("stream/clean_byte");
BENCHMARK(decode_stream<corrupt_stream>)->Name("stream/corrupt_1pct");
BENCHMARK(decode_stream<noise>)->Name("stream/noise");

// ---- single messages ----

constexpr std::size_t overhead = sbgc::frame_size(0);

/// A body of `M` with random bytes.
template <class M>
std::array<std::uint8_t, M::min_size> some_body() {
  std::array<std::uint8_t, M::min_size> body{};
  std::mt19937 random(4);
  fill_randomly(body, random);
  return body;
}

template <class M>
M some_message() {
  M message;
  static_cast<void>(sbgc::decode(some_body<M>(), message));
  return message;
}

/// Copies `size` bytes. The size is a compile-time constant, as in the codec.
template <std::size_t size>
void copy_bytes(benchmark::State& state) {
  std::array<std::uint8_t, size> from{};
  std::array<std::uint8_t, size> to{};
  benchmark::DoNotOptimize(from.data());
  benchmark::DoNotOptimize(to.data());
  for (auto _ : state) {
    benchmark::ClobberMemory();  // `from` may have changed
    std::memcpy(to.data(), from.data(), size);
    benchmark::ClobberMemory();  // `to` is read
  }
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
  M message = some_message<M>();
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
void validate_one(benchmark::State& state) {
  M message = some_message<M>();
  benchmark::DoNotOptimize(&message);
  for (auto _ : state) {
    benchmark::ClobberMemory();
    int violations = 0;
    sbgc::validate(message, [&](const sbgc::Violation&) { ++violations; });
    benchmark::DoNotOptimize(violations);
  }
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
BENCHMARK(validate_one<sbgc::msg::RealtimeData4>)->Name("realtime/validate");

BENCHMARK(copy_bytes<20>)->Name("control/copy_frame");
// The baseline includes the checksum, because encoding has to compute it too.
BENCHMARK(copy_and_sum<20>)->Name("control/memcpy");
BENCHMARK(encode_one<sbgc::msg::ControlExt>)->Name("control/encode_frame");
BENCHMARK(copy_and_sum_fresh_control)->Name("control/copy_and_sum_fresh");
BENCHMARK(encode_fresh_control)->Name("control/encode_frame_fresh");
BENCHMARK(decode_one<sbgc::msg::ControlExt>)->Name("control/decode");
BENCHMARK(validate_one<sbgc::msg::ControlExt>)->Name("control/validate");

BENCHMARK(copy_bytes<134>)->Name("params/memcpy");
BENCHMARK(copy_bytes<134 + overhead>)->Name("params/copy_frame");
BENCHMARK(copy_and_sum<134 + overhead>)->Name("params/copy_frame_and_sum");
BENCHMARK(decode_one<sbgc::msg::ReadParams3>)->Name("params/decode");
BENCHMARK(encode_one<sbgc::msg::ReadParams3>)->Name("params/encode_frame");
BENCHMARK(validate_one<sbgc::msg::ReadParams3>)->Name("params/validate");

}  // namespace
