/// Helpers shared by the tests of transports.
#pragma once

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <functional>
#include <memory>
#include <numeric>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <system_error>
#include <thread>
#include <utility>
#include <vector>

#include <asio/error.hpp>
#include <asio/io_context.hpp>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sbgc/io/memory.hpp>
#include <sbgc/io/network.hpp>
#include <sbgc/io/open.hpp>
#include <sbgc/io/pseudo_terminal.hpp>
#include <sbgc/io/serial.hpp>

namespace sbgc::io::test {

using namespace std::chrono_literals;
using ::testing::AnyOf;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;
using ::testing::StartsWith;

using Bytes = std::vector<std::uint8_t>;

/// No test takes this long: it turns a hang into a failure.
inline constexpr std::chrono::seconds patience{60};

/// Returns every value of a byte, `times` times over.
inline Bytes every_byte(std::size_t times = 1) {
  Bytes result(256 * times);
  std::iota(result.begin(), result.end(), std::uint8_t{0});
  return result;
}

/// The result of an operation.
struct Outcome {
  std::error_code error;
  std::size_t size{};
};

/// A pending operation; `outcome` is set when it completes.
struct Operation {
  std::optional<Outcome> outcome;
  int calls = 0;

  Transport::Handler handler() {
    return [this](std::error_code error, std::size_t size) {
      outcome = {error, size};
      ++calls;
    };
  }
};

/// Runs `context` until `done()` returns true; returns false on timeout.
template <class Done>
bool run_until(asio::io_context& context, Done done) {
  const auto end = std::chrono::steady_clock::now() + patience;
  context.restart();
  while (!done()) {
    if (context.run_one_until(end) == 0) {
      if (context.stopped()) context.restart();
      if (std::chrono::steady_clock::now() >= end) return done();
    }
  }
  return true;
}

inline Outcome finish(asio::io_context& context, const Operation& operation) {
  EXPECT_TRUE(run_until(context, [&] { return operation.outcome.has_value(); }));
  return operation.outcome.value_or(Outcome{std::make_error_code(std::errc::timed_out)});
}

inline Outcome read(asio::io_context& context, Transport& transport, std::span<std::uint8_t> into) {
  Operation operation;
  transport.async_read(into, operation.handler());
  return finish(context, operation);
}

/// Reads until `size` bytes have arrived or an error occurs.
inline Bytes read_all(asio::io_context& context, Transport& transport, std::size_t size) {
  Bytes result(size);
  std::size_t have = 0;
  while (have < size) {
    const Outcome outcome = read(context, transport, std::span(result).subspan(have));
    if (outcome.error) {
      ADD_FAILURE() << outcome.error.message();
      break;
    }
    have += outcome.size;
  }
  result.resize(have);
  return result;
}

inline Outcome write(asio::io_context& context, Transport& transport,
                     std::span<const std::uint8_t> bytes) {
  Operation operation;
  transport.async_write(bytes, operation.handler());
  return finish(context, operation);
}

/// Expects that bytes that one end writes arrive at the other one.
inline void expect_arrival(asio::io_context& context, Transport& from, Transport& to,
                           const Bytes& bytes) {
  Operation writing;
  from.async_write(bytes, writing.handler());
  EXPECT_EQ(read_all(context, to, bytes.size()), bytes);
  EXPECT_EQ(finish(context, writing).size, bytes.size());
}

/// A read that waits, or a write of more bytes than any line holds.
class Pending {
 public:
  Pending(asio::io_context& context, Transport& reader) : context_(context), bytes_(16) {
    reader.async_read(bytes_, operation_.handler());
    expect_waiting();
  }
  Pending(asio::io_context& context, Transport& writer, Bytes bytes)
      : context_(context), bytes_(std::move(bytes)) {
    writer.async_write(bytes_, operation_.handler());
    expect_waiting();
  }
  Pending(const Pending&) = delete;
  Pending& operator=(const Pending&) = delete;
  ~Pending() { EXPECT_LE(operation_.calls, 1); }

  Outcome end() { return finish(context_, operation_); }
  const Bytes& bytes() const { return bytes_; }
  void expect_waiting() {
    context_.poll();
    EXPECT_FALSE(operation_.outcome);
  }

 private:
  asio::io_context& context_;
  Bytes bytes_;
  Operation operation_{};
};

/// Returns the transport of what has been opened; throws its error.
template <class Opened>
auto opened(Opened result) {
  if (!result) throw std::runtime_error(result.error.message);
  return std::move(result.transport);
}

/// A test with an executor, and the two ends of a line.
class Line : public ::testing::Test {
 protected:
  void make_pair(const MemoryOptions& options = {}) {
    auto pair = make_memory_pair(context.get_executor(), options);
    port = std::move(pair.first);
    other = std::move(pair.second);
  }

  asio::io_context context;
  std::unique_ptr<Transport> port;
  std::unique_ptr<Transport> other;
};

}  // namespace sbgc::io::test
