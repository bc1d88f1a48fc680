// Tests of the gate between a line and its client.

#include "share/line_gate.hpp"

#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <system_error>
#include <utility>
#include <vector>

#include <asio/io_context.hpp>
#include <gtest/gtest.h>

#include <sbgc/io/memory.hpp>

namespace sbgc::tools {
namespace {

using Bytes = std::vector<std::uint8_t>;

TEST(LineGate, WhatWaitsIsSentBeforeTheLineIsGivenBack) {
  asio::io_context loop;
  // The board takes 10 bytes, until it reads.
  io::MemoryPair line = io::make_memory_pair(loop.get_executor(), {.capacity = 10});
  int sent = 0;
  LineGate gate([](const Bytes&) {}, [&] { ++sent; });
  std::unique_ptr<io::Transport> client = gate.pass(std::move(line.first));
  std::error_code end;
  std::array<std::uint8_t, 8> input{};
  client->async_read(input, [&](std::error_code error, std::size_t) { end = error; });
  gate.take();
  Bytes all;
  for (std::uint8_t i = 0; i < 10; ++i) {
    gate.write(Bytes(6, i));
    all.insert(all.end(), 6, i);
  }
  EXPECT_EQ(gate.waiting(), 60U);
  loop.poll();
  EXPECT_EQ(gate.waiting(), 54U) << "the second write does not fit";
  EXPECT_EQ(sent, 1);
  gate.give_back();
  loop.poll();
  EXPECT_FALSE(end) << "bytes are waiting";
  Bytes received;
  std::array<std::uint8_t, 100> output{};
  std::error_code board_end;
  while (!board_end) {
    line.second->async_read(output, [&](std::error_code error, std::size_t size) {
      board_end = error;
      received.insert(received.end(), output.begin(), output.begin() + size);
    });
    loop.restart();
    loop.run_for(std::chrono::milliseconds(20));
  }
  EXPECT_EQ(received, all);
  EXPECT_EQ(gate.waiting(), 0U);
  client.reset();
  EXPECT_EQ(gate.waiting(), 0U);
  EXPECT_EQ(end, io::Errc::device_lost);
}

}  // namespace
}  // namespace sbgc::tools
