// Tests of a session on a line that loses, delays, repeats and corrupts bytes.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sbgc/responses/all.hpp>
#include <sbgc/session.hpp>

#include "commands.hpp"
#include "simulation.hpp"

namespace {

using commands::board_info;
using commands::realtime_data_4;
using sbgc::EventKind;
using sbgc::Handle;
using sbgc::milliseconds;
using sbgc::Outcome;
using sbgc::seconds;
using simulation::Body;
using simulation::body_of;
using simulation::Record;
using simulation::Simulation;
using simulation::Written;
using ::testing::SizeIs;

// Loss

TEST(Session, RepeatsWhatIsSafeToRepeat) {
  Simulation line;
  line.board = [&](const Written&) {
    if (line.written.size() == 3) line.say(board_info, body_of(18));
  };
  const Handle handle = line.send(sbgc::msg::BoardInfoRequest{});
  line.run();
  EXPECT_EQ(line.outcome(handle), Outcome::answered);
  EXPECT_THAT(line.written, SizeIs(3));
  EXPECT_GE(line.written[1].at - line.written[0].at, milliseconds(500));
  const auto statistics = line.session.statistics();
  EXPECT_EQ(statistics.retries, 2U);
  EXPECT_EQ(statistics.timeouts, 2U);
  EXPECT_EQ(statistics.sent_frames, 3U);
  EXPECT_EQ(statistics.sent_bytes, 3U * sbgc::frame_size(0));
}

TEST(Session, GivesUpAfterAllAttempts) {
  Simulation line;
  const Handle three = line.send(sbgc::msg::BoardInfoRequest{});
  line.run();
  EXPECT_EQ(line.outcome(three), Outcome::timeout);
  EXPECT_THAT(line.written, SizeIs(3));
  const Handle one = line.send(sbgc::msg::BoardInfoRequest{}, {.attempts = 1});
  line.run();
  EXPECT_EQ(line.outcome(one), Outcome::timeout);
  EXPECT_THAT(line.written, SizeIs(4));
}

TEST(Session, DoesNotRepeatWhatIsNotSafe) {
  Simulation line;
  sbgc::msg::I2cReadRegBufRequest request;
  request.data_len = sbgc::msg::SmallByteCount(4);
  const Handle handle = line.send(request, {.attempts = 5});
  line.run();
  EXPECT_EQ(line.outcome(handle), Outcome::timeout);
  EXPECT_THAT(line.written, SizeIs(1));
}

TEST(Session, TimesOutNoEarlierAndNoLaterThanItShould) {
  Simulation line;
  const Handle handle =
      line.send(sbgc::msg::BoardInfoRequest{}, {.attempts = 1, .timeout = milliseconds(70)});
  line.run();
  EXPECT_EQ(line.completion(handle)->at, simulation::start + milliseconds(70));
}

TEST(Session, HasADeadlineForTheWholeRequest) {
  Simulation line;
  const sbgc::Instant deadline = line.now + milliseconds(700);
  const Handle handle = line.send(sbgc::msg::BoardInfoRequest{}, {.deadline = deadline});
  // It waits for the first request and then for its late reply, and is never sent.
  const Handle waiting = line.send(sbgc::msg::BoardInfoRequest{}, {.deadline = deadline});
  line.run();
  for (const Handle each : {handle, waiting}) {
    EXPECT_EQ(line.outcome(each), Outcome::timeout);
    EXPECT_EQ(line.completion(each)->at, deadline);
  }
  EXPECT_THAT(line.written, SizeIs(2)) << "one retry";
}

// Delay

TEST(Session, ALateAnswerIsNotTheAnswerOfTheNextRequest) {
  Simulation line;
  int asked = 0;
  line.board = [&](const Written&) {
    ++asked;
    line.say(board_info, body_of(18, {asked}), asked == 1 ? milliseconds(800) : milliseconds(5));
  };
  const Handle first = line.send(sbgc::msg::BoardInfoRequest{}, {.attempts = 1});
  const Handle second = line.send(sbgc::msg::BoardInfoRequest{}, {.attempts = 1});
  line.run();
  EXPECT_EQ(line.outcome(first), Outcome::timeout);
  ASSERT_EQ(line.outcome(second), Outcome::answered);
  EXPECT_EQ(line.completion(second)->body[0], 2) << "the response to the first request";
  EXPECT_EQ(line.session.statistics().late_replies, 1U);
  ASSERT_THAT(line.of(EventKind::unsolicited), SizeIs(1));
  EXPECT_TRUE(line.of(EventKind::unsolicited)[0].event.is_late);
}

TEST(Session, TheAnswerToTheFirstTransmissionAnswersARepeatedRequest) {
  Simulation line;
  line.board = [&](const Written&) {
    line.say(board_info, body_of(18, {static_cast<int>(line.written.size())}), milliseconds(520));
  };
  const Handle first = line.send(sbgc::msg::BoardInfoRequest{});
  line.run_for(milliseconds(530));
  ASSERT_EQ(line.outcome(first), Outcome::answered);
  EXPECT_EQ(line.completion(first)->body[0], 1);
  EXPECT_THAT(line.written, SizeIs(2));
  // The response to the second transmission arrives while the next request is queued.
  const Handle second =
      line.send(sbgc::msg::BoardInfoRequest{}, {.attempts = 1, .timeout = seconds(1)});
  line.run();
  ASSERT_EQ(line.outcome(second), Outcome::answered);
  EXPECT_EQ(line.completion(second)->body[0], 3);
}

TEST(Session, TheAnswerOfACancelledRequestIsNotThatOfTheNext) {
  Simulation line;
  line.board = [&](const Written&) {
    line.say(board_info, body_of(18, {static_cast<int>(line.written.size())}), milliseconds(300));
  };
  const Handle first = line.send(sbgc::msg::BoardInfoRequest{});
  line.run_for(milliseconds(100));
  EXPECT_TRUE(line.session.cancel(first, line.sink()));
  EXPECT_FALSE(line.session.cancel(first, line.sink()));
  EXPECT_EQ(line.outcome(first), Outcome::cancelled);
  const Handle second = line.send(sbgc::msg::BoardInfoRequest{});
  line.run();
  ASSERT_EQ(line.outcome(second), Outcome::answered);
  EXPECT_EQ(line.completion(second)->body[0], 2);
}

TEST(Session, AnAnswerIsLateEvenIfItsRequestWasStuckInTheLine) {
  sbgc::Session session;
  std::vector<Record> events;
  const auto sink = [&](const sbgc::Event& event) {
    events.push_back({event, {event.frame.body.begin(), event.frame.body.end()}, {}});
  };
  const auto say = [&](std::uint8_t content, sbgc::Instant now) {
    std::array<std::uint8_t, sbgc::max_frame_size> frame{};
    const auto size = sbgc::write_frame(board_info, body_of(18, {content}), frame).size;
    session.feed(std::span(frame).first(size), now, sink);
  };
  sbgc::Instant now{};
  const Handle first = session.send(sbgc::msg::BoardInfoRequest{}).handle;
  ASSERT_FALSE(session.poll(now, sink).bytes.empty());
  now = now + milliseconds(100);
  ASSERT_TRUE(session.cancel(first, sink));
  now = now + seconds(5);
  session.written(now);  // delayed until now

  const Handle second = session.send(sbgc::msg::BoardInfoRequest{}).handle;
  now = now + milliseconds(50);
  EXPECT_TRUE(session.poll(now, sink).bytes.empty())
      << "the response to the first request may still arrive";
  say(1, now);
  ASSERT_THAT(events, SizeIs(2));
  EXPECT_TRUE(events[1].event.is_late);
  now = now + milliseconds(50);
  ASSERT_FALSE(session.poll(now, sink).bytes.empty());
  session.written(now);
  say(2, now + milliseconds(10));
  ASSERT_THAT(events, SizeIs(3));
  EXPECT_EQ(events[2].event.handle, second);
  EXPECT_EQ(events[2].body.front(), 2);
}

TEST(Session, TheTimeForAnAnswerBeginsWhenTheRequestHasLeft) {
  sbgc::Session session;
  Outcome outcome = Outcome::none;
  const auto sink = [&](const sbgc::Event& event) { outcome = event.outcome; };
  sbgc::Instant now{};
  session.send(sbgc::msg::BoardInfoRequest{}, {.attempts = 1});
  ASSERT_FALSE(session.poll(now, sink).bytes.empty());
  now = now + seconds(3);
  session.written(now);
  static_cast<void>(session.poll(now + milliseconds(499), sink));
  EXPECT_EQ(outcome, Outcome::none);
  static_cast<void>(session.poll(now + milliseconds(501), sink));
  EXPECT_EQ(outcome, Outcome::timeout);
}

TEST(Session, AnAnswerIsLateAfterTheTimeoutOfARequestThatLeftLate) {
  sbgc::Session session;
  const auto ignore = [](const sbgc::Event&) {};
  session.send(sbgc::msg::BoardInfoRequest{}, {.attempts = 1});
  ASSERT_FALSE(session.poll(simulation::start, ignore).bytes.empty());
  const sbgc::Instant left = simulation::start + seconds(3);
  session.written(left);
  session.send(sbgc::msg::BoardInfoRequest{});
  // 500 ms until the timeout, and 500 ms for a late response.
  EXPECT_TRUE(session.poll(left + milliseconds(500), ignore).bytes.empty());
  EXPECT_TRUE(session.poll(left + milliseconds(999), ignore).bytes.empty());
  EXPECT_FALSE(session.poll(left + milliseconds(1000), ignore).bytes.empty());
}

TEST(Session, OnlyTheRequestThatLeftLateHasMoreTime) {
  sbgc::Session session;
  std::vector<Record> events;
  sbgc::Instant now = simulation::start;
  const auto sink = [&](const sbgc::Event& event) { events.push_back({event, {}, now}); };
  const Handle first = session.send(sbgc::msg::BoardInfoRequest{}, {.attempts = 1}).handle;
  ASSERT_FALSE(session.poll(now, sink).bytes.empty());
  now = now + milliseconds(20);
  const Handle second = session.send(sbgc::msg::ReadParams3Request{}, {.attempts = 1}).handle;
  ASSERT_FALSE(session.poll(now, sink).bytes.empty());
  now = simulation::start + milliseconds(100);
  session.written(now);
  for (const int ms : {499, 500, 599, 600}) {
    now = simulation::start + milliseconds(ms);
    static_cast<void>(session.poll(now, sink));
  }
  ASSERT_THAT(events, SizeIs(2));
  EXPECT_EQ(events[0].event.handle, first);
  EXPECT_EQ(events[0].at, simulation::start + milliseconds(500));
  EXPECT_EQ(events[1].event.handle, second);
  EXPECT_EQ(events[1].at, simulation::start + milliseconds(600));
}

TEST(Session, CancelsWhatIsNotSentYet) {
  Simulation line;
  const Handle handle = line.send(sbgc::msg::MotorsOn{});
  EXPECT_TRUE(line.session.cancel(handle, line.sink()));
  EXPECT_FALSE(line.session.cancel({}, line.sink()));
  line.run();
  EXPECT_EQ(line.outcome(handle), Outcome::cancelled);
  EXPECT_THAT(line.written, SizeIs(0));
}

// Line errors

TEST(Session, NoiseDoesNoHarm) {
  Simulation line;
  line.board = [&](const Written&) {
    Body bytes = {'>', 0x00, '>', '>', 9, 9, 18, 0x3E};
    const Body frame = simulation::frame_of(board_info, body_of(18));
    bytes.insert(bytes.end(), frame.begin(), frame.end());
    for (const std::uint8_t byte : bytes) line.say_bytes({byte});
  };
  const Handle handle = line.send(sbgc::msg::BoardInfoRequest{});
  line.run();
  EXPECT_EQ(line.outcome(handle), Outcome::answered);
  EXPECT_GT(line.session.statistics().parser.skipped_bytes, 0U);
}

TEST(Session, ABeginningOfAFrameDoesNotHoldTheAnswerBackForLong) {
  Simulation line;
  line.board = [&](const Written&) {
    line.say_bytes({'>', 9, 200, 209});  // a header without the announced body
    line.say(board_info, body_of(18), milliseconds(5));
  };
  const Handle handle = line.send(sbgc::msg::BoardInfoRequest{});
  line.run();
  EXPECT_EQ(line.outcome(handle), Outcome::answered);
  EXPECT_EQ(line.completion(handle)->at - simulation::start, milliseconds(5 + 100))
      << "100 ms of silence end the frame";
  EXPECT_EQ(line.session.statistics().parser.incomplete, 1U);
  EXPECT_THAT(line.written, SizeIs(1));
}

TEST(Session, AStartByteAloneIsDiscardedAfterTheSilence) {
  Simulation line;
  line.say_bytes({'>'});
  line.run();
  EXPECT_EQ(line.now, simulation::start + milliseconds(3 + 100));
  EXPECT_EQ(line.session.poll(line.now, line.sink()).deadline, sbgc::Instant::never);
}

TEST(Session, SilenceCountsEvenIfPollComesLate) {
  Simulation line;
  line.session.feed(Body{'>', 9, 200, 209}, line.now, line.sink());
  line.now = line.now + seconds(1);
  line.session.feed(simulation::frame_of(realtime_data_4, body_of(124)), line.now, line.sink());
  EXPECT_THAT(line.of(EventKind::unsolicited), SizeIs(1));
}

TEST(Session, ARepeatedAnswerIsNotThatOfTheNextRequestIfTheLineRepeats) {
  sbgc::SessionOptions options;
  options.duplicate_window = milliseconds(300);
  Simulation line(options);
  line.board = [&](const Written&) {
    const Body body = body_of(18, {static_cast<int>(line.written.size())});
    line.say(board_info, body, milliseconds(3));
    line.say(board_info, body, milliseconds(120));
  };
  const Handle first = line.send(sbgc::msg::BoardInfoRequest{});
  const Handle second = line.send(sbgc::msg::BoardInfoRequest{});
  line.run();
  EXPECT_EQ(line.completion(first)->body[0], 1);
  EXPECT_EQ(line.completion(second)->body[0], 2);
  EXPECT_THAT(line.of(EventKind::unsolicited), SizeIs(2));
}

}  // namespace
