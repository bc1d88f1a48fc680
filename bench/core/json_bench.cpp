// A message as JSON text and back, beside the same through the values of nlohmann_json.

#include <array>
#include <cstddef>
#include <string>

#include <benchmark/benchmark.h>

#include <sbgc/json.hpp>
#include <sbgc/json_dom.hpp>
#include <sbgc/messages/realtime.hpp>
#include <sbgc/meta/realtime.hpp>

#include "data.hpp"

namespace {

using namespace sbgc::bench;
using Message = sbgc::msg::RealtimeData4;

void copy_text(benchmark::State& state) {
  const std::string from = sbgc::to_json(typical<Message>());
  std::string to = from;
  for (auto _ : state) {
    __builtin_memcpy(to.data(), from.data(), from.size());
    benchmark::ClobberMemory();
  }
  count_bytes(state, from.size());
}

void to_json(benchmark::State& state) {
  auto message = typical<Message>();
  benchmark::DoNotOptimize(&message);
  std::size_t size = 0;
  for (auto _ : state) {
    benchmark::ClobberMemory();
    const std::string text = sbgc::to_json(message);
    benchmark::DoNotOptimize(text.data());
    size = text.size();
  }
  count_bytes(state, size);
}

void to_json_in_place(benchmark::State& state) {
  auto message = typical<Message>();
  std::array<char, 4096> text{};
  benchmark::DoNotOptimize(&message);
  benchmark::DoNotOptimize(text.data());
  std::size_t size = 0;
  for (auto _ : state) {
    benchmark::ClobberMemory();
    size = sbgc::to_json(message, text);
    benchmark::ClobberMemory();
  }
  count_bytes(state, size);
}

void from_json(benchmark::State& state) {
  const std::string text = sbgc::to_json(typical<Message>());
  Message message{};
  benchmark::DoNotOptimize(&message);
  for (auto _ : state) {
    if (!sbgc::from_json(text, message)) state.SkipWithError("the text is refused");
    benchmark::ClobberMemory();
  }
  count_bytes(state, text.size());
}

void to_dom(benchmark::State& state) {
  auto message = typical<Message>();
  benchmark::DoNotOptimize(&message);
  std::size_t size = 0;
  for (auto _ : state) {
    benchmark::ClobberMemory();
    const std::string text = sbgc::to_dom(message).dump();
    benchmark::DoNotOptimize(text.data());
    size = text.size();
  }
  count_bytes(state, size);
}

void from_dom(benchmark::State& state) {
  const std::string text = sbgc::to_json(typical<Message>());
  Message message{};
  benchmark::DoNotOptimize(&message);
  for (auto _ : state) {
    sbgc::from_dom(nlohmann::ordered_json::parse(text), message);  // throws for wrong text
    benchmark::ClobberMemory();
  }
  count_bytes(state, text.size());
}

BENCHMARK(copy_text)->Name("json/memcpy");
BENCHMARK(to_json)->Name("json/to_json");
BENCHMARK(to_json_in_place)->Name("json/to_json_in_place");
BENCHMARK(from_json)->Name("json/from_json");
BENCHMARK(to_dom)->Name("json/to_dom");
BENCHMARK(from_dom)->Name("json/from_dom");

}  // namespace
