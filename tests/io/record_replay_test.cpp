// Tests of the recorder: it is transparent for the conversation, whatever happens to the file; and
// of the replay of captures: contents, chunks and timing.

#include <sbgc/internal/crc32.hpp>
#include <sbgc/io/recorder.hpp>
#include <sbgc/io/replay.hpp>
#include <sbgc/wire.hpp>

#include "capture_support.hpp"

namespace sbgc::io::test {
namespace {

class Recording : public Line {
 protected:
  void start(const MemoryOptions& options = {}) {
    CaptureWriter writer;
    ASSERT_FALSE(writer.open(file.name(), begin));
    make_pair(options);
    host = record(std::move(port), std::move(writer),
                  {.on_error = [this](const Error& error) { errors.push_back(error); },
                   .now = [this] { return now; }});
  }

  TemporaryFile file;
  CaptureWriter::Clock::time_point now = begin;
  std::vector<Error> errors;
  std::unique_ptr<Transport> host;
};

TEST_F(Recording, KeepsWhoSaidWhatAndWhen) {
  start();
  now = begin + 10ms;
  expect_arrival(context, *host, *other, {'h', 'i'});
  write(context, *other, Bytes{'y', 'o', 'u'});
  now = begin + 30ms;
  EXPECT_EQ(read_all(context, *host, 3), (Bytes{'y', 'o', 'u'}));
  EXPECT_THAT(log_of(file.content()),
              ElementsAre("session", "3 @0: memory link", "2 @10000: hi", "1 @30000: you"));
}

TEST_F(Recording, ReadsAreKeptInThePiecesInWhichTheyCame) {
  start({.max_read = 2});
  expect_arrival(context, *other, *host, {'a', 'b', 'c'});
  EXPECT_THAT(log_of(file.content()),
              ElementsAre("session", "3 @0: memory link", "1 @0: ab", "1 @0: c"));
}

TEST_F(Recording, EveryByteIsTransparent) {
  start();
  expect_arrival(context, *host, *other, every_byte());
  expect_arrival(context, *other, *host, every_byte());
  EXPECT_EQ(host->description(), "memory link");
  EXPECT_EQ(host->line(), nullptr);
  EXPECT_EQ(host->executor(), context.get_executor());
}

TEST_F(Recording, NotesChangesOfTheLine) {
  start({.with_line = true});
  ASSERT_NE(host->line(), nullptr);
  EXPECT_FALSE(host->line()->set({57600, Parity::even}));
  EXPECT_EQ(host->line()->current(), (LineSettings{57600, Parity::even}));
  EXPECT_THAT(log_of(file.content()),
              ElementsAre("session", "3 @0: memory link, 115200 8N1", "3 @0: line: 57600 8E1"));
}

TEST_F(Recording, NotesHowItEnds) {
  start({.capacity = 1});
  Pending reading(context, *host);
  Pending writing(context, *host, {'a', 'b'});
  other.reset();
  EXPECT_EQ(reading.end().error, Errc::end_of_stream);
  EXPECT_EQ(writing.end().error, Errc::end_of_stream);
  const Log log = log_of(file.content());
  EXPECT_THAT(log, Contains("3 @0: read: The other side has closed the connection."));
  EXPECT_THAT(log, Contains("3 @0: write: 1 of 2 bytes, then: The other side has closed "
                            "the connection."));
}

TEST_F(Recording, DestroyedDuringRead) {
  start();
  Pending reading(context, *host);
  host.reset();
  EXPECT_EQ(reading.end().error, asio::error::operation_aborted);
  EXPECT_EQ(log_of(file.content()).back(), "3 @0: read: closed");
}

TEST_F(Recording, AFullDiskDoesNotDisturb) {
  start();
  write(context, *host, Bytes{'a'});
  const Log before = log_of(file.content());
  {
    const FileSizeLimit limit(file.content().size() + 3);
    write(context, *host, Bytes{'b'});
    expect_arrival(context, *other, *host, {'c'});
  }
  write(context, *host, Bytes{'d'});
  EXPECT_EQ(read_all(context, *other, 3), (Bytes{'a', 'b', 'd'}));
  ASSERT_THAT(errors, SizeIs(1));
  EXPECT_EQ(errors[0].code, std::errc::file_too_large);
  // Everything before is valid, and the remainder is reported as missing.
  Log expected = before;
  expected.push_back("torn: 3 from " + std::to_string(file.content().size() - 3));
  EXPECT_EQ(log_of(file.content()), expected);
}

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

TEST_F(Replay, AnswersFollowTheRequests) {
  session({{5ms, "a"}, {10ms, "b"}});
  open(ReplayTiming::answers);
  for (int n = 0; n < 2; ++n) {
    Pending reading(context, *port);
    std::this_thread::sleep_for(20ms);
    reading.expect_waiting();
    write(context, *port, Bytes{'?'});
    EXPECT_EQ(reading.end().size, 1U);
  }
  EXPECT_THAT(all(), ElementsAre());
}

TEST_F(Replay, AnswersComeWithoutRequestsToo) {
  session({{5ms, "a"}, {10ms, "b"}, {15ms, "c"}});
  open(ReplayTiming::answers);
  const auto start = SteadyClock::now();
  EXPECT_THAT(all(), ElementsAre("a", "b", "c"));
  EXPECT_GE(SteadyClock::now() - start, 1s);  // waits only once
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
