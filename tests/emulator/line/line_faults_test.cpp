// Tests of line faults: each occurs as often as configured, and text appears only between frames.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sbgc/parser.hpp>

#include "line_rig.hpp"

namespace sbgc::emulator::test {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

/// Expects that `count` is `share` of `total` within four standard deviations.
void expect_share(std::uint64_t count, std::uint64_t total, double share) {
  const double expected = static_cast<double>(total) * share;
  const double deviation = std::sqrt(expected * (1 - share));
  EXPECT_NEAR(static_cast<double>(count), expected, 4 * deviation);
}

TEST(Faults, ShareOfLostBytes) {
  Line line({.faults = {.lost = 0.02}}, Way::to_host, start, start);
  const Bytes bytes = noise(200'000);
  line.send(bytes, start);
  const Bytes got = received(line, start);
  expect_share(bytes.size() - got.size(), bytes.size(), 0.02);
  EXPECT_EQ(line.counters().lost, bytes.size() - got.size());
}

TEST(Faults, ShareOfDuplicatedBytes) {
  Line line({.board = {10000}, .faults = {.duplicated = 0.03}}, Way::to_board, start, start);
  Bytes bytes(100'000);
  for (std::size_t i = 0; i < bytes.size(); ++i) bytes[i] = static_cast<std::uint8_t>(i);
  line.send(bytes, start);
  const auto got = arrivals(line, later_on);
  std::uint64_t twice = 0;
  for (std::size_t i = 1; i < got.size(); ++i) twice += got[i].byte == got[i - 1].byte ? 1U : 0U;
  EXPECT_EQ(got.size(), bytes.size() + twice);
  EXPECT_EQ(line.counters().duplicated, twice);
  expect_share(twice, bytes.size(), 0.03);
  EXPECT_EQ(got.back().at, start + milliseconds(static_cast<std::int64_t>(got.size())));
}

TEST(Faults, ShareOfBitErrors) {
  Line line({.faults = {.bit_errors = 0.001}}, Way::to_host, start, start);
  const Bytes bytes = noise(200'000);
  line.send(bytes, start);
  const Bytes got = received(line, start);
  ASSERT_EQ(got.size(), bytes.size());
  std::array<std::uint64_t, 8> wrong{};
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    for (unsigned bit = 0; bit < 8; ++bit) {
      wrong[bit] += (static_cast<unsigned>(bytes[i] ^ got[i]) >> bit) & 1U;
    }
  }
  std::uint64_t sum = 0;
  for (const std::uint64_t count : wrong) {
    expect_share(count, bytes.size(), 0.001);
    sum += count;
  }
  EXPECT_EQ(line.counters().bit_errors, sum);
  // Errors are independent of each other.
  std::size_t neighbours = 0;
  for (std::size_t i = 1; i < bytes.size(); ++i) {
    neighbours += bytes[i - 1] != got[i - 1] && bytes[i] != got[i] ? 1U : 0U;
  }
  EXPECT_LT(neighbours, 50U);  // of 1600
}

TEST(Faults, ParityNoticesOneBadBit) {
  Line line({.board = {115200, Parity::even}, .faults = {.bit_errors = 0.001}}, Way::to_board,
            start, start);
  const Bytes bytes = noise(100'000);
  line.send(bytes, start);
  const Bytes got = bytes_of(arrivals(line, later_on));
  EXPECT_EQ(bytes.size() - got.size(), line.counters().parity_errors);
  EXPECT_GT(line.counters().parity_errors, 700U);
}

TEST(Faults, DelayedBytesHoldUpLaterOnes) {
  Line line({.board = {10000}, .faults = {.delayed = 0.01, .delay = milliseconds(50)}},
            Way::to_board, start, start);
  const Bytes bytes = noise(20'000);
  line.send(bytes, start);
  const auto got = arrivals(line, later_on);
  EXPECT_EQ(bytes_of(got), bytes);
  expect_share(line.counters().delayed, bytes.size(), 0.01);
  Duration most{};
  bool is_on_time_again = false;
  for (std::size_t i = 0; i < got.size(); ++i) {
    const Instant due = start + milliseconds(static_cast<std::int64_t>(i + 1));
    ASSERT_GE(got[i].at, due);
    most = std::max(most, got[i].at - due);
    if (most > Duration{} && got[i].at == due) is_on_time_again = true;
  }
  EXPECT_EQ(most, milliseconds(50));
  EXPECT_TRUE(is_on_time_again);
}

TEST(Faults, Silence) {
  const Silence silence{milliseconds(10), milliseconds(5)};
  Line line({.board = {10000}, .faults = {.silences = {silence}}}, Way::to_board, start, start);
  line.send(noise(20), start);
  std::vector<std::int64_t> times;
  for (const auto& [at, byte] : arrivals(line, later_on)) times.push_back((at - start).us / 1000);
  EXPECT_THAT(times, ElementsAre(1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 16, 17, 18, 19, 20));
  EXPECT_EQ(line.counters().silenced, 5U);
}

TEST(Faults, SilenceOfALineWithoutARate) {
  const Silence silence{seconds(1), seconds(1)};
  Line line({.faults = {.silences = {silence}}}, Way::to_board, start, start);
  for (const std::int64_t ms : {999, 1000, 1999, 2000}) {
    line.send(Bytes{static_cast<std::uint8_t>(ms / 10)}, start + milliseconds(ms));
  }
  EXPECT_THAT(received(line, later_on), ElementsAre(99, 200));
}

TEST(Faults, TheTwoWaysDiffer) {
  const LineOptions options{.faults = {.lost = 0.5}};
  Line there(options, Way::to_board, start, start);
  Line back(options, Way::to_host, start, start);
  there.send(noise(100), start);
  back.send(noise(100), start);
  EXPECT_NE(received(there, start), received(back, start));
}

std::size_t frames_in(const Bytes& bytes, Parser& parser) {
  std::size_t result = 0;
  parser.feed(bytes, [&](const Frame&) { ++result; });
  parser.flush([&](const Frame&) { ++result; });
  return result;
}

TEST(Faults, TextIsBetweenFrames) {
  Line line({.board = {115200}, .faults = {.text_every = milliseconds(30)}}, Way::to_host, start,
            start);
  line.send(frames(100), start);  // each takes 5.6 ms
  const Bytes got = bytes_of(arrivals(line, start + milliseconds(700)));
  Parser parser;
  EXPECT_EQ(frames_in(got, parser), 100U);
  EXPECT_GT(parser.counters().skipped_bytes, 200U);
  EXPECT_GE(line.counters().text_lines, 18U);
  EXPECT_LE(line.counters().text_lines, 23U);
}

TEST(Faults, TextComesByItself) {
  Line line({.faults = {.text_every = seconds(1)}}, Way::to_host, start,
            start + milliseconds(2500));
  EXPECT_EQ(line.next(), start + seconds(3));
  EXPECT_THAT(received(line, start + milliseconds(2999)), IsEmpty());
  const Bytes got = received(line, start + seconds(3));
  EXPECT_EQ(std::string(got.end() - 2, got.end()), "\r\n");
  EXPECT_EQ(line.next(), start + seconds(4));
  // Not within a frame.
  const Bytes frame = frames(1);
  line.send(std::span(frame).first(10), start + milliseconds(3900));
  EXPECT_EQ(received(line, start + seconds(5)), Bytes(frame.begin(), frame.begin() + 10));
  EXPECT_EQ(line.next(), Instant::never);
  line.send(std::span(frame).subspan(10), start + milliseconds(5200));
  EXPECT_GT(received(line, start + milliseconds(5200)).size(), frame.size() - 10);
}

TEST(Faults, TextThatIsLeftOut) {
  Line line({.faults = {.text_every = seconds(1)}}, Way::to_host, start, start);
  line.skip_text(start + milliseconds(2500));
  EXPECT_THAT(received(line, start + milliseconds(2500)), IsEmpty());
  EXPECT_EQ(line.next(), start + seconds(3));
  // Text that is waiting for the end of a frame is not left out.
  const Bytes frame = frames(1);
  line.send(std::span(frame).first(10), start + milliseconds(2900));
  line.skip_text(start + milliseconds(3500));
  line.send(std::span(frame).subspan(10), start + milliseconds(3600));
  EXPECT_GT(received(line, start + milliseconds(3600)).size(), frame.size());
  line.end_text();
  EXPECT_EQ(line.next(), Instant::never);
}

TEST(Faults, TextAfterAFrameThatIsBrokenOff) {
  Line line({.faults = {.text_every = seconds(1)}}, Way::to_host, start, start);
  const Bytes frame = frames(1);
  line.send(std::span(frame).first(10), start);
  EXPECT_EQ(received(line, start + seconds(2)).size(), 10U);
  line.abort_frame();
  EXPECT_GT(received(line, start + seconds(2)).size(), 0U);
  EXPECT_EQ(line.next(), start + seconds(3));
}

TEST(Faults, MoreTextThanTheLineCarries) {
  Line line({.board = {1200}, .faults = {.text_every = milliseconds(1)}}, Way::to_host, start,
            start);
  Bytes got;
  for (int ms = 0; ms < 10'000; ms += 10) line.receive(start + milliseconds(ms), got);
  EXPECT_NEAR(static_cast<double>(got.size()), 1200, 20);
  EXPECT_LT(line.under_way(), 20U);
}

}  // namespace
}  // namespace sbgc::emulator::test
