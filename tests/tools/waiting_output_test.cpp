// Tests of output that waits: that of a command does not wait for its reader, and what a client has
// written is sent before its line is given back.

#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <memory>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include <asio/io_context.hpp>
#include <gtest/gtest.h>
#include <unistd.h>

#include <sbgc/io/memory.hpp>

#include "command/background_output.hpp"
#include "share/line_gate.hpp"

namespace sbgc::tools {
namespace {

class Output : public ::testing::Test {
 protected:
  void SetUp() override { ASSERT_EQ(::pipe(ends.data()), 0); }
  void TearDown() override {
    for (const int end : ends) ::close(end);
  }
  /// Reads so many bytes.
  std::string read(std::size_t size) const {
    std::string text(size, ' ');
    for (std::size_t at = 0; at < size;) {
      const ssize_t some = ::read(ends[0], text.data() + at, size - at);
      if (some <= 0) return text.substr(0, at);
      at += static_cast<std::size_t>(some);
    }
    return text;
  }

  std::array<int, 2> ends{};
};

TEST_F(Output, IsWrittenInOrder) {
  BackgroundOutput output(ends[1]);
  output.write("one\n");
  output.write("two\n");
  EXPECT_EQ(read(8), "one\ntwo\n");
}

TEST_F(Output, OneLongTextIsNotDropped) {
  const std::string text(200'000, 'x');
  BackgroundOutput output(ends[1]);
  output.write(text);
  EXPECT_EQ(read(text.size()), text);
  output.write("end\n");
  EXPECT_EQ(read(4), "end\n");
}

TEST_F(Output, WithoutAReaderTheNewestIsDroppedAndCounted) {
  const std::string line(999, 'x');
  BackgroundOutput output(ends[1]);
  for (int i = 0; i < 1000; ++i) output.write(line + "\n");
  int kept = 0;
  int dropped = 0;
  while (kept + dropped < 1000) {
    std::string text;
    while (!text.ends_with('\n')) text += read(1);
    if (text == line + "\n") {
      ++kept;
    } else {
      int lines = 0;
      ASSERT_EQ(std::sscanf(text.c_str(), "... %d lines dropped: no reader", &lines), 1) << text;
      dropped += lines;
    }
  }
  EXPECT_EQ(kept + dropped, 1000);
  EXPECT_LT(kept, 300);
}

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
