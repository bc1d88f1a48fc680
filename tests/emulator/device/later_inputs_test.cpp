// Tests of inputs, outputs and variables of later firmware.

#include <cmath>
#include <cstdint>
#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sbgc/meta/variables.hpp>

#include "device/device.hpp"
#include "replies.hpp"

namespace sbgc::test {
namespace {

using ::testing::ElementsAre;

msg::RcMap virtual_channel(std::uint8_t number) {
  msg::RcMap result;
  EXPECT_TRUE(result.set_source(msg::RcSource::api) && result.set_channel(number));
  return result;
}

TEST(RcInputs, ReadTheVirtualChannels) {
  Host host(newest_board());
  msg::ApiVirtChHighRes channels;
  channels.val_ch.push_back(msg::FineRcSignal(12'345));
  channels.val_ch.push_back(msg::FineRcSignal(-16'384));
  channels.val_ch.push_back(msg::FineRcSignal(-32'768));
  EXPECT_THAT(host.ask(channels), ::testing::IsEmpty());
  msg::ReadRcInputsRequest request;
  for (const std::uint8_t number : {std::uint8_t{2}, std::uint8_t{1}, std::uint8_t{3}}) {
    request.rc_src.push_back(virtual_channel(number));
  }
  request.rc_src.push_back(msg::RcMap(msg::RcInput::rc_input_roll));
  const auto answer = host.get<msg::ReadRcInputs>(request);
  EXPECT_THAT(answer.rc_val, ElementsAre(msg::FineRcSignal(-16'384), msg::FineRcSignal(12'345),
                                         msg::FineRcSignal(-32'768), msg::FineRcSignal(-32'768)))
      << "the last two are undefined";
}

TEST(Servos, OnlyTheSelectedOnesChange) {
  emulator::Device device(newest_board(), {}, {});
  msg::ServoOut first;
  first.servo_time = {msg::ServoPulse(1000), msg::ServoPulse(1100), msg::ServoPulse(-1),
                      msg::ServoPulse(-1),   msg::ServoPulse(-1),   msg::ServoPulse(-1),
                      msg::ServoPulse(-1),   msg::ServoPulse(-1)};
  ASSERT_TRUE(device.outputs.set_servos(device.parameters, first));
  msg::ServoOutExt request;
  request.servo_bits = msg::ServoOutput::servo2 | msg::ServoOutput::can_drv7_servo2;
  request.servo_time.push_back(msg::ServoPulse(1500));
  request.servo_time.push_back(msg::ServoPulse(1600));
  EXPECT_TRUE(device.outputs.set_servos(device.parameters, request));
  EXPECT_EQ(device.outputs.servo(0), msg::ServoPulse(1000));
  EXPECT_EQ(device.outputs.servo(1), msg::ServoPulse(1500));
  EXPECT_EQ(device.outputs.driver_servo(13), msg::ServoPulse(1600));
  request.servo_time[0] = msg::ServoPulse(20'000);
  EXPECT_FALSE(device.outputs.set_servos(device.parameters, request)) << "longer than the period";
  EXPECT_EQ(device.outputs.servo(1), msg::ServoPulse(1500));
}

TEST(VariablePages, ListEveryVariableOnce) {
  Host host(newest_board());
  const auto total = host.get<msg::BoardInfo3>(msg::BoardInfo3Request{}).adj_vars_total_num;
  EXPECT_EQ(total, std::size(variables));
  std::set<msg::VariableId> found;
  msg::AdjVarsInfoRequest request;
  for (int page = 0; page < 20 && found.size() < total; ++page) {
    const auto info = host.get<msg::AdjVarsInfo>(request);
    ASSERT_EQ(info.total_number, total);
    ASSERT_FALSE(info.vars.empty());
    for (const msg::AdjVarInfo& one : info.vars) {
      EXPECT_TRUE(found.insert(one.var_id).second);
      EXPECT_LE(one.name.size(), 16U);
      EXPECT_LE(one.range_min, one.range_max);
    }
    request.start_id = static_cast<msg::VariableId>(static_cast<unsigned>(*found.rbegin()) + 1);
  }
  EXPECT_EQ(found.size(), total);
}

TEST(FloatVariables, SetAllOrNone) {
  Host host(newest_board());
  msg::SetAdjVarsValF request;
  request.params.push_back({msg::VariableId::p_roll, 41.6F});
  request.params.push_back({msg::VariableId::p_pitch, 300.0F});
  EXPECT_EQ(refusal(host, request), msg::BoardErrorCode::wrong_params) << "out of range";
  const auto p = [&] { return host.get<msg::ReadParams3>(msg::ReadParams3Request{}).axes.roll.p; };
  EXPECT_NE(p(), 42);
  request.params[1].value = 20;
  EXPECT_TRUE(is_confirmed(host, request));
  EXPECT_EQ(p(), 42);
  request.params[0].value = NAN;
  EXPECT_EQ(refusal(host, request), msg::BoardErrorCode::wrong_params);
}

TEST(SaveParameters, OnlyTheNamedVariables) {
  Host host(newest_board());
  msg::SetAdjVarsVal change;
  change.params.push_back({msg::VariableId::p_roll, 71});
  change.params.push_back({msg::VariableId::p_pitch, 72});
  host.ask(change);
  msg::SaveParams3 save;
  save.param_id.push_back(msg::VariableId::p_pitch);
  EXPECT_TRUE(is_confirmed(host, save));
  host.board.restart(host.now);
  host.listen(seconds(1));
  const auto parameters = host.get<msg::ReadParams3>(msg::ReadParams3Request{});
  EXPECT_NE(parameters.axes.roll.p, 71);
  EXPECT_EQ(parameters.axes.pitch.p, 72);
}

TEST(Signatures, DependOnBoardKeysAndMessage) {
  Host host(newest_board());
  msg::SignMessageRequest request{.sign_type = 1};
  const auto first = host.get<msg::SignMessage>(request).signature;
  EXPECT_EQ(host.get<msg::SignMessage>(request).signature, first);
  request.message[31] = 1;
  EXPECT_NE(host.get<msg::SignMessage>(request).signature, first);
  request.message[31] = 0;
  request.sign_type = 2;
  EXPECT_NE(host.get<msg::SignMessage>(request).signature, first);
  auto options = newest_board();
  options.device_id[0] = 0x11;
  Host other(options);
  request.sign_type = 1;
  EXPECT_NE(other.get<msg::SignMessage>(request).signature, first);
}

TEST(Calibrations, OfLaterFirmwareStoreTheirResult) {
  Host host(newest_board());
  const auto parameters = [&] {
    return host.get<msg::ReadParamsExt2>(msg::ReadParamsExt2Request{});
  };
  const auto before = parameters();
  EXPECT_EQ(confirmations<msg::CalibOrientCorr>(host.ask(msg::CalibOrientCorr{}, seconds(15))), 1);
  EXPECT_NE(parameters().imu_orientation_corr, before.imu_orientation_corr);
  EXPECT_EQ(confirmations<msg::CalibAccExtRef>(host.ask(msg::CalibAccExtRef{}, seconds(5))), 1);
  msg::CalibInfoRequest request{.imu_type = msg::SelectedImu::main};
  EXPECT_EQ(host.get<msg::CalibInfo>(request).acc_limits_info.raw(), 0x3F) << "all directions";
  host.ask(msg::ExecuteMenu{msg::MenuCommand::calib_momentum}, seconds(15));
  EXPECT_NE(parameters().momentum, before.momentum);
}

TEST(AutoPid2, TunesTheEnabledAxes) {
  Host host(newest_board());
  const auto gains = [&] {
    const auto parameters = host.get<msg::ReadParams3>(msg::ReadParams3Request{});
    return std::pair(parameters.axes.roll, parameters.axes.yaw);
  };
  const auto before = gains();
  msg::AutoPid2 request{.action = msg::AutoPid2Action::start};
  request.config = msg::AutoPid2Config{};
  EXPECT_EQ(refusal(host, request), msg::BoardErrorCode::wrong_params) << "no axis";
  request.config->axes.roll.axis_flags.set_enabled(true);
  request.config->axes.roll.gain = 100;
  EXPECT_TRUE(is_confirmed(host, request));
  EXPECT_EQ(host.get<msg::RealtimeData4>(msg::RealtimeData4Request{}).calib_mode,
            msg::CalibMode::auto_pid);
  host.listen(seconds(30));
  EXPECT_NE(gains().first, before.first);
  EXPECT_EQ(gains().second, before.second);
}

}  // namespace
}  // namespace sbgc::test
