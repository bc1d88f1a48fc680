// Tests of restarts: their duration, their notice, and lost state.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sbgc/roles.hpp>

#include "host.hpp"

namespace sbgc::test {
namespace {

using ::testing::IsEmpty;
using ::testing::SizeIs;

bool answers(Host& host) { return host.ask(msg::BoardInfoRequest{}, milliseconds(2)).size() == 1; }

/// Returns how long the board does not respond from now on.
Duration silence(Host& host) {
  const Instant begin = host.now;
  while (!answers(host) && host.now - begin < seconds(60)) {
  }
  return host.now - begin;
}

template <class Request>
Request with_notice(int delay_ms) {
  Request request;
  request.confirm = msg::ResetOption::notify;
  request.delay_ms = msg::Milliseconds(static_cast<std::uint16_t>(delay_ms));
  return request;
}

TEST(Restart, ABoardThatStartsIsSilent) {
  emulator::BoardOptions options;
  options.start_time = milliseconds(300);
  emulator::Board board(options, {}, {});
  EXPECT_EQ(board.next(), Instant{} + options.start_time);
  Host host(options);
  host.ask(msg::ResetRequest{}, milliseconds(1));
  const Duration length = silence(host);
  EXPECT_GT(length, milliseconds(298));
  EXPECT_LT(length, milliseconds(304));
  EXPECT_EQ(host.board.counters().restarts, 1U);
}

TEST(Restart, ComesAfterItsDelayAndNotice) {
  Host host;
  EXPECT_THAT(all<msg::Reset>(host.ask(with_notice<msg::ResetRequestExt>(400), milliseconds(100))),
              SizeIs(1));
  EXPECT_TRUE(answers(host));
  host.listen(milliseconds(290));
  EXPECT_TRUE(answers(host));
  host.listen(milliseconds(20));
  EXPECT_FALSE(answers(host));
}

TEST(Restart, WithoutAWishForItThereIsNoNotice) {
  Host host;
  auto request = with_notice<msg::ResetRequestExt>(100);
  request.confirm = {};
  EXPECT_THAT(host.ask(request, seconds(1)), IsEmpty());
  EXPECT_EQ(host.board.counters().restarts, 1U);
}

TEST(Restart, TheNoticeOfAnImmediateOneArrives) {
  Host host;
  EXPECT_THAT(all<msg::Reset>(host.ask(with_notice<msg::ResetRequestExt>(0), milliseconds(5))),
              SizeIs(1));
  EXPECT_FALSE(answers(host));
}

TEST(Restart, OfTwoTheEarlierComes) {
  Host host;
  host.ask(with_notice<msg::ResetRequestExt>(100), milliseconds(5));
  host.ask(with_notice<msg::ResetRequestExt>(2000), milliseconds(200));
  EXPECT_EQ(host.board.counters().restarts, 1U);
  host.listen(seconds(3));
  EXPECT_EQ(host.board.counters().restarts, 1U) << "the second restart is discarded";
}

TEST(Restart, TheBootloaderGivesUp) {
  emulator::BoardOptions options;
  options.bootloader_time = seconds(3);
  Host host(options);
  EXPECT_THAT(all<msg::Reset>(host.ask(with_notice<msg::BootMode3Ext>(0), milliseconds(5))),
              SizeIs(1));
  EXPECT_GT(silence(host), seconds(3) + options.start_time - milliseconds(10));
  EXPECT_TRUE(answers(host));
}

TEST(Restart, OfTheBoardItselfIsAnnouncedToAll) {
  Host host;
  const auto other = host.board.open_port().value();
  const auto packets =
      host.ask(msg::ExecuteMenu{.cmd_id = msg::MenuCommand::reset}, milliseconds(10));
  EXPECT_THAT(all<msg::Reset>(packets), SizeIs(1));
  EXPECT_FALSE(host.board.output(other).empty());
  host.listen(milliseconds(roles::reset_delay_ms - 20));
  EXPECT_EQ(host.board.counters().restarts, 0U);
  host.listen(milliseconds(20));
  EXPECT_EQ(host.board.counters().restarts, 1U);
}

TEST(Restart, LosesWhatIsNotSaved) {
  Host host;
  msg::SetAdjVarsVal change;
  change.params.push_back({msg::VariableId::p_roll, 99});
  host.ask(change);
  host.ask(msg::MotorsOff{});
  host.ask(msg::SelectImu3{.imu_type = msg::SelectedImu::frame});
  host.ask(msg::ResetRequest{}, seconds(1));
  EXPECT_EQ(host.get<msg::RealtimeData3>(msg::RealtimeData3Request{}).cur_imu,
            msg::SelectedImu::main);
  EXPECT_NE(host.get<msg::ReadParams3>(msg::ReadParams3Request{}).axes.roll.p, 99);
  EXPECT_TRUE(host.board.gimbal().motors_on()) << "they are on after each start";
}

TEST(Restart, PowerOffLosesWhatWaitsToBeSent) {
  Host host;
  host.send(msg::BoardInfoRequest{});
  host.board.advance(host.now + milliseconds(10));
  host.board.restart(host.now + milliseconds(10));
  EXPECT_TRUE(host.board.output(host.port).empty());
  EXPECT_FALSE(answers(host));
}

/// The setting applies to all profiles, regardless of the profile it is written with.
std::uint8_t profile_after_restart(bool is_remembered, std::uint8_t written) {
  Host host;
  host.ask(msg::ExecuteMenu{.cmd_id = msg::MenuCommand::profile3});
  auto parameters = host.get<msg::ReadParams3>(msg::ReadParams3Request{.profile_id = written});
  parameters.general_flags1.set(msg::GeneralFlag::remember_last_used_profile, is_remembered);
  host.ask(msg::WriteParams3{parameters});
  host.ask(msg::ResetRequest{}, seconds(1));
  return host.get<msg::RealtimeData3>(msg::RealtimeData3Request{}).cur_profile;
}

TEST(Restart, TheLastProfileIsRememberedIfTheSettingsWantThat) {
  for (const std::uint8_t written : {std::uint8_t{0}, std::uint8_t{2}, std::uint8_t{4}}) {
    EXPECT_EQ(profile_after_restart(true, written), 2);
    EXPECT_EQ(profile_after_restart(false, written), 0);
  }
}

TEST(Restart, ANewBaudRateIsThatOfTheNextStart) {
  Host host;
  EXPECT_EQ(host.board.baud_rate(), 115200U);
  auto parameters = host.get<msg::ReadParams3>(msg::ReadParams3Request{});
  parameters.serial_speed = msg::SerialSpeed::baud_9600;
  host.ask(msg::WriteParams3{parameters});
  EXPECT_EQ(host.board.baud_rate(), 115200U);
  host.board.restart(host.now);
  EXPECT_EQ(host.board.baud_rate(), 9600U);
}

TEST(Restart, TheBaudRateIsThatOfTheBoardWhicheverProfileIsActive) {
  Host host;
  auto parameters = host.get<msg::ReadParams3>(msg::ReadParams3Request{.profile_id = 3});
  parameters.serial_speed = msg::SerialSpeed::baud_57600;
  host.ask(msg::WriteParams3{parameters});
  host.board.restart(host.now);
  EXPECT_EQ(host.board.baud_rate(), 57600U);
}

TEST(Restart, WhatIsWrittenIntoTheEepromHoldsFromTheNextStartOn) {
  Host host;
  msg::EepromWrite erase;
  erase.data.resize(64);
  for (auto& byte : erase.data) byte = 0xFF;
  auto parameters = host.get<msg::ReadParams3>(msg::ReadParams3Request{});
  const auto before = parameters.gyro_trust;
  parameters.gyro_trust = static_cast<std::uint8_t>(before + 1);
  host.ask(msg::WriteParams3{parameters});
  host.ask(erase);
  EXPECT_EQ(host.get<msg::ReadParams3>(msg::ReadParams3Request{}).gyro_trust, before + 1);
  host.ask(msg::ResetRequest{}, seconds(1));
  EXPECT_EQ(host.get<msg::ReadParams3>(msg::ReadParams3Request{}).gyro_trust, before);
}

}  // namespace
}  // namespace sbgc::test
