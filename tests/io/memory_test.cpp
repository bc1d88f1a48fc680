// The pair in memory: order, capacity, closing, and what a UART makes of wrong settings.

#include <thread>

#include <asio/error.hpp>
#include <asio/executor_work_guard.hpp>
#include <asio/io_context.hpp>
#include <gmock/gmock.h>

#include <sbgc/io/memory.hpp>

#include "support.hpp"

namespace sbgc::io::test {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

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
  context.run();  // ends, because nothing is left
  EXPECT_TRUE(reading.outcome);
}

TEST(Memory, EndsOnTwoThreads) {
  asio::io_context here;
  asio::io_context there;
  auto [first, second] =
      make_memory_pair(here.get_executor(), there.get_executor(), {.capacity = 7, .max_read = 5});
  // There: an echo until the end.
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

TEST(MemoryLine, WrongSettingsMakeGarbage) {
  asio::io_context context;
  auto [first, second] = make_memory_pair(context.get_executor(), {.with_line = true});
  first->line()->set({57600, Parity::none});
  EXPECT_EQ(write(context, *first, Bytes{'>', 86, 0, 86, 0}).size, 5U);
  context.poll();
  first->close();
  Bytes got(100);
  const Outcome outcome = read(context, *second, got);
  got.resize(outcome.size);
  EXPECT_NE(got, (Bytes{'>', 86, 0, 86, 0}));
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

TEST(ReceivedAs, SameSettingsChangeNothing) {
  const Bytes bytes = every_byte();
  for (const LineSettings line : {LineSettings{9600}, LineSettings{115200, Parity::even}}) {
    EXPECT_EQ(received_as(bytes, line, line), bytes);
  }
}

TEST(ReceivedAs, AlmostTheSameRateChangesNothing) {
  const Bytes bytes = every_byte();
  EXPECT_EQ(received_as(bytes, {115200}, {117000}), bytes);
  EXPECT_EQ(received_as(bytes, {115200, Parity::even}, {113500, Parity::even}), bytes);
}

TEST(ReceivedAs, HalfTheRate) {
  // 0xE0 is six bits of 0, then ones: for the receiver a start bit and two bits of 0.
  EXPECT_THAT(received_as(Bytes{0xE0}, {19200}, {9600}), ElementsAre(0xFC));
}

TEST(ReceivedAs, TwiceTheRate) {
  // Bits seen at twice the rate: 0xFF has a start bit of two bits, then ones.
  EXPECT_THAT(received_as(Bytes{0xFF}, {9600}, {19200}), ElementsAre(0xFE));
  // 0x00 is a break: no stop bit where one should be.
  EXPECT_THAT(received_as(Bytes{0x00}, {9600}, {19200}), IsEmpty());
}

TEST(ReceivedAs, ParityThatIsNotThere) {
  // The stop bit is taken for parity: right for an odd number of ones, if the line is idle then.
  EXPECT_THAT(received_as(Bytes{0x01}, {9600}, {9600, Parity::even}), ElementsAre(0x01));
  EXPECT_THAT(received_as(Bytes{0x03}, {9600}, {9600, Parity::even}), IsEmpty());
}

TEST(ReceivedAs, ParityThatIsNotExpected) {
  // The parity bit is taken for the stop bit: it must be 1.
  EXPECT_THAT(received_as(Bytes{0x01, 0x03, 0x07}, {9600, Parity::even}, {9600}),
              ElementsAre(0x01, 0x07));
}

}  // namespace
}  // namespace sbgc::io::test
