// Tests of the EEPROM, as accessed by CMD_EEPROM_READ and CMD_EEPROM_WRITE, and of its records.

#include "device/storage/eeprom.hpp"

#include <algorithm>
#include <cstdint>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "memory_bytes.hpp"

namespace {

namespace msg = sbgc::msg;
using sbgc::emulator::Eeprom;
using sbgc::emulator::Memory;
using sbgc::test::numbered;
using sbgc::test::page;
using ByteVector = std::vector<std::uint8_t>;

TEST(Eeprom, HasThePagesOfTheSpecification) { EXPECT_EQ(Eeprom::page_size(), page); }

TEST(Eeprom, NewMemoryIsErased) {
  Memory memory;
  const Eeprom eeprom(memory);
  EXPECT_EQ(eeprom.read_pages(0, eeprom.size()), ByteVector(Memory::eeprom_size, 0xFF));
}

TEST(Eeprom, GivesBackWhatWasWrittenAndLeavesTheRest) {
  Memory memory;
  Eeprom eeprom(memory);
  const ByteVector bytes = numbered(3 * page);
  ASSERT_TRUE(eeprom.write_pages(5 * page, bytes));
  EXPECT_EQ(eeprom.read_pages(5 * page, bytes.size()), bytes);
  EXPECT_EQ(eeprom.read_pages(4 * page, page), ByteVector(page, 0xFF));
  EXPECT_EQ(eeprom.read_pages(8 * page, page), ByteVector(page, 0xFF));
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
  for (const std::uint32_t address : {1U, 63U, 65U, 96U}) {
    EXPECT_FALSE(eeprom.read_pages(address, page)) << address;
    EXPECT_FALSE(eeprom.write_pages(address, numbered(page))) << address;
  }
  for (const std::size_t size : {1U, 63U, 65U, 100U}) {
    EXPECT_FALSE(eeprom.read_pages(0, size)) << size;
    EXPECT_FALSE(eeprom.write_pages(0, numbered(size))) << size;
  }
  EXPECT_EQ(memory, Memory());
}

TEST(Eeprom, RefusesEveryAddressAfterTheEnd) {
  Memory memory;
  Eeprom eeprom(memory);
  for (const std::uint32_t address :
       {static_cast<std::uint32_t>(Memory::eeprom_size), 0x10000U, 0x80000000U, 0xFFFFFFC0U}) {
    EXPECT_FALSE(eeprom.read_pages(address, page)) << address;
    EXPECT_FALSE(eeprom.read_pages(address, 3 * page)) << address;
    EXPECT_FALSE(eeprom.write_pages(address, numbered(page))) << address;
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

}  // namespace
