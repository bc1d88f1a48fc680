// Tests of the recorder: it is transparent for the conversation, whatever happens to the file.

#include <sbgc/io/recorder.hpp>

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

}  // namespace
}  // namespace sbgc::io::test
