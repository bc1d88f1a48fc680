// Tests of checksums: every way to compute one against a computation byte by byte, or bit by bit.

#include <numeric>

#include <gtest/gtest.h>

#include <sbgc/checksum.hpp>
#include <sbgc/crc.hpp>
#include <sbgc/internal/compiler.hpp>

#include "support.hpp"

namespace sbgc::test {
namespace {

static_assert(byte_sum(nullptr, 0) == 0);
static_assert(byte_sum(std::array<std::uint8_t, 3>{0xFF, 0x02, 0x10}.data(), 3) == 0x11);
static_assert([] {
  std::array<std::uint8_t, 255> bytes{};
  bytes.fill(0xFF);
  return byte_sum(bytes.data(), bytes.size());
}() == 1);

TEST(ByteSum, IsThePlainSumForEverySizeAndAlignment) {
  std::mt19937 random(1);
  std::vector<std::uint8_t> bytes(400);
  for (int round = 0; round < 4; ++round) {
    for (std::uint8_t& b : bytes) b = round == 0 ? 0xFF : static_cast<std::uint8_t>(random());
    for (std::size_t begin = 0; begin < 17; ++begin) {
      for (std::size_t size = 0; size <= 320; ++size) {
        // A copy of exactly these bytes, so that a sanitizer detects a read out of bounds.
        const auto from = bytes.begin() + static_cast<std::ptrdiff_t>(begin);
        const std::vector<std::uint8_t> part(from, from + static_cast<std::ptrdiff_t>(size));
        const auto expected =
            static_cast<std::uint8_t>(std::accumulate(part.begin(), part.end(), 0U));
        ASSERT_EQ(byte_sum(bytes.data() + begin, size), expected) << begin << ", " << size;
        ASSERT_EQ(byte_sum(part.data(), size), expected) << size;
      }
    }
  }
}

TEST(ByteSum, SumsLongInputs) {
  const std::vector<std::uint8_t> bytes(1'000'003, 0xFF);
  EXPECT_EQ(byte_sum(bytes.data(), bytes.size()), static_cast<std::uint8_t>(255 * 1'000'003ULL));
}

using Bytes = std::vector<std::uint8_t>;

unsigned reflected(unsigned value, int bits) {
  unsigned result = 0;
  for (int i = 0; i < bits; ++i) result |= (value >> i & 1) << (bits - 1 - i);
  return result;
}

/// The definition of the catalogues, most significant bit first.
template <class Word>
unsigned bit_by_bit(const CrcParameters<Word>& parameters, const Bytes& bytes) {
  constexpr int width = 8 * sizeof(Word);
  unsigned value = parameters.initial;
  for (const std::uint8_t byte : bytes) {
    value ^= (parameters.reflect_in ? reflected(byte, 8) : byte) << (width - 8);
    for (int bit = 0; bit < 8; ++bit) {
      value = value << 1 ^ ((value >> (width - 1) & 1) != 0 ? parameters.polynomial : 0U);
    }
    value &= static_cast<Word>(-1);
  }
  return (parameters.reflect_out ? reflected(value, width) : value) ^ parameters.final_xor;
}

using Crc8Parameters = CrcParameters<std::uint8_t>;
using Crc16Parameters = CrcParameters<std::uint16_t>;
using Crc32Parameters = CrcParameters<std::uint32_t>;

constexpr Crc8Parameters smbus{0x07, 0, false, false, 0};
constexpr Crc8Parameters dvb_s2{0xD5, 0, false, false, 0};
constexpr Crc8Parameters maxim{0x31, 0, true, true, 0};
constexpr Crc16Parameters of_v2 = FramingFacts<Framing::v2>::trailer_checksum_crc;
constexpr Crc16Parameters arc{0x8005, 0, true, true, 0};
constexpr Crc16Parameters modbus{0x8005, 0xFFFF, true, true, 0};
constexpr Crc16Parameters x25{0x1021, 0xFFFF, true, true, 0xFFFF};
constexpr Crc16Parameters riello{0x1021, 0xB2AA, true, true, 0};
constexpr Crc16Parameters dnp{0x3D65, 0, true, true, 0xFFFF};
constexpr Crc16Parameters xmodem{0x1021, 0, false, false, 0};
constexpr Crc16Parameters genibus{0x1021, 0xFFFF, false, false, 0xFFFF};
constexpr Crc32Parameters iso_hdlc{0x04C11DB7, 0xFFFFFFFF, true, true, 0xFFFFFFFF};
constexpr Crc32Parameters mpeg_2{0x04C11DB7, 0xFFFFFFFF, false, false, 0};
constexpr Crc16Parameters reversed_output{0x3D65, 0x1234, true, false, 0x5678};

TEST(Crc, GivesTheCheckValuesOfTheCatalogue) {
  const Bytes text{'1', '2', '3', '4', '5', '6', '7', '8', '9'};
  EXPECT_EQ(bit_by_bit(arc, text), 0xBB3DU);
  EXPECT_EQ(bit_by_bit(modbus, text), 0x4B37U);
  EXPECT_EQ(bit_by_bit(x25, text), 0x906EU);
  EXPECT_EQ(bit_by_bit(riello, text), 0x63D0U);
  EXPECT_EQ(bit_by_bit(dnp, text), 0xEA82U);
  EXPECT_EQ(bit_by_bit(xmodem, text), 0x31C3U);
  EXPECT_EQ(bit_by_bit(genibus, text), 0xD64EU);
  EXPECT_EQ(bit_by_bit(smbus, text), 0xF4U);
  EXPECT_EQ(bit_by_bit(dvb_s2, text), 0xBCU);
  EXPECT_EQ(bit_by_bit(maxim, text), 0xA1U);
  EXPECT_EQ(bit_by_bit(iso_hdlc, text), 0xCBF43926U);
  EXPECT_EQ(bit_by_bit(mpeg_2, text), 0x0376E6E7U);
}

template <auto parameters, CrcTable table>
unsigned in_two_parts(const Bytes& bytes, std::size_t cut) {
  return Crc<parameters, table>{}
      .add(bytes.data(), cut)
      .add(bytes.data() + cut, bytes.size() - cut)
      .value();
}

template <auto parameters>
void expect_the_same_with_every_table() {
  std::mt19937 random(1);
  for (std::size_t size = 0; size <= 600; ++size) {
    for (int round = 0; round < 4; ++round) {
      Bytes bytes(size);
      for (std::uint8_t& byte : bytes) byte = static_cast<std::uint8_t>(random());
      const unsigned expected = bit_by_bit(parameters, bytes);
      const std::size_t cut = round == 0 ? 0 : random() % (size + 1);
      ASSERT_EQ((in_two_parts<parameters, CrcTable::nibbles>(bytes, cut)), expected) << size;
      ASSERT_EQ((in_two_parts<parameters, CrcTable::bytes>(bytes, cut)), expected) << size;
      ASSERT_EQ((in_two_parts<parameters, CrcTable::slices>(bytes, cut)), expected) << size;
      // `slices` does this on a processor without the multiplication.
      Crc<parameters, CrcTable::slices> by_table;
      by_table.add_by_table(bytes.data(), size);
      ASSERT_EQ(by_table.value(), expected) << size;
    }
  }
}

TEST(Crc, IsTheSameWithEveryTableAndEveryPolynomial) {
  expect_the_same_with_every_table<of_v2>();
  expect_the_same_with_every_table<modbus>();
  expect_the_same_with_every_table<x25>();
  expect_the_same_with_every_table<riello>();
  expect_the_same_with_every_table<dnp>();
  expect_the_same_with_every_table<reversed_output>();
  expect_the_same_with_every_table<xmodem>();
  expect_the_same_with_every_table<genibus>();
  expect_the_same_with_every_table<smbus>();
  expect_the_same_with_every_table<dvb_s2>();
  expect_the_same_with_every_table<maxim>();
  expect_the_same_with_every_table<iso_hdlc>();
  expect_the_same_with_every_table<mpeg_2>();
}

TEST(Crc, IsTheSameAtEveryAlignment) {
  std::mt19937 random(2);
  Bytes bytes(300);
  for (std::uint8_t& byte : bytes) byte = static_cast<std::uint8_t>(random());
  for (std::size_t begin = 0; begin < 20; ++begin) {
    for (std::size_t size = 0; begin + size <= bytes.size(); ++size) {
      const Bytes part(bytes.data() + begin, bytes.data() + begin + size);
      Crc<of_v2, CrcTable::slices> crc;
      ASSERT_EQ(crc.add(bytes.data() + begin, size).value(), bit_by_bit(of_v2, part)) << size;
    }
  }
}

#if SBGC_HAS_CARRYLESS_MULTIPLICATION
// Also for sizes for which it is not worthwhile.
TEST(Crc, FoldingGivesTheRegister) {
  if (!detail::has_carryless_multiplication()) GTEST_SKIP() << "this processor cannot fold";
  constexpr std::uint16_t polynomial = detail::reversed(x25.polynomial);
  const auto register_after = [](std::uint16_t start, const std::uint8_t* bytes, std::size_t size) {
    unsigned value = start;
    for (std::size_t i = 0; i < size; ++i) {
      value = detail::shifted(static_cast<std::uint16_t>(value ^ bytes[i]), 8, polynomial);
    }
    return value;
  };
  std::mt19937 random(3);
  for (std::size_t size = 16; size <= 300; ++size) {
    Bytes bytes(size);
    for (std::uint8_t& byte : bytes) byte = static_cast<std::uint8_t>(random());
    const auto start = static_cast<std::uint16_t>(random());
    ASSERT_EQ(detail::crc_by_folding<polynomial>(start, bytes.data(), size),
              register_after(start, bytes.data(), size))
        << size;
  }
}
#endif

constexpr std::uint8_t zero_to_63[] = {
    0,  1,  2,  3,  4,  5,  6,  7,  8,  9,  10, 11, 12, 13, 14, 15, 16, 17, 18, 19, 20, 21,
    22, 23, 24, 25, 26, 27, 28, 29, 30, 31, 32, 33, 34, 35, 36, 37, 38, 39, 40, 41, 42, 43,
    44, 45, 46, 47, 48, 49, 50, 51, 52, 53, 54, 55, 56, 57, 58, 59, 60, 61, 62, 63};
constexpr std::uint16_t at_compile_time =
    Crc<of_v2, CrcTable::slices>{}.add(zero_to_63, sizeof zero_to_63).value();

TEST(Crc, IsTheSameAtCompileTime) {
  EXPECT_EQ(at_compile_time, bit_by_bit(of_v2, Bytes(zero_to_63, zero_to_63 + 64)));
}

}  // namespace
}  // namespace sbgc::test
