// Tests of adjustable variables: writing, reading, losing and saving them.

#include <cmath>
#include <initializer_list>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sbgc/meta/variables.hpp>

#include "replies.hpp"

namespace sbgc::test {
namespace {

msg::SetAdjVarsVal setting(std::initializer_list<msg::AdjVarValue> values) {
  msg::SetAdjVarsVal request;
  for (const msg::AdjVarValue& one : values) request.params.push_back(one);
  return request;
}

std::int32_t value(Host& host, msg::VariableId id) {
  msg::GetAdjVarsVal request;
  request.param_id.push_back(id);
  const auto answer = host.get<msg::SetAdjVarsVal>(request);
  EXPECT_EQ(answer.params.size(), 1U);
  return answer.params.empty() ? 0 : answer.params[0].param_value;
}

std::uint8_t p_of_pitch(Host& host) {
  return host.get<msg::ReadParams3>(msg::ReadParams3Request{}).axes.pitch.p;
}

TEST(Variables, AreTheSettingsTheyStandFor) {
  Host host;
  EXPECT_EQ(value(host, msg::VariableId::p_pitch), p_of_pitch(host));
  EXPECT_TRUE(is_confirmed(
      host, setting({{msg::VariableId::p_pitch, 77}, {msg::VariableId::rc_trim_yaw, -5}})));
  EXPECT_EQ(value(host, msg::VariableId::p_pitch), 77);
  EXPECT_EQ(value(host, msg::VariableId::rc_trim_yaw), -5);
  EXPECT_EQ(p_of_pitch(host), 77);
}

TEST(Variables, AreLostUnlessSaved) {
  Host host;
  const int before = p_of_pitch(host);
  host.ask(setting({{msg::VariableId::p_pitch, 77}}));
  host.board.restart(host.now);
  host.listen(seconds(1));
  EXPECT_EQ(p_of_pitch(host), before);

  host.ask(setting({{msg::VariableId::p_pitch, 77}}));
  EXPECT_TRUE(is_confirmed(host, msg::SaveParams3{}));
  host.board.restart(host.now);
  host.listen(seconds(1));
  EXPECT_EQ(p_of_pitch(host), 77);
}

TEST(Variables, AreNotSavedByWhatStoresOtherSettings) {
  const auto lost_after = [](const auto& request) {
    Host host;
    const int before = p_of_pitch(host);
    host.ask(setting({{msg::VariableId::p_pitch, 77}}));
    host.ask(request, seconds(30));
    EXPECT_EQ(p_of_pitch(host), 77);
    host.board.restart(host.now);
    host.listen(seconds(1));
    EXPECT_EQ(p_of_pitch(host), before);
  };
  lost_after(msg::ExecuteMenu{msg::MenuCommand::set_angle});
  lost_after(msg::CalibPoles{});
  lost_after(msg::CalibExtGain{});
  lost_after(msg::CalibOffset{});
  lost_after(msg::AutoPidRequest{.cfg_flags = msg::AutoPidFlag::roll, .gain_vs_stability = 127});
}

TEST(Variables, AllOrNone) {
  Host host;
  const int p = value(host, msg::VariableId::p_pitch);
  EXPECT_EQ(refusal(host, setting({{msg::VariableId::p_pitch, p + 1}, {msg::VariableId{200}, 1}})),
            msg::BoardErrorCode::wrong_params);
  EXPECT_EQ(value(host, msg::VariableId::p_pitch), p);
  EXPECT_EQ(refusal(host, setting({{msg::VariableId::p_pitch, p + 1},
                                   {msg::VariableId::follow_mode, 3}})),
            msg::BoardErrorCode::wrong_params);
  EXPECT_EQ(value(host, msg::VariableId::p_pitch), p);
  EXPECT_EQ(refusal(host, setting({})), msg::BoardErrorCode::wrong_params);
}

TEST(Variables, NoneAlsoWhereTheSettingsGoBeyondTheVariable) {
  Host host;
  auto parameters = host.get<msg::ReadParamsExt>(msg::ReadParamsExtRequest{});
  parameters.lpf_freq.pitch = 800_Hz;
  host.ask(msg::WriteParamsExt{parameters});
  EXPECT_EQ(
      refusal(host, setting({{msg::VariableId::lpf_freq_pitch, 100}, {msg::VariableId{200}, 1}})),
      msg::BoardErrorCode::wrong_params);
  EXPECT_EQ(host.get<msg::ReadParamsExt>(msg::ReadParamsExtRequest{}).lpf_freq.pitch,
            parameters.lpf_freq.pitch);
  EXPECT_EQ(value(host, msg::VariableId::lpf_freq_pitch), 800);
}

TEST(Variables, EveryOneCanBeSetToBothEnds) {
  Host host(newest_board());
  for (const VariableInfo& one : variables) {
    for (const double end : {one.range.lowest, one.range.highest}) {
      const auto wanted = static_cast<std::int32_t>(end);
      EXPECT_TRUE(is_confirmed(host, setting({{one.id, wanted}}))) << one.name;
      EXPECT_EQ(value(host, one.id), wanted) << one.name;
    }
    const auto beyond = static_cast<std::int32_t>(one.range.highest) + 1;
    EXPECT_EQ(refusal(host, setting({{one.id, beyond}})), msg::BoardErrorCode::wrong_params)
        << one.name;
  }
}

TEST(Variables, OnlyKnownOnesAreAnswered) {
  Host host;
  msg::GetAdjVarsVal request;
  EXPECT_EQ(refusal(host, request), msg::BoardErrorCode::wrong_params) << "none";
  request.param_id.push_back(msg::VariableId::p_roll);
  request.param_id.push_back(msg::VariableId{200});
  EXPECT_EQ(refusal(host, request), msg::BoardErrorCode::wrong_params);
}

TEST(Variables, TheHeadingDriftsAsTheyCorrectIt) {
  emulator::BoardOptions options;
  options.gimbal.noise = 0;
  Host plain(options), corrected(options);
  plain.ask(setting({{msg::VariableId::gyro_heading_correction, 0}}));
  corrected.ask(setting({{msg::VariableId::gyro_heading_correction, 4000}}));
  for (Host* host : {&plain, &corrected}) host->listen(seconds(60));
  EXPECT_GT(std::abs(plain.board.gimbal().sample(plain.now).joints.yaw -
                     corrected.board.gimbal().sample(corrected.now).joints.yaw),
            1);
}

TEST(Variables, TheGimbalFeelsThem) {
  Host host;
  host.ask(setting({{msg::VariableId::power_pitch, 0}}));
  host.listen(seconds(1));
  EXPECT_EQ(host.board.gimbal().sample(host.now).power.pitch, 0);
}

}  // namespace
}  // namespace sbgc::test
