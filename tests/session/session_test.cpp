// Tests of the rules of a session, one by one: outcomes of requests without faults, and capacity
// limits.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sbgc/responses/all.hpp>
#include <sbgc/session.hpp>

#include "commands.hpp"
#include "simulation.hpp"

namespace {

using commands::board_info;
using commands::calib_gyro;
using commands::control;
using commands::eeprom_read;
using commands::motors_on;
using sbgc::EventKind;
using sbgc::Handle;
using sbgc::milliseconds;
using sbgc::Outcome;
using sbgc::seconds;
using sbgc::SendStatus;
using simulation::Body;
using simulation::body_of;
using simulation::ids;
using simulation::Record;
using simulation::Simulation;
using simulation::Written;
using ::testing::ElementsAre;
using ::testing::SizeIs;

TEST(Session, TakesTheAnswerOfARequest) {
  Simulation line;
  line.board = [&](const Written&) { line.say(board_info, body_of(18, {31})); };
  const Handle handle = line.send(sbgc::msg::BoardInfoRequest{});
  line.run();
  ASSERT_EQ(line.outcome(handle), Outcome::answered);
  const Record& record = *line.completion(handle);
  EXPECT_EQ(record.event.command, board_info);
  EXPECT_EQ(record.event.frame.id, board_info);
  EXPECT_EQ(record.body, body_of(18, {31}));
  EXPECT_EQ(line.events.size(), 1U);
  EXPECT_EQ(line.session.open_requests(), 0U);
}

TEST(Session, IsDoneWithARequestThatNeedsNoAnswer) {
  Simulation line;
  const Handle handle = line.send(sbgc::msg::Control{});
  EXPECT_EQ(line.outcome(handle), Outcome::none) << "before it is written";
  line.run();
  EXPECT_EQ(line.outcome(handle), Outcome::sent);
  EXPECT_THAT(ids(line.written), ElementsAre(control));
}

TEST(Session, WaitsForACertainConfirmation) {
  Simulation line;
  line.board = [&](const Written& frame) { line.confirm(frame.id); };
  const Handle handle = line.send(sbgc::msg::MotorsOn{});
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

TEST(Session, WaitsForAPossibleConfirmationOnlyIfTold) {
  expect_to_wait_only_if_told(sbgc::msg::ExecuteMenu{});
}

TEST(Session, RepeatsWhatIsNotConfirmedIfToldAndSafe) {
  for (const auto mode : {sbgc::msg::ScriptMode::stop, sbgc::msg::ScriptMode::start}) {
    Simulation line;
    const bool is_safe = mode == sbgc::msg::ScriptMode::stop;
    line.board = [&](const Written& frame) {
      if (line.written.size() == 3) line.confirm(frame.id);
    };
    const Handle handle = line.send(sbgc::msg::RunScript{mode},
                                    {.expect_confirmation = true, .repeat_unconfirmed = true});
    line.run();
    EXPECT_EQ(line.outcome(handle), is_safe ? Outcome::confirmed : Outcome::unconfirmed);
    EXPECT_THAT(line.written, SizeIs(is_safe ? 3 : 1));
  }
}

TEST(Session, WaitsForAnUnlikelyConfirmationOnlyIfTold) {
  sbgc::msg::ApiVirtChControl request;
  request.val_ch.push_back({});
  expect_to_wait_only_if_told(request);
}

TEST(Session, DoesNotTakeTheConfirmationOfAnEarlierRequestForThatOfALaterOne) {
  Simulation line;
  int frames = 0;
  line.board = [&](const Written& frame) {
    if (++frames == 1) line.confirm(frame.id, milliseconds(200));
  };
  line.send(sbgc::msg::ExecuteMenu{});  // its confirmation is not awaited and arrives late
  const Handle second = line.send(sbgc::msg::ExecuteMenu{}, {.expect_confirmation = true});
  line.run();
  EXPECT_EQ(line.outcome(second), Outcome::unconfirmed);
  ASSERT_THAT(line.of(EventKind::confirmation), SizeIs(1));
  EXPECT_TRUE(line.of(EventKind::confirmation)[0].event.is_late);
  EXPECT_FALSE(line.of(EventKind::confirmation)[0].event.handle);
}

TEST(Session, RequestsThatWaitForNothingDoNotHoldUpEachOther) {
  Simulation line;
  for (int i = 0; i < 40; ++i) {  // 50 per second; the board confirms none of them
    line.send(sbgc::msg::Control{});
    line.run_for(milliseconds(20));
  }
  EXPECT_THAT(line.written, SizeIs(40));
}

TEST(Session, CountsTheConfirmationsOfACalibration) {
  Simulation line;
  line.board = [&](const Written& frame) {
    line.confirm(frame.id, milliseconds(5));
    line.confirm(frame.id, seconds(12));
  };
  const Handle handle = line.send(sbgc::msg::CalibGyro{});
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

TEST(Session, ACalibrationThatIsNotConfirmedAtOnceHasNotBegun) {
  Simulation line;
  const Handle handle = line.send(sbgc::msg::CalibGyro{});
  line.run_for(seconds(1));
  EXPECT_EQ(line.outcome(handle), Outcome::timeout) << "the board ignores wrong parameters";
}

TEST(Session, ACalibrationMayFailToEnd) {
  Simulation line;
  line.board = [&](const Written& frame) { line.confirm(frame.id); };
  const Handle handle = line.send(sbgc::msg::CalibGyro{});
  line.run_for(seconds(29));
  EXPECT_EQ(line.outcome(handle), Outcome::none);
  line.run_for(seconds(2));
  EXPECT_EQ(line.outcome(handle), Outcome::timeout);
}

TEST(Session, ACalibrationThatRestartsTheBoardIsConfirmedOnce) {
  Simulation line;
  line.board = [&](const Written& frame) { line.confirm(frame.id); };
  sbgc::msg::CalibGyroExt request;
  request.action = sbgc::msg::CalibAction::reset;
  const Handle handle = line.send(request);
  line.run();
  EXPECT_EQ(line.outcome(handle), Outcome::confirmed);
}

// Overload

TEST(Session, RefusesWhatItCannotHold) {
  Simulation line;
  std::vector<Handle> handles;
  for (std::size_t i = 0; i < sbgc::SessionCapacity{}.requests; ++i) {
    handles.push_back(line.send(sbgc::msg::MotorsOn{}));
  }
  const sbgc::SendResult refused = line.session.send(sbgc::msg::MotorsOn{});
  EXPECT_EQ(refused.status, SendStatus::queue_full);
  EXPECT_FALSE(refused.handle);
  EXPECT_EQ(line.session.send(77, {}, sbgc::msg::response_policy(sbgc::msg::MotorsOn{})).status,
            SendStatus::queue_full);
  EXPECT_EQ(line.session.statistics().refused, 2U);
  line.board = [&](const Written& frame) { line.confirm(frame.id); };
  line.run();
  for (const Handle handle : handles) EXPECT_EQ(line.outcome(handle), Outcome::confirmed);
  EXPECT_THAT(line.written, SizeIs(handles.size())) << "nothing is lost";
  EXPECT_TRUE(line.session.send(sbgc::msg::MotorsOn{}));
}

TEST(Session, WaitsWhenThereIsNoRoomForLateReplies) {
  using Small =
      sbgc::BasicSession<sbgc::SessionCapacity{.requests = 8, .late_replies = 2, .streams = 1}>;
  simulation::Basic<Small> line;
  const sbgc::SendOptions once{.attempts = 1, .timeout = milliseconds(5)};
  std::vector<Handle> handles;
  handles.push_back(line.send(sbgc::msg::BoardInfoRequest{}, once));
  handles.push_back(line.send(sbgc::msg::I2cReadRegBufRequest{}, once));
  handles.push_back(line.send(sbgc::msg::GetAnglesRequest{}, once));
  line.run();
  for (const Handle handle : handles) EXPECT_EQ(line.outcome(handle), Outcome::timeout);
  EXPECT_LT(line.written[1].at - line.written[0].at, milliseconds(100));
  EXPECT_GT(line.written[2].at - line.written[0].at, milliseconds(500));
}

TEST(Session, WhatHasAnEffectDoesNotWaitForRoom) {
  using Small =
      sbgc::BasicSession<sbgc::SessionCapacity{.requests = 8, .late_replies = 2, .streams = 1}>;
  simulation::Basic<Small> line;
  std::vector<Handle> handles;
  handles.push_back(line.send(sbgc::msg::Control{}));
  handles.push_back(line.send(sbgc::msg::ExecuteMenu{.cmd_id = sbgc::msg::MenuCommand::profile1}));
  handles.push_back(line.send(sbgc::msg::BeepSound{}));
  handles.push_back(line.send(sbgc::msg::ServoOut{}));
  line.run();
  for (const Handle handle : handles) EXPECT_EQ(line.outcome(handle), Outcome::sent);
  EXPECT_LT(line.written[3].at - line.written[0].at, milliseconds(100));
}

TEST(Session, KeepsRoomForTheLateRepliesOfWhatIsInFlight) {
  using Small =
      sbgc::BasicSession<sbgc::SessionCapacity{.requests = 8, .late_replies = 2, .streams = 1}>;
  simulation::Basic<Small> line;
  line.send(sbgc::msg::BoardInfoRequest{}, {.attempts = 1});
  line.send(sbgc::msg::ReadParams3Request{}, {.attempts = 1});
  line.send(sbgc::msg::GetAnglesRequest{}, {.attempts = 1});
  line.run();
  ASSERT_THAT(line.written, SizeIs(3));
  EXPECT_LT(line.written[1].at - line.written[0].at, milliseconds(100));
  EXPECT_EQ(line.written[2].at - line.written[0].at, milliseconds(500 + 500))
      << "until no response to the first request can come";
}

TEST(Session, RefusesWhatCannotBeEncoded) {
  Simulation line;
  sbgc::msg::DataStreamInterval request;
  request.cmd_id = sbgc::msg::CommandFromBoard::realtime_data_custom;  // without its flags
  const sbgc::SendResult result = line.session.send(request);
  EXPECT_EQ(result.status, SendStatus::not_encodable);
  EXPECT_EQ(result.encoding.code, sbgc::Code::presence_mismatch);
  EXPECT_EQ(line.session.stream_usage().used, 0U);
  EXPECT_EQ(line.session.send(0, {}, {}).status, SendStatus::not_encodable);
  EXPECT_EQ(line.session.open_requests(), 0U);
}

TEST(Session, TakesEncodedBodies) {
  Simulation line;
  line.board = [&](const Written& frame) { line.say(eeprom_read, body_of(68, {frame.body[0]})); };
  sbgc::msg::EepromReadRequest request;
  request.addr = 64;
  const Body body = body_of(6, {64, 0, 0, 0, 64, 0});
  const auto result = line.session.send(eeprom_read, body, sbgc::msg::response_policy(request));
  line.run();
  EXPECT_EQ(line.outcome(result.handle), Outcome::answered);
  EXPECT_EQ(line.written[0].body, body);
}

// Time

TEST(Session, TimeThatRunsBackwardsStandsStill) {
  Simulation line;
  const Handle handle = line.send(sbgc::msg::BoardInfoRequest{}, {.attempts = 1});
  line.run_for(milliseconds(100));
  line.now = line.now - seconds(500);
  const sbgc::Output output = line.session.poll(line.now, line.sink());
  EXPECT_TRUE(output.bytes.empty());
  EXPECT_EQ(output.deadline, simulation::start + milliseconds(500));
  line.now = simulation::start + milliseconds(499);
  line.run_for(milliseconds(0));
  EXPECT_EQ(line.outcome(handle), Outcome::none);
  line.run_for(milliseconds(1));
  EXPECT_EQ(line.outcome(handle), Outcome::timeout);
}

TEST(Session, TimeMayJump) {
  Simulation line;
  const Handle handle = line.send(sbgc::msg::BoardInfoRequest{}, {.attempts = 1});
  line.run_for(milliseconds(1));
  line.now = line.now + seconds(1'000'000'000);
  line.run();
  EXPECT_EQ(line.outcome(handle), Outcome::timeout);
  line.now = {sbgc::Instant::never.us - 10};
  line.send(sbgc::msg::MotorsOn{});
  EXPECT_FALSE(line.session.poll(line.now, line.sink()).bytes.empty());
  EXPECT_EQ(line.session.poll(line.now, line.sink()).deadline, sbgc::Instant::never);
}

TEST(Session, HasNothingToDoWhenThereIsNothing) {
  Simulation line;
  EXPECT_EQ(line.session.poll(line.now, line.sink()).deadline, sbgc::Instant::never);
  line.session.feed({}, line.now, line.sink());
  EXPECT_EQ(line.session.poll(line.now, line.sink()).deadline, sbgc::Instant::never);
}

TEST(Session, TheSinkMaySendTheNextRequestAndCancelOthers) {
  Simulation line;
  line.board = [&](const Written& frame) { line.confirm(frame.id); };
  const Handle other = line.send(sbgc::msg::CalibGyro{});
  int left = 20;
  line.on_event = [&](const Record& record) {
    if (record.event.kind == EventKind::confirmation && record.event.command == calib_gyro) {
      line.session.cancel(other, line.sink());
    }
    if (record.event.kind == EventKind::completed && left-- > 0) line.send(sbgc::msg::MotorsOn{});
  };
  line.run();
  EXPECT_EQ(line.outcome(other), Outcome::cancelled);
  EXPECT_THAT(line.of(EventKind::completed), SizeIs(21));
}

}  // namespace
