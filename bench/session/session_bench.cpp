// Cost of a session compared with the bare parser: a stream of samples, and requests with their
// responses.

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <vector>

#include <benchmark/benchmark.h>

#include <sbgc/message.hpp>
#include <sbgc/parser.hpp>
#include <sbgc/responses/all.hpp>
#include <sbgc/session.hpp>

namespace {

/// A megabyte of unsolicited samples.
const std::vector<std::uint8_t>& samples() {
  static const std::vector<std::uint8_t> bytes = [] {
    std::vector<std::uint8_t> result;
    std::uint8_t frame[sbgc::max_frame_size];
    const std::size_t size = sbgc::encode_frame(sbgc::msg::RealtimeData4{}, frame).size;
    while (result.size() < 1'000'000) result.insert(result.end(), frame, frame + size);
    return result;
  }();
  return bytes;
}

void count_bytes(benchmark::State& state, std::size_t size) {
  state.SetBytesProcessed(state.iterations() * static_cast<std::int64_t>(size));
}

void copying(benchmark::State& state) {
  const auto& from = samples();
  std::vector<std::uint8_t> to(from.size());
  for (auto _ : state) {
    std::memcpy(to.data(), from.data(), from.size());
    benchmark::DoNotOptimize(to.data());
    benchmark::ClobberMemory();
  }
  count_bytes(state, from.size());
}

void parsing(benchmark::State& state) {
  sbgc::Parser parser;
  std::uint64_t seen = 0;
  for (auto _ : state) {
    parser.feed(samples(), [&](const sbgc::Frame& frame) { seen += frame.body[0]; });
    benchmark::DoNotOptimize(seen);
  }
  count_bytes(state, samples().size());
}

void feeding_a_session(benchmark::State& state) {
  sbgc::Session session;
  std::uint64_t seen = 0;
  for (auto _ : state) {
    session.feed(samples(), {}, [&](const sbgc::Event& event) { seen += event.frame.body[0]; });
    benchmark::DoNotOptimize(seen);
  }
  count_bytes(state, samples().size());
}

/// One request with its frame, response and outcome; the bytes counted are those of the response.
void asking(benchmark::State& state) {
  sbgc::SessionOptions options;
  options.pacing = {{}, {}};
  sbgc::Session session(options);
  std::uint8_t answer[sbgc::max_frame_size];
  const std::size_t size = sbgc::encode_frame(sbgc::msg::RealtimeData4{}, answer).size;
  sbgc::Instant now{};
  std::uint64_t ends = 0;
  const auto sink = [&](const sbgc::Event& event) {
    ends += event.outcome == sbgc::Outcome::answered ? 1U : 0U;
  };
  for (auto _ : state) {
    now = now + sbgc::microseconds(1);
    static_cast<void>(session.send(sbgc::msg::RealtimeData4Request{}));
    benchmark::DoNotOptimize(session.poll(now, sink).bytes.data());
    session.feed({answer, size}, now, sink);
  }
  if (ends != static_cast<std::uint64_t>(state.iterations())) state.SkipWithError("no answer");
  count_bytes(state, size);
}

BENCHMARK(copying)->Name("session/memcpy");
BENCHMARK(parsing)->Name("session/parser_alone");
BENCHMARK(feeding_a_session)->Name("session/feed");
BENCHMARK(asking)->Name("session/request_and_answer");

}  // namespace
