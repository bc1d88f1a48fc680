#include <array>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include <sbgc/checksum.hpp>

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

}  // namespace
}  // namespace sbgc::test
