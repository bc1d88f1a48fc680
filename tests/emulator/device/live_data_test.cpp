// Tests of live data: units, limits and sources; the blocks of CMD_REALTIME_DATA_CUSTOM in later
// firmware; debug variables and their announcement; data streams: rates, limits and their end.

#include <sbgc/meta/enums.hpp>
#include <sbgc/roles.hpp>

#include "device/debug/debugging.hpp"
#include "host.hpp"
#include "random_input.hpp"

namespace sbgc::test {
namespace {

emulator::BoardOptions still() { return {.gimbal = {.noise = 0}}; }

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

TEST(DebugVariables, EveryKindOfVariableIsThere) {
  const msg::DebugVarsInfo3 info = emulator::debug_variables_info();
  std::set<msg::DebugVarKind> kinds;
  std::set<msg::DebugVarAxis> axes;
  std::set<std::string> names;
  bool has_angle = false;
  for (const msg::DebugVarInfo& one : info.vars) {
    kinds.insert(one.var_type.kind());
    axes.insert(one.var_type.axis());
    names.insert(std::string(one.var_name.data(), one.var_name.size()));
    EXPECT_EQ(one.arr_size, 0) << "existing readers treat these bytes as reserved";
    has_angle = has_angle || one.var_type.flags().has(msg::DebugVarFlag::angle14);
  }
  EXPECT_EQ(kinds.size(), EnumMeta<msg::DebugVarKind>::info.values.size());
  EXPECT_EQ(axes.size(), EnumMeta<msg::DebugVarAxis>::info.values.size());
  EXPECT_EQ(names.size(), info.vars.size()) << "names are different";
  EXPECT_EQ(names.count(""), 0U);
  EXPECT_TRUE(has_angle);
}

msg::DataStreamInterval stream(msg::CommandFromBoard command, int interval_ms) {
  msg::DataStreamInterval request;
  request.cmd_id = command;
  request.interval_ms = msg::Milliseconds(static_cast<std::uint16_t>(interval_ms));
  return request;
}

msg::DataStreamInterval custom_stream(msg::RealtimeDataCustomFlags flags, int interval_ms) {
  auto request = stream(msg::CommandFromBoard::realtime_data_custom, interval_ms);
  request.config.flags = flags;
  return request;
}

const auto no_flags = msg::RealtimeDataCustomFlags{};

bool is_error(const Packets& packets) {
  return packets.size() == 1 && is<msg::ErrorExt>(packets[0]);
}

TEST(Streams, KeepTheirAverageRateForLong) {
  Host host;
  ASSERT_THAT(host.ask(custom_stream(no_flags, 7), milliseconds(1)), SizeIs(1));
  const auto packets = host.listen(seconds(60));
  ASSERT_EQ(packets.size(), 60'000U / 7);
  const Duration whole = packets.back().at - packets.front().at;
  EXPECT_EQ(whole.us, 7'000 * (static_cast<std::int64_t>(packets.size()) - 1));
}

TEST(Streams, AreSampledAtTheirTimeHoweverLateTheBoardIsAsked) {
  emulator::BoardOptions options;
  options.output_buffer = 0;
  Packets in_time, late;
  for (Packets* packets : {&in_time, &late}) {
    Host host(options);
    host.send(custom_stream(msg::RealtimeDataCustomFlag::imu_angles, 10));
    host.send(stream(msg::CommandFromBoard::realtime_data_4, 33));
    msg::Control control;
    control.control_mode.set_mode(msg::ControlModeKind::speed);
    control.axes.pitch.speed = 20_deg_per_s;
    host.send(control);
    if (packets == &late) host.board.advance(host.now + seconds(3));
    *packets = host.listen(seconds(3));
  }
  ASSERT_EQ(late.size(), in_time.size());
  ASSERT_GT(in_time.size(), 390U);
  for (std::size_t i = 0; i < late.size(); ++i) EXPECT_EQ(late[i].body, in_time[i].body) << i;
}

TEST(Streams, SamplesWithoutRoomAreSkippedAtNoCost) {
  Host host;
  host.ask(custom_stream(no_flags, 1), milliseconds(1));
  const auto skipped = host.board.counters().skipped;
  const auto sent = host.board.counters().sent;
  host.now = host.now + seconds(3600);
  host.board.advance(host.now);
  const auto now_sent = host.board.counters().sent - sent;
  EXPECT_LE(host.board.output(host.port).size(), host.board.options().output_buffer);
  EXPECT_GT(now_sent, 100U);
  EXPECT_EQ(host.board.counters().skipped - skipped + now_sent, 3600U * 1250);
  // The stream continues at its rate.
  host.listen({});
  EXPECT_THAT(host.listen(seconds(1)), SizeIs(1250));
}

TEST(Streams, AreLimitedOverAllPorts) {
  Host host;
  const auto other = host.board.open_port().value();
  const auto first = host.port;
  for (std::size_t i = 0; i < roles::stream_limit; ++i) {
    host.port = i % 2 == 0 ? first : other;
    const msg::RealtimeDataCustomFlags flags(static_cast<std::uint32_t>(i));
    const auto packets = host.ask(custom_stream(flags, 60'000));
    ASSERT_THAT(all<msg::Confirm>(packets), SizeIs(1));
  }
  EXPECT_TRUE(is_error(host.ask(stream(msg::CommandFromBoard::realtime_data_3, 60'000))));
  host.port = first;
  EXPECT_FALSE(is_error(host.ask(custom_stream(msg::RealtimeDataCustomFlags(0), 50'000))))
      << "a change";
  host.board.close_port(first);
  host.port = other;
  EXPECT_FALSE(is_error(host.ask(stream(msg::CommandFromBoard::realtime_data_3, 60'000))))
      << "there is room";
}

}  // namespace
}  // namespace sbgc::test
