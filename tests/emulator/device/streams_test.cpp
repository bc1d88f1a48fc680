// Tests of data streams: rates, limits and their end.

#include <vector>

#include <sbgc/roles.hpp>

#include "host.hpp"
#include "random_requests.hpp"

namespace sbgc::test {
namespace {

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
  const auto packets = host.listen(seconds(600));
  ASSERT_EQ(packets.size(), 600'000U / 7);
  const Duration whole = packets.back().at - packets.front().at;
  EXPECT_EQ(whole.us, 7'000 * (static_cast<std::int64_t>(packets.size()) - 1));
}

TEST(Streams, OneMillisecondMeansEachCycle) {
  Host host;
  host.ask(custom_stream(no_flags, 1), microseconds(800));
  EXPECT_THAT(host.listen(seconds(2)), SizeIs(2500));
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

TEST(Streams, AreNamedByCommandAndConfig) {
  Host host;
  host.ask(custom_stream(no_flags, 10));
  host.ask(custom_stream(msg::RealtimeDataCustomFlag::acc_data, 10));
  EXPECT_THAT(host.listen(seconds(1)), SizeIs(200));
  host.ask(custom_stream(no_flags, 100));
  host.listen(milliseconds(100));
  EXPECT_THAT(host.listen(seconds(1)), SizeIs(110)) << "the first one is changed";
  EXPECT_THAT(host.ask(custom_stream(msg::RealtimeDataCustomFlag::acc_data, 0), milliseconds(1)),
              ::testing::Not(IsEmpty()));
  EXPECT_THAT(host.listen(seconds(1)), SizeIs(10)) << "the second one is over";
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
