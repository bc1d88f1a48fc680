// Tests of the pair in memory: order, capacity, closing, and ends with different settings.

#include "support.hpp"

namespace sbgc::io::test {
namespace {

using Memory = Line;
using MemoryLine = Line;

TEST_F(Memory, BytesArriveUnchangedBothWays) {
  make_pair();
  expect_arrival(context, *port, *other, every_byte(2));
  expect_arrival(context, *other, *port, every_byte(2));
}

TEST_F(Memory, HandlersAreNeverCalledFromInside) {
  make_pair();
  Operation writing;
  Operation reading;
  Bytes into(8);
  port->async_write(Bytes{1, 2}, writing.handler());
  other->async_read(into, reading.handler());
  EXPECT_FALSE(writing.outcome || reading.outcome);
  context.run();
  EXPECT_TRUE(writing.outcome && reading.outcome);
}

TEST_F(Memory, WriteWaitsForRoom) {
  make_pair({.capacity = 4});
  Pending writing(context, *port, {1, 2, 3, 4, 5, 6, 7, 8, 9});
  EXPECT_THAT(read_all(context, *other, 4), ElementsAre(1, 2, 3, 4));
  writing.expect_waiting();
  EXPECT_THAT(read_all(context, *other, 4), ElementsAre(5, 6, 7, 8));
  EXPECT_EQ(writing.end().size, 9U);
  EXPECT_THAT(read_all(context, *other, 1), ElementsAre(9));
}

TEST_F(Memory, ReadsAreCutAsAsked) {
  make_pair({.max_read = 3});
  write(context, *port, every_byte());
  Bytes into(100);
  EXPECT_EQ(read(context, *other, into).size, 3U);
  EXPECT_EQ(read(context, *other, std::span(into).first(2)).size, 2U);
}

TEST_F(Memory, OtherSideClosesDuringRead) {
  make_pair();
  Pending reading(context, *other);
  port.reset();
  EXPECT_EQ(reading.end().error, Errc::end_of_stream);
}

TEST_F(Memory, OtherSideClosesDuringWrite) {
  make_pair({.capacity = 2});
  Pending writing(context, *port, {1, 2, 3});
  other->close();
  const Outcome outcome = writing.end();
  EXPECT_EQ(outcome.error, Errc::end_of_stream);
  EXPECT_EQ(outcome.size, 2U);
  EXPECT_EQ(write(context, *port, Bytes{4}).error, Errc::end_of_stream);
}

TEST_F(Memory, WhatWasWrittenBeforeTheEndIsStillRead) {
  make_pair();
  write(context, *port, Bytes{1, 2});
  port->close();
  EXPECT_THAT(read_all(context, *other, 2), ElementsAre(1, 2));
  Bytes into(8);
  EXPECT_EQ(read(context, *other, into).error, Errc::end_of_stream);
}

TEST_F(Memory, CloseCancels) {
  make_pair({.capacity = 1});
  Pending reading(context, *port);
  Pending writing(context, *port, {1, 2});
  port->close();
  port->close();
  Bytes into(8);
  for (const Outcome& outcome :
       {reading.end(), writing.end(), read(context, *port, into), write(context, *port, into)}) {
    EXPECT_EQ(outcome.error, asio::error::operation_aborted);
  }
}

TEST_F(Memory, DestroyingCancels) {
  make_pair();
  Pending reading(context, *port);
  port.reset();
  EXPECT_EQ(reading.end().error, asio::error::operation_aborted);
}

TEST_F(Memory, APendingReadIsWork) {
  make_pair();
  Pending reading(context, *port);
  EXPECT_FALSE(context.stopped());
  port->close();
  context.run();  // returns, because no work is left
}

TEST_F(Memory, EndsOnTwoThreads) {
  asio::io_context there;
  auto [first, second] = make_memory_pair(context.get_executor(), there.get_executor(),
                                          {.capacity = 7, .max_read = 5});
  // On the other thread: an echo until the line closes.
  Bytes buffer(64);
  std::function<void()> echo = [&, &end = second] {
    end->async_read(buffer, [&](std::error_code error, std::size_t size) {
      if (error) return;
      end->async_write(std::span(buffer).first(size), [&](std::error_code failed, std::size_t) {
        if (!failed) echo();
      });
    });
  };
  echo();
  std::thread thread([&] { there.run(); });
  expect_arrival(context, *first, *first, every_byte(20));
  first->close();
  thread.join();
}

TEST_F(MemoryLine, OnlyIfAskedFor) {
  make_pair();
  EXPECT_EQ(port->line(), nullptr);
  make_pair({.with_line = true});
  ASSERT_NE(port->line(), nullptr);
  EXPECT_FALSE(port->line()->set({57600, Parity::even}));
  EXPECT_EQ(port->line()->current(), (LineSettings{57600, Parity::even}));
  EXPECT_EQ(port->description(), "memory link, 57600 8E1");
  EXPECT_EQ(other->description(), "memory link, 115200 8N1");
}

TEST_F(MemoryLine, WrongSettingsLoseWhatIsWritten) {
  make_pair({.with_line = true});
  port->line()->set({57600, Parity::none});
  EXPECT_EQ(write(context, *port, Bytes{1, 2, 3}).size, 3U);
  other->line()->set({57600, Parity::none});
  expect_arrival(context, *port, *other, {4});
}

TEST_F(MemoryLine, WrongSettingsGarbleWhatIsWritten) {
  std::vector<LineSettings> seen;
  make_pair({.with_line = true,
             .mismatch = [&](std::span<const std::uint8_t> bytes, const LineSettings& sender,
                             const LineSettings& receiver) {
               seen = {sender, receiver};
               return Bytes(bytes.size() - 1, 0xFF);
             }});
  port->line()->set({57600, Parity::even});
  EXPECT_EQ(write(context, *port, Bytes{1, 2, 3}).size, 3U);
  EXPECT_THAT(read_all(context, *other, 2), ElementsAre(0xFF, 0xFF));
  EXPECT_THAT(seen, ElementsAre(LineSettings{57600, Parity::even}, default_line));
}

TEST_F(MemoryLine, SetAndFlushDiscardWhatWasReceived) {
  make_pair({.with_line = true});
  write(context, *port, Bytes{1, 2, 3});
  other->line()->set({115200, Parity::none});
  write(context, *port, Bytes{4, 5});
  other->line()->flush();
  expect_arrival(context, *port, *other, {6});
}

}  // namespace
}  // namespace sbgc::io::test
