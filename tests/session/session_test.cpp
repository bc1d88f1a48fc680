// Tests of the rules of a session, one by one: outcomes of requests without faults, and capacity
// limits.

#include "simulation.hpp"

namespace sbgc::test {
namespace {

using Rules = LineTest;

TEST_F(Rules, TakesTheAnswerOfARequest) {
  line.board = [&](const Written&) { line.say(board_info, body_of(18, {31})); };
  const Handle handle = line.send(msg::BoardInfoRequest{});
  line.run();
  ASSERT_EQ(line.outcome(handle), Outcome::answered);
  const Record& record = *line.completion(handle);
  EXPECT_EQ(record.event.command, board_info);
  EXPECT_EQ(record.event.frame.id, board_info);
  EXPECT_EQ(record.body, body_of(18, {31}));
  EXPECT_EQ(line.events.size(), 1U);
  EXPECT_EQ(line.session.open_requests(), 0U);
}

TEST_F(Rules, IsDoneWithARequestThatNeedsNoAnswer) {
  const Handle handle = line.send(msg::Control{});
  EXPECT_EQ(line.outcome(handle), Outcome::none) << "before it is written";
  line.run();
  EXPECT_EQ(line.outcome(handle), Outcome::sent);
  EXPECT_THAT(ids(line.written), ElementsAre(control));
}

TEST_F(Rules, WaitsForACertainConfirmation) {
  confirm_all();
  const Handle handle = line.send(msg::MotorsOn{});
  line.run();
  EXPECT_EQ(line.outcome(handle), Outcome::confirmed);
  const auto confirmations = line.of(EventKind::confirmation);
  ASSERT_THAT(confirmations, SizeIs(1));
  EXPECT_EQ(confirmations[0].event.handle, handle);
  EXPECT_EQ(confirmations[0].event.command, motors_on);
}

template <class Request>
void expect_to_wait_only_if_told(const Request& request) {
  for (const bool comes : {true, false}) {
    Simulation line;
    line.board = [&](const Written& frame) {
      if (comes) line.confirm(frame.id);
    };
    const Handle first = line.send(request);
    const Handle second = line.send(request, {.expect_confirmation = true});
    line.run();
    EXPECT_EQ(line.outcome(first), Outcome::sent);
    EXPECT_EQ(line.outcome(second), comes ? Outcome::confirmed : Outcome::unconfirmed);
    EXPECT_THAT(line.written, SizeIs(2)) << "a missing confirmation does not trigger a retry";
  }
}

TEST(Sessions, RepeatsWhatIsNotConfirmedIfToldAndSafe) {
  for (const auto mode : {msg::ScriptMode::stop, msg::ScriptMode::start}) {
    Simulation line;
    const bool is_safe = mode == msg::ScriptMode::stop;
    line.board = [&](const Written& frame) {
      if (line.written.size() == 3) line.confirm(frame.id);
    };
    EXPECT_EQ(
        line.ask(msg::RunScript{mode}, {.expect_confirmation = true, .repeat_unconfirmed = true}),
        is_safe ? Outcome::confirmed : Outcome::unconfirmed);
    EXPECT_THAT(line.written, SizeIs(is_safe ? 3 : 1));
  }
}

TEST(Sessions, WaitsForAPossibleOrUnlikelyConfirmationOnlyIfTold) {
  expect_to_wait_only_if_told(msg::ExecuteMenu{});
  msg::ApiVirtChControl request;
  request.val_ch.push_back({});
  expect_to_wait_only_if_told(request);
}

TEST_F(Rules, DoesNotTakeTheConfirmationOfAnEarlierRequestForThatOfALaterOne) {
  int frames = 0;
  line.board = [&](const Written& frame) {
    if (++frames == 1) line.confirm(frame.id, milliseconds(200));
  };
  line.send(msg::ExecuteMenu{});  // its confirmation is not awaited and arrives late
  EXPECT_EQ(line.ask(msg::ExecuteMenu{}, {.expect_confirmation = true}), Outcome::unconfirmed);
  ASSERT_THAT(line.of(EventKind::confirmation), SizeIs(1));
  EXPECT_TRUE(line.of(EventKind::confirmation)[0].event.is_late);
  EXPECT_FALSE(line.of(EventKind::confirmation)[0].event.handle);
}

TEST_F(Rules, CountsTheConfirmationsOfACalibration) {
  line.board = [&](const Written& frame) {
    line.confirm(frame.id, milliseconds(5));
    line.confirm(frame.id, seconds(12));
  };
  const Handle handle = line.send(msg::CalibGyro{});
  line.run_for(seconds(11));
  EXPECT_EQ(line.outcome(handle), Outcome::none);
  line.run();
  EXPECT_EQ(line.outcome(handle), Outcome::confirmed);
  const auto confirmations = line.of(EventKind::confirmation);
  ASSERT_THAT(confirmations, SizeIs(2));
  EXPECT_EQ(confirmations[0].event.confirmation, 1);
  EXPECT_EQ(confirmations[0].event.confirmations, 2);
  EXPECT_EQ(confirmations[1].event.confirmation, 2);
  EXPECT_THAT(line.written, SizeIs(1)) << "a calibration is not repeated";
}

TEST_F(Rules, ACalibrationThatIsNotConfirmedAtOnceHasNotBegun) {
  const Handle handle = line.send(msg::CalibGyro{});
  line.run_for(seconds(1));
  EXPECT_EQ(line.outcome(handle), Outcome::timeout) << "the board ignores wrong parameters";
}

TEST_F(Rules, ACalibrationMayFailToEnd) {
  confirm_all();
  const Handle handle = line.send(msg::CalibGyro{});
  line.run_for(seconds(29));
  EXPECT_EQ(line.outcome(handle), Outcome::none);
  line.run_for(seconds(2));
  EXPECT_EQ(line.outcome(handle), Outcome::timeout);
}

// Overload

TEST_F(Rules, RefusesWhatItCannotHold) {
  std::vector<Handle> handles;
  for (std::size_t i = 0; i < SessionCapacity{}.requests; ++i) {
    handles.push_back(line.send(msg::MotorsOn{}));
  }
  const SendResult refused = line.session.send(msg::MotorsOn{});
  EXPECT_EQ(refused.status, SendStatus::queue_full);
  EXPECT_FALSE(refused.handle);
  EXPECT_EQ(line.session.send(77, {}, msg::response_policy(msg::MotorsOn{})).status,
            SendStatus::queue_full);
  EXPECT_EQ(line.session.statistics().refused, 2U);
  confirm_all();
  line.run();
  for (const Handle handle : handles) EXPECT_EQ(line.outcome(handle), Outcome::confirmed);
  EXPECT_THAT(line.written, SizeIs(handles.size())) << "nothing is lost";
  EXPECT_TRUE(line.session.send(msg::MotorsOn{}));
}

using Small = BasicSession<SessionCapacity{.requests = 8, .late_replies = 2, .streams = 1}>;

TEST(Sessions, WaitsWhenThereIsNoRoomForLateReplies) {
  Basic<Small> line;
  const SendOptions once{.attempts = 1, .timeout = milliseconds(5)};
  std::vector<Handle> handles;
  handles.push_back(line.send(msg::BoardInfoRequest{}, once));
  handles.push_back(line.send(msg::I2cReadRegBufRequest{}, once));
  handles.push_back(line.send(msg::GetAnglesRequest{}, once));
  line.run();
  for (const Handle handle : handles) EXPECT_EQ(line.outcome(handle), Outcome::timeout);
  EXPECT_LT(line.written[1].at - line.written[0].at, milliseconds(100));
  EXPECT_GT(line.written[2].at - line.written[0].at, milliseconds(500));
}

TEST(Sessions, WhatHasAnEffectDoesNotWaitForRoom) {
  Basic<Small> line;
  std::vector<Handle> handles;
  handles.push_back(line.send(msg::Control{}));
  handles.push_back(line.send(msg::ExecuteMenu{.cmd_id = msg::MenuCommand::profile1}));
  handles.push_back(line.send(msg::BeepSound{}));
  handles.push_back(line.send(msg::ServoOut{}));
  line.run();
  for (const Handle handle : handles) EXPECT_EQ(line.outcome(handle), Outcome::sent);
  EXPECT_LT(line.written[3].at - line.written[0].at, milliseconds(100));
}

TEST(Sessions, KeepsRoomForTheLateRepliesOfWhatIsInFlight) {
  Basic<Small> line;
  line.send(msg::BoardInfoRequest{}, {.attempts = 1});
  line.send(msg::ReadParams3Request{}, {.attempts = 1});
  line.send(msg::GetAnglesRequest{}, {.attempts = 1});
  line.run();
  ASSERT_THAT(line.written, SizeIs(3));
  EXPECT_LT(line.written[1].at - line.written[0].at, milliseconds(100));
  EXPECT_EQ(line.written[2].at - line.written[0].at, milliseconds(500 + 500))
      << "until no response to the first request can come";
}

TEST_F(Rules, RefusesWhatCannotBeEncoded) {
  msg::DataStreamInterval request;
  request.cmd_id = msg::CommandFromBoard::realtime_data_custom;  // without its flags
  const SendResult result = line.session.send(request);
  EXPECT_EQ(result.status, SendStatus::not_encodable);
  EXPECT_EQ(result.encoding.code, Code::presence_mismatch);
  EXPECT_EQ(line.session.stream_usage().used, 0U);
  EXPECT_EQ(line.session.send(0, {}, {}).status, SendStatus::not_encodable);
  EXPECT_EQ(line.session.open_requests(), 0U);
}

// Time

TEST_F(Rules, TimeThatRunsBackwardsStandsStill) {
  const Handle handle = line.send(msg::BoardInfoRequest{}, {.attempts = 1});
  line.run_for(milliseconds(100));
  line.now = line.now - seconds(500);
  const Output output = line.session.poll(line.now, line.sink());
  EXPECT_TRUE(output.bytes.empty());
  EXPECT_EQ(output.deadline, start_time + milliseconds(500));
  line.now = start_time + milliseconds(499);
  line.run_for(milliseconds(0));
  EXPECT_EQ(line.outcome(handle), Outcome::none);
  line.run_for(milliseconds(1));
  EXPECT_EQ(line.outcome(handle), Outcome::timeout);
}

TEST_F(Rules, TimeMayJump) {
  const Handle handle = line.send(msg::BoardInfoRequest{}, {.attempts = 1});
  line.run_for(milliseconds(1));
  line.now = line.now + seconds(1'000'000'000);
  line.run();
  EXPECT_EQ(line.outcome(handle), Outcome::timeout);
  line.now = {Instant::never.us - 10};
  line.send(msg::MotorsOn{});
  EXPECT_FALSE(line.session.poll(line.now, line.sink()).bytes.empty());
  EXPECT_EQ(line.session.poll(line.now, line.sink()).deadline, Instant::never);
}

}  // namespace
}  // namespace sbgc::test
