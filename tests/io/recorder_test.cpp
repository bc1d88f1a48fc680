// Tests of the recorder: it is transparent for the conversation, whatever happens to the file.

#include <chrono>
#include <string>
#include <vector>

#include <asio/error.hpp>
#include <asio/io_context.hpp>
#include <gmock/gmock.h>

#include <sbgc/io/memory.hpp>
#include <sbgc/io/recorder.hpp>

#include "capture_support.hpp"

namespace sbgc::io::test {
namespace {

using namespace std::chrono_literals;
using testing::ElementsAre;
using testing::SizeIs;

class Recording : public testing::Test {
 protected:
  void start(const MemoryOptions& options = {}) {
    CaptureWriter writer;
    ASSERT_FALSE(writer.open(file.name(), begin));
    auto pair = make_memory_pair(context.get_executor(), options);
    board = std::move(pair.second);
    host = record(std::move(pair.first), std::move(writer),
                  {.on_error = [this](const Error& error) { errors.push_back(error); },
                   .now = [this] { return now; }});
  }

  asio::io_context context;
  TemporaryFile file;
  CaptureWriter::Clock::time_point now = begin;
  std::vector<Error> errors;
  std::unique_ptr<Transport> board;
  std::unique_ptr<Transport> host;
};

TEST_F(Recording, KeepsWhoSaidWhatAndWhen) {
  start();
  now = begin + 10ms;
  write(context, *host, Bytes{'h', 'i'});
  EXPECT_EQ(read_all(context, *board, 2), (Bytes{'h', 'i'}));
  write(context, *board, Bytes{'y', 'o', 'u'});
  now = begin + 30ms;
  EXPECT_EQ(read_all(context, *host, 3), (Bytes{'y', 'o', 'u'}));
  EXPECT_THAT(log_of(file.content()),
              ElementsAre("session", "3 @0: memory link", "2 @10000: hi", "1 @30000: you"));
}

TEST_F(Recording, ReadsAreKeptInThePiecesInWhichTheyCame) {
  start({.max_read = 2});
  write(context, *board, Bytes{'a', 'b', 'c'});
  EXPECT_EQ(read_all(context, *host, 3), (Bytes{'a', 'b', 'c'}));
  EXPECT_THAT(log_of(file.content()),
              ElementsAre("session", "3 @0: memory link", "1 @0: ab", "1 @0: c"));
}

TEST_F(Recording, EveryByteIsTransparent) {
  start();
  Operation writing;
  host->async_write(every_byte(), writing.handler());
  EXPECT_EQ(read_all(context, *board, 256), every_byte());
  EXPECT_EQ(finish(context, writing).size, 256U);
  write(context, *board, every_byte());
  EXPECT_EQ(read_all(context, *host, 256), every_byte());
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
  Operation reading;
  Operation writing;
  Bytes into(4);
  host->async_read(into, reading.handler());
  host->async_write(Bytes{'a', 'b'}, writing.handler());
  board.reset();
  EXPECT_EQ(finish(context, reading).error, Errc::end_of_stream);
  EXPECT_EQ(finish(context, writing).error, Errc::end_of_stream);
  const Log log = log_of(file.content());
  EXPECT_THAT(log, testing::Contains("3 @0: read: The other side has closed the connection."));
  EXPECT_THAT(log, testing::Contains("3 @0: write: 1 of 2 bytes, then: The other side has closed "
                                     "the connection."));
}

TEST_F(Recording, DestroyedDuringRead) {
  start();
  Operation reading;
  Bytes into(4);
  host->async_read(into, reading.handler());
  host.reset();
  EXPECT_EQ(finish(context, reading).error, asio::error::operation_aborted);
  EXPECT_EQ(log_of(file.content()).back(), "3 @0: read: closed");
}

TEST_F(Recording, AFullDiskDoesNotDisturb) {
  start();
  write(context, *host, Bytes{'a'});
  const Log before = log_of(file.content());
  {
    const FileSizeLimit limit(file.content().size() + 3);
    write(context, *host, Bytes{'b'});
    write(context, *board, Bytes{'c'});
    EXPECT_EQ(read_all(context, *host, 1), Bytes{'c'});
  }
  write(context, *host, Bytes{'d'});
  EXPECT_EQ(read_all(context, *board, 3), (Bytes{'a', 'b', 'd'}));
  ASSERT_THAT(errors, SizeIs(1));
  EXPECT_EQ(errors[0].code, std::errc::file_too_large);
  // Everything before is valid, and the remainder is reported as missing.
  Log expected = before;
  expected.push_back("torn: 3 from " + std::to_string(file.content().size() - 3));
  EXPECT_EQ(log_of(file.content()), expected);
}

}  // namespace
}  // namespace sbgc::io::test
