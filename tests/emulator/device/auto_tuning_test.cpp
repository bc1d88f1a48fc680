// Tests of automatic tuning: progress, results, and where they are stored.

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "replies.hpp"

namespace sbgc::test {
namespace {

using ::testing::IsEmpty;

constexpr msg::AutoPidFlags pitch_with_progress =
    msg::AutoPidFlag::pitch | msg::AutoPidFlag::send_gui;

msg::AutoPidRequest tune(msg::AutoPidFlags flags, std::uint8_t profile = 0,
                         std::uint8_t gain = 127) {
  return {.profile_id = profile, .cfg_flags = flags, .gain_vs_stability = gain};
}

msg::ReadParams3 parameters(Host& host, std::uint8_t profile) {
  return host.get<msg::ReadParams3>(msg::ReadParams3Request{.profile_id = profile});
}
msg::ReadParamsExt filters(Host& host, std::uint8_t profile) {
  return host.get<msg::ReadParamsExt>(msg::ReadParamsExtRequest{.profile_id = profile});
}

TEST(AutoTuning, ReportsTwiceASecondAndStoresWhatItFound) {
  Host host;
  const msg::ReadParams3 before = parameters(host, 0);
  EXPECT_TRUE(is_confirmed(host, tune(pitch_with_progress)));
  EXPECT_EQ(all<msg::AutoPid>(host.listen(seconds(4))).size(), 8U);
  const auto rest = all<msg::AutoPid>(host.listen(seconds(30)));
  ASSERT_FALSE(rest.empty());
  const msg::ReadParams3 after = parameters(host, 0);
  EXPECT_NE(after.axes.pitch, before.axes.pitch);
  EXPECT_EQ(after.axes.pitch.p, rest.back().p.pitch);
  EXPECT_EQ(after.axes.pitch.i.raw(), rest.back().i.pitch);
  EXPECT_EQ(after.axes.pitch.d, rest.back().d.pitch);
  EXPECT_EQ(after.axes.roll, before.axes.roll) << "not tuned";
  EXPECT_EQ(filters(host, 0).lpf_freq.pitch.raw(), rest.back().lpf_freq.pitch);
}

TEST(AutoTuning, GainsConverge) {
  Host host;
  host.ask(tune(pitch_with_progress));
  const auto rounds = all<msg::AutoPid>(host.listen(seconds(30)));
  ASSERT_GT(rounds.size(), 10U);
  const int last = rounds.back().p.pitch;
  int distance = 255;
  std::uint16_t number = 0;
  for (const msg::AutoPid& one : rounds) {
    EXPECT_EQ(one.iter_num, ++number);
    EXPECT_LE(std::abs(one.p.pitch - last), distance);
    distance = std::abs(one.p.pitch - last);
    EXPECT_GT(one.axes.pitch.tracking_error, 0);
    EXPECT_EQ(one.axes.roll.tracking_error, 0);
  }
  EXPECT_LT(rounds.back().axes.pitch.tracking_error, rounds.front().axes.pitch.tracking_error / 4);
  EXPECT_LT(rounds.front().p.pitch, last);
}

TEST(AutoTuning, NothingIsReportedUnlessAskedFor) {
  Host host;
  const msg::ReadParams3 before = parameters(host, 0);
  EXPECT_TRUE(is_confirmed(host, tune(msg::AutoPidFlag::roll)));
  EXPECT_THAT(host.listen(seconds(30)), IsEmpty());
  EXPECT_NE(parameters(host, 0).axes.roll, before.axes.roll);
}

TEST(AutoTuning, MoreGainForLessStability) {
  Host calm, bold;
  calm.ask(tune(msg::AutoPidFlag::yaw, 0, 0));
  bold.ask(tune(msg::AutoPidFlag::yaw, 0, 255));
  calm.listen(seconds(30));
  bold.listen(seconds(30));
  EXPECT_LT(parameters(calm, 0).axes.yaw.p, parameters(bold, 0).axes.yaw.p);
}

TEST(AutoTuning, CanBeginWithThePresentGains) {
  Host host;
  const msg::ReadParams3 before = parameters(host, 0);
  host.ask(tune(pitch_with_progress | msg::AutoPidFlag::keep_current));
  const auto rounds = all<msg::AutoPid>(host.listen(seconds(1)));
  ASSERT_FALSE(rounds.empty());
  EXPECT_NEAR(rounds.front().d.pitch, before.axes.pitch.d, 6);
}

TEST(AutoTuning, FiltersAreTunedOnDemand) {
  Host host;
  const auto before = filters(host, 0).lpf_freq;
  host.ask(tune(msg::AutoPidFlag::pitch | msg::AutoPidFlag::tune_lpf_freq));
  host.listen(seconds(40));
  const auto after = filters(host, 0).lpf_freq;
  EXPECT_NE(after.pitch, before.pitch);
  EXPECT_EQ(after.roll, before.roll);
}

TEST(AutoTuning, SwitchesToTheProfileAndTunesNoOther) {
  Host host;
  const msg::ReadParams3 first = parameters(host, 0);
  const msg::ReadParams3 third = parameters(host, 2);
  EXPECT_TRUE(is_confirmed(host, tune(msg::AutoPidFlag::pitch, 2)));
  EXPECT_EQ(host.board.memory().profile, 2);
  host.listen(seconds(30));
  EXPECT_NE(parameters(host, 2).axes.pitch, third.axes.pitch);
  EXPECT_EQ(parameters(host, 0).axes.pitch, first.axes.pitch);
}

TEST(AutoTuning, AllProfilesGetTheResultOnDemand) {
  Host host;
  host.ask(tune(msg::AutoPidFlag::pitch | msg::AutoPidFlag::all_profiles, 1));
  host.listen(seconds(30));
  const auto found = parameters(host, 1).axes.pitch;
  for (std::uint8_t profile = 0; profile < 5; ++profile) {
    EXPECT_EQ(parameters(host, profile).axes.pitch.p, found.p);
    EXPECT_EQ(parameters(host, profile).axes.pitch.d, found.d);
  }
}

TEST(AutoTuning, StopKeepsNothing) {
  Host host;
  const msg::ReadParams3 before = parameters(host, 0);
  host.ask(tune(pitch_with_progress));
  host.listen(seconds(3));
  EXPECT_EQ(confirmations<msg::AutoPidRequest>(host.ask(tune({}))), 1);
  EXPECT_THAT(host.listen(seconds(30)), IsEmpty());
  EXPECT_EQ(parameters(host, 0), before);
}

TEST(AutoTuning, WhatMakesNoSenseIsRefused) {
  Host host;
  EXPECT_EQ(refusal(host, tune(msg::AutoPidFlag::pitch, 5)), msg::BoardErrorCode::wrong_params);
  EXPECT_EQ(refusal(host, tune(msg::AutoPidFlag::send_gui)), msg::BoardErrorCode::wrong_params);
  EXPECT_TRUE(is_confirmed(host, tune(msg::AutoPidFlag::pitch)));
  EXPECT_EQ(refusal(host, tune(msg::AutoPidFlag::pitch)), msg::BoardErrorCode::wrong_state);
  EXPECT_EQ(refusal(host, msg::CalibGyro{}), msg::BoardErrorCode::wrong_state);
}

TEST(AutoTuning, NeedsMotors) {
  Host host;
  host.ask(msg::MotorsOff{});
  EXPECT_EQ(refusal(host, tune(msg::AutoPidFlag::pitch, 3)), msg::BoardErrorCode::wrong_state);
  EXPECT_EQ(host.board.memory().profile, 0) << "nothing happens";
}

TEST(AutoTuning, EndsWithoutMotors) {
  Host host;
  const msg::ReadParams3 before = parameters(host, 0);
  host.ask(tune(pitch_with_progress));
  host.listen(seconds(2));
  host.ask(msg::MotorsOff{});
  EXPECT_THAT(host.listen(seconds(30)), IsEmpty());
  EXPECT_EQ(parameters(host, 0), before);
}

TEST(AutoTuning, TheMenuTunesAsTheSettingsSay) {
  Host host;
  const msg::ReadParams3 before = parameters(host, 0);
  host.ask(msg::ExecuteMenu{.cmd_id = msg::MenuCommand::auto_pid});
  EXPECT_THAT(host.listen(seconds(60)), IsEmpty());
  const msg::ReadParams3 after = parameters(host, 0);
  for (std::size_t axis = 0; axis < 3; ++axis) EXPECT_NE(after.axes[axis], before.axes[axis]);
}

TEST(AutoTuning, AHostThatHasLeftGetsNothing) {
  Host host;
  host.ask(tune(pitch_with_progress));
  host.board.close_port(host.port);
  ASSERT_EQ(host.board.open_port(), host.port);
  EXPECT_THAT(host.listen(seconds(30)), IsEmpty());
}

TEST(AutoTuning, TheSameSeedFindsTheSame) {
  Host one, two;
  for (Host* host : {&one, &two}) {
    host->ask(tune(msg::AutoPidFlag::pitch));
    host->listen(seconds(30));
  }
  EXPECT_EQ(parameters(one, 0), parameters(two, 0));
  emulator::BoardOptions other;
  other.gimbal.seed = 77;
  Host three(other);
  three.ask(tune(msg::AutoPidFlag::pitch));
  three.listen(seconds(30));
  EXPECT_NE(parameters(one, 0), parameters(three, 0));
}

}  // namespace
}  // namespace sbgc::test
