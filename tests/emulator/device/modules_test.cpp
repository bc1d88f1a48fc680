// Tests of modules on the CAN bus: lists, telemetry, transparent connections; and of copies for
// debugging.

#include <algorithm>
#include <cstdint>
#include <span>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "replies.hpp"

namespace sbgc::test {
namespace {

using ::testing::IsEmpty;
using ::testing::SizeIs;

TEST(Modules, AreTheSameInBothLists) {
  Host host(newest_board());
  const auto list = host.get<msg::ModuleList>(msg::ModuleListRequest{}).modules;
  const auto scan = host.get<msg::CanDeviceScan>(msg::CanDeviceScanRequest{}).devices;
  ASSERT_EQ(list.size(), scan.size());
  EXPECT_EQ(list[0].id, msg::ModuleId::imu_main);
  EXPECT_EQ(scan[0].id, msg::CanDeviceId::can_imu_main);
  EXPECT_EQ(scan[0].type.kind(), msg::CanDeviceKind::imu);
  EXPECT_EQ(list[8].id, msg::ModuleId::can_drv7);
  EXPECT_EQ(scan[8].id, msg::CanDeviceId::can_drv7);
  EXPECT_EQ(scan[8].type.kind(), msg::CanDeviceKind::motor_driver);
  for (std::size_t i = 1; i < scan.size(); ++i) EXPECT_NE(scan[i].uid, scan[0].uid);
}

TEST(Modules, NeedACanBus) {
  auto options = newest_board();
  options.board = msg::BoardVersion(30);
  Host host(options);
  EXPECT_THAT(host.get<msg::ModuleList>(msg::ModuleListRequest{}).modules, IsEmpty());
  EXPECT_EQ(refusal(host, msg::CanDeviceScanRequest{}), msg::BoardErrorCode::not_supported);
  const auto info = host.get<msg::BoardInfo>(msg::BoardInfoRequest{});
  EXPECT_FALSE(info.board_features.has(msg::BoardFeature::can_port));
}

TEST(Modules, StreamTelemetryOfADriver) {
  Host host(newest_board());
  using Field = msg::CanDrvTelemetryFlag;
  const msg::CanDrvTelemetry::Context fields{Field::temp_board | Field::motor_speed};
  msg::ExtMotorsControlConfig config{.for_motors = msg::ExtMotorTargets(0x84)};
  config.data_set = msg::ExtMotorsControlConfigField::mode;
  config.mode = msg::ExtMotorMode::speed;
  host.ask(config);
  host.ask(msg::ExtMotorsAction{msg::ExtMotorTargets(0x84), msg::ExtMotorActionKind::on, {}});
  msg::ExtMotorsControl control{.for_motors = msg::ExtMotor::motor3};
  control.setpoint16.emplace().push_back(1474);  // 180 deg/s, 30 turns a minute
  host.ask(control, seconds(2));
  msg::DataStreamInterval stream;
  stream.cmd_id = msg::CommandFromBoard::can_drv_telemetry;
  stream.interval_ms = msg::Milliseconds(100);
  stream.config.telemetry_flags = fields.flags;
  stream.config.drv_id = std::uint8_t{2};
  EXPECT_TRUE(is_confirmed(host, stream));
  const Packets samples = host.listen(seconds(1));
  ASSERT_THAT(samples, SizeIs(10));
  msg::CanDrvTelemetry data;
  ASSERT_TRUE(decode(std::span(samples.back().body), data, fields));
  EXPECT_EQ(data.drv_id, 2);
  EXPECT_NEAR((*data.motor_speed).revolutions_per_minute(), 30, 1);
  stream.config.drv_id = std::uint8_t{7};
  EXPECT_THAT(all<msg::ErrorExt>(host.ask(stream, milliseconds(5))), SizeIs(1));
}

TEST(Modules, IntroduceThemselvesThroughTheBoard) {
  Host host(newest_board());
  std::array<std::uint8_t, max_frame_size> frame{};
  const auto size = encode_frame(msg::BoardInfoRequest{}, frame).size;
  msg::TransparentSapiRequest request;
  static_cast<void>(request.target.set_device(msg::TransparentDevice::can_imu_main));
  for (std::size_t i = 0; i < size; ++i) request.payload.push_back(frame[i]);
  const auto answer = host.get<msg::TransparentSapi>(request);
  EXPECT_EQ(answer.target, request.target);
  Parser parser;
  unsigned introductions = 0;
  parser.feed(std::span(answer.payload.data(), answer.payload.size()), [&](const Frame& inner) {
    msg::BoardInfo info;
    if (inner.id == 86 && decode(inner.body, info)) ++introductions;
  });
  EXPECT_EQ(introductions, 1U);
  static_cast<void>(request.target.set_device(msg::TransparentDevice::can_serial_hub2));
  EXPECT_THAT(host.ask(request), IsEmpty()) << "there is no such device";
}

TEST(DebugCopies, OfOtherPorts) {
  Host host(newest_board());
  const auto watcher = host.port;
  EXPECT_TRUE(is_confirmed(
      host, msg::SetDebugPortRequest{.action = msg::DebugPortAction::start,
                                     .cmd_filter = msg::DebugPortCommand::get_angles}));
  const auto other = host.board.open_port().value();
  host.port = other;
  host.send(msg::MotorsOn{});
  host.send(msg::GetAnglesRequest{});
  host.listen(milliseconds(50));
  host.port = watcher;
  const auto copies = all<msg::SetDebugPort>(host.listen(milliseconds(50)));
  ASSERT_THAT(copies, SizeIs(2)) << "the request and its confirmation, but no angles";
  EXPECT_EQ(copies[0].cmd_id, 77);
  EXPECT_EQ(copies[0].port_and_dir.port(), other);
  EXPECT_FALSE(copies[0].port_and_dir.direction());
  EXPECT_EQ(copies[1].cmd_id, 67);
  EXPECT_TRUE(copies[1].port_and_dir.direction());
  EXPECT_THAT(copies[1].payload, ::testing::ElementsAre(77));
  EXPECT_TRUE(is_confirmed(host, msg::SetDebugPortRequest{}));
  host.port = other;
  host.ask(msg::MotorsOn{});
  host.port = watcher;
  EXPECT_THAT(host.listen(milliseconds(50)), IsEmpty());
}

TEST(DebugCopies, OfEachOtherDoNotRunAway) {
  Host host(newest_board());
  const msg::SetDebugPortRequest start{.action = msg::DebugPortAction::start};
  host.ask(start);
  const auto first = host.port;
  host.port = host.board.open_port().value();
  host.ask(start);
  host.ask(msg::MotorsOn{});
  const auto sent = host.board.counters().sent;
  host.listen(seconds(1));
  EXPECT_EQ(host.board.counters().sent, sent);
  host.port = first;
  EXPECT_FALSE(all<msg::SetDebugPort>(host.listen(milliseconds(10))).empty());
}

}  // namespace
}  // namespace sbgc::test
