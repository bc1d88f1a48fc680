// Tests of a line: what the other end receives and when, also with other settings of the UART and
// with faults, each of which occurs as often as configured; text appears only between frames.

#include <numeric>
#include <string>

#include <sbgc/emulator/uart.hpp>
#include <sbgc/parser.hpp>

#include "line_rig.hpp"

namespace sbgc::emulator::test {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
TEST(Line, WithoutARateBytesTakeNoTime) {
  Line line({}, Way::to_host, start, start);
  EXPECT_EQ(line.next(), Instant::never);
  const Bytes bytes = noise(1000);
  EXPECT_GE(line.room(start), bytes.size());
  line.send(bytes, start + seconds(1));
  EXPECT_EQ(line.next(), start + seconds(1));
  EXPECT_EQ(received(line, start + seconds(1)), bytes);
  EXPECT_EQ(line.next(), Instant::never);
}

TEST(Line, BytesTakeTheirTime) {
  Line line({.board = {9600}}, Way::to_board, start, start);
  line.send(Bytes{1, 2, 3}, start);
  EXPECT_EQ(line.next(), start + microseconds(1042));  // 10 bits
  EXPECT_THAT(received(line, start + microseconds(1041)), IsEmpty());
  EXPECT_THAT(received(line, start + microseconds(1042)), ElementsAre(1));
  EXPECT_EQ(line.next(), start + microseconds(2084));
  EXPECT_THAT(received(line, start + microseconds(3125)), ElementsAre(2, 3));
}

TEST(Line, ParityTakesABitMore) {
  Line line({.board = {10000, Parity::even}}, Way::to_board, start, start);
  line.send(Bytes{1, 2}, start);
  EXPECT_THAT(arrivals(line, later_on), ElementsAre(Arrived{start + microseconds(1100), 1},
                                                    Arrived{start + microseconds(2200), 2}));
}

TEST(Line, RoundingNeverAddsUp) {
  // At 115200 baud a byte takes 86.8055... us. A sender that refills the UART whenever possible
  // gets exactly this rate for an hour.
  Line line({.board = {115200}}, Way::to_host, start, start);
  Instant now = start;
  std::uint64_t sent = 0;
  Bytes got;
  constexpr std::uint64_t total = 115200 / 10 * 600;
  while (sent < total) {
    const std::size_t room = std::min<std::uint64_t>(line.room(now), total - sent);
    line.send(Bytes(room, 0x55), now);
    sent += room;
    now = later(now + microseconds(1), line.ready());
    got.clear();
    line.receive(now, got);
  }
  Instant last{};
  while (line.next() != Instant::never) received(line, last = line.next());
  EXPECT_EQ(last, start + seconds(600));
}

TEST(Line, BytesHandedOverInTheLastMomentMakeNoPause) {
  Line line({.board = {115200}}, Way::to_host, start, start);
  Instant now = start;
  for (int i = 0; i < 1000; ++i) {
    line.send(Bytes{1}, now);
    now = line.next();
    received(line, now);
  }
  EXPECT_EQ(now, start + microseconds(86'806));
}

TEST(Line, TheUartTakesFewBytesAtOnce) {
  Line line({.board = {10000}}, Way::to_host, start, start);
  EXPECT_EQ(line.room(start), Line::fifo_size);
  line.send(Bytes(Line::fifo_size, 1), start);
  EXPECT_EQ(line.room(start), 0U);
  EXPECT_EQ(line.room(start + microseconds(999)), 0U);
  EXPECT_EQ(line.room(start + microseconds(1000)), 1U);
  EXPECT_EQ(line.ready(), start + milliseconds(8));
  EXPECT_EQ(line.room(line.ready()), 8U);
  EXPECT_EQ(line.room(start + seconds(5)), Line::fifo_size);
}

TEST(Line, APauseIsAPause) {
  Line line({.board = {10000}}, Way::to_board, start, start);
  line.send(Bytes{1}, start);
  line.send(Bytes{2}, start + microseconds(500));
  line.send(Bytes{3}, start + microseconds(7777));
  EXPECT_THAT(arrivals(line, later_on), ElementsAre(Arrived{start + microseconds(1000), 1},
                                                    Arrived{start + microseconds(2000), 2},
                                                    Arrived{start + microseconds(8777), 3}));
}

TEST(WrongSettings, TheRateOfTheHostCounts) {
  Line line({.board = {115200}}, Way::to_board, start, start);
  line.set_host(LineSettings{57600});
  const Bytes bytes = noise(100);
  line.send(bytes, start);
  const auto got = arrivals(line, later_on);
  EXPECT_NE(bytes_of(got), bytes);
  ASSERT_FALSE(got.empty());
  EXPECT_GT(got.back().at, start + microseconds(16'000));
  EXPECT_LE(got.back().at, start + microseconds(17'500));
  EXPECT_EQ(line.counters().mismatched, 100U);
}

TEST(WrongSettings, RightOnesAgain) {
  Line line({.board = {115200}}, Way::to_host, start, start);
  const Bytes bytes = frames(3);
  line.set_host(LineSettings{57600});
  line.send(bytes, start);
  EXPECT_NE(bytes_of(arrivals(line, start + seconds(1))), bytes);
  line.set_host(LineSettings{115200});
  line.send(bytes, start + seconds(1));
  EXPECT_EQ(bytes_of(arrivals(line, start + seconds(2))), bytes);
  line.set_board({256000});
  line.send(bytes, start + seconds(2));
  EXPECT_NE(bytes_of(arrivals(line, start + seconds(3))), bytes);
  line.set_host(std::nullopt);
  line.send(bytes, start + seconds(3));
  EXPECT_EQ(bytes_of(arrivals(line, start + seconds(4))), bytes);
}

TEST(WrongSettings, Parity) {
  const Bytes bytes = frames(1);
  for (const bool detects : {false, true}) {
    for (const Way way : {Way::to_board, Way::to_host}) {
      Line line({.board = {115200}, .detects_parity = detects}, way, start, start);
      line.set_host(LineSettings{115200, Parity::even});
      line.send(bytes, start);
      EXPECT_EQ(bytes_of(arrivals(line, later_on)) == bytes, detects);
    }
  }
}

TEST(WrongSettings, DoNotMatterWithoutARate) {
  Line line({}, Way::to_host, start, start);
  line.set_host(LineSettings{9600, Parity::even});
  line.send(Bytes{1, 2}, start);
  EXPECT_THAT(received(line, start), ElementsAre(1, 2));
}

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

/// The result of sending the same bytes at the same times, in any chunks and received at any times.
struct Result {
  std::vector<Arrived> arrived;
  LineCounters counters;
  bool operator==(const Result&) const = default;
};

Result run(const LineOptions& options, Way way, std::optional<LineSettings> host,
           std::uint64_t cutting) {
  Line line(options, way, start, start);
  line.set_host(host);
  Result result;
  std::uint64_t counter = 0;
  const auto random = [&](std::uint64_t below) { return random_bits(cutting, counter++) % below; };
  const auto receive_until = [&](Instant until) {
    for (auto& one : arrivals(line, until)) result.arrived.push_back(one);
  };
  const Bytes stream = frames(60);
  Instant now = start;
  for (std::size_t at = 0; at < stream.size();) {
    now = now + microseconds(static_cast<std::int64_t>(random_bits(5, at) % 9000));
    const std::size_t size = std::min<std::size_t>(1 + random_bits(6, at) % 90, stream.size() - at);
    if (cutting != 0 && random(2) == 0) receive_until(now);
    for (std::size_t done = 0; done < size;) {
      const std::size_t piece = cutting == 0 ? size : std::min(1 + random(40), size - done);
      line.send(std::span(stream).subspan(at + done, piece), now);
      done += piece;
      if (cutting != 0 && random(2) == 0) receive_until(now);
    }
    at += size;
  }
  receive_until(now + seconds(1));
  result.counters = line.counters();
  return result;
}

TEST(Deterministic, HoweverItIsCut) {
  const Faults faults{.bit_errors = 0.002,
                      .lost = 0.01,
                      .duplicated = 0.01,
                      .delayed = 0.01,
                      .text_every = milliseconds(40),
                      .silences = {{milliseconds(100), milliseconds(20)}}};
  for (const LineSettings board : {LineSettings{}, {115200}, {57600, Parity::even}, {2'000'000}}) {
    for (const auto& host : std::vector<std::optional<LineSettings>>{
             std::nullopt, LineSettings{115200}, LineSettings{9600}, LineSettings{256000}}) {
      for (const Way way : {Way::to_board, Way::to_host}) {
        const LineOptions options{.board = board, .faults = faults, .seed = 3};
        const Result whole = run(options, way, host, 0);
        ASSERT_TRUE(!whole.arrived.empty() || whole.counters.mismatched > 0);
        for (std::uint64_t cutting = 1; cutting < 10; ++cutting) {
          const Result cut = run(options, way, host, cutting);
          ASSERT_EQ(cut.counters, whole.counters);
          ASSERT_TRUE(cut.arrived == whole.arrived)
              << board.baud_rate << ' ' << (host ? host->baud_rate : 0) << ' ' << cutting;
        }
      }
    }
  }
}

TEST(Deterministic, AnotherSeedIsAnotherLine) {
  const LineOptions options{.faults = {.lost = 0.1}};
  LineOptions other = options;
  other.seed = 2;
  EXPECT_NE(run(options, Way::to_host, {}, 0), run(other, Way::to_host, {}, 0));
}

}  // namespace
}  // namespace sbgc::emulator::test

namespace sbgc::emulator {
namespace {

using ByteVector = std::vector<std::uint8_t>;

ByteVector every_byte() {
  ByteVector bytes(256);
  std::iota(bytes.begin(), bytes.end(), std::uint8_t{0});
  return bytes;
}
TEST(ReceivedAs, SameSettingsChangeNothing) {
  const ByteVector bytes = every_byte();
  for (const LineSettings line : {LineSettings{9600}, LineSettings{115200, Parity::even}}) {
    EXPECT_EQ(received_as(bytes, line, line), bytes);
  }
}

TEST(ReceivedAs, AlmostTheSameRateChangesNothing) {
  const ByteVector bytes = every_byte();
  EXPECT_EQ(received_as(bytes, {115200}, {117000}), bytes);
  EXPECT_EQ(received_as(bytes, {115200, Parity::even}, {113500, Parity::even}), bytes);
}

TEST(ReceivedAs, OtherSettingsGiveOtherBytes) {
  const LineSettings even{9600, Parity::even};
  struct Case {
    ByteVector sent;
    LineSettings by, to;
    ByteVector received;
    const char* why;
  };
  for (const Case& one : std::vector<Case>{
           {{0xE0}, {19200}, {9600}, {0xFC}, "six 0 bits, then ones: a start bit and two 0 bits"},
           {{0xFF}, {9600}, {19200}, {0xFE}, "a start bit of two bits, then ones"},
           {{0x00}, {9600}, {19200}, {}, "a break: the stop bit is missing"},
           {{0x01}, {9600}, even, {0x01}, "an odd number of ones: the stop bit is the parity bit"},
           {{0x03}, {9600}, even, {}, "an even number of ones"},
           {{0x01, 0x03, 0x07}, even, {9600}, {0x01, 0x07}, "the parity bit is the stop bit"},
       }) {
    EXPECT_EQ(received_as(one.sent, one.by, one.to), one.received) << one.why;
  }
}

}  // namespace
}  // namespace sbgc::emulator
