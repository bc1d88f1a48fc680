// Cost of emulated boards: one board per second of simulated time, and 200 boards that stream at 50
// Hz over sockets in real time. `cpu_share` is relative to one processor and includes the hosts.

#include <array>
#include <chrono>
#include <cstdint>
#include <cstring>
#include <memory>
#include <string>
#include <vector>

#include <asio/buffer.hpp>
#include <asio/io_context.hpp>
#include <asio/ip/tcp.hpp>
#include <asio/write.hpp>
#include <benchmark/benchmark.h>
#include <sys/resource.h>

#include <sbgc/emulator/emulator.hpp>
#include <sbgc/message.hpp>
#include <sbgc/messages/realtime.hpp>
#include <sbgc/parser.hpp>

#include "serving/service.hpp"

namespace {

using Bytes = std::vector<std::uint8_t>;
using asio::ip::tcp;

constexpr unsigned boards = 200;
constexpr int rate = 50;
constexpr std::size_t sample_size = sbgc::frame_size(sbgc::msg::RealtimeData4::max_size);

Bytes stream_request() {
  sbgc::msg::DataStreamInterval request;
  request.cmd_id = sbgc::msg::CommandFromBoard::realtime_data_4;
  request.interval_ms = sbgc::msg::Milliseconds(1000 / rate);
  std::array<std::uint8_t, sbgc::max_frame_size> frame{};
  const std::size_t size = sbgc::encode_frame(request, frame).size;
  return {frame.begin(), frame.begin() + static_cast<std::ptrdiff_t>(size)};
}

/// Returns the processor time used by this program, in seconds.
double cpu_seconds() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  const auto seconds = [](const timeval& time) {
    return static_cast<double>(time.tv_sec) + static_cast<double>(time.tv_usec) * 1e-6;
  };
  return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

/// Copies the bytes that one board sends in a second.
void copying(benchmark::State& state) {
  const Bytes from(sample_size * rate, 0x5A);
  Bytes to(from.size());
  for (auto _ : state) {
    std::memcpy(to.data(), from.data(), from.size());
    benchmark::DoNotOptimize(to.data());
    benchmark::ClobberMemory();
  }
  state.SetBytesProcessed(state.iterations() * static_cast<std::int64_t>(from.size()));
}

template <std::uint32_t baud_rate>
void second_of_one_board(benchmark::State& state) {
  sbgc::emulator::EmulatorOptions options;
  options.line.board.baud_rate = baud_rate;
  sbgc::Instant now{};
  sbgc::emulator::Emulator emulator(options, {}, now);
  const std::size_t port = emulator.connect(false, now).value();
  now = now + sbgc::seconds(1);
  emulator.from_host(port, stream_request(), now);
  std::int64_t bytes = 0;
  for (auto _ : state) {
    const sbgc::Instant end = now + sbgc::seconds(1);
    while (now < end) {
      now = sbgc::earlier(end, now + sbgc::milliseconds(1));
      emulator.advance(now);
      const std::size_t size = emulator.to_host(port).size();
      bytes += static_cast<std::int64_t>(size);
      emulator.take(port, size, now);
    }
  }
  if (bytes < state.iterations() * rate * static_cast<std::int64_t>(sample_size) * 95 / 100) {
    state.SkipWithError("samples are missing");
  }
  state.SetBytesProcessed(bytes);
}

/// Requests a stream and counts the frames and bytes received.
class Listener {
 public:
  Listener(asio::io_context& context, const std::string& address) : socket_(context) {
    const auto port = std::stoul(address.substr(address.rfind(':') + 1));
    socket_.connect({asio::ip::address_v4::loopback(), static_cast<std::uint16_t>(port)});
    asio::write(socket_, asio::buffer(stream_request()));
    read();
  }

  std::uint64_t frames = 0;
  std::int64_t bytes = 0;

 private:
  void read() {
    socket_.async_read_some(asio::buffer(buffer_), [this](std::error_code error, std::size_t size) {
      if (error) return;
      bytes += static_cast<std::int64_t>(size);
      parser_.feed(std::span(buffer_).first(size), [this](const sbgc::Frame&) { ++frames; });
      read();
    });
  }

  tcp::socket socket_;
  std::array<std::uint8_t, 4096> buffer_{};
  sbgc::Parser parser_;
};

void many_boards(benchmark::State& state) {
  asio::io_context context(1);
  sbgc::serving::ServiceOptions options;
  options.count = boards;
  options.tcp.emplace();
  sbgc::serving::Service service(context, options, {});
  std::vector<std::unique_ptr<Listener>> listeners;
  for (unsigned i = 0; i < boards; ++i) {
    const std::string address = service.endpoints(i).front()->address();
    listeners.push_back(std::make_unique<Listener>(context, address));
  }
  context.run_for(std::chrono::milliseconds(500));  // until all streams have started
  const auto sum = [&](auto of) {
    std::int64_t result = 0;
    for (const auto& one : listeners) result += static_cast<std::int64_t>(of(*one));
    return result;
  };
  const auto frames = [&] { return sum([](const Listener& one) { return one.frames; }); };
  const auto bytes = [&] { return sum([](const Listener& one) { return one.bytes; }); };
  const std::int64_t frames_before = frames();
  const std::int64_t bytes_before = bytes();
  double cpu = 0;
  for (auto _ : state) {
    const double before = cpu_seconds();
    context.run_for(std::chrono::seconds(2));
    cpu += cpu_seconds() - before;
  }
  const double wall = 2.0 * static_cast<double>(state.iterations());
  state.counters["cpu_share"] = cpu / wall;
  state.counters["frames_per_second"] = static_cast<double>(frames() - frames_before) / wall;
  state.SetBytesProcessed(bytes() - bytes_before);
  context.run_for(std::chrono::milliseconds(500));  // let a busy machine catch up
  // The counters show if a machine is too slow or too busy for all samples.
  if (frames() == frames_before) state.SkipWithError("there are no samples");
}

BENCHMARK(copying)->Name("emulator/memcpy");
BENCHMARK(second_of_one_board<0>)->Name("emulator/second_of_one_board");
BENCHMARK(second_of_one_board<115200>)->Name("emulator/second_at_115200");
BENCHMARK(many_boards)
    ->Name("emulator/200_boards_at_50_Hz")
    ->Iterations(1)
    ->UseRealTime()
    ->Unit(benchmark::kMillisecond);

}  // namespace
