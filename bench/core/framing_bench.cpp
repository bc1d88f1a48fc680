// Benchmarks of framing. One iteration is one pass over 16 MB, so bytes per second compare
// directly.

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
#include <sbgc/frame.hpp>
#include <sbgc/parser.hpp>

namespace {

using Bytes = std::vector<std::uint8_t>;

constexpr std::size_t stream_size = std::size_t{16} << 20;
constexpr std::uint8_t realtime_data_id = 25;
constexpr std::size_t realtime_body_size = 124;

/// Frames of the size of CMD_REALTIME_DATA_4 with random bodies, back to back.
template <sbgc::Framing framing = sbgc::Framing::v1>
const Bytes& clean_stream() {
  static const Bytes stream = [] {
    std::mt19937 random(1);
    Bytes bytes;
    bytes.reserve(stream_size + sbgc::max_frame_size);
    std::array<std::uint8_t, sbgc::max_frame_size> frame{};
    while (bytes.size() < stream_size) {
      std::uint8_t* const body = sbgc::frame_body(frame.data());
      std::generate_n(body, realtime_body_size,
                      [&] { return static_cast<std::uint8_t>(random()); });
      const std::size_t size =
          sbgc::finish_frame<framing>(frame.data(), realtime_data_id, realtime_body_size);
      bytes.insert(bytes.end(), frame.data(), frame.data() + size);
    }
    return bytes;
  }();
  return stream;
}

/// The clean stream with 1 % of its bytes, on average, replaced by a different value.
template <sbgc::Framing framing = sbgc::Framing::v1>
const Bytes& corrupt_stream() {
  static const Bytes stream = [] {
    std::mt19937 random(2);
    Bytes bytes = clean_stream<framing>();
    for (std::uint8_t& byte : bytes) {
      if (random() % 100 == 0) byte = static_cast<std::uint8_t>(byte + 1 + random() % 255);
    }
    return bytes;
  }();
  return stream;
}

const Bytes& noise() {
  static const Bytes stream = [] {
    std::mt19937 random(3);
    Bytes bytes(clean_stream().size());
    std::generate(bytes.begin(), bytes.end(), [&] { return static_cast<std::uint8_t>(random()); });
    return bytes;
  }();
  return stream;
}

void count_bytes(benchmark::State& state, const Bytes& bytes) {
  state.SetBytesProcessed(static_cast<std::int64_t>(bytes.size()) * state.iterations());
}

void memory_copy(benchmark::State& state) {
  const Bytes& bytes = clean_stream();
  Bytes copy(bytes.size());
  for (auto _ : state) {
    std::memcpy(copy.data(), bytes.data(), bytes.size());
    benchmark::ClobberMemory();
  }
  count_bytes(state, bytes);
}

void byte_sum(benchmark::State& state) {
  const Bytes& bytes = clean_stream();
  for (auto _ : state) benchmark::DoNotOptimize(sbgc::byte_sum(bytes.data(), bytes.size()));
  count_bytes(state, bytes);
}

using sbgc::CrcTable;
using sbgc::Framing;

template <CrcTable table>
using ParserV2 = sbgc::BasicParser<sbgc::FrameFormats<table, Framing::v2>>;

template <CrcTable table>
void crc16(benchmark::State& state) {
  using Crc = sbgc::Crc16<sbgc::FramingFacts<Framing::v2>::trailer_checksum_crc, table>;
  const Bytes& bytes = clean_stream();
  for (auto _ : state) benchmark::DoNotOptimize(Crc{}.add(bytes.data(), bytes.size()).value());
  count_bytes(state, bytes);
}

/// Feeds `bytes` in chunks of `chunk_size`, a compile-time constant as in most applications.
template <const Bytes& (*stream)(), std::size_t chunk_size = stream_size * 2,
          class Parser = sbgc::Parser>
void parse(benchmark::State& state) {
  const Bytes& bytes = stream();
  sbgc::ParserCounters counters;
  for (auto _ : state) {
    Parser parser;
    std::uint64_t sum = 0;
    const auto sink = [&sum](const sbgc::Frame& frame) {
      sum += frame.id + frame.body.size() + frame.body.front();
    };
    std::span<const std::uint8_t> rest(bytes);
    while (rest.size() >= chunk_size) {
      parser.feed(rest.first(chunk_size), sink);
      rest = rest.subspan(chunk_size);
    }
    parser.feed(rest, sink);
    parser.flush(sink);
    benchmark::DoNotOptimize(sum);
    counters = parser.counters();
  }
  count_bytes(state, bytes);
  state.counters["frames"] = static_cast<double>(counters.frames);
}

BENCHMARK(memory_copy)->Name("frames/memcpy");
BENCHMARK(byte_sum)->Name("frames/byte_sum");
BENCHMARK(parse<clean_stream<>>)->Name("frames/clean");
BENCHMARK(parse<clean_stream<>, 4096>)->Name("frames/clean_chunk4096");
BENCHMARK(parse<clean_stream<>, 64>)->Name("frames/clean_chunk64");
BENCHMARK(parse<clean_stream<>, 1>)->Name("frames/clean_byte");
BENCHMARK(parse<corrupt_stream<>>)->Name("frames/corrupt_1pct");
BENCHMARK(parse<noise>)->Name("frames/noise");

// The second framing, and both in one stream.
constexpr std::size_t whole = stream_size * 2;
BENCHMARK(crc16<CrcTable::slices>)->Name("frames_v2/crc16_slices");
BENCHMARK(crc16<CrcTable::bytes>)->Name("frames_v2/crc16_bytes");
BENCHMARK(crc16<CrcTable::nibbles>)->Name("frames_v2/crc16_nibbles");
BENCHMARK(parse<clean_stream<Framing::v2>, whole, ParserV2<CrcTable::slices>>)
    ->Name("frames_v2/clean");
BENCHMARK(parse<clean_stream<Framing::v2>, whole, ParserV2<CrcTable::bytes>>)
    ->Name("frames_v2/clean_crc_bytes");
BENCHMARK(parse<corrupt_stream<Framing::v2>, whole, ParserV2<CrcTable::slices>>)
    ->Name("frames_v2/corrupt_1pct");
BENCHMARK(parse<noise, whole, ParserV2<CrcTable::slices>>)->Name("frames_v2/noise");
BENCHMARK(parse<clean_stream<>, whole, sbgc::ParserOfAll>)->Name("frames_all/clean_v1");
BENCHMARK(parse<clean_stream<Framing::v2>, whole, sbgc::ParserOfAll>)->Name("frames_all/clean_v2");
BENCHMARK(parse<noise, whole, sbgc::ParserOfAll>)->Name("frames_all/noise");

}  // namespace
