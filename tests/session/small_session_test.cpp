// Tests of sessions of small capacity.

#include "simulation.hpp"

namespace sbgc::test {
namespace {

using LongTimes = LineTest;

/// For requests of at most 24 bytes.
using ControllerSession = BasicSession<
    SessionCapacity{
        .requests = 1, .late_replies = 1, .streams = 0, .body = 24, .optimize = Optimize::size},
    FrameFormats<CrcTable::nibbles, Framing::v1>>;

TEST(SmallSession, SendsOneRequestAtATime) {
  Basic<ControllerSession> line;
  line.board = [&](const Written& frame) {
    if (frame.id == 86) line.say(86, body_of(18));
  };
  const Handle identify = line.send(msg::BoardInfoRequest{});
  EXPECT_EQ(line.session.send(msg::Control{}).status, SendStatus::queue_full);
  line.run();
  EXPECT_EQ(line.outcome(identify), Outcome::answered);
  EXPECT_EQ(line.ask(msg::Control{}), Outcome::sent);
}

TEST(SmallSession, ABodyOfAWrongSizeAnswers) {
  Basic<ControllerSession> line;
  line.board = [&](const Written&) { line.say(86, body_of(17)); };
  EXPECT_EQ(line.ask(msg::BoardInfoRequest{}), Outcome::answered);
  EXPECT_EQ(line.written.size(), 1U);
}

TEST(SmallSession, RefusesABodyLargerThanItsCapacity) {
  Basic<ControllerSession> line;
  const std::vector<std::uint8_t> body(25);
  const ResponsePolicy policy = response_policy(msg::Control{});
  const SendResult sent = line.session.send(67, body, policy);
  EXPECT_EQ(sent.status, SendStatus::not_encodable);
  EXPECT_EQ(sent.encoding.code, Code::buffer_too_small);
  EXPECT_TRUE(line.session.send(67, std::span(body).first(24), policy));
  line.run();
  ASSERT_EQ(line.written.size(), 1U);
  EXPECT_EQ(line.written[0].body.size(), 24U);
}

TEST(SmallSession, RefusesStreamsIfItHasNoRoomForThem) {
  Basic<ControllerSession> line;
  msg::DataStreamInterval stream{.cmd_id = msg::CommandFromBoard::realtime_data_3,
                                 .interval_ms = msg::Milliseconds(20)};
  EXPECT_EQ(line.session.send(stream).status, SendStatus::too_many_streams);
  stream.interval_ms = msg::Milliseconds(0);
  EXPECT_TRUE(line.session.send(stream)) << "an end needs no room";
}

TEST(SmallSession, TheEndOfAnUnknownStreamDoesNotEndThatOfALaterRequest) {
  Basic<BasicSession<SessionCapacity{.streams = 1}>> line;
  line.board = [&](const Written& frame) { line.confirm(frame.id); };
  line.send(stream_of(msg::CommandFromBoard::realtime_data_3, 100));
  line.run();
  const Handle end = line.send(stream_of(msg::CommandFromBoard::realtime_data_3, 0));
  line.send(stream_of(msg::CommandFromBoard::realtime_data_4, 0));  // not running
  line.on_event = [&](const Record& record) {
    if (record.event.kind == EventKind::completed && record.event.handle == end) {
      line.send(stream_of(msg::CommandFromBoard::realtime_data_4, 100));
    }
  };
  line.run();
  EXPECT_EQ(line.session.stream_usage().used, 1290U) << "129 bytes, 10 times a second";
}

TEST(SmallSession, CountsOnlyFramesAndNoise) {
  Basic<ControllerSession> line;
  line.board = [&](const Written&) { line.say_bytes({1, 2, 3}); };
  line.send(msg::BoardInfoRequest{}, {.attempts = 1});
  line.run();
  const SessionStatistics statistics = line.session.statistics();
  EXPECT_EQ(statistics.parser.skipped_bytes, 3U);
  EXPECT_EQ(statistics.sent_frames, 0U);
}

TEST_F(LongTimes, RefusesATimeoutLongerThanItsTimers) {
  EXPECT_EQ(
      line.session.send(msg::BoardInfoRequest{}, {.timeout = longest_timeout + microseconds(1)})
          .status,
      SendStatus::timeout_too_long);
  const Handle handle =
      line.send(msg::BoardInfoRequest{}, {.attempts = 1, .timeout = longest_timeout});
  line.run_for(longest_timeout - seconds(1));
  EXPECT_EQ(line.outcome(handle), Outcome::none);
  line.run_for(seconds(1) + milliseconds(1));
  EXPECT_EQ(line.outcome(handle), Outcome::timeout);
}

// A timer has 32 bits; a deadline is a point in time, which may be far away.
TEST_F(LongTimes, KeepsADeadlineOfManyHours) {
  SendOptions options{.expect_confirmation = true, .timeout = longest_timeout};
  options.deadline = line.now + seconds(100'000);
  std::size_t asked = 0;
  // Restarted whenever it times out, so that a request is always open.
  line.on_event = [&](const Record& record) {
    if (record.event.outcome == Outcome::none || line.now >= options.deadline) return;
    if (++asked < 100) line.send(msg::BoardInfoRequest{}, options);
  };
  line.send(msg::BoardInfoRequest{}, options);
  line.run();
  EXPECT_EQ(line.now, options.deadline);
}

}  // namespace
}  // namespace sbgc::test
