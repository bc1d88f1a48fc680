// Tests of modules on the CAN bus: transparent connections; and of copies for
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
