// Tests of live data: units, limits and sources.

#include <cmath>
#include <cstdint>
#include <vector>

#include "host.hpp"
#include "random_requests.hpp"

namespace sbgc::test {
namespace {

emulator::BoardOptions still() {
  emulator::BoardOptions options;
  options.gimbal.noise = 0;
  return options;
}

/// Returns a board with motors off, so that the camera remains where it is placed.
Host placed(const Axes<double>& angles) {
  Host host(still());
  host.ask(msg::MotorsOff{});
  host.board.gimbal().place(angles, host.now);
  return host;
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

}  // namespace
}  // namespace sbgc::test
