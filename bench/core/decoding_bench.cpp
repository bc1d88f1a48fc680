// Finding and decoding the messages of a stream. One iteration is one pass over 64 MB.

#include <cstddef>
#include <cstdint>
#include <span>

#include <benchmark/benchmark.h>

#include <sbgc/messages.hpp>
#include <sbgc/parser.hpp>
#include <sbgc/visit.hpp>

#include "data.hpp"

namespace sbgc::bench {
namespace {

using sbgc::Framing;

constexpr std::size_t whole = stream_size * 2;

void count_messages(benchmark::State& state, std::uint64_t messages) {
  state.counters["messages"] =
      benchmark::Counter(static_cast<double>(messages), benchmark::Counter::kAvgIterations);
}

/// Parses and decodes `stream` in chunks of `chunk_size`. Every message is stored to memory.
template <const Bytes& (*stream)(), std::size_t chunk_size = whole, class Parser = sbgc::Parser>
void decode_stream(benchmark::State& state) {
  const Bytes& bytes = stream();
  std::uint64_t decoded = 0;
  for (auto _ : state) {
    Parser parser;
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
  count_messages(state, decoded);
}

/// Parses and visits `stream`: the visitor gets each message by its type.
template <const Bytes& (*stream)()>
void visit_stream(benchmark::State& state) {
  const Bytes& bytes = stream();
  std::uint64_t visited = 0;
  std::uint64_t failed = 0;
  for (auto _ : state) {
    sbgc::Parser parser;
    parser.feed(bytes, [&](const sbgc::Frame& frame) {
      const auto status = sbgc::visit(frame, sbgc::Direction::from_board, [&](const auto& message) {
        benchmark::DoNotOptimize(&message);
        benchmark::ClobberMemory();
        ++visited;
      });
      if (!status) ++failed;
    });
  }
  if (failed != 0) state.SkipWithError("a message does not decode");
  count_bytes(state, bytes.size());
  count_messages(state, visited);
}

using ParserV2 = sbgc::BasicParser<sbgc::FrameFormats<sbgc::CrcTable::slices, Framing::v2>>;

BENCHMARK(copy_stream<realtime>)->Name("stream/memcpy");
BENCHMARK(decode_stream<realtime>)->Name("stream/clean");
BENCHMARK(decode_stream<realtime, 4096>)->Name("stream/clean_chunk4096");
BENCHMARK(decode_stream<realtime, 64>)->Name("stream/clean_chunk64");
BENCHMARK(decode_stream<realtime, 1>)->Name("stream/clean_byte");
BENCHMARK(decode_stream<corrupted_realtime>)->Name("stream/corrupt_1pct");
BENCHMARK(decode_stream<noise_stream>)->Name("stream/noise");
BENCHMARK(decode_stream<noise_stream, 1>)->Name("stream/noise_byte");
BENCHMARK(copy_stream<realtime_v2>)->Name("stream_v2/memcpy");
BENCHMARK(decode_stream<realtime_v2, whole, ParserV2>)->Name("stream_v2/clean");
BENCHMARK(decode_stream<realtime_v2, whole, sbgc::ParserOfAll>)->Name("stream_v2/clean_of_all");
BENCHMARK(copy_stream<realtime>)->Name("visit/memcpy");
BENCHMARK(visit_stream<realtime>)->Name("visit/realtime");
BENCHMARK(visit_stream<mixed>)->Name("visit/mixed");

}  // namespace
}  // namespace sbgc::bench
