// The rules of a session, one by one.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sbgc/exchanges/all.hpp>
#include <sbgc/session.hpp>

#include "simulation.hpp"

namespace {

using sbgc::EventKind;
using sbgc::Handle;
using sbgc::milliseconds;
using sbgc::Outcome;
using sbgc::seconds;
using sbgc::SendStatus;
using simulation::Body;
using simulation::body_of;
using simulation::Record;
using simulation::Simulation;
using simulation::Written;
using ::testing::ElementsAre;
using ::testing::SizeIs;

// Ids of the protocol, as the specification lists them.
constexpr std::uint8_t read_params_3 = 21;
constexpr std::uint8_t write_params_3 = 22;
constexpr std::uint8_t realtime_data_4 = 25;
constexpr std::uint8_t eeprom_write = 47;
constexpr std::uint8_t eeprom_read = 48;
constexpr std::uint8_t read_file = 53;
constexpr std::uint8_t write_file = 54;
constexpr std::uint8_t control = 67;
constexpr std::uint8_t confirm = 67;
constexpr std::uint8_t motors_on = 77;
constexpr std::uint8_t calib_gyro = 103;
constexpr std::uint8_t board_info = 86;
constexpr std::uint8_t reset = 114;
constexpr std::uint8_t error = 255;

std::vector<std::uint8_t> ids(const std::vector<Written>& written) {
  std::vector<std::uint8_t> result;
  result.reserve(written.size());
  for (const Written& frame : written) result.push_back(frame.id);
  return result;
}

sbgc::ReadParams3Request read_profile(std::uint8_t profile) {
  sbgc::ReadParams3Request request;
  request.profile_id = profile;
  return request;
}

TEST(Session, TakesTheAnswerOfARequest) {
  Simulation line;
  line.board = [&](const Written&) { line.say(board_info, body_of(18, {31})); };
  const Handle handle = line.send(sbgc::BoardInfoRequest{});
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
  const Handle handle = line.send(sbgc::Control{});
  EXPECT_EQ(line.outcome(handle), Outcome::none) << "before it is written";
  line.run();
  EXPECT_EQ(line.outcome(handle), Outcome::sent);
  EXPECT_THAT(ids(line.written), ElementsAre(control));
}

TEST(Session, WaitsForACertainConfirmation) {
  Simulation line;
  line.board = [&](const Written& frame) { line.confirm(frame.id); };
  const Handle handle = line.send(sbgc::MotorsOn{});
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
    EXPECT_THAT(line.written, SizeIs(2)) << "that a confirmation is missing is no reason to repeat";
  }
}

TEST(Session, WaitsForAPossibleConfirmationOnlyIfTold) {
  expect_to_wait_only_if_told(sbgc::ExecuteMenu{});
}

TEST(Session, WaitsForAnUnlikelyConfirmationOnlyIfTold) {
  expect_to_wait_only_if_told(sbgc::ApiVirtChControl{});
}

TEST(Session, DoesNotTakeTheConfirmationOfAnEarlierRequestForThatOfALaterOne) {
  Simulation line;
  int frames = 0;
  line.board = [&](const Written& frame) {
    if (++frames == 1) line.confirm(frame.id, milliseconds(200));
  };
  line.send(sbgc::ExecuteMenu{});  // nobody waits for its confirmation, which comes late
  const Handle second = line.send(sbgc::ExecuteMenu{}, {.expect_confirmation = true});
  line.run();
  EXPECT_EQ(line.outcome(second), Outcome::unconfirmed);
  ASSERT_THAT(line.of(EventKind::confirmation), SizeIs(1));
  EXPECT_TRUE(line.of(EventKind::confirmation)[0].event.is_late);
  EXPECT_FALSE(line.of(EventKind::confirmation)[0].event.handle);
}

TEST(Session, RequestsThatWaitForNothingDoNotHoldUpEachOther) {
  Simulation line;
  for (int i = 0; i < 40; ++i) {  // 50 a second; the board confirms none of them
    line.send(sbgc::Control{});
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
  const Handle handle = line.send(sbgc::CalibGyro{});
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
  const Handle handle = line.send(sbgc::CalibGyro{});
  line.run_for(seconds(1));
  EXPECT_EQ(line.outcome(handle), Outcome::timeout) << "the board ignores wrong parameters";
}

TEST(Session, ACalibrationMayFailToEnd) {
  Simulation line;
  line.board = [&](const Written& frame) { line.confirm(frame.id); };
  const Handle handle = line.send(sbgc::CalibGyro{});
  line.run_for(seconds(29));
  EXPECT_EQ(line.outcome(handle), Outcome::none);
  line.run_for(seconds(2));
  EXPECT_EQ(line.outcome(handle), Outcome::timeout);
}

TEST(Session, ACalibrationThatRestartsTheBoardIsConfirmedOnce) {
  Simulation line;
  line.board = [&](const Written& frame) { line.confirm(frame.id); };
  sbgc::CalibGyroExt request;
  request.action = sbgc::CalibAction::reset;
  const Handle handle = line.send(request);
  line.run();
  EXPECT_EQ(line.outcome(handle), Outcome::confirmed);
}

// Loss

TEST(Session, RepeatsWhatIsSafeToRepeat) {
  Simulation line;
  line.board = [&](const Written&) {
    if (line.written.size() == 3) line.say(board_info, body_of(18));
  };
  const Handle handle = line.send(sbgc::BoardInfoRequest{});
  line.run();
  EXPECT_EQ(line.outcome(handle), Outcome::answered);
  EXPECT_THAT(line.written, SizeIs(3));
  EXPECT_GE(line.written[1].at - line.written[0].at, milliseconds(500));
  const auto statistics = line.session.statistics();
  EXPECT_EQ(statistics.retries, 2U);
  EXPECT_EQ(statistics.timeouts, 2U);
  EXPECT_EQ(statistics.sent_frames, 3U);
}

TEST(Session, GivesUpAfterAllAttempts) {
  Simulation line;
  const Handle three = line.send(sbgc::BoardInfoRequest{});
  line.run();
  EXPECT_EQ(line.outcome(three), Outcome::timeout);
  EXPECT_THAT(line.written, SizeIs(3));
  const Handle one = line.send(sbgc::BoardInfoRequest{}, {.attempts = 1});
  line.run();
  EXPECT_EQ(line.outcome(one), Outcome::timeout);
  EXPECT_THAT(line.written, SizeIs(4));
}

TEST(Session, DoesNotRepeatWhatIsNotSafe) {
  Simulation line;
  sbgc::I2cReadRegBufRequest request;
  request.data_len = sbgc::SmallByteCount::from_bytes(4);
  const Handle handle = line.send(request, {.attempts = 5});
  line.run();
  EXPECT_EQ(line.outcome(handle), Outcome::timeout);
  EXPECT_THAT(line.written, SizeIs(1));
}

TEST(Session, TimesOutNoEarlierAndNoLaterThanItShould) {
  Simulation line;
  const Handle handle =
      line.send(sbgc::BoardInfoRequest{}, {.attempts = 1, .timeout = milliseconds(70)});
  line.run();
  EXPECT_EQ(line.completion(handle)->at, simulation::start + milliseconds(70));
}

TEST(Session, HasADeadlineForTheWholeRequest) {
  Simulation line;
  const sbgc::Instant deadline = line.now + milliseconds(700);
  const Handle handle = line.send(sbgc::BoardInfoRequest{}, {.deadline = deadline});
  // It waits for the first one, and for the ghost of it, and never gets its turn.
  const Handle waiting = line.send(sbgc::BoardInfoRequest{}, {.deadline = deadline});
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
  const Handle first = line.send(sbgc::BoardInfoRequest{}, {.attempts = 1});
  const Handle second = line.send(sbgc::BoardInfoRequest{}, {.attempts = 1});
  line.run();
  EXPECT_EQ(line.outcome(first), Outcome::timeout);
  ASSERT_EQ(line.outcome(second), Outcome::answered);
  EXPECT_EQ(line.completion(second)->body[0], 2) << "the answer of the first request";
  EXPECT_EQ(line.session.statistics().late_answers, 1U);
  ASSERT_THAT(line.of(EventKind::unsolicited), SizeIs(1));
  EXPECT_TRUE(line.of(EventKind::unsolicited)[0].event.is_late);
}

TEST(Session, TheAnswerToTheFirstTransmissionAnswersARepeatedRequest) {
  Simulation line;
  line.board = [&](const Written&) {
    line.say(board_info, body_of(18, {static_cast<int>(line.written.size())}), milliseconds(520));
  };
  const Handle first = line.send(sbgc::BoardInfoRequest{});
  line.run_for(milliseconds(530));
  ASSERT_EQ(line.outcome(first), Outcome::answered);
  EXPECT_EQ(line.completion(first)->body[0], 1);
  EXPECT_THAT(line.written, SizeIs(2));
  // The answer to the second transmission comes while the next request waits for its turn.
  const Handle second = line.send(sbgc::BoardInfoRequest{}, {.attempts = 1, .timeout = seconds(1)});
  line.run();
  ASSERT_EQ(line.outcome(second), Outcome::answered);
  EXPECT_EQ(line.completion(second)->body[0], 3);
}

TEST(Session, TheAnswerOfACancelledRequestIsNotThatOfTheNext) {
  Simulation line;
  line.board = [&](const Written&) {
    line.say(board_info, body_of(18, {static_cast<int>(line.written.size())}), milliseconds(300));
  };
  const Handle first = line.send(sbgc::BoardInfoRequest{});
  line.run_for(milliseconds(100));
  EXPECT_TRUE(line.session.cancel(first, line.sink()));
  EXPECT_FALSE(line.session.cancel(first, line.sink()));
  EXPECT_EQ(line.outcome(first), Outcome::cancelled);
  const Handle second = line.send(sbgc::BoardInfoRequest{});
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
  const Handle first = session.send(sbgc::BoardInfoRequest{}).handle;
  ASSERT_FALSE(session.poll(now, sink).bytes.empty());
  now = now + milliseconds(100);
  ASSERT_TRUE(session.cancel(first, sink));
  now = now + seconds(5);
  session.written(now);  // only now

  const Handle second = session.send(sbgc::BoardInfoRequest{}).handle;
  now = now + milliseconds(50);
  EXPECT_TRUE(session.poll(now, sink).bytes.empty()) << "the answer to the first may still come";
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
  session.send(sbgc::BoardInfoRequest{}, {.attempts = 1});
  ASSERT_FALSE(session.poll(now, sink).bytes.empty());
  now = now + seconds(3);
  session.written(now);
  static_cast<void>(session.poll(now + milliseconds(499), sink));
  EXPECT_EQ(outcome, Outcome::none);
  static_cast<void>(session.poll(now + milliseconds(501), sink));
  EXPECT_EQ(outcome, Outcome::timeout);
}

TEST(Session, CancelsWhatIsNotSentYet) {
  Simulation line;
  const Handle handle = line.send(sbgc::MotorsOn{});
  EXPECT_TRUE(line.session.cancel(handle, line.sink()));
  EXPECT_FALSE(line.session.cancel({}, line.sink()));
  line.run();
  EXPECT_EQ(line.outcome(handle), Outcome::cancelled);
  EXPECT_THAT(line.written, SizeIs(0));
}

// What belongs to what

TEST(Session, RequestsThatAnswersTellApartAreInFlightTogether) {
  Simulation line;
  line.board = [&](const Written& frame) {  // answers in reverse order
    const int delay = 300 - 50 * frame.body[0];
    line.say(read_params_3, body_of(134, {frame.body[0]}), milliseconds(delay));
  };
  std::vector<Handle> handles;
  for (std::uint8_t profile = 0; profile < 5; ++profile) {
    handles.push_back(line.send(read_profile(profile)));
  }
  line.run_for(milliseconds(90));
  EXPECT_THAT(line.written, SizeIs(5)) << "before the first answer";
  line.run();
  for (std::uint8_t profile = 0; profile < 5; ++profile) {
    ASSERT_EQ(line.outcome(handles[profile]), Outcome::answered);
    EXPECT_EQ(line.completion(handles[profile])->body[0], profile);
  }
}

TEST(Session, ASpecialValueIsNotRepeatedByTheAnswer) {
  Simulation line;
  line.board = [&](const Written&) { line.say(read_params_3, body_of(134, {2})); };
  const Handle handle = line.send(read_profile(255));  // the active profile, which is 2
  line.run();
  EXPECT_EQ(line.outcome(handle), Outcome::answered);
}

TEST(Session, AWrongAnswerIsNone) {
  Simulation line;
  line.board = [&](const Written&) {
    line.say(read_params_3, body_of(134, {4}), milliseconds(3));    // another profile
    line.say(read_params_3, body_of(133, {1}), milliseconds(5));    // too short
    line.say(realtime_data_4, body_of(124, {1}), milliseconds(7));  // another message
    line.say(read_params_3, body_of(140, {1}), milliseconds(9));    // right, from later firmware
  };
  const Handle handle = line.send(read_profile(1));
  line.run();
  ASSERT_EQ(line.outcome(handle), Outcome::answered);
  EXPECT_EQ(line.completion(handle)->body, body_of(140, {1}));
  EXPECT_THAT(line.of(EventKind::unsolicited), SizeIs(3));
  EXPECT_EQ(line.session.statistics().unsolicited, 3U);
}

TEST(Session, RequestsThatCouldBeConfusedWaitAndOthersOvertake) {
  Simulation line;
  line.board = [&](const Written& frame) { line.confirm(frame.id, milliseconds(100)); };
  line.send(sbgc::WriteParams3{});
  const Handle second = line.send(sbgc::WriteParams3{});
  line.send(sbgc::MotorsOn{});
  line.run();
  EXPECT_THAT(ids(line.written), ElementsAre(write_params_3, motors_on, write_params_3));
  EXPECT_GE(line.written[2].at - line.written[0].at, milliseconds(100));
  EXPECT_EQ(line.outcome(second), Outcome::confirmed);
}

TEST(Session, ReadsOfFilesFollowEachOtherBecauseOfTheirErrors) {
  Simulation line;
  line.board = [&](const Written& frame) {
    const bool is_good = frame.body[2] == 0;
    line.say(read_file, is_good ? body_of(20, {9, 0, 0, 0}) : body_of(1, {2}));
  };
  sbgc::ReadFileRequest request;
  const Handle good = line.send(request);
  request.page_offset = sbgc::Pages(1);
  const Handle bad = line.send(request);
  line.run();
  EXPECT_EQ(line.outcome(good), Outcome::answered);
  EXPECT_EQ(line.outcome(bad), Outcome::failed) << "the answer has the form of an error";
  EXPECT_EQ(line.completion(bad)->body, body_of(1, {2}));
}

TEST(Session, AConfirmationWithTheAddressOfAnotherBlockIsNotMeant) {
  Simulation line;
  line.board = [&](const Written&) {
    line.say(confirm, {eeprom_write, 64, 0, 0, 0}, milliseconds(3));
    line.say(confirm, {eeprom_write, 128, 0, 0, 0}, milliseconds(50));
  };
  sbgc::EepromWrite request;
  request.addr = 128;
  const Handle handle = line.send(request);
  line.run_for(milliseconds(10));
  EXPECT_EQ(line.outcome(handle), Outcome::none);
  line.run();
  EXPECT_EQ(line.outcome(handle), Outcome::confirmed);
  // Boards may leave the address out.
  line.board = [&](const Written& frame) { line.confirm(frame.id); };
  const Handle bare = line.send(request);
  line.run();
  EXPECT_EQ(line.outcome(bare), Outcome::confirmed);
}

TEST(Session, AConfirmationCanTellOfAFailure) {
  for (const int result : {0, 4}) {
    Simulation line;
    line.board = [&](const Written& frame) {
      line.say(confirm, {frame.id, static_cast<std::uint8_t>(result)});
    };
    const Handle handle = line.send(sbgc::WriteFile{});
    line.run();
    EXPECT_EQ(line.outcome(handle), result == 0 ? Outcome::confirmed : Outcome::failed);
    EXPECT_EQ(line.completion(handle)->event.command, write_file);
  }
}

TEST(Session, WhatIsAskedForDependsOnTheRequest) {
  Simulation line;
  line.board = [&](const Written& frame) {
    if ((frame.body[0] & 1) == 0) line.say(56, body_of(24));
  };
  sbgc::AhrsHelperRequestExt request;
  const Handle get = line.send(request);
  request.mode.set(sbgc::AhrsHelperModeBit::set);
  const Handle set = line.send(request);
  line.run();
  EXPECT_EQ(line.outcome(get), Outcome::answered);
  EXPECT_EQ(line.outcome(set), Outcome::sent);
}

// Errors

TEST(Session, AnErrorThatNamesItsCommandEndsTheRequest) {
  Simulation line;
  line.board = [&](const Written& frame) {
    if (frame.id == motors_on) {
      line.say(error, {motors_on, 7, 0, 0, 0, 0});
    } else {
      line.say(board_info, body_of(18), milliseconds(100));
    }
  };
  const Handle motors = line.send(sbgc::MotorsOn{});
  const Handle info = line.send(sbgc::BoardInfoRequest{});
  line.run();
  ASSERT_EQ(line.outcome(motors), Outcome::board_error);
  EXPECT_EQ(line.completion(motors)->body[1], 7);
  EXPECT_EQ(line.outcome(info), Outcome::answered);
  EXPECT_THAT(line.of(EventKind::board_error), SizeIs(0));
}

TEST(Session, AnErrorWithoutCommandBelongsToTheOnlyRequest) {
  Simulation line;
  line.board = [&](const Written&) { line.say(error, {7, 0, 0, 0, 0}, milliseconds(50)); };
  const Handle only = line.send(sbgc::MotorsOn{});
  line.run();
  EXPECT_EQ(line.outcome(only), Outcome::board_error);

  line.board = [&](const Written& frame) {
    if (frame.id == motors_on) line.say(error, {7, 0, 0, 0, 0}, milliseconds(50));
  };
  const Handle first = line.send(sbgc::MotorsOn{}, {.attempts = 1});
  const Handle second = line.send(sbgc::BoardInfoRequest{}, {.attempts = 1});
  line.run();
  EXPECT_EQ(line.outcome(first), Outcome::timeout) << "either could be meant";
  EXPECT_EQ(line.outcome(second), Outcome::timeout);
  EXPECT_THAT(line.of(EventKind::board_error), SizeIs(1));
}

TEST(Session, AnErrorForWhatIsOverIsLate) {
  Simulation line;
  line.board = [&](const Written& frame) {
    if (frame.id == control) line.say(error, {control, 1, 0, 0, 0, 0});
  };
  line.send(sbgc::Control{});
  line.run();
  ASSERT_THAT(line.of(EventKind::board_error), SizeIs(1));
  EXPECT_TRUE(line.of(EventKind::board_error)[0].event.is_late);
  EXPECT_EQ(line.of(EventKind::board_error)[0].event.command, control);
}

// Resets

TEST(Session, AResetEndsWhateverIsOpen) {
  Simulation line;
  line.board = [&](const Written& frame) {
    if (frame.id == motors_on) line.say(reset, {});
  };
  const Handle info = line.send(sbgc::BoardInfoRequest{});
  const Handle motors = line.send(sbgc::MotorsOn{});
  const Handle waiting = line.send(sbgc::BoardInfoRequest{});
  line.run();
  EXPECT_THAT(line.of(EventKind::reset), SizeIs(1));
  for (const Handle handle : {info, motors, waiting}) {
    EXPECT_EQ(line.outcome(handle), Outcome::reset);
  }
  EXPECT_EQ(line.session.statistics().resets, 1U);
  EXPECT_EQ(line.session.open_requests(), 0U);
}

TEST(Session, AResetThatWasAskedForAnswers) {
  Simulation line;
  line.board = [&](const Written& frame) {
    if (frame.body.size() == 3 && frame.body[0] == 1) line.say(reset, {});
  };
  sbgc::ResetRequestExt request;
  request.confirm.set(sbgc::ResetOption::notify);
  const Handle noticed = line.send(request);
  line.run();
  EXPECT_EQ(line.outcome(noticed), Outcome::answered);
  EXPECT_THAT(line.of(EventKind::reset), SizeIs(1));
  request.confirm = {};
  const Handle silent = line.send(request);
  line.run();
  EXPECT_EQ(line.outcome(silent), Outcome::sent);
}

TEST(Session, WhatIsSentWhileTheResetIsReportedIsAnotherRequest) {
  Simulation line;
  Handle next;
  line.on_event = [&](const Record& record) {
    if (record.event.kind == EventKind::reset) next = line.send(sbgc::BoardInfoRequest{});
  };
  const Handle first = line.send(sbgc::MotorsOn{});
  line.run_for(milliseconds(1));
  line.say(reset, {});
  line.run_for(milliseconds(4));
  EXPECT_EQ(line.outcome(first), Outcome::reset);
  EXPECT_EQ(line.outcome(next), Outcome::none);
  line.say(board_info, body_of(18), milliseconds(20));
  line.run();
  EXPECT_EQ(line.outcome(next), Outcome::answered);
}

TEST(Session, AnAbandonedLinkEndsEverything) {
  Simulation line;
  const Handle sent = line.send(sbgc::MotorsOn{});
  line.run_for(milliseconds(1));
  const Handle waiting = line.send(sbgc::MotorsOn{});
  line.session.abandon(line.sink());
  EXPECT_EQ(line.outcome(sent), Outcome::link_lost);
  EXPECT_EQ(line.outcome(waiting), Outcome::link_lost);
  // On the next link nothing of the old one is left.
  line.board = [&](const Written& frame) { line.confirm(frame.id); };
  const Handle next = line.send(sbgc::MotorsOn{});
  line.run_for(milliseconds(4));
  EXPECT_EQ(line.outcome(next), Outcome::confirmed) << "it need not wait for ghosts";
}

// The line

TEST(Session, NoiseDoesNoHarm) {
  Simulation line;
  line.board = [&](const Written&) {
    Body bytes = {'>', 0x00, '>', '>', 9, 9, 18, 0x3E};
    const Body frame = simulation::frame_of(board_info, body_of(18));
    bytes.insert(bytes.end(), frame.begin(), frame.end());
    for (const std::uint8_t byte : bytes) line.say_bytes({byte});
  };
  const Handle handle = line.send(sbgc::BoardInfoRequest{});
  line.run();
  EXPECT_EQ(line.outcome(handle), Outcome::answered);
  EXPECT_GT(line.session.statistics().parser.skipped_bytes, 0U);
}

TEST(Session, ABeginningOfAFrameDoesNotHoldTheAnswerBackForLong) {
  Simulation line;
  line.board = [&](const Written&) {
    line.say_bytes({'>', 9, 200, 209});  // a header whose body never comes
    line.say(board_info, body_of(18), milliseconds(5));
  };
  const Handle handle = line.send(sbgc::BoardInfoRequest{});
  line.run();
  EXPECT_EQ(line.outcome(handle), Outcome::answered);
  EXPECT_LT(line.completion(handle)->at - simulation::start, milliseconds(110));
  EXPECT_EQ(line.session.statistics().parser.incomplete, 1U);
  EXPECT_THAT(line.written, SizeIs(1));
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
  options.duplicates = milliseconds(300);
  Simulation line(options);
  line.board = [&](const Written&) {
    const Body body = body_of(18, {static_cast<int>(line.written.size())});
    line.say(board_info, body, milliseconds(3));
    line.say(board_info, body, milliseconds(120));
  };
  const Handle first = line.send(sbgc::BoardInfoRequest{});
  const Handle second = line.send(sbgc::BoardInfoRequest{});
  line.run();
  EXPECT_EQ(line.completion(first)->body[0], 1);
  EXPECT_EQ(line.completion(second)->body[0], 2);
  EXPECT_THAT(line.of(EventKind::unsolicited), SizeIs(2));
}

// Overload

TEST(Session, RefusesWhatItCanNotHold) {
  Simulation line;
  std::vector<Handle> handles;
  for (std::size_t i = 0; i < sbgc::SessionCapacity{}.requests; ++i) {
    handles.push_back(line.send(sbgc::MotorsOn{}));
  }
  const sbgc::SendResult refused = line.session.send(sbgc::MotorsOn{});
  EXPECT_EQ(refused.status, SendStatus::queue_full);
  EXPECT_FALSE(refused.handle);
  EXPECT_EQ(line.session.send(77, {}, sbgc::exchange_of(sbgc::MotorsOn{})).status,
            SendStatus::queue_full);
  EXPECT_EQ(line.session.statistics().refused, 2U);
  line.board = [&](const Written& frame) { line.confirm(frame.id); };
  line.run();
  for (const Handle handle : handles) EXPECT_EQ(line.outcome(handle), Outcome::confirmed);
  EXPECT_THAT(line.written, SizeIs(handles.size())) << "nothing is lost";
  EXPECT_TRUE(line.session.send(sbgc::MotorsOn{}));
}

TEST(Session, WaitsWhenThereIsNoRoomForGhosts) {
  using Small = sbgc::BasicSession<sbgc::SessionCapacity{.requests = 8, .ghosts = 2, .streams = 1}>;
  simulation::Basic<Small> line;
  std::vector<Handle> handles;
  handles.push_back(line.send(sbgc::Control{}));
  handles.push_back(line.send(sbgc::ExecuteMenu{}));
  handles.push_back(line.send(sbgc::BeepSound{}));
  handles.push_back(line.send(sbgc::ServoOut{}));
  line.run();
  for (const Handle handle : handles) EXPECT_EQ(line.outcome(handle), Outcome::sent);
  EXPECT_LT(line.written[1].at - line.written[0].at, milliseconds(100));
  EXPECT_GT(line.written[2].at - line.written[0].at, milliseconds(900));
}

TEST(Session, RefusesWhatCanNotBeEncoded) {
  Simulation line;
  sbgc::DataStreamInterval request;
  request.cmd_id = sbgc::CommandId::realtime_data_custom;  // its flags are missing
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
  sbgc::EepromReadRequest request;
  request.addr = 64;
  const Body body = body_of(6, {64, 0, 0, 0, 64, 0});
  const auto result = line.session.send(eeprom_read, body, sbgc::exchange_of(request));
  line.run();
  EXPECT_EQ(line.outcome(result.handle), Outcome::answered);
  EXPECT_EQ(line.written[0].body, body);
}

// Time

TEST(Session, TimeThatRunsBackwardsStandsStill) {
  Simulation line;
  const Handle handle = line.send(sbgc::BoardInfoRequest{}, {.attempts = 1});
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
  const Handle handle = line.send(sbgc::BoardInfoRequest{}, {.attempts = 1});
  line.run_for(milliseconds(1));
  line.now = line.now + seconds(1'000'000'000);
  line.run();
  EXPECT_EQ(line.outcome(handle), Outcome::timeout);
  line.now = {sbgc::Instant::never.us - 10};
  line.send(sbgc::MotorsOn{});
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
  const Handle other = line.send(sbgc::CalibGyro{});
  int left = 20;
  line.on_event = [&](const Record& record) {
    if (record.event.kind == EventKind::confirmation && record.event.command == calib_gyro) {
      line.session.cancel(other, line.sink());
    }
    if (record.event.kind == EventKind::completed && left-- > 0) line.send(sbgc::MotorsOn{});
  };
  line.run();
  EXPECT_EQ(line.outcome(other), Outcome::cancelled);
  EXPECT_THAT(line.of(EventKind::completed), SizeIs(21));
}

}  // namespace
