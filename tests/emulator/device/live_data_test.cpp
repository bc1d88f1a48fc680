// Tests of live data: units, limits and sources.

#include <cmath>
#include <cstdint>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host.hpp"
#include "random_requests.hpp"

namespace sbgc::test {
namespace {

using ::testing::SizeIs;

emulator::BoardOptions still() {
  emulator::BoardOptions options;
  options.gimbal.noise = 0;
  return options;
}

/// Returns a board with motors off, so that the camera remains where it is placed.
Host placed(const Axes<double>& angles, const emulator::BoardOptions& options = still()) {
  Host host(options);
  host.ask(msg::MotorsOff{});
  host.board.gimbal().place(angles, host.now);
  return host;
}

TEST(LiveData, LevelAndAtRest) {
  Host host = placed({0, 0, 0});
  const auto data = host.get<msg::RealtimeData4>(msg::RealtimeData4Request{});
  EXPECT_NEAR(data.axes.yaw.acc_data.g(), 1, 0.02);
  EXPECT_NEAR(data.axes.roll.acc_data.g(), 0, 0.02);
  EXPECT_NEAR(data.angle.pitch.degrees(), 0, 0.1);
  EXPECT_EQ(data.cycle_time.raw(), 800);
  EXPECT_EQ(data.system_error.raw(), 0);
  EXPECT_FALSE(data.other_flags.has(msg::OtherFlag::motors_on));
  EXPECT_GT(data.bat_level.volts(), 15);
  EXPECT_NEAR(data.imu_temperature.real(), 25, 15);
}

TEST(LiveData, AnglesBeginAgainAfterTwoTurns) {
  Host host = placed({0, 0, 700});
  EXPECT_NEAR(host.get<msg::GetAngles>(msg::GetAnglesRequest{}).axes.yaw.imu_angle.degrees(), 700,
              0.5);
  host.board.gimbal().place({0, 0, 730}, host.now);
  EXPECT_NEAR(host.get<msg::GetAngles>(msg::GetAnglesRequest{}).axes.yaw.imu_angle.degrees(),
              730 - 1440, 0.5);
  EXPECT_NEAR(
      host.get<msg::GetAnglesExt>(msg::GetAnglesExtRequest{}).axes.yaw.stator_rotor_angle.degrees(),
      730, 1)
      << "joint angles do not wrap";
}

TEST(LiveData, EachAxisShowsItsOwnTurning) {
  for (std::size_t axis = 0; axis < 3; ++axis) {
    Host host(still());
    msg::ControlExt turn;
    turn.control_mode[axis].set_mode(msg::ControlModeKind::speed);
    turn.axes[axis].speed = 20_deg_per_s;
    host.ask(turn);
    host.listen(milliseconds(400));
    const auto data = host.get<msg::RealtimeData3>(msg::RealtimeData3Request{}, milliseconds(2));
    for (std::size_t other = 0; other < 3; ++other) {
      const double speed = data.axes[other].gyro_data.degrees_per_second();
      EXPECT_NEAR(speed, other == axis ? 20 : 0, 4) << axis << other;
    }
  }
}

TEST(LiveData, BothFormsAgree) {
  Host host = placed({3, -20, 40});
  const auto three = host.get<msg::RealtimeData3>(msg::RealtimeData3Request{});
  const auto four = host.get<msg::RealtimeData4>(msg::RealtimeData4Request{});
  EXPECT_EQ(three.angle, four.angle);
  EXPECT_NEAR(three.angle.pitch.degrees(), -20, 0.1);
  EXPECT_EQ(host.get<msg::RealtimeData3>(msg::RealtimeData{}).angle, four.angle)
      << "the older request";
}

/// Returns a request that sets the attitude of the frame, in degrees about z and x.
msg::AhrsHelperRequestExt frame_attitude(double yaw, double pitch) {
  const double z = yaw * M_PI / 180, x = pitch * M_PI / 180;
  msg::AhrsHelperRequestExt set;
  set.mode = msg::AhrsHelperModeBit::set | msg::AhrsHelperModeBit::frame_imu;
  set.z1_vector = {0, static_cast<float>(-std::sin(x)), static_cast<float>(std::cos(x))};
  set.h1_vector = {static_cast<float>(std::sin(z)), static_cast<float>(std::cos(x) * std::cos(z)),
                   static_cast<float>(std::sin(x) * std::cos(z))};
  return set;
}

TEST(LiveData, ErrorsAreThoseOfTheActiveImu) {
  for (const bool of_heading : {false, true}) {
    Host host = placed({0, 0, 0});
    auto reference = of_heading ? frame_attitude(10, 0) : frame_attitude(0, 10);
    reference.mode.set(msg::AhrsHelperModeBit::reference_only);
    host.ask(reference, milliseconds(5));
    const auto gravity = [&] {
      return host.get<msg::RealtimeData4>(msg::RealtimeData4Request{}).imu_g_err.degrees();
    };
    const auto heading = [&] {
      return host.get<msg::RealtimeData4>(msg::RealtimeData4Request{}).imu_h_err.degrees();
    };
    EXPECT_NEAR(gravity(), 0, 0.5);
    EXPECT_NEAR(heading(), 0, 0.5);
    host.ask(msg::SelectImu3{.imu_type = msg::SelectedImu::frame});
    EXPECT_NEAR(gravity(), of_heading ? 0 : 10, 0.5);
    EXPECT_NEAR(heading(), of_heading ? 10 : 0, 0.5);
    const auto length = [&](msg::SelectedImu imu) {
      return host.get<msg::CalibInfo>(msg::CalibInfoRequest{.imu_type = imu}).h1_err_length.value();
    };
    EXPECT_NEAR(length(msg::SelectedImu::frame), of_heading ? 0.17 : 0, 0.02);
    EXPECT_NEAR(length(msg::SelectedImu::main), 0, 0.02)
        << "the error is that of the requested IMU";
  }
}

/// Sets FRAME_IMU_POS.
void put_frame_imu(Host& host, msg::FrameImuPosition position) {
  auto parameters = host.get<msg::ReadParams3>(msg::ReadParams3Request{});
  parameters.frame_imu_pos = position;
  host.ask(msg::WriteParams3{parameters});
}

TEST(LiveData, AFrameImuThatIsDisabledIsNone) {
  emulator::BoardOptions options = still();
  options.gimbal.frame.kind = emulator::Disturbance::Kind::recorded;
  options.gimbal.frame.recording = {{Instant{}, {5, -8, 20}}};
  Host host(options);
  const auto frame = [&] {
    return host.get<msg::RealtimeData4>(msg::RealtimeData4Request{})
        .frame_imu_angle.pitch.degrees();
  };
  EXPECT_NEAR(frame(), -8, 0.5);
  host.ask(msg::SelectImu3{.imu_type = msg::SelectedImu::frame});
  put_frame_imu(host, msg::FrameImuPosition::disabled);
  EXPECT_EQ(frame(), 0);
  EXPECT_EQ(host.get<msg::RealtimeData3>(msg::RealtimeData3Request{}).cur_imu,
            msg::SelectedImu::main);
  EXPECT_THAT(host.ask(msg::SelectImu3{.imu_type = msg::SelectedImu::frame}), SizeIs(0));
  EXPECT_THAT(host.ask(msg::CalibGyroExt{.imu_idx = msg::CalibImu::frame,
                                         .action = msg::CalibAction::regular}),
              SizeIs(0));
  const msg::CalibInfoRequest info{.imu_type = msg::SelectedImu::frame};
  EXPECT_EQ(host.get<msg::ErrorExt>(info).cmd_id, msg::CommandToBoard::calib_info);
  put_frame_imu(host, msg::FrameImuPosition::above_yaw);
  EXPECT_NEAR(frame(), -8, 0.5);
  EXPECT_THAT(host.ask(msg::SelectImu3{.imu_type = msg::SelectedImu::frame}), SizeIs(1));
}

TEST(LiveData, AFramesAttitudeThatIsToldIsKnownWithoutItsImu) {
  Host host(still());
  put_frame_imu(host, msg::FrameImuPosition::disabled);
  const msg::AhrsHelperRequest get{.mode = msg::AhrsHelperModeBit::frame_imu};
  EXPECT_EQ(host.get<msg::ErrorExt>(get).cmd_id, msg::CommandToBoard::ahrs_helper);
  const auto told = frame_attitude(0, 30);
  host.ask(told, milliseconds(5));
  const auto known = host.get<msg::AhrsHelper>(get);
  EXPECT_NEAR(static_cast<double>(known.z1_vector.y), -0.5, 0.01);
  EXPECT_NEAR(static_cast<double>(known.z1_vector.z), 0.866, 0.01);
  host.listen(seconds(2));
  EXPECT_EQ(host.get<msg::ErrorExt>(get).cmd_id, msg::CommandToBoard::ahrs_helper)
      << "the reference has expired";
}

TEST(LiveData, TheBatteryIsWatched) {
  Host host;
  const auto errors = [&](double volts) {
    host.board.gimbal().set_battery(volts, host.now);
    host.listen(seconds(1));
    return host.get<msg::RealtimeData3>(msg::RealtimeData3Request{}).system_error;
  };
  auto parameters = host.get<msg::ReadParams3>(msg::ReadParams3Request{});
  parameters.bat_threshold_alarm = 14_V;
  parameters.bat_threshold_motors = 12_V;
  host.ask(msg::WriteParams3{parameters});
  EXPECT_EQ(errors(15.5).raw(), 0);
  EXPECT_EQ(errors(13), msg::SystemErrors(msg::SystemError::low_bat1));
  EXPECT_EQ(errors(11), msg::SystemError::low_bat1 | msg::SystemError::low_bat2);
  parameters.bat_threshold_alarm = -14_V;
  parameters.bat_threshold_motors = -12_V;
  host.ask(msg::WriteParams3{parameters});
  host.ask(msg::MotorsOn{});
  EXPECT_EQ(errors(11).raw(), 0) << "negative thresholds are ignored";
}

TEST(LiveData, AnEmptyBatteryShowsWithoutMotorsToo) {
  Host host;
  host.ask(msg::MotorsOff{});
  host.board.gimbal().set_battery(9, host.now);
  EXPECT_EQ(host.get<msg::RealtimeData3>(msg::RealtimeData3Request{}).system_error,
            msg::SystemError::low_bat1 | msg::SystemError::low_bat2);
  host.board.gimbal().set_battery(16, host.now);
  EXPECT_EQ(host.get<msg::RealtimeData3>(msg::RealtimeData3Request{}).system_error,
            msg::SystemErrors{});
}

TEST(LiveData, ABoardWithoutAMeterDoesNotWatchTheBattery) {
  emulator::BoardOptions options;
  options.features = msg::BoardFeature::three_axis;
  Host host(options);
  host.board.gimbal().set_battery(9, host.now);
  host.listen(seconds(1));
  EXPECT_TRUE(host.board.gimbal().motors_on());
  EXPECT_EQ(host.get<msg::RealtimeData3>(msg::RealtimeData3Request{}).system_error.raw(), 0);
  EXPECT_EQ(host.get<msg::ErrorExt>(msg::CalibBat{9_V}).cmd_id, msg::CommandToBoard::calib_bat);
}

TEST(LiveData, CustomBlocksAreThoseOfTheRequest) {
  Host host;
  for (std::uint32_t bits = 0; bits < 0x200; ++bits) {
    const msg::RealtimeDataCustomFlags flags(bits);
    const auto packets = host.ask(msg::RealtimeDataCustomRequest{.flags = flags}, milliseconds(2));
    ASSERT_THAT(packets, SizeIs(1));
    msg::RealtimeDataCustom data;
    ASSERT_TRUE(decode(std::span(packets[0].body), data, {.flags = flags}));
    EXPECT_TRUE(data.tail.empty()) << bits;
    EXPECT_EQ(data.rc_channels.has_value(), flags.has(msg::RealtimeDataCustomFlag::rc_channels));
    if (data.rc_data) {
      EXPECT_EQ((*data.rc_data)[0].raw(), msg::RealtimeDataCustom::undefined);
    }
  }
}

TEST(LiveData, TheTimestampCountsMilliseconds) {
  Host host;
  const auto stamp = [&] {
    return host.get<msg::RealtimeDataCustom>(msg::RealtimeDataCustomRequest{}).timestamp_ms.raw();
  };
  const auto first = stamp();
  host.listen(milliseconds(1000 - 50));
  EXPECT_NEAR(static_cast<std::uint16_t>(stamp() - first), 1000, 1);
  host.listen(seconds(70));
  EXPECT_NEAR(static_cast<std::uint16_t>(stamp() - first), (1000 + 70'050) % 65536, 1);
}

TEST(LiveData, WithoutAFrameImuNothingIsKnownOfTheFrame) {
  emulator::BoardOptions options = still();
  options.has_frame_imu = false;
  options.features = {};
  Host host = placed({0, 0, 90}, options);
  const auto data = host.get<msg::RealtimeData4>(msg::RealtimeData4Request{});
  EXPECT_EQ(data.rotor_angle, Axes<msg::Angle14>{});
  EXPECT_EQ(data.frame_imu_angle, Axes<msg::Angle14>{});
  EXPECT_EQ(data.bat_level.raw(), 0);
  EXPECT_EQ(data.current.raw(), 0);
  const msg::AhrsHelperRequest of_frame{.mode = msg::AhrsHelperModeBit::frame_imu};
  EXPECT_EQ(host.get<msg::ErrorExt>(of_frame).cmd_id, msg::CommandToBoard::ahrs_helper);
}

double length(const Xyz<float>& v) {
  return std::hypot(static_cast<double>(v.x), static_cast<double>(v.y), static_cast<double>(v.z));
}

TEST(LiveData, TheAttitudeAsVectors) {
  Host host = placed({0, 0, 0});
  auto level = host.get<msg::AhrsHelper>(msg::AhrsHelperRequest{});
  EXPECT_NEAR(static_cast<double>(level.z1_vector.z), 1, 0.01);
  EXPECT_NEAR(length(level.h1_vector), 1, 1e-5);
  host.board.gimbal().place({30, 0, 0}, host.now);
  const auto tilted = host.get<msg::AhrsHelper>(msg::AhrsHelperRequestExt{});
  EXPECT_NEAR(static_cast<double>(tilted.z1_vector.z), std::cos(30 * M_PI / 180), 0.01);
  EXPECT_NEAR(std::abs(static_cast<double>(tilted.z1_vector.x)), 0.5, 0.01);
}

TEST(LiveData, TheOrderOfTheAnglesIsThatOfTheSettings) {
  Host host = placed({30, 40, 50});
  const auto up = [&](msg::EulerOrder order) {
    auto parameters = host.get<msg::ReadParams3>(msg::ReadParams3Request{});
    parameters.euler_order = order;
    host.ask(msg::WriteParams3{parameters});
    return host.get<msg::AhrsHelper>(msg::AhrsHelperRequest{}).z1_vector;
  };
  const auto near = [](const Xyz<float>& a, const Xyz<float>& b) {
    return length({a.x - b.x, a.y - b.y, a.z - b.z}) < 0.01;
  };
  using enum msg::EulerOrder;
  EXPECT_FALSE(near(up(pitch_roll_yaw), up(roll_pitch_yaw)));
  EXPECT_FALSE(near(up(yaw_roll_pitch), up(yaw_pitch_roll)));
  EXPECT_FALSE(near(up(yaw_roll_pitch), up(roll_pitch_yaw)));
  // For two axes: yaw is the outermost.
  EXPECT_TRUE(near(up(local_roll), up(pitch_roll_yaw)));
  EXPECT_TRUE(near(up(roll_local), up(roll_pitch_yaw)));
}

TEST(LiveData, AnAttitudeCanBeSet) {
  Host host = placed({0, 0, 0});
  msg::AhrsHelperRequestExt set;
  set.mode = msg::AhrsHelperModeBit::set;
  set.z1_vector = {0, -0.70710678F, 0.70710678F};
  set.h1_vector = {0, 0.70710678F, 0.70710678F};
  EXPECT_THAT(host.ask(set, milliseconds(3)), SizeIs(0))
      << "it is sent often, so it is not confirmed";
  const auto angles = host.get<msg::GetAngles>(msg::GetAnglesRequest{}, milliseconds(3));
  EXPECT_NEAR(angles.axes.pitch.imu_angle.degrees(), 45, 2) << "up is behind: it looks down";
}

TEST(LiveData, AFrameTellsTheCamerasAttitudeAndTheOtherWayRound) {
  for (const bool by_frame : {false, true}) {
    Host host = placed({0, 0, 0});
    msg::AhrsHelperRequestExt set;
    set.mode = msg::AhrsHelperModeBit::set | msg::AhrsHelperModeBit::translate;
    if (by_frame) set.mode.set(msg::AhrsHelperModeBit::frame_imu);
    set.z1_vector = {0, -0.5F, 0.8660254F};
    set.h1_vector = {0, 0.8660254F, 0.5F};
    host.ask(set, milliseconds(3));
    // It is only a reference for the other IMU, which converges slowly.
    const auto before = host.board.gimbal().sample(host.now);
    EXPECT_NEAR(by_frame ? before.angles.pitch : before.frame.pitch, 0, 0.5);
    for (int i = 0; i < 2000; ++i) host.ask(set, milliseconds(20));
    const auto after = host.board.gimbal().sample(host.now);
    const double moved = by_frame ? after.angles.pitch - before.angles.pitch
                                  : after.frame.pitch - before.frame.pitch;
    EXPECT_NEAR(moved, 30, 5) << by_frame << ": up is behind, so the front is down";
  }
}

TEST(LiveData, LaterFirmwareHasAModeOfTwoBytesInFrontOfTheVectors) {
  // The requested attitude is a tilt of 30 degrees; each firmware accepts only its own form.
  const std::vector<std::uint8_t> vectors{0,    0,    0,    0,    0, 0, 0, 0xBF,
                                          0xD7, 0xB3, 0x5D, 0x3F, 0, 0, 0, 0,
                                          0xD7, 0xB3, 0x5D, 0x3F, 0, 0, 0, 0x3F};
  for (const int firmware : {2590, 2694, 2695, 2740}) {
    SCOPED_TRACE(firmware);
    emulator::BoardOptions options = still();
    options.firmware = msg::FirmwareVersion(static_cast<std::uint16_t>(firmware));
    options.is_strict = true;  // otherwise a longer form is an older one with surplus
    const bool is_late = firmware >= 2695;
    Host host(options);
    std::vector<std::uint8_t> body{1};
    if (is_late) body.push_back(0);
    body.insert(body.end(), vectors.begin(), vectors.end());
    host.send_bytes(frame_of(56, body));
    EXPECT_THAT(host.listen(milliseconds(5)), SizeIs(0)) << "taken";
    const double pitch = host.board.gimbal().sample(host.now).angles.pitch;
    EXPECT_NEAR(std::abs(pitch), 30, 1);
    for (const std::size_t size : {1U, 2U, 25U, 26U}) {
      host.send_bytes(frame_of(56, std::vector<std::uint8_t>(size)));
      const Packets packets = host.listen(milliseconds(20));
      const bool fits = size % 2 == (is_late ? 0U : 1U);
      EXPECT_THAT(all<msg::AhrsHelper>(packets), SizeIs(fits ? 1 : 0)) << size;
      EXPECT_THAT(all<msg::ErrorExt>(packets), SizeIs(fits ? 0 : 1)) << size;
    }
  }
}

TEST(LiveData, AnAttitudeCanBeLeftUncorrected) {
  using enum msg::AhrsHelperWideModeBit;
  emulator::BoardOptions options;
  options.firmware = msg::FirmwareVersion(2740);
  Host host(options);
  msg::AhrsHelperRequestExtWide set_attitude;
  // Upside down.
  set_attitude.z1_vector = {0, 0, -1};
  set_attitude.h1_vector = {0, 1, 0};
  const auto up = [&] { return host.board.gimbal().sample(host.now).up.z; };
  set_attitude.mode = set | disable_correction;
  EXPECT_THAT(host.ask(set_attitude), SizeIs(0));
  EXPECT_GT(up(), 0.9);
  set_attitude.mode = set;
  EXPECT_THAT(host.ask(set_attitude), SizeIs(0));
  EXPECT_LT(up(), -0.9);
}

TEST(LiveData, AnAttitudeThatIsNoneIsRefused) {
  Host host;
  msg::AhrsHelperRequestExt set;
  set.mode = msg::AhrsHelperModeBit::set;
  set.z1_vector = {0, 0, 1};
  EXPECT_EQ(host.get<msg::ErrorExt>(set).cmd_id, msg::CommandToBoard::ahrs_helper) << "no heading";
  set.mode = msg::AhrsHelperModeBit::set | msg::AhrsHelperModeBit::z1_only;
  EXPECT_THAT(host.ask(set), SizeIs(0));
  set.z1_vector = {0, 0, NAN};
  EXPECT_THAT(all<msg::ErrorExt>(host.ask(set)), SizeIs(1));
  set.z1_vector = {0, 0, 5};
  EXPECT_THAT(all<msg::ErrorExt>(host.ask(set)), SizeIs(1));
  EXPECT_THAT(
      all<msg::ErrorExt>(host.ask(msg::AhrsHelperRequest{.mode = msg::AhrsHelperModeBit::set})),
      SizeIs(1));
}

}  // namespace
}  // namespace sbgc::test
