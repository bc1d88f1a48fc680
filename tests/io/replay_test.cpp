// Tests of the replay of captures: contents, chunks and timing.

#include <sbgc/internal/crc32.hpp>
#include <sbgc/io/replay.hpp>
#include <sbgc/wire.hpp>

#include "capture_support.hpp"

namespace sbgc::io::test {
namespace {

using SteadyClock = std::chrono::steady_clock;

class Replay : public Line {
 protected:
  /// Adds a session to the file.
  void session(const std::vector<std::pair<CaptureTime, std::string>>& said) {
    CaptureWriter writer;
    ASSERT_FALSE(writer.open(file.name(), begin));
    for (const auto& [time, text] : said) {
      writer.write(CaptureKind::to_board, Bytes{'?'}, begin + time);
      writer.write(CaptureKind::from_board, Bytes(text.begin(), text.end()), begin + time);
      writer.write_note("said", begin + time);
    }
  }

  void open(ReplayTiming timing) {
    port = opened(open_replay(context.get_executor(), file.name(), timing));
  }

  /// Reads to the end; returns one text for each read.
  std::vector<std::string> all(std::size_t size = 4096) {
    std::vector<std::string> result;
    for (;;) {
      Bytes into(size);
      const Outcome outcome = read(context, *port, into);
      if (outcome.error) {
        EXPECT_EQ(outcome.error, Errc::end_of_stream);
        return result;
      }
      into.resize(outcome.size);
      result.push_back(text_of(into));
    }
  }

  TemporaryFile file;
};

TEST_F(Replay, DeliversTheBoardsBytesInTheirPieces) {
  session({{0s, "ab"}, {1h, "c"}, {2h, ""}, {3h, "def"}});
  open(ReplayTiming::fast);
  EXPECT_THAT(all(), ElementsAre("ab", "c", "def"));
  EXPECT_EQ(port->description(), "capture " + file.name());
  EXPECT_EQ(port->line(), nullptr);
  open(ReplayTiming::fast);
  EXPECT_THAT(all(2), ElementsAre("ab", "c", "de", "f"));
}

TEST_F(Replay, OriginalTiming) {
  session({{20ms, "a"}, {20ms, "b"}, {60ms, "c"}});
  open(ReplayTiming::original);
  const auto start = SteadyClock::now();
  EXPECT_EQ(read_all(context, *port, 1), Bytes{'a'});
  EXPECT_GE(SteadyClock::now() - start, 20ms);
  EXPECT_EQ(read_all(context, *port, 1), Bytes{'b'});
  EXPECT_EQ(read_all(context, *port, 1), Bytes{'c'});
  EXPECT_GE(SteadyClock::now() - start, 60ms);
  EXPECT_THAT(all(), ElementsAre());
}

TEST_F(Replay, NoPauseBetweenSessions) {
  session({{0s, "a"}, {30ms, "b"}});
  // Changes the start to 1970: the header has the start at offset 12 and its checksum at 20.
  Bytes bytes = file.content();
  std::fill_n(bytes.begin() + 12, 8, std::uint8_t{0});
  wire::store(bytes.data() + 20, sbgc::detail::crc32(std::span(bytes).first(20)));
  file.write(bytes);
  session({{10ms, "c"}});
  open(ReplayTiming::original);
  const auto start = SteadyClock::now();
  EXPECT_THAT(all(), ElementsAre("a", "b", "c"));
  EXPECT_GE(SteadyClock::now() - start, 40ms);
}

TEST_F(Replay, CloseWhileItWaits) {
  session({{0s, "a"}, {1h, "b"}});
  open(ReplayTiming::original);
  EXPECT_EQ(read_all(context, *port, 1), Bytes{'a'});
  Pending reading(context, *port);
  port->close();
  EXPECT_EQ(reading.end().error, asio::error::operation_aborted);
  Bytes into(4);
  EXPECT_EQ(read(context, *port, into).error, asio::error::operation_aborted);
  EXPECT_EQ(write(context, *port, into).error, asio::error::operation_aborted);
}

TEST_F(Replay, DestroyedWhileItWaits) {
  session({{1h, "b"}});
  open(ReplayTiming::original);
  Pending reading(context, *port);
  port.reset();
  EXPECT_EQ(reading.end().error, asio::error::operation_aborted);
}

TEST_F(Replay, IgnoresWhatIsWritten) {
  session({{0s, "a"}});
  open(ReplayTiming::fast);
  EXPECT_EQ(write(context, *port, every_byte()).size, 256U);
  EXPECT_THAT(all(), ElementsAre("a"));
}

TEST_F(Replay, TornAndDamagedPlacesAreLeftOut) {
  const auto tear = [&] { std::filesystem::resize_file(file.name(), file.content().size() - 3); };
  session({{0s, "a"}, {1s, "b"}});
  tear();
  session({{0s, "c"}});
  tear();
  open(ReplayTiming::fast);
  EXPECT_THAT(all(), ElementsAre("a", "b", "c"));
}

TEST_F(Replay, LargeCaptures) {
  std::vector<std::pair<CaptureTime, std::string>> said;
  said.reserve(3000);
  for (int i = 0; i < 3000; ++i) said.emplace_back(CaptureTime(i), std::string(100, 'x'));
  session(said);
  open(ReplayTiming::fast);
  EXPECT_THAT(all(), SizeIs(3000));
}

TEST_F(Replay, TimesOutOfAllBounds) {
  for (int i = 0; i < 300; ++i) session({{std::chrono::years(290), "a"}});
  open(ReplayTiming::fast);
  EXPECT_THAT(all(), SizeIs(300));
}

TEST_F(Replay, RawCaptures) {
  const Bytes raw = every_byte(1000);
  file.write(raw);
  open(ReplayTiming::original);
  std::string got;
  for (const std::string& piece : all()) got += piece;
  EXPECT_EQ(got, text_of(raw));
}

TEST_F(Replay, EmptyFile) {
  file.write({});
  open(ReplayTiming::original);
  EXPECT_THAT(all(), ElementsAre());
}

TEST_F(Replay, OnlyFiles) {
  EXPECT_EQ(open_replay(context.get_executor(), "/dev/null").error.code, Errc::not_a_capture);
  EXPECT_EQ(open_replay(context.get_executor(), "/dev").error.code, Errc::not_a_capture);
  EXPECT_EQ(open_replay(context.get_executor(), file.name()).error.code, Errc::no_such_port);
}

}  // namespace
}  // namespace sbgc::io::test
