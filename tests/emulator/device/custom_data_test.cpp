// Tests of the blocks of CMD_REALTIME_DATA_CUSTOM in later firmware.

#include <cstdint>
#include <span>

#include "host.hpp"

namespace sbgc::test {
namespace {

using Block = msg::RealtimeDataCustomFlag;

TEST(CustomData, HasTheSizeOfEachBlock) {
  // Sizes by bit, from 9 on.
  const int sizes[]{8, 26, 9, 12, 40, 20, 46, 6, 12, 12, 7, 13, 8, 8, 8, 8, 12, 6, 24, 12, 11};
  Host host(newest_board());
  for (unsigned bit = 9; bit < 30; ++bit) {
    const msg::RealtimeDataCustomFlags flags(1U << bit);
    const Packets packets = host.ask(msg::RealtimeDataCustomRequest{.flags = flags});
    ASSERT_EQ(packets.size(), 1U) << bit;
    EXPECT_EQ(packets[0].body.size(), 2U + static_cast<unsigned>(sizes[bit - 9])) << bit;
  }
}

TEST(CustomData, RepeatsTheFlagsOnRequest) {
  Host host(newest_board());
  const auto flags = Block::imu_angles | Block::main_imu_state | Block::include_flags;
  const Packets packets = host.ask(msg::RealtimeDataCustomRequest{.flags = flags});
  ASSERT_EQ(packets.size(), 1U);
  // Decoding needs no request, nor is it misled by another one.
  for (const msg::RealtimeDataCustomFlags known : {{}, flags, Block::imu_angles | Block::rc_data}) {
    msg::RealtimeDataCustom data;
    ASSERT_TRUE(decode(std::span(packets[0].body), data, {known}));
    EXPECT_EQ(data.flags, flags);
    EXPECT_TRUE(data.main_imu_state);
    EXPECT_TRUE(data.tail.empty());
  }
}

}  // namespace
}  // namespace sbgc::test
