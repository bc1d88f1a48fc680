// Tests of slots: RC signals that start actions and change variables.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "replies.hpp"

namespace sbgc::test {
namespace {

using emulator::BoardOptions;

msg::RcMap channel(std::uint8_t number) {
  msg::RcMap result;
  EXPECT_TRUE(result.set_source(msg::RcSource::api) && result.set_channel(number));
  return result;
}

/// Returns one trigger slot on channel 1 and one analog slot on channel 2.
msg::WriteAdjVarsCfg config() {
  msg::WriteAdjVarsCfg result;
  result.trigger_slots[0] = {
      channel(1),
      {msg::MenuCommand::profile1, msg::MenuCommand::profile2, msg::MenuCommand::none,
       msg::MenuCommand::profile4, msg::MenuCommand::profile5}};
  result.analog_slots[0] = {channel(2), msg::VariableId::p_pitch, 0, 255};
  return result;
}

/// Sets both channels, in counts of -500..500, and lets the board process them.
void move(Host& host, std::int16_t first, std::int16_t second) {
  msg::ApiVirtChControl request;
  while (request.val_ch.push_back(msg::CentredRcSignal(msg::ApiVirtChControl::undefined))) {
  }
  request.val_ch[0] = msg::CentredRcSignal(first);
  request.val_ch[1] = msg::CentredRcSignal(second);
  host.ask(request, milliseconds(100));
}

msg::AdjVarsState state(Host& host) {
  return host.get<msg::AdjVarsState>(msg::AdjVarsStateRequest{.trigger_slot = 0, .analog_slot = 0});
}

std::int32_t p_of_pitch(Host& host) {
  return host
      .get<msg::ReadParams3>(msg::ReadParams3Request{.profile_id = host.board.memory().profile})
      .axes.pitch.p;
}

constexpr std::int16_t none = msg::ApiVirtChControl::undefined;

TEST(TriggerSlots, FiveLevelsStartTheirActions) {
  Host host;
  ASSERT_TRUE(is_confirmed(host, config()));
  move(host, 500, none);
  EXPECT_EQ(host.board.memory().profile, 4);
  move(host, 200, none);
  EXPECT_EQ(host.board.memory().profile, 3);
  move(host, 0, none);
  EXPECT_EQ(host.board.memory().profile, 3) << "the middle does nothing";
  move(host, -200, none);
  EXPECT_EQ(host.board.memory().profile, 1);
  move(host, -500, none);
  EXPECT_EQ(host.board.memory().profile, 0);
}

TEST(TriggerSlots, OnlyAChangeOfTheLevelActs) {
  Host host;
  host.ask(config());
  move(host, 500, none);
  host.ask(msg::ExecuteMenu{.cmd_id = msg::MenuCommand::profile3});
  move(host, 450, none);
  host.listen(seconds(5));
  EXPECT_EQ(host.board.memory().profile, 2);
  move(host, none, none);
  EXPECT_EQ(host.board.memory().profile, 2) << "a lost signal starts nothing";
  move(host, 500, none);
  EXPECT_EQ(host.board.memory().profile, 4) << "a regained signal does";
}

TEST(AnalogSlots, TheSignalIsTheVariable) {
  Host host;
  host.ask(config());
  move(host, none, -500);
  EXPECT_EQ(p_of_pitch(host), 0);
  move(host, none, 500);
  EXPECT_EQ(p_of_pitch(host), 255);
  move(host, none, 0);
  EXPECT_NEAR(p_of_pitch(host), 127, 1);
}

TEST(AnalogSlots, PartOfTheRange) {
  Host host;
  msg::WriteAdjVarsCfg part = config();
  part.analog_slots[0] = {channel(2), msg::VariableId::rc_trim_roll, 51, 204};
  host.ask(part);
  const auto trim = [&] {
    return host.get<msg::ReadParams3>(msg::ReadParams3Request{}).rc_trim.roll;
  };
  move(host, none, -500);
  EXPECT_NEAR(trim(), -127 + 254 / 5, 1);
  move(host, none, 500);
  EXPECT_NEAR(trim(), 127 - 254 / 5, 1);
  std::swap(part.analog_slots[0].min_val, part.analog_slots[0].max_val);
  host.ask(part, milliseconds(100));
  EXPECT_NEAR(trim(), -127 + 254 / 5, 1) << "the other way round";
}

TEST(AnalogSlots, AHostMaySetTheVariableToo) {
  Host host;
  host.ask(config());
  move(host, none, 500);
  msg::SetAdjVarsVal request;
  request.params.push_back({msg::VariableId::p_pitch, 99});
  EXPECT_TRUE(is_confirmed(host, request));
  host.listen(seconds(1));
  EXPECT_EQ(p_of_pitch(host), 99) << "until the signal changes";
  move(host, none, -500);
  EXPECT_EQ(p_of_pitch(host), 0);
}

TEST(AnalogSlots, NothingIsSavedByItself) {
  Host host;
  const int before = p_of_pitch(host);
  host.ask(config());
  move(host, none, 500);
  host.board.restart(host.now);
  host.listen(seconds(1));
  EXPECT_EQ(p_of_pitch(host), before);
}

TEST(Slots, StateIsReported) {
  Host host;
  EXPECT_EQ(state(host), msg::AdjVarsState{});
  host.ask(config());
  move(host, 450, -500);
  const msg::AdjVarsState now = state(host);
  EXPECT_EQ(now.trigger_rc_data, msg::CentredRcSignal(450));
  EXPECT_EQ(now.trigger_action, msg::MenuCommand::profile5);
  EXPECT_EQ(now.analog_rc_data, msg::CentredRcSignal(-500));
  EXPECT_EQ(now.analog_value, 0);
  move(host, 450, 500);
  EXPECT_EQ(state(host).analog_value, 255);
}

TEST(Slots, LaterFirmwareAsksWithMoreBytes) {
  BoardOptions options;
  options.firmware = msg::FirmwareVersion(2680);
  Host host(options);
  host.ask(config());
  move(host, 450, 500);
  const msg::AdjVarsStateRequestExt request{.trigger_slot = 0,
                                            .analog_src_id = msg::RcMap(msg::RcInput{}).raw(),
                                            .analog_var_id = msg::VariableId::p_pitch,
                                            .lut_src_id = channel(1).raw(),
                                            .lut_var_id = msg::VariableId::p_roll};
  const auto answer = host.get<msg::AdjVarsStateExt>(request);
  EXPECT_EQ(answer.trigger_rc_data.raw(), 450 * 16384 / 500 + 1) << "in high resolution";
  EXPECT_EQ(answer.analog_src_value.raw(), 0) << "no signal";
  const auto parameters = host.get<msg::ReadParams3>(msg::ReadParams3Request{.profile_id = 255});
  EXPECT_EQ(answer.analog_var_value, static_cast<float>(parameters.axes.pitch.p));
  EXPECT_EQ(answer.lut_src_value.raw(), 450 * 16384 / 500 + 1);
  EXPECT_EQ(answer.lut_var_value, static_cast<float>(parameters.axes.roll.p));
}

TEST(Slots, OnlyThoseThatExist) {
  Host host;
  EXPECT_EQ(refusal(host, msg::AdjVarsStateRequest{.trigger_slot = 10}),
            msg::BoardErrorCode::wrong_params);
  EXPECT_EQ(refusal(host, msg::AdjVarsStateRequest{.analog_slot = 15}),
            msg::BoardErrorCode::wrong_params);
  EXPECT_EQ(
      host.get<msg::AdjVarsState>(msg::AdjVarsStateRequest{.trigger_slot = 9, .analog_slot = 14}),
      msg::AdjVarsState{});
}

TEST(Slots, ARestartForgetsWhatTheySaw) {
  Host host;
  host.ask(config());
  move(host, 450, none);
  host.board.restart(host.now);
  host.listen(seconds(1));
  EXPECT_EQ(state(host).trigger_action, msg::MenuCommand::none);
  move(host, -500, none);
  EXPECT_EQ(host.board.memory().profile, 0) << "the configuration is preserved";
  EXPECT_EQ(state(host).trigger_action, msg::MenuCommand::profile1);
}

}  // namespace
}  // namespace sbgc::test
