/// The data of all benchmarks: the same bytes in each run.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <random>
#include <span>
#include <vector>

#include <benchmark/benchmark.h>

#include <sbgc/message.hpp>

namespace sbgc::bench {

using Bytes = std::vector<std::uint8_t>;

/// The size of each stream: larger than all caches, or memcpy would be twice as fast.
inline constexpr std::size_t stream_size = std::size_t{64} << 20;

// Streams of at least `size` bytes, and of one frame more at most

/// CMD_REALTIME_DATA_4 frames with random bodies, back to back.
Bytes realtime_stream(std::size_t size = stream_size, Framing framing = basic_framing);
/// Frames of 20 messages from the board in random order, with typical values.
Bytes mixed_stream(std::size_t size = stream_size);
/// The bytes with 1 % of them, on average, replaced by a different value.
Bytes corrupted(Bytes bytes);
Bytes noise(std::size_t size = stream_size);
/// Every third byte starts a valid header that announces the longest body; no body is valid.
Bytes worst_stream(std::size_t size = stream_size);

/// One stream of each kind, made when it is first used.
const Bytes& realtime();
const Bytes& realtime_v2();
const Bytes& mixed();
const Bytes& corrupted_realtime();
const Bytes& corrupted_realtime_v2();
const Bytes& noise_stream();
const Bytes& worst();

// Single messages

/// The body of a message from the board with the typical values of the test vectors.
Bytes typical_body(std::uint8_t id, std::size_t size);

/// Ends the program: the data of the benchmarks are wrong.
[[noreturn]] void fail(const char* what);

/// A message from the board with typical values.
template <class M>
M typical() {
  M message{};
  if (!decode(typical_body(static_cast<std::uint8_t>(M::command), M::min_size), message)) {
    fail("typical values");
  }
  return message;
}

inline void fill_randomly(std::span<std::uint8_t> bytes, std::mt19937& random) {
  for (std::uint8_t& byte : bytes) byte = static_cast<std::uint8_t>(random());
}

inline void count_bytes(::benchmark::State& state, std::size_t bytes) {
  state.SetBytesProcessed(static_cast<std::int64_t>(bytes) * state.iterations());
}

/// Copies a stream: the baseline of its group.
template <const Bytes& (*stream)()>
void copy_stream(::benchmark::State& state) {
  const Bytes& bytes = stream();
  Bytes copy(bytes.size());
  for (auto _ : state) {
    __builtin_memcpy(copy.data(), bytes.data(), bytes.size());
    ::benchmark::ClobberMemory();
  }
  count_bytes(state, bytes.size());
}

/// Copies `size` bytes, a constant as in the codec: the baseline of a message.
template <std::size_t size>
void copy_bytes(::benchmark::State& state) {
  std::array<std::uint8_t, size> from{};
  std::array<std::uint8_t, size> to{};
  ::benchmark::DoNotOptimize(from.data());
  ::benchmark::DoNotOptimize(to.data());
  for (auto _ : state) {
    ::benchmark::ClobberMemory();  // `from` may have changed
    __builtin_memcpy(to.data(), from.data(), size);
    ::benchmark::ClobberMemory();  // `to` is read
  }
}

}  // namespace sbgc::bench
