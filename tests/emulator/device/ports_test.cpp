// Tests of the serial interfaces: the framings that a board understands, buffers, and the order of
// requests.

#include "host.hpp"
#include "random_input.hpp"

namespace sbgc::test {
namespace {

const Bytes who = frame_of(86, {});
const std::size_t answer_size = frame_of(86, Bytes(18)).size();

Bytes times(int count, const Bytes& frame) {
  Bytes result;
  for (int i = 0; i < count; ++i) result.insert(result.end(), frame.begin(), frame.end());
  return result;
}

TEST(Ports, OneRequestIsCarriedOutInEachCycle) {
  Host host;
  host.send_bytes(times(100, who));
  const auto packets = host.listen(seconds(1));
  ASSERT_THAT(packets, SizeIs(100));
  for (std::size_t i = 1; i < packets.size(); ++i) {
    EXPECT_EQ(packets[i].at - packets[i - 1].at, microseconds(800));
  }
}

TEST(Ports, DoNotWaitForEachOther) {
  Host host;
  const auto other = host.board.open_port().value();
  host.board.receive(other, times(50, who), host.now);
  host.send_bytes(who);
  EXPECT_THAT(host.listen(milliseconds(1)), SizeIs(1));
}

TEST(Ports, ARequestThatDoesNotFitIsLostWhole) {
  Host host({.input_buffer = 3 * who.size() + 2});
  host.send_bytes(times(5, who));
  EXPECT_EQ(host.board.counters().lost, 2U);
  EXPECT_THAT(host.listen(seconds(1)), SizeIs(3));
  host.send_bytes(frame_of(41, Bytes(128)));
  EXPECT_EQ(host.board.counters().lost, 3U) << "longer than the buffer";
  host.send_bytes(who);
  EXPECT_THAT(host.listen(seconds(1)), SizeIs(1)) << "there is space again";
}

TEST(Ports, AFloodOfRequestsHasAnEnd) {
  Host host;
  host.send_bytes(times(500'000, who));
  EXPECT_GT(host.board.counters().lost, 100'000U);
}

TEST(Ports, AnswersWaitForRoomAndRequestsAfterThem) {
  emulator::BoardOptions options;
  options.output_buffer = answer_size + 5;
  Host host(options);
  int executed = 0;
  host.board.on_traffic = [&](const emulator::Board::Traffic& one) {
    executed += one.reaction ? 1 : 0;
  };
  host.send_bytes(times(4, who));
  host.now = host.now + seconds(1);
  host.board.advance(host.now);
  EXPECT_EQ(executed, 2) << "the second answer waits, and the third request for it";
  EXPECT_EQ(host.board.output(host.port).size(), options.output_buffer);
  EXPECT_EQ(host.board.next(), Instant::never);
  host.board.sent(host.port, answer_size, host.now);
  host.now = host.now + milliseconds(1);
  host.board.advance(host.now);
  EXPECT_EQ(executed, 3);
  std::size_t answers = 0;
  for (int i = 0; i < 10; ++i) answers += host.listen(milliseconds(1)).size();
  EXPECT_EQ(answers, 3U) << "nothing is lost";
}

TEST(Ports, AHostThatLeavesIsForgotten) {
  Host host;
  host.send_bytes(times(3, who));
  host.board.close_port(host.port);
  ASSERT_EQ(host.board.open_port(), host.port);
  EXPECT_THAT(host.listen(seconds(1)), IsEmpty());
}

TEST(Ports, ASilentBoardNeitherHearsNorSpeaks) {
  Host host;
  host.send_bytes(who);
  host.board.set_silent(true);
  EXPECT_THAT(host.listen(seconds(1)), IsEmpty());
  EXPECT_THAT(host.ask(msg::BoardInfoRequest{}), IsEmpty());
  host.board.set_silent(false);
  EXPECT_THAT(host.ask(msg::BoardInfoRequest{}), SizeIs(1));
}

TEST(Ports, WhatNobodyReadsIsLimited) {
  emulator::BoardOptions options;
  options.output_buffer = 100;
  Host host(options);
  // Each of them is announced to a host that has stopped reading.
  for (int i = 0; i < 2000; ++i) {
    host.board.receive(host.port, frame_of(69, Bytes{7}), host.now);
    host.now = host.now + seconds(2);
    host.board.advance(host.now);
  }
  EXPECT_LE(host.board.output(host.port).size(), options.output_buffer);
}

TEST(BoardFraming, AFullOutputBufferCountsTheBytesOfTheFraming) {
  // The answer has 18 bytes: 23 in the first framing, 24 in the second.
  Host host({.firmware = msg::FirmwareVersion(2680), .output_buffer = 24});
  host.framing = Framing::v2;
  EXPECT_THAT(host.ask(msg::BoardInfoRequest{}), SizeIs(1));
}

}  // namespace
}  // namespace sbgc::test
