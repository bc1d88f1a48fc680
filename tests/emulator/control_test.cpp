// What control commands make of the axes.

#include <optional>
#include <span>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host.hpp"
#include "random_requests.hpp"

namespace sbgc::test {
namespace {

using board::AxisMode;
using ::testing::IsEmpty;
using ::testing::SizeIs;

msg::ControlExt one_axis(msg::ControlModeKind mode, std::int16_t speed, std::int16_t angle) {
  msg::ControlExt request;
  request.control_mode.pitch.set_mode(mode);
  request.axes.pitch = {msg::ControlSpeed(speed), msg::Angle14(angle)};
  return request;
}

TEST(Control, ModesAndUnits) {
  Host host;
  const auto command = [&] { return host.board.gimbal().command(1); };
  EXPECT_THAT(host.ask(one_axis(msg::ControlModeKind::speed, 1000, 0)), SizeIs(1));
  EXPECT_EQ(command().mode, AxisMode::speed);
  EXPECT_NEAR(command().speed, 1000 * 4000.0 / 32767, 1e-9);
  host.ask(one_axis(msg::ControlModeKind::angle, -1000, 8192));
  EXPECT_EQ(command().mode, AxisMode::angle);
  EXPECT_NEAR(command().speed, 1000 * 4000.0 / 32767, 1e-9) << "the angle says the direction";
  EXPECT_EQ(command().angle, 180);
  host.ask(one_axis(msg::ControlModeKind::speed_angle, -1000, 100));
  EXPECT_EQ(command().mode, AxisMode::speed_angle);
  EXPECT_LT(command().speed, 0);
  auto settings = host.get<msg::ReadParams3>(msg::ReadParams3Request{});
  settings.rc_deadband = 0;
  host.ask(msg::WriteParams3{settings});
  host.ask(one_axis(msg::ControlModeKind::rc, 0, -250));
  EXPECT_EQ(command().mode, AxisMode::signal);
  EXPECT_EQ(command().signal, -0.5);
  settings.rc.pitch.rc_mode.set_inverted(true);
  settings.rc_trim.pitch = 50;
  host.ask(msg::WriteParams3{settings});
  host.ask(one_axis(msg::ControlModeKind::rc, 0, -250));
  EXPECT_NEAR(command().signal, 0.6, 1e-9) << "it stands for the RC signal, settings and all";
  settings.rc.pitch.rc_mode.set_inverted(false);
  host.ask(msg::WriteParams3{settings});
  host.ask(one_axis(msg::ControlModeKind::rc, 0, 9999));
  EXPECT_EQ(command().signal, 1);
  host.ask(one_axis(msg::ControlModeKind::angle_rel_frame, 0, -16384));
  EXPECT_EQ(command().mode, AxisMode::relative_angle);
  EXPECT_EQ(command().angle, -360);
  EXPECT_EQ(host.board.gimbal().command(0).mode, AxisMode::remote) << "other axes have their own";
  host.ask(one_axis(msg::ControlModeKind::no_control, 0, 0));
  EXPECT_EQ(command().mode, AxisMode::remote);
}

TEST(Control, OneModeForAllAxes) {
  Host host;
  msg::Control request;
  request.control_mode.set_mode(msg::ControlModeKind::speed);
  request.axes.yaw.speed = msg::ControlSpeed(100);
  host.ask(request);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    EXPECT_EQ(host.board.gimbal().command(axis).mode, AxisMode::speed);
  }
}

TEST(Control, FineSpeedIsKnownToNewFirmwareOnly) {
  for (const int firmware : {2590, 2560}) {
    board::Options options;
    options.firmware = msg::FirmwareVersion(static_cast<std::uint16_t>(firmware));
    Host host(options);
    auto request = one_axis(msg::ControlModeKind::speed, 1000, 0);
    request.control_mode.pitch.set_flags(msg::ControlFlag::high_res_speed);
    host.ask(request);
    const double speed = host.board.gimbal().command(1).speed;
    EXPECT_NEAR(speed, firmware == 2590 ? 1.0 : 1000 * 4000.0 / 32767, 1e-9);
  }
}

TEST(Control, AnUnknownModeIsRefusedAsAWhole) {
  Host host;
  host.ask(one_axis(msg::ControlModeKind::speed, 10, 0));
  msg::ControlExt request = one_axis(msg::ControlModeKind::angle, 10, 0);
  request.control_mode.yaw = msg::ControlMode(9);
  EXPECT_EQ(host.get<msg::ErrorExt>(request).cmd_id, msg::CommandId::control);
  EXPECT_EQ(host.board.gimbal().command(1).mode, AxisMode::speed);
}

TEST(Control, TheCameraMoves) {
  Host host;
  auto request = one_axis(msg::ControlModeKind::angle, 0, 0);
  request.axes.pitch.angle = -30_deg;
  host.ask(request);
  host.listen(seconds(5));
  const auto angles = host.get<msg::GetAngles>(msg::GetAnglesRequest{});
  EXPECT_NEAR(angles.axes.pitch.imu_angle.degrees(), -30, 0.5);
  EXPECT_EQ(angles.axes.pitch.rc_speed.raw(), 0);
}

/// Settings by which the joint of yaw turns from -30 to 60 degrees.
void limit_yaw(Host& host) {
  auto settings = host.get<msg::ReadParamsExt>(msg::ReadParamsExtRequest{});
  settings.encoder_limit_min.yaw = msg::EncoderLimit(-10);
  settings.encoder_limit_max.yaw = msg::EncoderLimit(20);
  host.ask(msg::WriteParamsExt{settings});
}

/// Where the joint of yaw ends if the camera is told to turn to that angle.
double joint_after(Host& host, double angle) {
  msg::ControlExt request;
  request.control_mode.yaw.set_mode(msg::ControlModeKind::angle);
  request.axes.yaw.angle = *msg::Angle14::from_degrees(angle);
  host.ask(request, seconds(8));
  return host.get<msg::GetAnglesExt>(msg::GetAnglesExtRequest{})
      .axes.yaw.stator_rotor_angle.degrees();
}

TEST(Control, TheJointsTurnAsFarAsTheSettingsLetThem) {
  Host host;
  EXPECT_NEAR(joint_after(host, 150), 150, 0.5) << "factory settings have no limits";
  limit_yaw(host);
  EXPECT_NEAR(joint_after(host, 150), 60, 0.5) << "it comes back";
  EXPECT_NEAR(joint_after(host, -150), -30, 0.5);
  EXPECT_NEAR(joint_after(host, 45), 45, 0.5);
}

TEST(Control, WithoutEncodersJointsHaveNoLimits) {
  board::Options options;
  options.features = msg::BoardFeature::three_axis;
  Host host(options);
  limit_yaw(host);
  EXPECT_NEAR(joint_after(host, 150), 150, 0.5);
}

TEST(Control, AnEmptyBatteryKeepsTheMotorsOff) {
  Host host;
  host.board.gimbal().set_battery(9, host.now);
  host.listen(seconds(1));
  host.ask(msg::MotorsOff{});
  const auto packets = host.ask(msg::MotorsOn{});
  ASSERT_THAT(packets, SizeIs(1));
  EXPECT_TRUE(is<msg::ErrorExt>(packets[0]));
}

/// Settings by which an API channel controls pitch.
void map_pitch(Host& host, int channel, msg::RcModeKind mode = msg::RcModeKind::angle) {
  auto settings = host.get<msg::ReadParams3>(msg::ReadParams3Request{});
  settings.rc_map.pitch.set_source(msg::RcSource::api);
  settings.rc_map.pitch.set_channel(static_cast<std::uint8_t>(channel));
  settings.rc.pitch.rc_mode.set_mode(mode);
  settings.rc_trim = {};
  settings.rc_deadband = 0;
  settings.rc_expo_rate = 0;
  host.ask(msg::WriteParams3{settings});
}

msg::ApiVirtChControl channels(std::size_t channel, std::int16_t signal) {
  msg::ApiVirtChControl request;
  while (request.val_ch.push_back(msg::CentredRcSignal(msg::ApiVirtChControl::undefined))) {
  }
  request.val_ch[channel - 1] = msg::CentredRcSignal(signal);
  return request;
}

TEST(Control, VirtualChannelsControlTheCamera) {
  Host host;
  map_pitch(host, 5);
  EXPECT_THAT(host.ask(channels(5, 500)), IsEmpty()) << "it comes often, so it is not confirmed";
  host.listen(seconds(8));
  const auto settings = host.get<msg::ReadParams3>(msg::ReadParams3Request{});
  const auto angles = host.get<msg::GetAngles>(msg::GetAnglesRequest{});
  EXPECT_NEAR(angles.axes.pitch.rc_target_angle.degrees(), settings.rc.pitch.rc_max_angle.degrees(),
              1);
}

TEST(Control, ChannelsThatAreNotSentKeepTheirSignals) {
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

TEST(Control, NoChannelsAndTooManyAreRefused) {
  Host host;
  for (const std::size_t size : {0U, 1U, 63U, 66U}) {
    host.send_bytes(frame_of(45, std::vector<std::uint8_t>(size)));
    const auto errors = all<msg::ErrorExt>(host.listen(milliseconds(20)));
    ASSERT_THAT(errors, SizeIs(1)) << size;
    EXPECT_EQ(errors[0].error_code, msg::BoardErrorCode::cmd_size);
  }
}

/// What the signals make of pitch, as a share of RC_SPEED. Precondition: they are speeds.
double control(Host& host, const msg::ApiVirtChControl& signals) {
  host.ask(signals, seconds(1));
  const double full = host.get<msg::ReadParams3>(msg::ReadParams3Request{}).rc.pitch.rc_speed;
  return host.board.gimbal().sample(host.now).target_speeds.pitch / full;
}

TEST(Control, TheDeadBandLeavesTheEndsOfTheStick) {
  Host host;
  map_pitch(host, 5, msg::RcModeKind::speed);
  auto settings = host.get<msg::ReadParams3>(msg::ReadParams3Request{});
  settings.rc_deadband = 100;
  host.ask(msg::WriteParams3{settings});
  EXPECT_EQ(control(host, channels(5, 100)), 0);
  EXPECT_NEAR(control(host, channels(5, 300)), 0.5, 1e-9);
  EXPECT_EQ(control(host, channels(5, 500)), 1);
  EXPECT_EQ(control(host, channels(5, -500)), -1);
}

TEST(Control, SignalsAreBentAsTheSettingsSay) {
  Host host;
  map_pitch(host, 5, msg::RcModeKind::speed);
  const auto plain = host.get<msg::ReadParams3>(msg::ReadParams3Request{});
  auto signals = channels(5, 250);
  signals.val_ch[5] = msg::CentredRcSignal(400);
  const auto bent = [&](auto&& change) {
    auto settings = plain;
    change(settings);
    host.ask(msg::WriteParams3{settings});
    const double result = control(host, signals);
    const auto shown = host.get<msg::RealtimeData3>(msg::RealtimeData3Request{}).rc.pitch;
    EXPECT_EQ(shown, signals.val_ch[4].raw() == 250 ? msg::RcSignal(1750) : msg::RcSignal(1500))
        << "live data have it as it comes";
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
  // A flight controller controls an axis that has no signal of its own.
  signals.val_ch[4] = msg::CentredRcSignal(msg::ApiVirtChControl::undefined);
  EXPECT_NEAR(bent(mix(63)), 0.8, 1e-9);
  EXPECT_NEAR(bent(mix(32)), 0.4, 0.01) << "as if that were in the middle";
  EXPECT_EQ(bent(mix(0)), 0);
}

/// Settings by which the flight controller's signals are those of API channels 6 and 7, and roll
/// and pitch follow it.
void follow_controller(Host& host, int roll_percent, int pitch_percent) {
  auto settings = host.get<msg::ReadParams3>(msg::ReadParams3Request{});
  settings.follow_mode = msg::FollowMode::fc;
  settings.follow_deadband = 0;
  settings.rc_map_fc_roll.set_source(msg::RcSource::api);
  settings.rc_map_fc_roll.set_channel(6);
  settings.rc_map_fc_pitch.set_source(msg::RcSource::api);
  settings.rc_map_fc_pitch.set_channel(7);
  settings.ext_fc_gain_roll = 127;
  settings.ext_fc_gain_pitch = -127;
  settings.rc.roll.rc_follow = static_cast<std::int8_t>(roll_percent);
  settings.rc.pitch.rc_follow = static_cast<std::int8_t>(pitch_percent);
  settings.rc.yaw.rc_follow = 100;
  host.ask(msg::WriteParams3{settings});
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

TEST(Control, AFlightControllerTiltsTheCameraThatFollowsIt) {
  Host host;
  follow_controller(host, 50, 100);
  host.ask(controller_signals(250, 100));
  const Axes<double> tilted = targets_after(host, seconds(5));
  EXPECT_NEAR(tilted.roll, 22.5, 0.1) << "half of what its signal says";
  EXPECT_NEAR(tilted.pitch, -18, 0.1) << "its gain turns it round";
  EXPECT_NEAR(tilted.yaw, 0, 0.1) << "yaw follows the frame";
  // Speeds of RC control come on top of it.
  auto turn = one_axis(msg::ControlModeKind::speed, 0, 0);
  turn.axes.pitch.speed = 10_deg_per_s;
  host.ask(turn, seconds(1));
  host.ask(one_axis(msg::ControlModeKind::no_control, 0, 0));
  EXPECT_NEAR(targets_after(host, seconds(1)).pitch, -8, 1);
  // Who is no longer heard is level.
  host.ask(channels(1, 0));
  EXPECT_NEAR(targets_after(host, seconds(5)).roll, 0, 0.1);
  EXPECT_NEAR(targets_after(host, seconds(1)).pitch, 10, 1);
}

TEST(Control, AFlightControllerIsFollowedInItsModeOnly) {
  Host host;
  follow_controller(host, 0, 100);
  host.ask(controller_signals(500, 500));
  const Axes<double> followed = targets_after(host, seconds(5));
  EXPECT_NEAR(followed.roll, 0, 0.1) << "RC_FOLLOW 0";
  EXPECT_NEAR(followed.pitch, -90, 0.1);
  host.ask(one_axis(msg::ControlModeKind::angle, 0, 0));
  EXPECT_NEAR(targets_after(host, seconds(5)).pitch, 0, 0.1) << "angles are those of the world";
  for (const msg::FollowMode mode : {msg::FollowMode::disabled, msg::FollowMode::pitch}) {
    auto settings = host.get<msg::ReadParams3>(msg::ReadParams3Request{});
    settings.follow_mode = mode;
    host.ask(msg::WriteParams3{settings});
    host.ask(one_axis(msg::ControlModeKind::no_control, 0, 0));
    host.ask(controller_signals(0, 250));
    EXPECT_NEAR(targets_after(host, seconds(5)).pitch, 0, 0.1);
  }
}

TEST(Control, RcAnglesCountFromWhatTheFlightControllerSays) {
  Host host;
  map_pitch(host, 5);
  follow_controller(host, 0, 100);
  auto signals = controller_signals(0, 100);
  signals.val_ch[4] = msg::CentredRcSignal(0);
  host.ask(signals);
  const auto settings = host.get<msg::ReadParams3>(msg::ReadParams3Request{});
  const double middle =
      (settings.rc.pitch.rc_min_angle.degrees() + settings.rc.pitch.rc_max_angle.degrees()) / 2;
  EXPECT_NEAR(targets_after(host, seconds(5)).pitch, middle - 18, 0.1);
}

TEST(Control, NoMotorIsFasterThanTheGyroscopeCanTell) {
  Host host;
  host.ask(one_axis(msg::ControlModeKind::speed, 32767, 0), seconds(8));
  const auto data = host.get<msg::GetAngles>(msg::GetAnglesRequest{});
  EXPECT_NEAR(data.axes.pitch.rc_speed.degrees_per_second(), 2000, 0.1) << "and says so";
}

/// What a handheld gimbal does in 5 s, while a host sends the message 50 times a second.
template <class Data>
board::Sample helped(const std::optional<Data>& data) {
  board::Options options;
  options.gimbal.frame.kind = board::Disturbance::Kind::handheld;
  options.gimbal.noise = 0;
  Host host(options);
  for (int i = 0; i < 250; ++i) {
    if (data) {
      host.send(*data);
    }
    EXPECT_THAT(host.listen(milliseconds(20)), IsEmpty()) << "it comes often";
  }
  return host.board.gimbal().sample(host.now);
}

TEST(Control, HelpIsWhatTellsSomething) {
  const auto alone = helped<msg::HelperData>({}).angles;
  EXPECT_EQ(helped(std::optional(msg::HelperData{})).angles, alone) << "zeros are not used";
  EXPECT_EQ(helped(std::optional(msg::HelperDataExt{})).angles, alone);
  msg::HelperData tilt;
  tilt.frame_angle_pitch = msg::Angle14(100);
  EXPECT_NE(helped(std::optional(tilt)).angles, alone);
  msg::HelperDataExt speed{.coord_sys = msg::CoordinateSystem::ground_yaw_rotated};
  speed.frame_speed.z = msg::GyroRate(100);
  const auto with_speed = helped(std::optional(speed)).angles;
  EXPECT_NE(with_speed, alone);
  speed.coord_sys = msg::CoordinateSystem{7};
  EXPECT_EQ(helped(std::optional(speed)).angles, with_speed) << "as the usual coordinates";
}

TEST(Control, AMotorThatIsNotConnectedHoldsNothing) {
  Host host;
  auto settings = host.get<msg::ReadParams3>(msg::ReadParams3Request{});
  settings.output.pitch = msg::MotorOutput::disabled;
  host.ask(msg::WriteParams3{settings});
  const auto power = host.board.gimbal().sample(host.now).power;
  EXPECT_EQ(power.pitch, 0);
  EXPECT_GT(power.roll, 0);
}

TEST(Control, SignalsShowInLiveData) {
  Host host;
  map_pitch(host, 31);
  host.ask(channels(31, 250));
  EXPECT_EQ(host.get<msg::RealtimeData3>(msg::RealtimeData3Request{}).rc.pitch.raw(), 1750);
  // Settings that bend it do not change it.
  auto settings = host.get<msg::ReadParams3>(msg::ReadParams3Request{});
  settings.rc_trim.pitch = 100;
  settings.rc.pitch.rc_mode.set_inverted(true);
  host.ask(msg::WriteParams3{settings});
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
  EXPECT_EQ(host.get<msg::RealtimeData3>(msg::RealtimeData3Request{}).rc.pitch.raw(), 1500)
      << "lost";
}

TEST(Control, TheCommandChannelStartsActions) {
  Host host;
  auto settings = host.get<msg::ReadParams3>(msg::ReadParams3Request{});
  settings.rc_map_cmd.set_source(msg::RcSource::api);
  settings.rc_map_cmd.set_channel(1);
  settings.rc_cmd_high = msg::MenuCommand::motor_toggle;
  host.ask(msg::WriteParams3{settings});
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
