
#include <gtest/gtest.h>

#include <sbgc/wire.hpp>

#include "support.hpp"

namespace sbgc::test {
namespace {

using wire::load;
using wire::store;

template <class T, std::size_t n>
constexpr bool is_wire_form(T value, const std::array<std::uint8_t, n>& bytes) {
  static_assert(sizeof(T) == n);
  std::array<std::uint8_t, n> out{};
  store(out.data(), value);
  return out == bytes && load<T>(bytes.data()) == value;
}

template <std::size_t n>
using Array = std::array<std::uint8_t, n>;

static_assert(is_wire_form<std::uint8_t>(0xFE, Array<1>{0xFE}));
static_assert(is_wire_form<std::int8_t>(-2, Array<1>{0xFE}));
static_assert(is_wire_form<std::uint16_t>(0xFE01, Array<2>{0x01, 0xFE}));
static_assert(is_wire_form<std::int16_t>(-2, Array<2>{0xFE, 0xFF}));
static_assert(is_wire_form<std::uint32_t>(0xFE030201, Array<4>{0x01, 0x02, 0x03, 0xFE}));
static_assert(is_wire_form<std::int32_t>(std::numeric_limits<std::int32_t>::min(),
                                         Array<4>{0, 0, 0, 0x80}));
static_assert(is_wire_form<float>(-1.5F, Array<4>{0x00, 0x00, 0xC0, 0xBF}));
static_assert(std::bit_cast<std::uint32_t>(load<float>(Array<4>{1, 0, 0xA0, 0x7F}.data())) ==
              0x7FA00001);  // a signaling NaN

static_assert(noexcept(load<float>(nullptr)) && noexcept(store<float>(nullptr, 0)));

/// Tests the code of this host and that of big-endian hosts, which any host can run, with unaligned
/// bytes.
template <class T>
class Wire : public testing::Test {
 protected:
  static void check(std::uint32_t bits) {
    using Bits = wire::detail::Bits<T>;
    const T value = std::bit_cast<T>(static_cast<Bits>(bits));
    std::array<std::uint8_t, 1 + sizeof(T) + 1> expected{};
    expected.fill(0xAA);
    for (std::size_t i = 0; i < sizeof(T); ++i) {
      expected[1 + i] = static_cast<std::uint8_t>(bits >> (8 * i));
    }
    auto native = expected;
    native.fill(0xAA);
    auto big_endian = native;
    store(native.data() + 1, value);
    store<T, std::endian::big>(big_endian.data() + 1, value);
    ASSERT_EQ(native, expected);
    ASSERT_EQ(big_endian, expected);
    // Compared as bits: NaNs must keep their payload.
    ASSERT_EQ(std::bit_cast<Bits>(load<T>(expected.data() + 1)), static_cast<Bits>(bits));
    ASSERT_EQ(std::bit_cast<Bits>(load<T, std::endian::big>(expected.data() + 1)),
              static_cast<Bits>(bits));
  }
};

using Numbers = testing::Types<std::uint8_t, std::int8_t, std::uint16_t, std::int16_t,
                               std::uint32_t, std::int32_t, float>;
TYPED_TEST_SUITE(Wire, Numbers);

TYPED_TEST(Wire, CarriesBitPatterns) {
  for (const std::uint32_t bits : {0U, 1U, 0x7FU, 0x80U, 0xFFU, 0x100U, 0x7FFFU, 0x8000U, 0xFFFFU,
                                   0x01020304U, 0x7FFFFFFFU, 0x80000000U, 0xFFFFFFFFU, 0x7FC00001U,
                                   0x7FA12345U, 0xFFA12345U, 0x7F800000U, 0x00000001U}) {
    this->check(bits);
  }
  for (std::uint32_t i = 0, bits = 1; i < 10'000; ++i, bits = bits * 1664525U + 1013904223U) {
    this->check(bits);
  }
}

}  // namespace
}  // namespace sbgc::test
