// Tests of a session on a line that loses, delays, repeats and corrupts bytes.

#include "simulation.hpp"

namespace sbgc::test {
namespace {

using Delivery = LineTest;

// Loss

TEST_F(Delivery, RepeatsWhatIsSafeToRepeat) {
  line.board = [&](const Written&) {
    if (line.written.size() == 3) line.say(board_info, body_of(18));
  };
  EXPECT_EQ(line.ask(msg::BoardInfoRequest{}), Outcome::answered);
  EXPECT_THAT(line.written, SizeIs(3));
  EXPECT_GE(gap(1), milliseconds(500));
  const auto statistics = line.session.statistics();
  EXPECT_EQ(statistics.retries, 2U);
  EXPECT_EQ(statistics.timeouts, 2U);
  EXPECT_EQ(statistics.sent_frames, 3U);
  EXPECT_EQ(statistics.sent_bytes, 3U * frame_size(0));
}

TEST_F(Delivery, GivesUpAfterAllAttempts) {
  EXPECT_EQ(line.ask(msg::BoardInfoRequest{}), Outcome::timeout);
  EXPECT_THAT(line.written, SizeIs(3));
  EXPECT_EQ(line.ask(msg::BoardInfoRequest{}, {.attempts = 1}), Outcome::timeout);
  EXPECT_THAT(line.written, SizeIs(4));
}

TEST_F(Delivery, DoesNotRepeatWhatIsNotSafe) {
  msg::I2cReadRegBufRequest request{.data_len = msg::SmallByteCount(4)};
  EXPECT_EQ(line.ask(request, {.attempts = 5}), Outcome::timeout);
  EXPECT_THAT(line.written, SizeIs(1));
}

TEST_F(Delivery, HasADeadlineForTheWholeRequest) {
  const Instant deadline = line.now + milliseconds(700);
  const Handle handle = line.send(msg::BoardInfoRequest{}, {.deadline = deadline});
  // It waits for the first request and then for its late reply, and is never sent.
  const Handle waiting = line.send(msg::BoardInfoRequest{}, {.deadline = deadline});
  line.run();
  for (const Handle each : {handle, waiting}) {
    EXPECT_EQ(line.outcome(each), Outcome::timeout);
    EXPECT_EQ(line.completion(each)->at, deadline);
  }
  EXPECT_THAT(line.written, SizeIs(2)) << "one retry";
}

// Delay

TEST_F(Delivery, ALateAnswerIsNotTheAnswerOfTheNextRequest) {
  int asked = 0;
  line.board = [&](const Written&) {
    ++asked;
    line.say(board_info, body_of(18, {asked}), asked == 1 ? milliseconds(800) : milliseconds(5));
  };
  const Handle first = line.send(msg::BoardInfoRequest{}, {.attempts = 1});
  const Handle second = line.send(msg::BoardInfoRequest{}, {.attempts = 1});
  line.run();
  EXPECT_EQ(line.outcome(first), Outcome::timeout);
  ASSERT_EQ(line.outcome(second), Outcome::answered);
  EXPECT_EQ(line.completion(second)->body[0], 2) << "the response to the first request";
  EXPECT_EQ(line.session.statistics().late_replies, 1U);
  ASSERT_THAT(line.of(EventKind::unsolicited), SizeIs(1));
  EXPECT_TRUE(line.of(EventKind::unsolicited)[0].event.is_late);
}

TEST_F(Delivery, TheAnswerToTheFirstTransmissionAnswersARepeatedRequest) {
  line.board = [&](const Written&) {
    line.say(board_info, body_of(18, {static_cast<int>(line.written.size())}), milliseconds(520));
  };
  const Handle first = line.send(msg::BoardInfoRequest{});
  line.run_for(milliseconds(530));
  ASSERT_EQ(line.outcome(first), Outcome::answered);
  EXPECT_EQ(line.completion(first)->body[0], 1);
  EXPECT_THAT(line.written, SizeIs(2));
  // The response to the second transmission arrives while the next request is queued.
  const Handle second = line.send(msg::BoardInfoRequest{}, {.attempts = 1, .timeout = seconds(1)});
  line.run();
  ASSERT_EQ(line.outcome(second), Outcome::answered);
  EXPECT_EQ(line.completion(second)->body[0], 3);
}

TEST(Sessions, AnAnswerIsLateEvenIfItsRequestWasStuckInTheLine) {
  Session session;
  std::vector<Event> events;
  const auto sink = [&](const Event& event) { events.push_back(event); };
  const Handle first = session.send(msg::BoardInfoRequest{}).handle;
  ASSERT_FALSE(session.poll(start_time, sink).bytes.empty());
  Instant now = start_time + milliseconds(100);
  ASSERT_TRUE(session.cancel(first, sink));
  now = now + seconds(5);
  session.written(now);  // delayed until now
  session.send(msg::BoardInfoRequest{});
  now = now + milliseconds(50);
  EXPECT_TRUE(session.poll(now, sink).bytes.empty())
      << "the response to the first request may still arrive";
  session.feed(frame_of(board_info, body_of(18)), now, sink);
  ASSERT_THAT(events, SizeIs(2));
  EXPECT_TRUE(events[1].is_late);
  EXPECT_FALSE(session.poll(now + milliseconds(50), sink).bytes.empty());
}

TEST(Sessions, AnAnswerIsLateAfterTheTimeoutOfARequestThatLeftLate) {
  Session session;
  const auto ignore = [](const Event&) {};
  session.send(msg::BoardInfoRequest{}, {.attempts = 1});
  ASSERT_FALSE(session.poll(start_time, ignore).bytes.empty());
  const Instant left = start_time + seconds(3);
  session.written(left);
  session.send(msg::BoardInfoRequest{});
  // 500 ms until the timeout, and 500 ms for a late response.
  EXPECT_TRUE(session.poll(left + milliseconds(500), ignore).bytes.empty());
  EXPECT_TRUE(session.poll(left + milliseconds(999), ignore).bytes.empty());
  EXPECT_FALSE(session.poll(left + milliseconds(1000), ignore).bytes.empty());
}

TEST(Sessions, OnlyTheRequestThatLeftLateHasMoreTime) {
  Session session;
  std::vector<Record> events;
  Instant now = start_time;
  const auto sink = [&](const Event& event) { events.push_back({event, {}, now}); };
  const Handle first = session.send(msg::BoardInfoRequest{}, {.attempts = 1}).handle;
  ASSERT_FALSE(session.poll(now, sink).bytes.empty());
  now = now + milliseconds(20);
  const Handle second = session.send(msg::ReadParams3Request{}, {.attempts = 1}).handle;
  ASSERT_FALSE(session.poll(now, sink).bytes.empty());
  now = start_time + milliseconds(100);
  session.written(now);
  for (const int ms : {499, 500, 599, 600}) {
    now = start_time + milliseconds(ms);
    static_cast<void>(session.poll(now, sink));
  }
  ASSERT_THAT(events, SizeIs(2));
  EXPECT_EQ(events[0].event.handle, first);
  EXPECT_EQ(events[0].at, start_time + milliseconds(500));
  EXPECT_EQ(events[1].event.handle, second);
  EXPECT_EQ(events[1].at, start_time + milliseconds(600));
}

TEST_F(Delivery, CancelsWhatIsNotSentYet) {
  const Handle handle = line.send(msg::MotorsOn{});
  EXPECT_TRUE(line.session.cancel(handle, line.sink()));
  EXPECT_FALSE(line.session.cancel({}, line.sink()));
  line.run();
  EXPECT_EQ(line.outcome(handle), Outcome::cancelled);
  EXPECT_THAT(line.written, SizeIs(0));
}

// Line errors

TEST_F(Delivery, ABeginningOfAFrameDoesNotHoldTheAnswerBackForLong) {
  line.board = [&](const Written&) {
    line.say_bytes({'>', 9, 200, 209});  // a header without the announced body
    line.say(board_info, body_of(18), milliseconds(5));
  };
  const Handle handle = line.send(msg::BoardInfoRequest{});
  line.run();
  EXPECT_EQ(line.outcome(handle), Outcome::answered);
  EXPECT_EQ(line.completion(handle)->at - start_time, milliseconds(5 + 100))
      << "100 ms of silence end the frame";
  EXPECT_EQ(line.session.statistics().parser.incomplete, 1U);
  EXPECT_THAT(line.written, SizeIs(1));
}

TEST_F(Delivery, AStartByteAloneIsDiscardedAfterTheSilence) {
  line.say_bytes({'>'});
  line.run();
  EXPECT_EQ(line.now, start_time + milliseconds(3 + 100));
  EXPECT_EQ(line.session.poll(line.now, line.sink()).deadline, Instant::never);
}

TEST_F(Delivery, SilenceCountsEvenIfPollComesLate) {
  line.session.feed(Body{'>', 9, 200, 209}, line.now, line.sink());
  line.now = line.now + seconds(1);
  line.session.feed(frame_of(realtime_data_4, body_of(124)), line.now, line.sink());
  EXPECT_THAT(line.of(EventKind::unsolicited), SizeIs(1));
}

}  // namespace
}  // namespace sbgc::test
