// Tests of the board's files, as accessed by CMD_READ_FILE and CMD_WRITE_FILE.

#include "device/storage/file_system.hpp"

#include <algorithm>
#include <array>
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

#include "memory_bytes.hpp"

namespace sbgc {

// NOLINTNEXTLINE(readability-identifier-naming): the name that GoogleTest looks for
void PrintTo(msg::FileError error, std::ostream* out) {
  *out << "FileError " << static_cast<int>(error);
}

}  // namespace sbgc

namespace {

namespace msg = sbgc::msg;
using sbgc::emulator::FileSystem;
using sbgc::emulator::Memory;
using sbgc::test::numbered;
using sbgc::test::page;
using ByteVector = std::vector<std::uint8_t>;

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

TEST(Files, ANewBoardHasNone) {
  Memory memory;
  const FileSystem files(memory);
  EXPECT_EQ(files.read(0, 0, 64).error, msg::FileError::file_not_found);
  EXPECT_EQ(files.size(0), 0);
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
