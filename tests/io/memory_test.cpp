// Tests of the pair in memory: order, capacity, closing, and ends with different settings.

#include <cstdint>
#include <span>
#include <thread>
#include <vector>

#include <asio/error.hpp>
#include <asio/executor_work_guard.hpp>
#include <asio/io_context.hpp>
#include <gmock/gmock.h>

#include <sbgc/io/memory.hpp>

#include "support.hpp"

namespace sbgc::io::test {
namespace {

using testing::ElementsAre;

TEST(Memory, BytesArriveUnchangedBothWays) {
  asio::io_context context;
  auto [first, second] = make_memory_pair(context.get_executor());
  const Bytes bytes = every_byte(2);
  EXPECT_EQ(write(context, *first, bytes).size, bytes.size());
  EXPECT_EQ(read_all(context, *second, bytes.size()), bytes);
  EXPECT_EQ(write(context, *second, bytes).size, bytes.size());
  EXPECT_EQ(read_all(context, *first, bytes.size()), bytes);
}

TEST(Memory, HandlersAreNeverCalledFromInside) {
  asio::io_context context;
  auto [first, second] = make_memory_pair(context.get_executor());
  Operation writing;
  Operation reading;
  Bytes into(8);
  first->async_write(Bytes{1, 2}, writing.handler());
  second->async_read(into, reading.handler());
  EXPECT_FALSE(writing.outcome || reading.outcome);
  context.run();
  EXPECT_TRUE(writing.outcome && reading.outcome);
}

TEST(Memory, WriteWaitsForRoom) {
  asio::io_context context;
  auto [first, second] = make_memory_pair(context.get_executor(), {.capacity = 4});
  Operation writing;
  first->async_write(Bytes{1, 2, 3, 4, 5, 6, 7, 8, 9}, writing.handler());
  context.poll();
  EXPECT_FALSE(writing.outcome);
  EXPECT_THAT(read_all(context, *second, 4), ElementsAre(1, 2, 3, 4));
  context.poll();
  EXPECT_FALSE(writing.outcome);
  EXPECT_THAT(read_all(context, *second, 4), ElementsAre(5, 6, 7, 8));
  EXPECT_EQ(finish(context, writing).size, 9U);
  EXPECT_THAT(read_all(context, *second, 1), ElementsAre(9));
}

TEST(Memory, ReadsAreCutAsAsked) {
  asio::io_context context;
  auto [first, second] = make_memory_pair(context.get_executor(), {.max_read = 3});
  write(context, *first, every_byte());
  Bytes into(100);
  EXPECT_EQ(read(context, *second, into).size, 3U);
  EXPECT_EQ(read(context, *second, std::span(into).first(2)).size, 2U);
}

TEST(Memory, OtherSideClosesDuringRead) {
  asio::io_context context;
  auto [first, second] = make_memory_pair(context.get_executor());
  Operation reading;
  Bytes into(8);
  second->async_read(into, reading.handler());
  context.poll();
  EXPECT_FALSE(reading.outcome);
  first.reset();
  EXPECT_EQ(finish(context, reading).error, Errc::end_of_stream);
}

TEST(Memory, OtherSideClosesDuringWrite) {
  asio::io_context context;
  auto [first, second] = make_memory_pair(context.get_executor(), {.capacity = 2});
  Operation writing;
  first->async_write(Bytes{1, 2, 3}, writing.handler());
  second->close();
  const Outcome outcome = finish(context, writing);
  EXPECT_EQ(outcome.error, Errc::end_of_stream);
  EXPECT_EQ(outcome.size, 2U);
  EXPECT_EQ(write(context, *first, Bytes{4}).error, Errc::end_of_stream);
}

TEST(Memory, WhatWasWrittenBeforeTheEndIsStillRead) {
  asio::io_context context;
  auto [first, second] = make_memory_pair(context.get_executor());
  write(context, *first, Bytes{1, 2});
  first->close();
  EXPECT_THAT(read_all(context, *second, 2), ElementsAre(1, 2));
  Bytes into(8);
  EXPECT_EQ(read(context, *second, into).error, Errc::end_of_stream);
}

TEST(Memory, CloseCancels) {
  asio::io_context context;
  auto [first, second] = make_memory_pair(context.get_executor(), {.capacity = 1});
  Operation reading;
  Operation writing;
  Bytes into(8);
  first->async_read(into, reading.handler());
  first->async_write(Bytes{1, 2}, writing.handler());
  first->close();
  first->close();
  EXPECT_EQ(finish(context, reading).error, asio::error::operation_aborted);
  EXPECT_EQ(finish(context, writing).error, asio::error::operation_aborted);
  EXPECT_EQ(read(context, *first, into).error, asio::error::operation_aborted);
  EXPECT_EQ(write(context, *first, into).error, asio::error::operation_aborted);
  EXPECT_EQ(reading.calls, 1);
  EXPECT_EQ(writing.calls, 1);
}

TEST(Memory, DestroyingCancels) {
  asio::io_context context;
  auto [first, second] = make_memory_pair(context.get_executor());
  Operation reading;
  Bytes into(8);
  first->async_read(into, reading.handler());
  first.reset();
  EXPECT_EQ(finish(context, reading).error, asio::error::operation_aborted);
}

TEST(Memory, APendingReadIsWork) {
  asio::io_context context;
  auto [first, second] = make_memory_pair(context.get_executor());
  Operation reading;
  Bytes into(8);
  first->async_read(into, reading.handler());
  context.poll();
  EXPECT_FALSE(context.stopped());
  first->close();
  context.run();  // returns, because no work is left
  EXPECT_TRUE(reading.outcome);
}

TEST(Memory, EndsOnTwoThreads) {
  asio::io_context here;
  asio::io_context there;
  auto [first, second] =
      make_memory_pair(here.get_executor(), there.get_executor(), {.capacity = 7, .max_read = 5});
  // On the other thread: an echo until the line closes.
  Bytes buffer(64);
  std::function<void()> echo = [&, &other = second] {
    other->async_read(buffer, [&](std::error_code error, std::size_t size) {
      if (error) return;
      other->async_write(std::span(buffer).first(size), [&](std::error_code failed, std::size_t) {
        if (!failed) echo();
      });
    });
  };
  echo();
  std::thread thread([&] { there.run(); });
  const Bytes sent = every_byte(20);
  Operation writing;
  first->async_write(sent, writing.handler());
  EXPECT_EQ(read_all(here, *first, sent.size()), sent);
  EXPECT_EQ(finish(here, writing).size, sent.size());
  first->close();
  thread.join();
}

TEST(MemoryLine, OnlyIfAskedFor) {
  asio::io_context context;
  EXPECT_EQ(make_memory_pair(context.get_executor()).first->line(), nullptr);
  const auto pair = make_memory_pair(context.get_executor(), {.with_line = true});
  ASSERT_NE(pair.first->line(), nullptr);
  EXPECT_FALSE(pair.first->line()->set({57600, Parity::even}));
  EXPECT_EQ(pair.first->line()->current(), (LineSettings{57600, Parity::even}));
  EXPECT_EQ(pair.first->description(), "memory link, 57600 8E1");
  EXPECT_EQ(pair.second->description(), "memory link, 115200 8N1");
}

TEST(MemoryLine, WrongSettingsLoseWhatIsWritten) {
  asio::io_context context;
  auto [first, second] = make_memory_pair(context.get_executor(), {.with_line = true});
  first->line()->set({57600, Parity::none});
  EXPECT_EQ(write(context, *first, Bytes{1, 2, 3}).size, 3U);
  second->line()->set({57600, Parity::none});
  write(context, *first, Bytes{4});
  EXPECT_THAT(read_all(context, *second, 1), ElementsAre(4));
}

TEST(MemoryLine, WrongSettingsGarbleWhatIsWritten) {
  asio::io_context context;
  std::vector<LineSettings> seen;
  const auto garble = [&](std::span<const std::uint8_t> bytes, const LineSettings& sender,
                          const LineSettings& receiver) {
    seen = {sender, receiver};
    return Bytes(bytes.size() - 1, 0xFF);
  };
  auto [first, second] =
      make_memory_pair(context.get_executor(), {.with_line = true, .mismatch = garble});
  first->line()->set({57600, Parity::even});
  EXPECT_EQ(write(context, *first, Bytes{1, 2, 3}).size, 3U);
  EXPECT_THAT(read_all(context, *second, 2), ElementsAre(0xFF, 0xFF));
  EXPECT_THAT(seen, ElementsAre(LineSettings{57600, Parity::even}, default_line));
}

TEST(MemoryLine, SetAndFlushDiscardWhatWasReceived) {
  asio::io_context context;
  auto [first, second] = make_memory_pair(context.get_executor(), {.with_line = true});
  write(context, *first, Bytes{1, 2, 3});
  second->line()->set({115200, Parity::none});
  write(context, *first, Bytes{4, 5});
  second->line()->flush();
  write(context, *first, Bytes{6});
  EXPECT_THAT(read_all(context, *second, 1), ElementsAre(6));
}

}  // namespace
}  // namespace sbgc::io::test
