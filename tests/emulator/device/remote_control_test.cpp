// Tests of RC signals, virtual channels and a flight controller, and their effect on the axes.

#include <algorithm>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "control_requests.hpp"
#include "host.hpp"
#include "random_requests.hpp"

namespace sbgc::test {
namespace {

using ::testing::IsEmpty;
using ::testing::SizeIs;

/// Sets the parameters so that an API channel controls pitch.
void map_pitch(Host& host, int channel, msg::RcModeKind mode = msg::RcModeKind::angle) {
  auto parameters = host.get<msg::ReadParams3>(msg::ReadParams3Request{});
  parameters.rc_map.pitch.set_source(msg::RcSource::api);
  parameters.rc_map.pitch.set_channel(static_cast<std::uint8_t>(channel));
  parameters.rc.pitch.rc_mode.set_mode(mode);
  parameters.rc_trim = {};
  parameters.rc_deadband = 0;
  parameters.rc_expo_rate = 0;
  host.ask(msg::WriteParams3{parameters});
}

msg::ApiVirtChControl channels(std::size_t channel, std::int16_t signal) {
  msg::ApiVirtChControl request;
  while (request.val_ch.push_back(msg::CentredRcSignal(msg::ApiVirtChControl::undefined))) {
  }
  request.val_ch[channel - 1] = msg::CentredRcSignal(signal);
  return request;
}

TEST(RemoteControl, VirtualChannelsControlTheCamera) {
  Host host;
  map_pitch(host, 5);
  EXPECT_THAT(host.ask(channels(5, 500)), IsEmpty()) << "it is sent often, so it is not confirmed";
  host.listen(seconds(8));
  const auto parameters = host.get<msg::ReadParams3>(msg::ReadParams3Request{});
  const auto angles = host.get<msg::GetAngles>(msg::GetAnglesRequest{});
  EXPECT_NEAR(angles.axes.pitch.rc_target_angle.degrees(),
              parameters.rc.pitch.rc_max_angle.degrees(), 1);
}

TEST(RemoteControl, ReportsInputsWithoutASignal) {
  Host host;
  constexpr msg::RcSignal no_signal(-10'000);
  const auto is_silent = [&](const auto& data) {
    return data.rc == Axes<msg::RcSignal>{no_signal, no_signal, no_signal} &&
           data.rc_cmd == no_signal;
  };
  const auto live = host.get<msg::RealtimeData3>(msg::RealtimeData3Request{});
  EXPECT_TRUE(is_silent(live)) << "no receiver is connected";
  EXPECT_TRUE(is_silent(host.get<msg::RealtimeData4>(msg::RealtimeData4Request{})));
  EXPECT_EQ(live.ext_fc_roll, msg::RcSignal(0)) << "no input serves a flight controller";

  auto parameters = host.get<msg::ReadParams3>(msg::ReadParams3Request{});
  parameters.rc_map_fc_roll = msg::RcInput::ext_fc_input_roll;
  host.ask(msg::WriteParams3{parameters});
  const auto mapped = host.get<msg::RealtimeData3>(msg::RealtimeData3Request{});
  EXPECT_EQ(mapped.ext_fc_roll, no_signal);
  EXPECT_EQ(mapped.ext_fc_pitch, msg::RcSignal(0));
}

TEST(RemoteControl, ChannelsThatAreNotSentKeepTheirSignals) {
  Host host;
  map_pitch(host, 5);
  const auto signal = [&] {
    return host.get<msg::RealtimeData3>(msg::RealtimeData3Request{}).rc.pitch;
  };
  host.ask(channels(5, 250));
  EXPECT_EQ(signal(), msg::RcSignal(1750));
  // 31 channels, as the vendor's library sends them; then 4; then 5.
  for (const auto& [count, expected] :
       {std::pair{31U, 1400}, std::pair{4U, 1400}, std::pair{5U, 1500}}) {
    msg::ApiVirtChControl request;
    for (unsigned i = 0; i < count; ++i) {
      request.val_ch.push_back(msg::CentredRcSignal(count == 31 ? -100 : 0));
    }
    EXPECT_THAT(host.ask(request), IsEmpty());
    EXPECT_EQ(signal(), msg::RcSignal(static_cast<std::int16_t>(expected))) << count;
  }
}

TEST(RemoteControl, NoChannelsAndTooManyAreRefused) {
  Host host;
  for (const std::size_t size : {0U, 1U, 63U, 66U}) {
    host.send_bytes(frame_of(45, std::vector<std::uint8_t>(size)));
    const auto errors = all<msg::ErrorExt>(host.listen(milliseconds(20)));
    ASSERT_THAT(errors, SizeIs(1)) << size;
    EXPECT_EQ(errors[0].error_code, msg::BoardErrorCode::cmd_size);
  }
}

/// Returns the pitch speed that results from the signals, relative to RC_SPEED. Precondition: the
/// signals control speeds.
double control(Host& host, const msg::ApiVirtChControl& signals) {
  host.ask(signals, seconds(1));
  const double full = host.get<msg::ReadParams3>(msg::ReadParams3Request{}).rc.pitch.rc_speed;
  return host.board.gimbal().sample(host.now).target_speeds.pitch / full;
}

TEST(RemoteControl, TheDeadBandLeavesTheEndsOfTheStick) {
  Host host;
  map_pitch(host, 5, msg::RcModeKind::speed);
  auto parameters = host.get<msg::ReadParams3>(msg::ReadParams3Request{});
  parameters.rc_deadband = 100;
  host.ask(msg::WriteParams3{parameters});
  EXPECT_EQ(control(host, channels(5, 100)), 0);
  EXPECT_NEAR(control(host, channels(5, 300)), 0.5, 1e-9);
  EXPECT_EQ(control(host, channels(5, 500)), 1);
  EXPECT_EQ(control(host, channels(5, -500)), -1);
}

TEST(RemoteControl, SignalsAreBentAsTheSettingsSay) {
  Host host;
  map_pitch(host, 5, msg::RcModeKind::speed);
  const auto plain = host.get<msg::ReadParams3>(msg::ReadParams3Request{});
  auto signals = channels(5, 250);
  signals.val_ch[5] = msg::CentredRcSignal(400);
  const auto bent = [&](auto&& change) {
    auto parameters = plain;
    change(parameters);
    host.ask(msg::WriteParams3{parameters});
    const double result = control(host, signals);
    const auto shown = host.get<msg::RealtimeData3>(msg::RealtimeData3Request{}).rc.pitch;
    EXPECT_EQ(shown, signals.val_ch[4].raw() == 250 ? msg::RcSignal(1750) : msg::RcSignal(-10'000))
        << "live data contain the raw signal";
    return result;
  };
  EXPECT_NEAR(bent([](msg::ReadParams3&) {}), 0.5, 1e-9);
  EXPECT_NEAR(bent([](msg::ReadParams3& to) { to.rc.pitch.rc_mode.set_inverted(true); }), -0.5,
              1e-9);
  EXPECT_NEAR(bent([](msg::ReadParams3& to) { to.rc_trim.pitch = -50; }), 0.4, 1e-9);
  EXPECT_NEAR(bent([](msg::ReadParams3& to) { to.rc_expo_rate = 100; }), 0.125, 1e-9);
  const auto mix = [](std::uint8_t rate) {
    return [rate](msg::ReadParams3& to) {
      to.rc_map_fc_roll.set_source(msg::RcSource::api);
      to.rc_map_fc_roll.set_channel(6);
      to.rc_mix_fc_roll.set_target(msg::MixTarget::pitch);
      to.rc_mix_fc_roll.set_rate(rate);
      to.ext_fc_gain_roll = 127;
    };
  };
  EXPECT_NEAR(bent(mix(0)), 0.5, 1e-9);
  EXPECT_NEAR(bent(mix(32)), 0.65, 0.01) << "half and half";
  EXPECT_NEAR(bent(mix(63)), 0.8, 1e-9);
  // A flight controller controls an axis without a signal of its own.
  signals.val_ch[4] = msg::CentredRcSignal(msg::ApiVirtChControl::undefined);
  EXPECT_NEAR(bent(mix(63)), 0.8, 1e-9);
  EXPECT_NEAR(bent(mix(32)), 0.4, 0.01) << "as if the missing signal were centered";
  EXPECT_EQ(bent(mix(0)), 0);
}

/// Sets the parameters so that the flight controller's signals are API channels 6 and 7, and roll
/// and pitch follow it.
void follow_controller(Host& host, int roll_percent, int pitch_percent) {
  auto parameters = host.get<msg::ReadParams3>(msg::ReadParams3Request{});
  parameters.follow_mode = msg::FollowMode::fc;
  parameters.follow_deadband = 0;
  parameters.rc_map_fc_roll.set_source(msg::RcSource::api);
  parameters.rc_map_fc_roll.set_channel(6);
  parameters.rc_map_fc_pitch.set_source(msg::RcSource::api);
  parameters.rc_map_fc_pitch.set_channel(7);
  parameters.ext_fc_gain_roll = 127;
  parameters.ext_fc_gain_pitch = -127;
  parameters.rc.roll.rc_follow = static_cast<std::int8_t>(roll_percent);
  parameters.rc.pitch.rc_follow = static_cast<std::int8_t>(pitch_percent);
  parameters.rc.yaw.rc_follow = 100;
  host.ask(msg::WriteParams3{parameters});
}

msg::ApiVirtChControl controller_signals(std::int16_t roll, std::int16_t pitch) {
  msg::ApiVirtChControl request = channels(6, roll);
  request.val_ch[6] = msg::CentredRcSignal(pitch);
  return request;
}

Axes<double> targets_after(Host& host, Duration duration) {
  host.listen(duration);
  const auto angles = host.get<msg::GetAngles>(msg::GetAnglesRequest{});
  Axes<double> result;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    result[axis] = angles.axes[axis].rc_target_angle.degrees();
  }
  return result;
}

TEST(RemoteControl, AFlightControllerTiltsTheCameraThatFollowsIt) {
  Host host;
  follow_controller(host, 50, 100);
  host.ask(controller_signals(250, 100));
  const Axes<double> tilted = targets_after(host, seconds(5));
  EXPECT_NEAR(tilted.roll, 22.5, 0.1) << "half of its signal";
  EXPECT_NEAR(tilted.pitch, -18, 0.1) << "its gain is negative";
  EXPECT_NEAR(tilted.yaw, 0, 0.1) << "yaw follows the frame";
  // Speeds of RC control are added.
  auto turn = one_axis(msg::ControlModeKind::speed, 0, 0);
  turn.axes.pitch.speed = 10_deg_per_s;
  host.ask(turn, seconds(1));
  host.ask(one_axis(msg::ControlModeKind::no_control, 0, 0));
  EXPECT_NEAR(targets_after(host, seconds(1)).pitch, -8, 1);
  // Without a signal, the axis levels.
  host.ask(channels(1, 0));
  EXPECT_NEAR(targets_after(host, seconds(5)).roll, 0, 0.1);
  EXPECT_NEAR(targets_after(host, seconds(1)).pitch, 10, 1);
}

TEST(RemoteControl, AFlightControllerIsFollowedInItsModeOnly) {
  Host host;
  follow_controller(host, 0, 100);
  host.ask(controller_signals(500, 500));
  const Axes<double> followed = targets_after(host, seconds(5));
  EXPECT_NEAR(followed.roll, 0, 0.1) << "RC_FOLLOW 0";
  EXPECT_NEAR(followed.pitch, -90, 0.1);
  host.ask(one_axis(msg::ControlModeKind::angle, 0, 0));
  EXPECT_NEAR(targets_after(host, seconds(5)).pitch, 0, 0.1) << "angles are relative to the world";
  for (const msg::FollowMode mode : {msg::FollowMode::disabled, msg::FollowMode::pitch}) {
    auto parameters = host.get<msg::ReadParams3>(msg::ReadParams3Request{});
    parameters.follow_mode = mode;
    host.ask(msg::WriteParams3{parameters});
    host.ask(one_axis(msg::ControlModeKind::no_control, 0, 0));
    host.ask(controller_signals(0, 250));
    EXPECT_NEAR(targets_after(host, seconds(5)).pitch, 0, 0.1);
  }
}

TEST(RemoteControl, RcAnglesCountFromWhatTheFlightControllerSays) {
  Host host;
  map_pitch(host, 5);
  follow_controller(host, 0, 100);
  auto signals = controller_signals(0, 100);
  signals.val_ch[4] = msg::CentredRcSignal(0);
  host.ask(signals);
  const auto parameters = host.get<msg::ReadParams3>(msg::ReadParams3Request{});
  const double middle =
      (parameters.rc.pitch.rc_min_angle.degrees() + parameters.rc.pitch.rc_max_angle.degrees()) / 2;
  EXPECT_NEAR(targets_after(host, seconds(5)).pitch, middle - 18, 0.1);
}

TEST(RemoteControl, SignalsShowInLiveData) {
  Host host;
  map_pitch(host, 31);
  host.ask(channels(31, 250));
  EXPECT_EQ(host.get<msg::RealtimeData3>(msg::RealtimeData3Request{}).rc.pitch.raw(), 1750);
  // Parameters of the signal curve do not affect it.
  auto parameters = host.get<msg::ReadParams3>(msg::ReadParams3Request{});
  parameters.rc_trim.pitch = 100;
  parameters.rc.pitch.rc_mode.set_inverted(true);
  host.ask(msg::WriteParams3{parameters});
  EXPECT_EQ(host.get<msg::RealtimeData3>(msg::RealtimeData3Request{}).rc.pitch.raw(), 1750);
  const msg::RealtimeDataCustomFlags blocks = msg::RealtimeDataCustomFlag::rc_data;
  const auto packets = host.ask(msg::RealtimeDataCustomRequest{.flags = blocks});
  ASSERT_THAT(packets, SizeIs(1));
  msg::RealtimeDataCustom data;
  ASSERT_TRUE(decode(std::span(packets[0].body), data, {.flags = blocks}));
  EXPECT_EQ((*data.rc_data)[1].raw(), 8192) << "half of 16384";
  host.ask(channels(31, 9999));
  EXPECT_EQ(host.get<msg::RealtimeData3>(msg::RealtimeData3Request{}).rc.pitch.raw(), 2000)
      << "clipped";
  host.ask(channels(30, 250));
  EXPECT_EQ(host.get<msg::RealtimeData3>(msg::RealtimeData3Request{}).rc.pitch.raw(), -10'000)
      << "lost";
}

TEST(RemoteControl, TheCommandChannelStartsActions) {
  Host host;
  auto parameters = host.get<msg::ReadParams3>(msg::ReadParams3Request{});
  parameters.rc_map_cmd.set_source(msg::RcSource::api);
  parameters.rc_map_cmd.set_channel(1);
  parameters.rc_cmd_high = msg::MenuCommand::motor_toggle;
  host.ask(msg::WriteParams3{parameters});
  host.ask(channels(1, 400));
  EXPECT_FALSE(host.board.gimbal().motors_on());
  host.ask(channels(1, 450));
  EXPECT_FALSE(host.board.gimbal().motors_on()) << "once for each movement of the switch";
  host.ask(channels(1, 0));
  host.ask(channels(1, 400));
  EXPECT_TRUE(host.board.gimbal().motors_on());
}

}  // namespace
}  // namespace sbgc::test
