// Tests of automatic tuning: progress and results.

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "replies.hpp"

namespace sbgc::test {
namespace {

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
