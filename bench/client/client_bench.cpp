// Requests for angles over an emulated line, one after the other: at most 411 a second at 115200
// baud, since request and response are 28 bytes.

#include <atomic>
#include <chrono>
#include <string>
#include <thread>

#include <asio/executor_work_guard.hpp>
#include <asio/io_context.hpp>
#include <benchmark/benchmark.h>

#include <sbgc/client/client.hpp>
#include <sbgc/emulator/emulator.hpp>
#include <sbgc/messages.hpp>
#include <sbgc/responses/all.hpp>
#include <sbgc/session.hpp>

#include "serving/service.hpp"

namespace {

constexpr std::uint32_t baud_rate = 115200;

sbgc::emulator::EmulatorOptions emulated() {
  sbgc::emulator::EmulatorOptions options;
  options.line.board.baud_rate = baud_rate;
  return options;
}

void count_requests(benchmark::State& state, double requests, double seconds) {
  state.counters["requests_per_second"] = requests / seconds;
}

/// In virtual time: what the protocol and the session allow.
void session_in_virtual_time(benchmark::State& state) {
  sbgc::Instant now{};
  sbgc::emulator::Emulator emulator(emulated(), {}, now);
  const std::size_t port = emulator.connect(false, now).value();
  sbgc::SessionOptions options;
  options.line.baud_rate = baud_rate;
  sbgc::Session session(options);
  const sbgc::Instant begin = now = now + sbgc::seconds(5);  // once the board has started
  emulator.advance(now);
  emulator.take(port, emulator.to_host(port).size(), now);
  double answered = 0;
  const auto sink = [&](const sbgc::Event& event) {
    answered += event.outcome == sbgc::Outcome::answered ? 1 : 0;
  };
  for (auto _ : state) {
    const double before = answered;
    static_cast<void>(session.send(sbgc::msg::GetAnglesRequest{}));
    while (answered == before) {
      const sbgc::Output output = session.poll(now, sink);
      if (!output.bytes.empty()) emulator.from_host(port, output.bytes, now);
      now = sbgc::earlier(emulator.next(), session.poll(now, sink).deadline);
      emulator.advance(now);
      session.feed(emulator.to_host(port), now, sink);
      emulator.take(port, emulator.to_host(port).size(), now);
    }
  }
  count_requests(state, answered, static_cast<double>((now - begin).us) * 1e-6);
}

/// In real time: a client with its defaults, over a pseudo-terminal.
void client_over_a_terminal(benchmark::State& state) {
  asio::io_context context(1);
  sbgc::serving::ServiceOptions options;
  options.emulator = emulated();
  options.terminal = true;
  sbgc::serving::Service service(context, options, {});
  const auto work = asio::make_work_guard(context);
  std::thread serving([&] { context.run(); });
  const std::string address = service.endpoints(0).front()->address();
  auto client = sbgc::Client::connect(address);
  if (!client) {
    state.SkipWithError(client.error().message.c_str());
  } else {
    const auto begin = std::chrono::steady_clock::now();
    for (auto _ : state) {
      if (!client->get_angles()) state.SkipWithError("no angles");
    }
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begin;
    count_requests(state, static_cast<double>(state.iterations()), took.count());
    client->close();
  }
  context.stop();
  serving.join();
}

BENCHMARK(session_in_virtual_time)->Name("requests/session_at_115200");
BENCHMARK(client_over_a_terminal)
    ->Name("requests/client_at_115200")
    ->Iterations(500)
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);

}  // namespace
