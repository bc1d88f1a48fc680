/// Helpers shared by the tests of transports.
#pragma once

#include <chrono>
#include <cstdint>
#include <numeric>
#include <optional>
#include <span>
#include <string>
#include <system_error>
#include <vector>

#include <asio/io_context.hpp>
#include <gtest/gtest.h>

#include <sbgc/io/transport.hpp>

namespace sbgc::io::test {

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

}  // namespace sbgc::io::test
