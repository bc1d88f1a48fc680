// Tests of what a board's memory holds: the EEPROM, as accessed by CMD_EEPROM_READ and
// CMD_EEPROM_WRITE, its records, and files, as accessed by CMD_READ_FILE and CMD_WRITE_FILE.

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <map>
#include <optional>
#include <random>
#include <span>
#include <vector>

#include <gtest/gtest.h>

#include <sbgc/internal/crc32.hpp>
#include <sbgc/wire.hpp>

#include "device/storage/eeprom.hpp"
#include "device/storage/file_system.hpp"

namespace sbgc {

// NOLINTNEXTLINE(readability-identifier-naming): the name that GoogleTest looks for
void PrintTo(msg::FileError error, std::ostream* out) {
  *out << "FileError " << static_cast<int>(error);
}

}  // namespace sbgc

namespace {

namespace msg = sbgc::msg;
using sbgc::emulator::Eeprom;
using sbgc::emulator::FileSystem;
using sbgc::emulator::Memory;
using ByteVector = std::vector<std::uint8_t>;

/// The page size of the specification.
constexpr std::size_t page = 64;

/// Returns `size` bytes, each different from its neighbors.
ByteVector numbered(std::size_t size, unsigned start = 1) {
  ByteVector result(size);
  for (std::size_t i = 0; i < size; ++i) result[i] = static_cast<std::uint8_t>(start + i * 7);
  return result;
}

TEST(Eeprom, WritesUpToTheLastPage) {
  Memory memory;
  Eeprom eeprom(memory);
  const ByteVector bytes = numbered(page);
  const auto last = static_cast<std::uint32_t>(eeprom.size() - page);
  ASSERT_TRUE(eeprom.write_pages(last, bytes));
  EXPECT_EQ(eeprom.read_pages(last, page), bytes);
  EXPECT_FALSE(eeprom.read_pages(last, 2 * page));
  EXPECT_FALSE(eeprom.write_pages(last, numbered(2 * page)));
}

TEST(Eeprom, RefusesWhatIsNoPages) {
  Memory memory;
  Eeprom eeprom(memory);
  const auto end = static_cast<std::uint32_t>(Memory::eeprom_size);
  for (const std::uint32_t address : {1U, 63U, 65U, 96U, end, 0x10000U, 0x80000000U, 0xFFFFFFC0U}) {
    EXPECT_FALSE(eeprom.read_pages(address, page)) << address;
    EXPECT_FALSE(eeprom.read_pages(address, 3 * page)) << address;
    EXPECT_FALSE(eeprom.write_pages(address, numbered(page))) << address;
  }
  for (const std::size_t size : {1U, 63U, 65U, 100U}) {
    EXPECT_FALSE(eeprom.read_pages(0, size)) << size;
    EXPECT_FALSE(eeprom.write_pages(0, numbered(size))) << size;
  }
  EXPECT_FALSE(eeprom.read_pages(page, static_cast<std::size_t>(-64)));
  EXPECT_EQ(memory, Memory());
}

TEST(Eeprom, CountsChangesOnly) {
  Memory memory;
  Eeprom eeprom(memory);
  eeprom.write_pages(0, numbered(page));
  const auto revision = memory.revision;
  EXPECT_NE(revision, 0);
  eeprom.write_pages(0, numbered(page));
  EXPECT_EQ(memory.revision, revision);
  eeprom.erase();
  EXPECT_NE(memory.revision, revision);
  EXPECT_EQ(memory.eeprom, Memory().eeprom);
}

TEST(Eeprom, MakesMemoryOfAnotherSizeFit) {
  Memory memory;
  memory.eeprom = {1, 2, 3};
  const Eeprom eeprom(memory);
  ASSERT_EQ(eeprom.size(), Memory::eeprom_size);
  EXPECT_EQ(eeprom.bytes(0, 4).back(), 0xFF);
  EXPECT_EQ(eeprom.bytes(0, 4).front(), 1);
}

TEST(Record, HoldsABodyOfAnySize) {
  Memory memory;
  Eeprom eeprom(memory);
  for (std::size_t size = 0; size <= 255; ++size) {
    ASSERT_TRUE(
        write_record(eeprom, 640, {msg::CommandFromBoard::read_params_3, 2}, numbered(size)));
    EXPECT_EQ(read_record(eeprom, 640, {msg::CommandFromBoard::read_params_3, 2}), numbered(size));
  }
  EXPECT_FALSE(write_record(eeprom, 640, {msg::CommandFromBoard::read_params_3, 2}, numbered(256)));
}

TEST(Record, TakesNoMoreThanItsPlace) {
  Memory memory;
  Eeprom eeprom(memory);
  const std::size_t size = sbgc::emulator::record_size();
  EXPECT_EQ(size % Eeprom::page_size(), 0);
  ASSERT_TRUE(
      write_record(eeprom, size, {msg::CommandFromBoard::read_params_3, 0}, ByteVector(255, 0)));
  EXPECT_EQ(eeprom.bytes(size - 1, 1).front(), 0xFF);
  EXPECT_EQ(eeprom.bytes(2 * size, 1).front(), 0xFF);
}

TEST(Record, ErasedOrEmptyMemoryIsNone) {
  Memory memory;
  const Eeprom eeprom(memory);
  EXPECT_FALSE(read_record(eeprom, 0, {static_cast<msg::CommandFromBoard>(0xFF), 0xFF}));
  std::ranges::fill(memory.eeprom, 0);
  EXPECT_FALSE(read_record(eeprom, 0, {static_cast<msg::CommandFromBoard>(0), 0}));
}

TEST(Record, IsNoneForAnotherMessageOrCopy) {
  Memory memory;
  Eeprom eeprom(memory);
  ASSERT_TRUE(write_record(eeprom, 0, {msg::CommandFromBoard::read_params_3, 1}, numbered(20)));
  EXPECT_FALSE(read_record(eeprom, 0, {msg::CommandFromBoard::read_params_3, 2}));
  EXPECT_FALSE(read_record(eeprom, 0, {msg::CommandFromBoard::read_params_ext, 1}));
}

TEST(Record, EveryChangedBitIsNoticed) {
  Memory memory;
  Eeprom eeprom(memory);
  constexpr std::size_t written = 3 + 40 + 4;
  ASSERT_TRUE(write_record(eeprom, 0, {msg::CommandFromBoard::read_params_3, 1}, numbered(40)));
  for (std::size_t bit = 0; bit < 8 * written; ++bit) {
    memory.eeprom[bit / 8] ^= static_cast<std::uint8_t>(1U << bit % 8);
    EXPECT_FALSE(read_record(eeprom, 0, {msg::CommandFromBoard::read_params_3, 1})) << bit;
    memory.eeprom[bit / 8] ^= static_cast<std::uint8_t>(1U << bit % 8);
  }
  EXPECT_TRUE(read_record(eeprom, 0, {msg::CommandFromBoard::read_params_3, 1}));
}

/// Writes a file as a host does: in parts of three pages.
msg::FileError write_whole(FileSystem& files, std::uint16_t file, const ByteVector& content) {
  const auto size = static_cast<std::uint16_t>(content.size());
  for (std::size_t at = 0; at < content.size(); at += 3 * page) {
    const auto part = std::span(content).subspan(at, std::min(3 * page, content.size() - at));
    const auto error = files.write(file, size, static_cast<std::uint16_t>(at / page), part);
    if (error != msg::FileError::no_error) return error;
  }
  return msg::FileError::no_error;
}

/// Returns the contents of a file, or nothing if it does not exist.
std::optional<ByteVector> whole(const FileSystem& files, std::uint16_t file) {
  ByteVector content;
  while (true) {
    const auto part = files.read(file, static_cast<std::uint16_t>(content.size() / page), 3 * page);
    if (part.error != msg::FileError::no_error) return std::nullopt;
    content.insert(content.end(), part.data.begin(), part.data.end());
    if (content.size() >= part.file_size) return content;
  }
}

/// Returns the maximum size of a single file in an empty file system.
std::uint16_t capacity() {
  Memory memory;
  FileSystem files(memory);
  std::uint16_t size = 0x8000;
  while (files.write(1, size, 0, numbered(1)) == msg::FileError::no_free_space)
    size = static_cast<std::uint16_t>(size - page);
  return size;
}

TEST(Files, APartIsWhatFitsIntoIt) {
  Memory memory;
  FileSystem files(memory);
  const ByteVector content = numbered(300);
  ASSERT_EQ(write_whole(files, 7, content), msg::FileError::no_error);
  const auto middle = files.read(7, 1, 10);
  EXPECT_EQ(middle.file_size, 300);
  EXPECT_EQ(middle.data, ByteVector(content.begin() + 64, content.begin() + 74));
  const auto end = files.read(7, 4, 100);
  EXPECT_EQ(end.data, ByteVector(content.begin() + 256, content.end()));
  for (const std::uint16_t behind : std::array<std::uint16_t, 3>{5, 6, 0xFFFF}) {
    const auto part = files.read(7, behind, 100);
    EXPECT_EQ(part.error, msg::FileError::no_error);
    EXPECT_EQ(part.file_size, 300);
    EXPECT_TRUE(part.data.empty());
  }
}

TEST(Files, AFullMemoryRefusesWithoutAnyChange) {
  Memory memory;
  FileSystem files(memory);
  const std::uint16_t all = capacity();
  EXPECT_GT(all, 10000);
  ASSERT_EQ(write_whole(files, 1, numbered(all - page)), msg::FileError::no_error);
  ASSERT_EQ(write_whole(files, 2, numbered(page)), msg::FileError::no_error);
  const Memory before = memory;
  EXPECT_EQ(files.write(3, 1, 0, numbered(1)), msg::FileError::no_free_space);
  EXPECT_EQ(files.write(2, page + 1, 0, numbered(page)), msg::FileError::no_free_space);
  EXPECT_EQ(files.write(2, 0xFFFF, 0, numbered(page)), msg::FileError::no_free_space);
  EXPECT_EQ(memory, before);
  // Deleting frees space.
  ASSERT_EQ(files.write(2, 0, 0, {}), msg::FileError::no_error);
  EXPECT_EQ(write_whole(files, 3, numbered(page)), msg::FileError::no_error);
  EXPECT_EQ(whole(files, 1), numbered(all - page));
  EXPECT_EQ(whole(files, 3), numbered(page));
}

TEST(Files, ADamagedTableIsNoticedAndClearRepairsIt) {
  Memory memory;
  FileSystem files(memory);
  ASSERT_EQ(write_whole(files, 1, numbered(100)), msg::FileError::no_error);
  memory.eeprom[sbgc::emulator::layout::files + 3] ^= 0x10;
  EXPECT_EQ(files.read(1, 0, 64).error, msg::FileError::fat);
  EXPECT_EQ(files.write(1, 10, 0, numbered(10)), msg::FileError::fat);
  EXPECT_EQ(files.write(1, 0, 0, {}), msg::FileError::fat);
  EXPECT_EQ(files.size(1), 0);
  EXPECT_EQ(files.clear(), msg::FileError::no_error);
  EXPECT_EQ(files.read(1, 0, 64).error, msg::FileError::file_not_found);
  EXPECT_EQ(write_whole(files, 1, numbered(100)), msg::FileError::no_error);
}

TEST(Files, ATableThatNoBoardHasWrittenIsDamaged) {
  Memory memory;
  FileSystem files(memory);
  const std::size_t size = capacity() / 2;
  ASSERT_EQ(write_whole(files, 1, numbered(size)), msg::FileError::no_error);
  ASSERT_EQ(write_whole(files, 2, numbered(100)), msg::FileError::no_error);
  // The second file extends past the end, although the checksum is valid.
  const auto table = std::span(memory.eeprom).subspan(sbgc::emulator::layout::files);
  constexpr std::size_t entry = 8, entries = FileSystem::most_files * entry;
  sbgc::wire::store(table.data() + entry + 2, static_cast<std::uint16_t>(size + 2 * page));
  sbgc::wire::store(table.data() + entries, sbgc::detail::crc32(table.first(entries)));
  EXPECT_EQ(files.read(1, 0, 64).error, msg::FileError::fat);
}

TEST(Files, ADamagedFileIsNoticedAndTheOthersAreNot) {
  Memory memory;
  FileSystem files(memory);
  ASSERT_EQ(write_whole(files, 1, ByteVector(200, 0xA5)), msg::FileError::no_error);
  ASSERT_EQ(write_whole(files, 2, numbered(100)), msg::FileError::no_error);
  const ByteVector content(200, 0xA5);
  const auto at =
      std::search(memory.eeprom.begin(), memory.eeprom.end(), content.begin(), content.end());
  ASSERT_NE(at, memory.eeprom.end());
  *at ^= 0x01;
  EXPECT_EQ(files.read(1, 0, 64).error, msg::FileError::crc);
  EXPECT_EQ(files.write(1, 200, 0, numbered(64)), msg::FileError::crc);
  EXPECT_EQ(whole(files, 2), numbered(100));
  // It remains damaged when another file is written or deleted.
  ASSERT_EQ(write_whole(files, 3, numbered(50)), msg::FileError::no_error);
  ASSERT_EQ(files.write(2, 0, 0, {}), msg::FileError::no_error);
  EXPECT_EQ(files.read(1, 0, 64).error, msg::FileError::crc);
  EXPECT_EQ(files.write(1, 0, 0, {}), msg::FileError::no_error);
  EXPECT_EQ(write_whole(files, 1, numbered(200)), msg::FileError::no_error);
  EXPECT_EQ(whole(files, 3), numbered(50));
}

// Any sequence of operations has the same result as on a map of contents: contents are kept, sizes
// and numbers of files have limits, an error changes nothing, and each step begins with the memory
// alone.
TEST(Files, BehaveAsAMapOfContents) {
  const std::size_t all_pages = capacity() / page;
  std::mt19937 random(6);
  const auto below = [&](std::size_t limit) { return random() % limit; };
  Memory memory;
  std::map<std::uint16_t, ByteVector> model;
  std::map<msg::FileError, int> seen;
  for (int step = 0; step < 5000; ++step) {
    FileSystem files(memory);
    constexpr std::array<std::uint16_t, 4> numbers{255, 256, 0x8000, 0xFFFF};
    const std::size_t which = below(44);
    const auto file = which < 40 ? static_cast<std::uint16_t>(which) : numbers[which - 40];
    const Memory before = memory;
    const auto found = model.find(file);
    const std::size_t action = below(1000);
    if (action == 0) {
      ASSERT_EQ(files.clear(), msg::FileError::no_error);
      model.clear();
    } else if (action < 150) {
      const auto error =
          found == model.end() ? msg::FileError::file_not_found : msg::FileError::no_error;
      ASSERT_EQ(files.write(file, static_cast<std::uint16_t>(random()), 3, {}), error);
      model.erase(file);
      ++seen[error];
    } else {
      const bool is_extreme = action % 50 == 1;
      const auto size = static_cast<std::uint16_t>(
          is_extreme ? 0xFFFF - below(2) : below(action % 10 == 0 ? 9000 : 700));
      const auto at = static_cast<std::uint16_t>(is_extreme ? random() : below(size / page + 2));
      const ByteVector data = numbered(1 + below(249), static_cast<unsigned>(random()));
      std::size_t taken = (size + page - 1) / page;
      for (const auto& [other, content] : model) {
        if (other != file) taken += (content.size() + page - 1) / page;
      }
      auto error = msg::FileError::no_error;
      if (taken > all_pages) error = msg::FileError::no_free_space;
      if (found == model.end() && model.size() == FileSystem::most_files) {
        error = msg::FileError::fat_is_full;
      }
      if (at * page + data.size() > size) error = msg::FileError::file_size;
      ASSERT_EQ(files.write(file, size, at, data), error);
      if (error != msg::FileError::no_error) {
        ASSERT_EQ(memory, before);
      }
      ++seen[error];
      if (error == msg::FileError::no_error) {
        ByteVector& content = model[file];
        content.resize(size);
        std::ranges::copy(data, content.begin() + static_cast<std::ptrdiff_t>(at * page));
      }
    }
    for (const auto& [id, content] : model) {
      if (below(20) != 0) continue;
      ASSERT_EQ(files.size(id), content.size());
      ASSERT_EQ(whole(files, id), content);
    }
  }
  EXPECT_EQ(seen.size(), 5) << "an outcome never came";
}

}  // namespace
