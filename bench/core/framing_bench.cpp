// Finding frames in a stream. One iteration is one pass over 64 MB, so bytes per second compare
// directly.

#include <cstddef>
#include <cstdint>
#include <span>

#include <benchmark/benchmark.h>

#include <sbgc/checksum.hpp>
#include <sbgc/frame.hpp>
#include <sbgc/parser.hpp>

#include "data.hpp"

namespace sbgc::bench {
namespace {

using sbgc::CrcTable;
using sbgc::Framing;

template <CrcTable table>
using ParserV2 = sbgc::BasicParser<sbgc::FrameFormats<table, Framing::v2>>;

void byte_sum(benchmark::State& state) {
  const Bytes& bytes = realtime();
  for (auto _ : state) benchmark::DoNotOptimize(sbgc::byte_sum(bytes.data(), bytes.size()));
  count_bytes(state, bytes.size());
}

template <CrcTable table>
void crc16(benchmark::State& state) {
  using Crc = sbgc::Crc<sbgc::FramingFacts<Framing::v2>::trailer_checksum_crc, table>;
  const Bytes& bytes = realtime();
  for (auto _ : state) benchmark::DoNotOptimize(Crc{}.add(bytes.data(), bytes.size()).value());
  count_bytes(state, bytes.size());
}

constexpr std::size_t whole = stream_size * 2;

/// Feeds the stream in chunks of `chunk_size`, a compile-time constant as in most applications.
template <const Bytes& (*stream)(), std::size_t chunk_size = whole, class Parser = sbgc::Parser>
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
  count_bytes(state, bytes.size());
  state.counters["frames"] = static_cast<double>(counters.frames);
}

BENCHMARK(copy_stream<realtime>)->Name("frames/memcpy");
BENCHMARK(byte_sum)->Name("frames/byte_sum");
BENCHMARK(parse<realtime>)->Name("frames/clean");
BENCHMARK(parse<realtime, 4096>)->Name("frames/clean_chunk4096");
BENCHMARK(parse<realtime, 64>)->Name("frames/clean_chunk64");
BENCHMARK(parse<realtime, 1>)->Name("frames/clean_byte");
BENCHMARK(parse<corrupted_realtime>)->Name("frames/corrupt_1pct");
BENCHMARK(parse<noise_stream>)->Name("frames/noise");
BENCHMARK(parse<noise_stream, 1>)->Name("frames/noise_byte");
BENCHMARK(parse<worst>)->Name("frames/worst");
BENCHMARK(parse<worst, 64>)->Name("frames/worst_chunk64");
BENCHMARK(parse<worst, 1>)->Name("frames/worst_byte");

// The second framing, and both in one stream.
BENCHMARK(copy_stream<realtime_v2>)->Name("frames_v2/memcpy");
BENCHMARK(crc16<CrcTable::slices>)->Name("frames_v2/crc16_slices");
BENCHMARK(crc16<CrcTable::bytes>)->Name("frames_v2/crc16_bytes");
BENCHMARK(crc16<CrcTable::nibbles>)->Name("frames_v2/crc16_nibbles");
BENCHMARK(parse<realtime_v2, whole, ParserV2<CrcTable::slices>>)->Name("frames_v2/clean");
BENCHMARK(parse<realtime_v2, whole, ParserV2<CrcTable::bytes>>)->Name("frames_v2/clean_crc_bytes");
BENCHMARK(parse<corrupted_realtime_v2, whole, ParserV2<CrcTable::slices>>)
    ->Name("frames_v2/corrupt_1pct");
BENCHMARK(parse<noise_stream, whole, ParserV2<CrcTable::slices>>)->Name("frames_v2/noise");
BENCHMARK(copy_stream<realtime>)->Name("frames_all/memcpy");
BENCHMARK(parse<realtime, whole, sbgc::ParserOfAll>)->Name("frames_all/clean_v1");
BENCHMARK(parse<realtime_v2, whole, sbgc::ParserOfAll>)->Name("frames_all/clean_v2");
BENCHMARK(parse<noise_stream, whole, sbgc::ParserOfAll>)->Name("frames_all/noise");
BENCHMARK(parse<noise_stream, 1, sbgc::ParserOfAll>)->Name("frames_all/noise_byte");

}  // namespace
}  // namespace sbgc::bench
