// Tests of matching responses, confirmations, errors and resets with requests.

#include "simulation.hpp"

namespace sbgc::test {
namespace {

using Matching = LineTest;

msg::ReadParams3Request read_profile(std::uint8_t profile) {
  msg::ReadParams3Request request{.profile_id = profile};
  return request;
}

TEST_F(Matching, RequestsThatAnswersTellApartAreInFlightTogether) {
  line.board = [&](const Written& frame) {  // responses in reverse order
    const int delay = 300 - 50 * frame.body[0];
    line.say(read_params_3, body_of(134, {frame.body[0]}), milliseconds(delay));
  };
  std::vector<Handle> handles;
  for (std::uint8_t profile = 0; profile < 5; ++profile) {
    handles.push_back(line.send(read_profile(profile)));
  }
  line.run_for(milliseconds(90));
  EXPECT_THAT(line.written, SizeIs(5)) << "before the first response";
  line.run();
  for (std::uint8_t profile = 0; profile < 5; ++profile) {
    ASSERT_EQ(line.outcome(handles[profile]), Outcome::answered);
    EXPECT_EQ(line.completion(handles[profile])->body[0], profile);
  }
}

TEST_F(Matching, AWrongAnswerIsNone) {
  line.board = [&](const Written&) {
    line.say(read_params_3, body_of(134, {4}), milliseconds(3));    // another profile
    line.say(realtime_data_4, body_of(124, {1}), milliseconds(7));  // another message
    line.say(read_params_3, body_of(140, {1}), milliseconds(9));    // valid, from later firmware
  };
  const Handle handle = line.send(read_profile(1));
  line.run();
  ASSERT_EQ(line.outcome(handle), Outcome::answered);
  EXPECT_EQ(line.completion(handle)->body, body_of(140, {1}));
  EXPECT_THAT(line.of(EventKind::unsolicited), SizeIs(2));
  EXPECT_EQ(line.session.statistics().unsolicited, 2U);
}

// Live data of 35 and of 8 bytes.
msg::RealtimeDataCustomRequest read_encoders() {
  using Flag = msg::RealtimeDataCustomFlag;
  return {.flags = Flag::imu_angles | Flag::target_angles | Flag::rc_data | Flag::encoder_raw24};
}
msg::RealtimeDataCustomRequest read_angles() {
  return {.flags = msg::RealtimeDataCustomFlag::imu_angles};
}

TEST(Sessions, ABodyOfAWrongSizeAnswers) {
  for (const std::size_t size : {0U, 26U}) {
    Simulation line;
    line.board = [&](const Written&) { line.say(realtime_data_custom, body_of(size)); };
    const Handle handle = line.send(read_encoders());
    line.run_for(milliseconds(20));
    ASSERT_EQ(line.outcome(handle), Outcome::answered) << size;
    EXPECT_EQ(line.completion(handle)->body, body_of(size));
    const Handle next = line.send(read_encoders());
    line.run_for(milliseconds(20));
    EXPECT_EQ(line.outcome(next), Outcome::answered) << "it waits for nothing";
    EXPECT_THAT(line.written, SizeIs(2));
    EXPECT_THAT(line.of(EventKind::unsolicited), SizeIs(0));
  }
}

TEST_F(Matching, ALateBodyOfAWrongSizeIsLate) {
  line.board = [&](const Written& frame) {
    const bool is_first = line.written.size() == 1;
    line.say(realtime_data_custom, is_first ? body_of(26) : body_of(frame.body[0] == 1 ? 8 : 26),
             milliseconds(is_first ? 600 : 3));
  };
  const Handle first = line.send(read_encoders(), {.attempts = 1});
  line.run_for(milliseconds(550));
  EXPECT_EQ(line.outcome(first), Outcome::timeout);
  const Handle second = line.send(read_encoders());
  line.run_for(milliseconds(150));
  ASSERT_EQ(line.outcome(second), Outcome::answered);
  EXPECT_THAT(line.written, SizeIs(2));
  EXPECT_EQ(line.session.statistics().late_replies, 1U);
}

TEST_F(Matching, ABodyOfTheRightSizeIsMeantForWhatHasIt) {
  line.board = [&](const Written& frame) {
    if (frame.body[0] == 1) line.say(realtime_data_custom, body_of(8), milliseconds(3));
  };
  const Handle silent = line.send(read_encoders(), {.attempts = 1});
  EXPECT_EQ(line.ask(read_angles()), Outcome::answered);
  EXPECT_EQ(line.outcome(silent), Outcome::timeout);
}

TEST_F(Matching, RequestsThatCouldBeConfusedWaitAndOthersOvertake) {
  line.board = [&](const Written& frame) {
    line.say(frame.id, body_of(frame.id == board_info ? 18 : 4), milliseconds(100));
  };
  line.send(msg::I2cReadRegBufRequest{.reg_addr = 1});
  const Handle second = line.send(msg::I2cReadRegBufRequest{.reg_addr = 2});
  line.send(msg::BoardInfoRequest{});
  line.run();
  EXPECT_THAT(ids(line.written), ElementsAre(i2c_read, board_info, i2c_read));
  EXPECT_GE(line.written[2].at - line.written[0].at, milliseconds(100));
  EXPECT_EQ(line.outcome(second), Outcome::answered);
}

TEST_F(Matching, RequestsOfOneHostDoNotWaitForEachOther) {
  const Handle first = line.send(msg::BoardInfoRequest{}, {.host = 1});
  const Handle second = line.send(msg::BoardInfoRequest{}, {.host = 1});
  line.send(msg::BoardInfoRequest{}, {.host = 2});
  line.send(msg::GetAnglesRequest{}, {.host = 2});
  line.run_for(milliseconds(100));
  EXPECT_THAT(ids(line.written), ElementsAre(board_info, board_info))
      << "a host does not overtake itself";
  for (const Handle handle : {first, second}) {
    line.say(board_info, body_of(18));
    line.run_for(milliseconds(10));
    EXPECT_EQ(line.outcome(handle), Outcome::answered);
  }
  line.run_for(milliseconds(100));
  EXPECT_THAT(line.written, SizeIs(4));
}

TEST_F(Matching, AnErrorWhileACalibrationRunsIsThatOfAnother) {
  const Handle running = line.send(msg::CalibPoles{});
  line.run_for(milliseconds(100));
  line.board = [&](const Written& frame) { line.say(error, {frame.id, 7, 0, 0, 0, 0}); };
  const Handle refused = line.send(msg::CalibPoles{});
  line.run_for(milliseconds(100));
  EXPECT_EQ(line.outcome(refused), Outcome::board_error);
  line.confirm(static_cast<std::uint8_t>(msg::CalibPoles::command));
  line.run_for(milliseconds(100));
  EXPECT_EQ(line.outcome(running), Outcome::confirmed);
}

TEST_F(Matching, AnErrorWhileAModuleIsLoadedIsThatOfTheFirstPart) {
  // whose board works on one part after the other, each for up to 5 s
  msg::ModuleFlashWrite part;
  ASSERT_TRUE(part.data.resize(4));
  const Handle first = line.send(part);
  line.run_for(milliseconds(100));
  line.board = [&](const Written& frame) { line.say(error, {frame.id, 7, 0, 0, 0, 0}); };
  const Handle second = line.send(part);
  line.run_for(milliseconds(100));
  EXPECT_EQ(line.outcome(first), Outcome::board_error);
  EXPECT_EQ(line.outcome(second), Outcome::none);
}

TEST_F(Matching, NoRequestOvertakesOneThatItCouldBeConfusedWith) {
  line.board = [&](const Written& frame) {
    const std::uint8_t profile = frame.body[0] == 255 ? 3 : frame.body[0];
    line.say(read_params_3, body_of(134, {profile}), milliseconds(100));
  };
  line.send(read_profile(1));
  const Handle active = line.send(read_profile(255));  // waits because it may be 1
  line.send(read_profile(2));
  line.run();
  ASSERT_THAT(line.written, SizeIs(3));
  EXPECT_EQ(line.written[1].body[0], 255);
  EXPECT_EQ(line.written[2].body[0], 2);
  EXPECT_EQ(line.outcome(active), Outcome::answered) << "by profile 3";
}

TEST_F(Matching, ReadsOfFilesFollowEachOtherBecauseOfTheirErrors) {
  line.board = [&](const Written& frame) {
    const bool is_good = frame.body[2] == 0;
    line.say(read_file, is_good ? body_of(20, {9, 0, 0, 0}) : body_of(1, {2}));
  };
  msg::ReadFileRequest request;
  const Handle good = line.send(request);
  request.page_offset = msg::Pages(1);
  const Handle bad = line.send(request);
  line.run();
  EXPECT_EQ(line.outcome(good), Outcome::answered);
  EXPECT_EQ(line.outcome(bad), Outcome::failed) << "the response has the form of an error";
  EXPECT_EQ(line.completion(bad)->body, body_of(1, {2}));
}

TEST_F(Matching, AConfirmationWithTheAddressOfAnotherBlockIsNotMeant) {
  line.board = [&](const Written&) {
    line.say(confirm, {eeprom_write, 64, 0, 0, 0}, milliseconds(3));
    line.say(confirm, {eeprom_write, 128, 0, 0, 0}, milliseconds(50));
  };
  msg::EepromWrite request{.addr = 128};
  const Handle handle = line.send(request);
  line.run_for(milliseconds(10));
  EXPECT_EQ(line.outcome(handle), Outcome::none);
  line.run();
  EXPECT_EQ(line.outcome(handle), Outcome::confirmed);
  // Boards may omit the address.
  confirm_all();
  EXPECT_EQ(line.ask(request), Outcome::confirmed);
}

TEST(Sessions, AConfirmationCanTellOfAFailure) {
  for (const int result : {0, 4}) {
    Simulation line;
    line.board = [&](const Written& frame) {
      line.say(confirm, {frame.id, static_cast<std::uint8_t>(result)});
    };
    const Handle handle = line.send(msg::WriteFile{});
    line.run();
    EXPECT_EQ(line.outcome(handle), result == 0 ? Outcome::confirmed : Outcome::failed);
    EXPECT_EQ(line.completion(handle)->event.command, write_file);
  }
}

// Errors

TEST_F(Matching, AnErrorThatNamesItsCommandEndsTheRequest) {
  line.board = [&](const Written& frame) {
    if (frame.id == motors_on) {
      line.say(error, {motors_on, 7, 0, 0, 0, 0});
    } else {
      line.say(board_info, body_of(18), milliseconds(100));
    }
  };
  const Handle motors = line.send(msg::MotorsOn{});
  const Handle info = line.send(msg::BoardInfoRequest{});
  line.run();
  ASSERT_EQ(line.outcome(motors), Outcome::board_error);
  EXPECT_EQ(line.completion(motors)->body[1], 7);
  EXPECT_EQ(line.outcome(info), Outcome::answered);
  EXPECT_THAT(line.of(EventKind::board_error), SizeIs(0));
}

TEST_F(Matching, AnErrorWithoutCommandBelongsToTheOnlyRequest) {
  line.board = [&](const Written&) { line.say(error, {7, 0, 0, 0, 0}, milliseconds(50)); };
  EXPECT_EQ(line.ask(msg::MotorsOn{}), Outcome::board_error);

  line.board = [&](const Written& frame) {
    if (frame.id == motors_on) line.say(error, {7, 0, 0, 0, 0}, milliseconds(50));
  };
  const Handle first = line.send(msg::MotorsOn{}, {.attempts = 1});
  const Handle second = line.send(msg::BoardInfoRequest{}, {.attempts = 1});
  line.run();
  EXPECT_EQ(line.outcome(first), Outcome::timeout) << "it may refer to either";
  EXPECT_EQ(line.outcome(second), Outcome::timeout);
  EXPECT_THAT(line.of(EventKind::board_error), SizeIs(1));
}

TEST_F(Matching, AnErrorForWhatIsOverIsLate) {
  line.board = [&](const Written& frame) {
    if (frame.id == control) line.say(error, {control, 1, 0, 0, 0, 0});
  };
  line.send(msg::Control{});
  line.run();
  ASSERT_THAT(line.of(EventKind::board_error), SizeIs(1));
  EXPECT_TRUE(line.of(EventKind::board_error)[0].event.is_late);
  EXPECT_EQ(line.of(EventKind::board_error)[0].event.command, control);
}

// Resets

TEST_F(Matching, AResetEndsWhateverIsOpen) {
  line.board = [&](const Written& frame) {
    if (frame.id == motors_on) line.say(reset, {});
  };
  const Handle info = line.send(msg::BoardInfoRequest{});
  const Handle motors = line.send(msg::MotorsOn{});
  const Handle waiting = line.send(msg::BoardInfoRequest{});
  line.run();
  EXPECT_THAT(line.of(EventKind::reset), SizeIs(1));
  for (const Handle handle : {info, motors, waiting}) {
    EXPECT_EQ(line.outcome(handle), Outcome::reset);
  }
  EXPECT_EQ(line.session.statistics().resets, 1U);
  EXPECT_EQ(line.session.open_requests(), 0U);
}

TEST_F(Matching, ARequestWaitsUntilTheBoardHasRestarted) {
  line.send(msg::I2cReadRegBufRequest{}, {.timeout = seconds(30)});
  line.run_for(milliseconds(1));
  line.say(reset, {});
  line.run_for(milliseconds(10));
  line.send(msg::I2cReadRegBufRequest{}, {.attempts = 1});
  line.run();
  ASSERT_THAT(line.written, SizeIs(2));
  const Instant told = start_time + milliseconds(1 + 3);
  EXPECT_EQ(line.written[1].at, told + milliseconds(roles::reset_delay_ms + 500));
}

TEST_F(Matching, WhatIsSentWhileTheResetIsReportedIsAnotherRequest) {
  Handle next;
  line.on_event = [&](const Record& record) {
    if (record.event.kind == EventKind::reset) next = line.send(msg::BoardInfoRequest{});
  };
  const Handle first = line.send(msg::MotorsOn{});
  line.run_for(milliseconds(1));
  line.say(reset, {});
  line.run_for(milliseconds(4));
  EXPECT_EQ(line.outcome(first), Outcome::reset);
  EXPECT_EQ(line.outcome(next), Outcome::none);
  line.say(board_info, body_of(18), milliseconds(20));
  line.run();
  EXPECT_EQ(line.outcome(next), Outcome::answered);
}

TEST_F(Matching, AnAbandonedLinkEndsEverything) {
  const Handle sent = line.send(msg::MotorsOn{});
  line.run_for({});
  ASSERT_THAT(line.written, SizeIs(1));
  const Handle waiting = line.send(msg::MotorsOn{});
  line.session.abandon(line.sink());
  EXPECT_EQ(line.outcome(sent), Outcome::link_lost);
  EXPECT_EQ(line.outcome(waiting), Outcome::link_lost);
  // No state of the old link remains.
  confirm_all();
  const Handle next = line.send(msg::MotorsOn{});
  line.run_for(milliseconds(4));
  EXPECT_EQ(line.outcome(next), Outcome::confirmed) << "it need not wait for late replies";
  EXPECT_EQ(line.written.back().at, start_time) << "nor for the end of a pause";
}

}  // namespace
}  // namespace sbgc::test
