// Tests of sessions of small capacity.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sbgc/responses/all.hpp>
#include <sbgc/session.hpp>

#include "simulation.hpp"

namespace {

using sbgc::milliseconds;
using sbgc::Outcome;
using sbgc::seconds;
using sbgc::SendStatus;
using simulation::body_of;
using simulation::Written;

/// For requests of at most 24 bytes.
using ControllerSession =
    sbgc::BasicSession<sbgc::SessionCapacity{.requests = 1,
                                             .late_replies = 1,
                                             .streams = 0,
                                             .body = 24,
                                             .optimize = sbgc::Optimize::size},
                       sbgc::FrameFormats<sbgc::CrcTable::nibbles, sbgc::Framing::v1>>;

TEST(SmallSession, SendsOneRequestAtATime) {
  simulation::Basic<ControllerSession> line;
  line.board = [&](const Written& frame) {
    if (frame.id == 86) line.say(86, body_of(18));
  };
  const sbgc::Handle identify = line.send(sbgc::msg::BoardInfoRequest{});
  EXPECT_EQ(line.session.send(sbgc::msg::Control{}).status, SendStatus::queue_full);
  line.run();
  EXPECT_EQ(line.outcome(identify), Outcome::answered);
  const sbgc::Handle control = line.send(sbgc::msg::Control{});
  line.run();
  EXPECT_EQ(line.outcome(control), Outcome::sent);
}

TEST(SmallSession, ABodyOfAWrongSizeAnswers) {
  simulation::Basic<ControllerSession> line;
  line.board = [&](const Written&) { line.say(86, body_of(17)); };
  const sbgc::Handle identify = line.send(sbgc::msg::BoardInfoRequest{});
  line.run();
  EXPECT_EQ(line.outcome(identify), Outcome::answered);
  EXPECT_EQ(line.written.size(), 1U);
}

TEST(SmallSession, RefusesABodyLargerThanItsCapacity) {
  simulation::Basic<ControllerSession> line;
  const std::vector<std::uint8_t> body(25);
  const sbgc::ResponsePolicy policy = response_policy(sbgc::msg::Control{});
  const sbgc::SendResult sent = line.session.send(67, body, policy);
  EXPECT_EQ(sent.status, SendStatus::not_encodable);
  EXPECT_EQ(sent.encoding.code, sbgc::Code::buffer_too_small);
  EXPECT_TRUE(line.session.send(67, std::span(body).first(24), policy));
  line.run();
  ASSERT_EQ(line.written.size(), 1U);
  EXPECT_EQ(line.written[0].body.size(), 24U);
}

TEST(SmallSession, RefusesStreamsIfItHasNoRoomForThem) {
  simulation::Basic<ControllerSession> line;
  sbgc::msg::DataStreamInterval stream;
  stream.cmd_id = sbgc::msg::CommandFromBoard::realtime_data_3;
  stream.interval_ms = sbgc::msg::Milliseconds(20);
  EXPECT_EQ(line.session.send(stream).status, SendStatus::too_many_streams);
  stream.interval_ms = sbgc::msg::Milliseconds(0);
  EXPECT_TRUE(line.session.send(stream)) << "an end needs no room";
}

TEST(SmallSession, TheEndOfAnUnknownStreamDoesNotEndThatOfALaterRequest) {
  simulation::Basic<sbgc::BasicSession<sbgc::SessionCapacity{.streams = 1}>> line;
  line.board = [&](const Written& frame) { line.confirm(frame.id); };
  const auto stream_of = [](sbgc::msg::CommandFromBoard command, std::uint16_t interval) {
    sbgc::msg::DataStreamInterval request;
    request.cmd_id = command;
    request.interval_ms = sbgc::msg::Milliseconds(interval);
    return request;
  };
  line.send(stream_of(sbgc::msg::CommandFromBoard::realtime_data_3, 100));
  line.run();
  const sbgc::Handle end = line.send(stream_of(sbgc::msg::CommandFromBoard::realtime_data_3, 0));
  line.send(stream_of(sbgc::msg::CommandFromBoard::realtime_data_4, 0));  // not running
  line.on_event = [&](const simulation::Record& record) {
    if (record.event.kind == sbgc::EventKind::completed && record.event.handle == end) {
      line.send(stream_of(sbgc::msg::CommandFromBoard::realtime_data_4, 100));
    }
  };
  line.run();
  EXPECT_EQ(line.session.stream_usage().used, 1290U) << "129 bytes, 10 times a second";
}

TEST(SmallSession, CountsOnlyFramesAndNoise) {
  simulation::Basic<ControllerSession> line;
  line.board = [&](const Written&) { line.say_bytes({1, 2, 3}); };
  line.send(sbgc::msg::BoardInfoRequest{}, {.attempts = 1});
  line.run();
  const sbgc::SessionStatistics statistics = line.session.statistics();
  EXPECT_EQ(statistics.parser.skipped_bytes, 3U);
  EXPECT_EQ(statistics.sent_frames, 0U);
}

TEST(Session, RefusesATimeoutLongerThanItsTimers) {
  simulation::Simulation line;
  EXPECT_EQ(line.session
                .send(sbgc::msg::BoardInfoRequest{},
                      {.timeout = sbgc::longest_timeout + sbgc::microseconds(1)})
                .status,
            SendStatus::timeout_too_long);
  const sbgc::Handle handle =
      line.send(sbgc::msg::BoardInfoRequest{}, {.attempts = 1, .timeout = sbgc::longest_timeout});
  line.run_for(sbgc::longest_timeout - seconds(1));
  EXPECT_EQ(line.outcome(handle), Outcome::none);
  line.run_for(seconds(1) + milliseconds(1));
  EXPECT_EQ(line.outcome(handle), Outcome::timeout);
}

// A timer has 32 bits; a deadline is a point in time, which may be far away.
TEST(Session, KeepsADeadlineOfManyHours) {
  simulation::Simulation line;
  sbgc::SendOptions options{.expect_confirmation = true, .timeout = sbgc::longest_timeout};
  options.deadline = line.now + seconds(100'000);
  std::size_t asked = 0;
  // Restarted whenever it times out, so that a request is always open.
  line.on_event = [&](const simulation::Record& record) {
    if (record.event.outcome == Outcome::none || line.now >= options.deadline) return;
    if (++asked < 100) line.send(sbgc::msg::BoardInfoRequest{}, options);
  };
  line.send(sbgc::msg::BoardInfoRequest{}, options);
  line.run();
  EXPECT_EQ(line.now, options.deadline);
}

}  // namespace
