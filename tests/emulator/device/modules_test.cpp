// Tests of modules on the CAN bus: transparent connections; and of copies for
// debugging.

#include <algorithm>
#include <cstdint>
#include <span>

#include "replies.hpp"

namespace sbgc::test {
namespace {

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
