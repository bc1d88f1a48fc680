// Checks of live data and of commands that move the camera.

#include <span>
#include <type_traits>

#include <gmock/gmock.h>

#include "table.hpp"

namespace sbgc::test {
namespace {

using ::testing::IsEmpty;
using ::testing::SizeIs;

/// Returns a request that moves the camera to a pitch angle.
template <Message M>
M to_pitch(double degrees) {
  M request{};
  if constexpr (std::is_same_v<M, msg::Control>) {
    request.control_mode.set_mode(msg::ControlModeKind::angle);
  } else {
    request.control_mode.pitch.set_mode(msg::ControlModeKind::angle);
  }
  request.axes.pitch.angle = *msg::Angle14::from_degrees(degrees);
  return request;
}

}  // namespace

void Table::add_live_data() {
  const auto is_alive = [](Host& host, const auto& data) {
    EXPECT_EQ(data.cur_imu, msg::SelectedImu::main);
    EXPECT_NEAR(data.axes.yaw.acc_data.real(), 1.0, 0.05) << "gravity, level and at rest";
    EXPECT_GT(data.bat_level.raw(), 1000);
    EXPECT_EQ(data.other_flags.has(msg::OtherFlag::motors_on), host.board.gimbal().motors_on());
    EXPECT_EQ(data.system_error.raw(), 0);
  };
  const auto of_data_3 = [is_alive](Host& host, const Packets& packets) {
    is_alive(host, only<msg::RealtimeData3>(packets));
  };
  add<msg::RealtimeData>({.after = of_data_3});
  add<msg::RealtimeData3Request>({.after = of_data_3});
  add<msg::RealtimeData4Request>({.after = [is_alive](Host& host, const Packets& packets) {
    const auto data = only<msg::RealtimeData4>(packets);
    is_alive(host, data);
    EXPECT_GT(data.current.raw(), 0);
    EXPECT_GT(data.imu_temperature.raw(), 10);
  }});
  const msg::RealtimeDataCustomFlags flags =
      msg::RealtimeDataCustomFlag::imu_angles | msg::RealtimeDataCustomFlag::z1_h1_vectors;
  const auto has_the_blocks = [flags](Host&, const Packets& packets) {
    ASSERT_THAT(packets, SizeIs(1));
    msg::RealtimeDataCustom data;
    ASSERT_TRUE(decode(std::span(packets[0].body), data, {.flags = flags}));
    ASSERT_TRUE(data.imu_angles && data.z1_vector);
    EXPECT_NEAR(static_cast<double>(data.z1_vector->z), 1.0, 0.01);
    EXPECT_FALSE(data.acc_data);
  };
  add<msg::RealtimeDataCustomRequest>({.request = {.flags = flags}, .after = has_the_blocks});
  msg::DataStreamInterval stream;
  stream.cmd_id = msg::CommandFromBoard::realtime_data_3;
  stream.interval_ms = msg::Milliseconds(0);
  add<msg::DataStreamInterval>(
      {.request = stream,
       .before =
           [](Host& host) {
             msg::DataStreamInterval begin;
             begin.cmd_id = msg::CommandFromBoard::realtime_data_3;
             begin.interval_ms = msg::Milliseconds(10);
             EXPECT_THAT(all<msg::RealtimeData3>(host.ask(begin, milliseconds(1005))), SizeIs(100));
           },
       .after = [](Host& host,
                   const Packets&) { EXPECT_THAT(host.listen(seconds(1)), IsEmpty()); }});
}

void Table::add_control() {
  const auto has_arrived = [](Host& host, const Packets&) {
    host.listen(seconds(5));
    const auto angles = host.get<msg::GetAngles>(msg::GetAnglesRequest{});
    EXPECT_NEAR(angles.axes.pitch.imu_angle.degrees(), -30, 0.5);
    EXPECT_NEAR(angles.axes.pitch.rc_target_angle.degrees(), -30, 0.03);
    EXPECT_EQ(angles.axes.pitch.rc_speed.raw(), 0);
  };
  const auto tells_angles = [](Host& host, const Packets& packets, const auto& angles) {
    EXPECT_THAT(packets, SizeIs(1));
    const auto truth = host.board.gimbal().sample(host.now);
    EXPECT_NEAR(angles.axes.pitch.imu_angle.degrees(), truth.angles.pitch, 0.5);
  };
  const auto moved = [](Host& host) {
    host.send(to_pitch<msg::Control>(20));
    host.listen(seconds(5));
  };
  add<msg::Control>(
      {.request = to_pitch<msg::Control>(-30), .comes = Comes::confirmation, .after = has_arrived});
  add<msg::ControlExt>({.request = to_pitch<msg::ControlExt>(-30),
                        .comes = Comes::confirmation,
                        .after = has_arrived});
  add<msg::GetAnglesRequest>({.before = moved, .after = [=](Host& host, const Packets& packets) {
                                tells_angles(host, packets, only<msg::GetAngles>(packets));
                              }});
  add<msg::GetAnglesExtRequest>({.before = moved, .after = [=](Host& host, const Packets& packets) {
                                   tells_angles(host, packets, only<msg::GetAnglesExt>(packets));
                                 }});
  const auto on = [](Host& host) { host.ask(msg::MotorsOn{}); };
  const auto off = [](Host& host) { host.ask(msg::MotorsOff{}); };
  const auto is_on = [](Host& host, const Packets&) {
    EXPECT_TRUE(host.board.gimbal().motors_on());
  };
  const auto is_off = [](Host& host, const Packets&) {
    EXPECT_FALSE(host.board.gimbal().motors_on());
  };
  add<msg::MotorsOn>({.before = off, .after = is_on});
  add<msg::MotorsOff>({.before = on, .after = is_off});
  emulator::BoardOptions later;
  later.firmware = msg::FirmwareVersion(2687);
  add<msg::MotorsOffExt>({.before = on, .after = is_off, .options = later});
  add<msg::ExecuteMenu>({.request = {.cmd_id = msg::MenuCommand::motor_toggle},
                         .comes = Comes::confirmation,
                         .before = on,
                         .after = is_off});
  add<msg::ExecuteMenuExt>(
      {.request = {.cmd_id = msg::MenuCommand::profile3},
       .comes = Comes::confirmation,
       .after = [](Host& host, const Packets&) {
         EXPECT_EQ(host.get<msg::RealtimeData3>(msg::RealtimeData3Request{}).cur_profile, 2);
       }});
  add<msg::HelperDataExt>({.request = {.coord_sys = msg::CoordinateSystem::ground_yaw_rotated}});
}

}  // namespace sbgc::test
