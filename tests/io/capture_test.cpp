// Tests of capture files: the format byte by byte, and the recovery of files that are truncated or
// damaged at any position.

#include <random>

#include <sys/stat.h>
#include <sys/time.h>

#include <sbgc/internal/crc32.hpp>
#include <sbgc/wire.hpp>

#include "capture_support.hpp"

namespace sbgc::io::test {
namespace {

/// Two sessions; `ends` holds the offsets at which items end.
struct Example {
  Bytes file;
  Log log;
  std::vector<std::size_t> ends;

  /// Returns how many items end at `offset` or before.
  std::size_t count(std::size_t offset) const {
    return static_cast<std::size_t>(std::ranges::upper_bound(ends, offset) - ends.begin());
  }
  std::size_t end(std::size_t item) const { return item == 0 ? 0 : ends[item - 1]; }
  Bytes first(std::size_t size) const {
    return {file.begin(), file.begin() + static_cast<std::ptrdiff_t>(size)};
  }
  /// Returns the log of the items before `from`, of what is there instead of those up to `to`, and
  /// of the rest.
  Log without(std::size_t from, std::size_t to, const Log& instead) const {
    const auto at = [&](std::size_t item) {
      return log.begin() + static_cast<std::ptrdiff_t>(item);
    };
    Log result(log.begin(), at(from));
    result.insert(result.end(), instead.begin(), instead.end());
    result.insert(result.end(), at(to), log.end());
    return result;
  }
};

Log bytes_lost(const std::string& reason, std::size_t begin, std::size_t end) {
  if (begin == end) return {};
  return {reason + ": " + std::to_string(end - begin) + " from " + std::to_string(begin)};
}

Example example() {
  Example result;
  const TemporaryFile path;
  const auto end_item = [&] { result.ends.push_back(path.content().size()); };
  for (int session = 0; session < 2; ++session) {
    CaptureWriter writer;
    EXPECT_FALSE(writer.open(path.name(), begin));
    end_item();
    EXPECT_FALSE(writer.write(CaptureKind::to_board, Bytes{'>', 86, 0, 86, 0}, begin + 5us));
    end_item();
    EXPECT_FALSE(writer.write(CaptureKind::from_board, every_byte(), begin + 1234567us));
    end_item();
    EXPECT_FALSE(writer.write_note("line: 57600 8E1", begin + 2s));
    end_item();
  }
  result.file = path.content();
  result.log = log_of(result.file);
  return result;
}

TEST(Capture, IsWrittenAsDocumented) {
  const TemporaryFile path;
  const auto before = std::chrono::system_clock::now();
  CaptureWriter writer;
  ASSERT_FALSE(writer.open(path.name(), begin));
  writer.write(CaptureKind::from_board, Bytes{1, 2, 3}, begin + 258us);
  const Bytes file = path.content();
  ASSERT_THAT(file, SizeIs(24 + 16 + 3));
  EXPECT_EQ(Bytes(file.begin(), file.begin() + 12),
            (Bytes{0x89, 'S', 'B', 'G', 'C', 0x0D, 0x0A, 0x1A, 1, 0, 0, 0}));
  const auto start = std::get<CaptureSession>(parse(file).at(0).item).start;
  EXPECT_GE(start, std::chrono::floor<std::chrono::microseconds>(before));
  EXPECT_LE(start, std::chrono::system_clock::now());
  // The checksum was calculated by another program (Python's zlib).
  EXPECT_EQ(Bytes(file.begin() + 24, file.end()),
            (Bytes{0xA5, 1, 3, 0, 2, 1, 0, 0, 0, 0, 0, 0, 1, 2, 3, 0x01, 0x75, 0x80, 0x1F}));
}

TEST(Capture, IsReadBack) {
  const Log log = example().log;
  ASSERT_THAT(log, SizeIs(8));
  EXPECT_EQ(log[0], "session");
  EXPECT_EQ(log[1], "2 @5: " + text_of(Bytes{'>', 86, 0, 86, 0}));
  EXPECT_EQ(log[2], "1 @1234567: " + text_of(every_byte()));
  EXPECT_EQ(log[3], "3 @2000000: line: 57600 8E1");
  EXPECT_EQ(log[4], "session");
}

TEST(Capture, ArrivesInAnyPieces) {
  const Example whole = example();
  for (const std::size_t size : {1U, 2U, 3U, 7U, 23U, 64U, 300U}) {
    EXPECT_EQ(log_of(whole.file, size), whole.log) << size;
  }
}

TEST(Capture, TornAnywhereKeepsEverythingBefore) {
  const Example whole = example();
  for (std::size_t size = 0; size < whole.file.size(); ++size) {
    const std::size_t good = whole.count(size);
    ASSERT_EQ(log_of(whole.first(size)),
              whole.without(good, 8, bytes_lost("torn", whole.end(good), size)))
        << size;
  }
}

TEST(Capture, TornAnywhereAndContinued) {
  const Example whole = example();
  for (std::size_t size = capture_magic_size; size < whole.ends[3]; ++size) {
    const TemporaryFile path;
    path.write(whole.first(size));
    CaptureWriter writer;
    ASSERT_FALSE(writer.open(path.name(), begin));
    writer.write(CaptureKind::from_board, Bytes{42}, begin + 1us);
    const std::size_t good = whole.count(size);
    Log expected = whole.without(good, 8, bytes_lost("damaged", whole.end(good), size));
    expected.insert(expected.end(), {"session", "1 @1: *"});
    ASSERT_EQ(log_of(path.content()), expected) << size;
  }
}

TEST(Capture, OneWrongByteCostsOneRecordOrTheSessionOfAHeader) {
  const Example whole = example();
  for (std::size_t at = capture_magic_size; at < whole.ends[3]; ++at) {
    Bytes damaged = whole.file;
    damaged[at] ^= 0x10;
    const std::size_t good = whole.count(at);
    const std::size_t next = good == 0 ? 4 : good + 1;
    const Log expected =
        whole.without(good, next, bytes_lost("damaged", whole.end(good), whole.end(next)));
    ASSERT_EQ(log_of(damaged), expected) << at;
    ASSERT_EQ(log_of(damaged, 7), expected) << at;
  }
}

TEST(Capture, RecordsOfALostSessionAreNotThoseOfTheSessionBefore) {
  const Example whole = example();
  Bytes damaged = whole.file;
  damaged[whole.ends[3]] ^= 0x10;  // the magic of the second session
  EXPECT_EQ(log_of(damaged),
            whole.without(4, 8, bytes_lost("damaged", whole.ends[3], damaged.size())));
}

TEST(Capture, NeitherAreThoseAfterADamagedHeader) {
  const TemporaryFile path;
  std::size_t half = 0;
  for (const auto time : {2s, 3s}) {
    CaptureWriter writer;
    half = path.content().size();
    ASSERT_FALSE(writer.open(path.name(), begin));
    writer.write(CaptureKind::from_board, Bytes{'a'}, begin + time);
  }
  Bytes damaged = path.content();
  damaged[half + capture_magic_size] ^= 0x10;
  EXPECT_EQ(log_of(damaged),
            (Log{"session", "1 @2000000: a", bytes_lost("damaged", half, damaged.size()).front()}));
}

TEST(Capture, AfterDamageARecordIsAtMostASecondEarlier) {
  for (const auto& [time, is_taken] : {std::pair(1s, true), std::pair(0s, false)}) {
    const TemporaryFile path;
    CaptureWriter writer;
    ASSERT_FALSE(writer.open(path.name(), begin));
    writer.write(CaptureKind::from_board, Bytes{'a'}, begin + 2s);
    const std::size_t size = path.content().size();
    writer.write(CaptureKind::from_board, Bytes{'b'}, begin + 2s);
    writer.write(CaptureKind::from_board, Bytes{'c'}, begin + time);
    Bytes damaged = path.content();
    damaged[size] ^= 0x10;
    const Log log = log_of(damaged);
    EXPECT_EQ(log.back() == "1 @1000000: c", is_taken);
    EXPECT_THAT(log, SizeIs(is_taken ? 4 : 3));
  }
}

TEST(Capture, LaterVersionsAreSkipped) {
  Example whole = example();
  const std::size_t size = whole.file.size();
  // A header of version 2, and bytes that may belong to it.
  const Bytes later{0x89, 0x53, 0x42, 0x47, 0x43, 0x0D, 0x0A, 0x1A, 0x02,
                    0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00, 0x00,
                    0x00, 0x00, 0x7E, 0xD1, 0xE5, 0xE8, 0x01, 0x02, 0x03};
  whole.file.insert(whole.file.end(), later.begin(), later.end());
  EXPECT_EQ(log_of(whole.file), whole.without(8, 8, bytes_lost("newer version", size, size + 27)));
}

TEST(Capture, ZerosAtTheEndAreDamage) {
  // Some file systems leave zeros at the end of a file after a power failure.
  Example whole = example();
  const std::size_t size = whole.file.size();
  whole.file.resize(size + 4096);
  EXPECT_EQ(log_of(whole.file), whole.without(8, 8, bytes_lost("damaged", size, size + 4096)));
}

constexpr std::uint64_t longest_time = (std::uint64_t{1} << 62) - 1;

/// Sets the time of a record of `file`, and its checksum.
void set_time(Bytes& file, std::size_t begin, std::size_t end, std::uint64_t time) {
  for (std::size_t i = 0; i < 8; ++i)
    file[begin + 4 + i] = static_cast<std::uint8_t>(time >> 8 * i);
  wire::store(file.data() + end - 4,
              sbgc::detail::crc32(std::span(file).subspan(begin, end - 4 - begin)));
}

TEST(Capture, TimesHave62Bits) {
  const Example whole = example();
  for (const std::uint64_t highest_bits : {0U, 1U, 2U, 3U}) {
    Bytes file = whole.file;
    set_time(file, whole.ends[0], whole.ends[1], highest_bits << 62 | longest_time);
    Log expected = whole.log;
    expected[1].replace(2, 2, "@" + std::to_string(longest_time));
    EXPECT_EQ(log_of(file), expected) << highest_bits;
  }
}

TEST(Capture, TheLongestTimeIsFollowedByDamageAndASession) {
  const Example whole = example();
  Bytes file = whole.file;
  set_time(file, whole.ends[0], whole.ends[1], ~std::uint64_t{0});
  file[whole.ends[1]] ^= 0x10;
  Log expected = whole.without(2, 4, bytes_lost("damaged", whole.ends[1], whole.ends[3]));
  expected[1].replace(2, 2, "@" + std::to_string(longest_time));
  EXPECT_EQ(log_of(file), expected);
}

TEST(Capture, OtherFilesAreNone) {
  EXPECT_THAT(log_of({}), IsEmpty());
  EXPECT_EQ(log_of({'>', 86, 0, 86, 0}), Log{"not a capture: 5 from 0"});
  Bytes behind = {0};
  const Bytes file = example().file;
  behind.insert(behind.end(), file.begin(), file.end());
  EXPECT_EQ(log_of(behind), Log{"not a capture: " + std::to_string(behind.size()) + " from 0"});
  EXPECT_FALSE(is_capture(Bytes{0x89, 'S', 'B'}));
  EXPECT_FALSE(is_capture(behind));
  EXPECT_TRUE(is_capture(file));
}

TEST(Capture, UnknownKindsAreHandedOn) {
  const TemporaryFile path;
  CaptureWriter writer;
  writer.open(path.name(), begin);
  writer.write(static_cast<CaptureKind>(77), Bytes{'a'}, begin);
  EXPECT_EQ(log_of(path.content()), (Log{"session", "77 @0: a"}));
}

TEST(Capture, LongReadsBecomeSeveralRecords) {
  const TemporaryFile path;
  CaptureWriter writer;
  writer.open(path.name(), begin);
  const Bytes much = every_byte(600);
  writer.write(CaptureKind::from_board, much, begin + 3us);
  Bytes all;
  for (const Parsed& parsed : parse(path.content()))
    all.insert(all.end(), parsed.bytes.begin(), parsed.bytes.end());
  EXPECT_EQ(all, much);
  EXPECT_THAT(log_of(path.content()), SizeIs(1 + 3));
}

TEST(Capture, TimeNeverRunsBackwards) {
  const TemporaryFile path;
  CaptureWriter writer;
  writer.open(path.name(), begin);
  writer.write(CaptureKind::from_board, Bytes{'a'}, begin - 1h);
  EXPECT_EQ(log_of(path.content()), (Log{"session", "1 @0: a"}));
}

TEST(CaptureWriter, LeavesOtherFilesAlone) {
  const TemporaryFile path;
  path.write({'n', 'o'});
  CaptureWriter writer;
  EXPECT_EQ(writer.open(path.name()).code, Errc::not_a_capture);
  EXPECT_EQ(writer.write(CaptureKind::from_board, Bytes{1}, begin).code, Errc::not_a_capture);
  EXPECT_EQ(path.content(), (Bytes{'n', 'o'}));
}

TEST(CaptureWriter, APartOfTheFirstHeaderIsReplaced) {
  const Example whole = example();
  for (std::size_t size = 0; size < capture_magic_size; ++size) {
    const TemporaryFile path;
    path.write(whole.first(size));
    CaptureWriter writer;
    ASSERT_FALSE(writer.open(path.name(), begin)) << size;
    writer.write(CaptureKind::from_board, Bytes{'a'}, begin);
    EXPECT_EQ(log_of(path.content()), (Log{"session", "1 @0: a"})) << size;
  }
}

TEST(CaptureWriter, OneAtATime) {
  const TemporaryFile path;
  CaptureWriter first;
  ASSERT_FALSE(first.open(path.name()));
  CaptureWriter second;
  EXPECT_EQ(second.open(path.name()).code, Errc::busy);
  first = CaptureWriter();
  EXPECT_FALSE(second.open(path.name()));
}

TEST(CaptureWriter, SaysWhyNot) {
  CaptureWriter writer;
  const Error error = writer.open("/nowhere/x.sbgc");
  EXPECT_EQ(error.code, std::errc::no_such_file_or_directory);
  EXPECT_THAT(error.message, HasSubstr("/nowhere/x.sbgc"));
  EXPECT_TRUE(CaptureWriter().write(CaptureKind::note, {}, begin));
}

TEST(RangeCrc32, IsTheCrcOfEachRange) {
  Bytes bytes(70000);
  std::mt19937 random(1);
  for (auto& byte : bytes) byte = static_cast<std::uint8_t>(random());
  detail::RangeCrc32 ranges;
  ranges.append(std::span(bytes).first(300));
  ranges.append(std::span(bytes).subspan(300));
  const auto expect_right = [&](std::size_t begin, std::size_t count) {
    EXPECT_EQ(ranges.of(begin, count), sbgc::detail::crc32(std::span(bytes).subspan(begin, count)))
        << begin << ' ' << count;
  };
  for (std::size_t begin = 0; begin < 20; ++begin) {
    for (std::size_t count = 0; count < 300; ++count) expect_right(begin, count);
  }
  for (const std::size_t count : {511U, 512U, 65535U, 65536U, 69000U}) expect_right(1000, count);
  ranges.drop(69000);
  bytes.erase(bytes.begin(), bytes.begin() + 69000);
  EXPECT_EQ(ranges.size(), 1000);
  expect_right(0, 1000);
  ranges.drop(2000);
  EXPECT_EQ(ranges.size(), 0);
  ranges.append(bytes);
  expect_right(10, 990);
}

TEST(CaptureWriter, AFullDiskIsAnError) {
  CaptureWriter writer;
  EXPECT_EQ(writer.open("/dev/full").code, std::errc::no_space_on_device);
}

TEST(CaptureWriter, APipeThatNobodyReadsIsAnError) {
  const TemporaryFile path;
  ASSERT_EQ(::mkfifo(path.name().c_str(), 0600), 0);
  CaptureWriter writer;
  EXPECT_EQ(writer.open(path.name(), begin).code, std::errc::no_such_device_or_address);
}

TEST(CaptureWriter, ASignalEndsWaitingForAReader) {
  std::array<int, 2> ends{};
  ASSERT_EQ(::pipe(ends.data()), 0);
  CaptureWriter writer;
  ASSERT_FALSE(writer.open(ends[1], "pipe", begin));
  struct sigaction old {};
  struct sigaction caught {};
  caught.sa_handler = [](int) {};
  ASSERT_EQ(::sigaction(SIGALRM, &caught, &old), 0);
  // Again and again, in case that the first one comes too early.
  const itimerval soon{{0, 20000}, {0, 20000}};
  ASSERT_EQ(::setitimer(ITIMER_REAL, &soon, nullptr), 0);
  writer.write(CaptureKind::from_board, every_byte(1000), begin);  // more than a pipe takes
  const itimerval never{};
  ::setitimer(ITIMER_REAL, &never, nullptr);
  ::sigaction(SIGALRM, &old, nullptr);
  EXPECT_EQ(writer.error().code, std::errc::interrupted);
  for (const int end : ends) ::close(end);
}

TEST(CaptureWriter, TimesBeginWithTheOpening) {
  std::array<int, 2> ends{};
  ASSERT_EQ(::pipe(ends.data()), 0);
  {
    CaptureWriter writer;
    ASSERT_FALSE(writer.open(ends[1], "pipe", begin));
    ASSERT_FALSE(writer.write(CaptureKind::from_board, Bytes{'a'}, begin + 3us));
  }
  Bytes content(1000);
  const ssize_t size = ::read(ends[0], content.data(), content.size());
  ASSERT_GT(size, 0);
  content.resize(static_cast<std::size_t>(size));
  EXPECT_EQ(log_of(content), (Log{"session", "1 @3: a"}));
  for (const int end : ends) ::close(end);
}

TEST(CaptureWriter, StopsAtTheFirstFailure) {
  const TemporaryFile path;
  CaptureWriter writer;
  ASSERT_FALSE(writer.open(path.name(), begin));
  writer.write(CaptureKind::from_board, Bytes{'a'}, begin);
  {
    const FileSizeLimit limit(path.content().size() + 10);  // within the next record
    EXPECT_EQ(writer.write(CaptureKind::from_board, Bytes{'b'}, begin).code,
              std::errc::file_too_large);
  }
  // There would be space again, but only after a torn record.
  EXPECT_EQ(writer.write(CaptureKind::from_board, Bytes{'c'}, begin).code,
            std::errc::file_too_large);
  EXPECT_EQ(log_of(path.content()), (Log{"session", "1 @0: a", "torn: 10 from 41"}));
}

}  // namespace
}  // namespace sbgc::io::test
