// Tests of the small value types that messages consist of.

#include <cctype>
#include <new>
#include <type_traits>

#include <gtest/gtest.h>

#include <sbgc/enums.hpp>
#include <sbgc/flags.hpp>
#include <sbgc/status.hpp>
#include <sbgc/types.hpp>

#include "support.hpp"

namespace sbgc::test {
namespace {

TEST(Integer24, HoldsEveryNumberOf24Bits) {
  EXPECT_EQ(U24(0xFFFFFF).raw(), 0xFFFFFFU);
  EXPECT_EQ(I24(0x7FFFFF).raw(), 0x7FFFFF);
  EXPECT_EQ(I24(-0x800000).raw(), -0x800000);
}

TEST(Integer24DeathTest, StopsTheProgramThatGivesItMore) {
  EXPECT_DEATH(static_cast<void>(U24(0x1000000)), "");
  EXPECT_DEATH(static_cast<void>(I24(0x800000)), "");
  EXPECT_DEATH(static_cast<void>(I24(-0x800001)), "");
}

TEST(BoundedArray, GrowsUpToItsCapacity) {
  BoundedArray<int, 3> list;
  EXPECT_TRUE(list.empty());
  EXPECT_EQ(list.capacity(), 3U);
  for (int i = 0; i < 3; ++i) EXPECT_TRUE(list.push_back(i));
  EXPECT_FALSE(list.push_back(3));
  EXPECT_EQ(list.size(), 3U);
  EXPECT_EQ(list[2], 2);
  EXPECT_FALSE(list.resize(4));
  EXPECT_EQ(list.size(), 3U);
  EXPECT_TRUE(list.resize(1));
  int sum = 0;
  for (const int value : list) sum += value + 1;
  EXPECT_EQ(sum, 1);
}

TEST(BoundedArray, ComparesWhatIsInUse) {
  BoundedArray<int, 3> a;
  BoundedArray<int, 3> b;
  a.push_back(1);
  a.push_back(2);
  b.push_back(1);
  EXPECT_NE(a, b);
  a.resize(1);
  EXPECT_EQ(a, b);
  a.clear();
  b.clear();
  EXPECT_EQ(a, b);
  a.push_back(1);
  EXPECT_NE(a, b) << "the bytes past the end are equal, the sizes are not";
  EXPECT_NE(b, a);
  b.push_back(2);
  EXPECT_NE(a, b);
  a.push_back(3);
  b.push_back(3);
  EXPECT_NE(a, b) << "only the first elements differ";
}

TEST(BoundedArray, ResizeInitializesWhatItAdds) {
  struct Pair {
    std::uint8_t first = 7;
    std::uint8_t second{};
    bool operator==(const Pair&) const = default;
  };
  BoundedArray<int, 4> numbers;
  BoundedArray<Pair, 4> pairs;
  for (int i = 1; i <= 4; ++i) {
    numbers.push_back(i);
    pairs.push_back({1, 1});
  }
  numbers.resize(1);
  pairs.resize(1);
  EXPECT_TRUE(numbers.resize(3));
  EXPECT_TRUE(pairs.resize(3));
  EXPECT_EQ(std::vector<int>(numbers.begin(), numbers.end()), (std::vector<int>{1, 0, 0}));
  EXPECT_EQ(std::vector<Pair>(pairs.begin(), pairs.end()),
            (std::vector<Pair>{{1, 1}, {7, 0}, {7, 0}}));
}

// The unused part is not initialized at run time, but copied as bytes.
TEST(BoundedArray, CopiesAreEqualWhateverTheUnusedBytes) {
  using List = BoundedArray<std::uint16_t, 5>;
  static_assert(std::is_trivially_copyable_v<List>);
  alignas(List) std::array<unsigned char, sizeof(List)> zeros{};
  alignas(List) std::array<unsigned char, sizeof(List)> ones{};
  ones.fill(0xFF);
  List& a = *new (zeros.data()) List;
  List& b = *new (ones.data()) List;
  EXPECT_EQ(a, b);
  EXPECT_TRUE(b.empty());
  a.push_back(3);
  b.push_back(3);
  const List copy = b;
  EXPECT_EQ(copy, a);
  EXPECT_TRUE(b.resize(5));
  EXPECT_EQ(b[4], 0);
}

constexpr BoundedArray<std::uint8_t, 3> list_at_compile_time = [] {
  BoundedArray<std::uint8_t, 3> list;
  list.push_back(5);
  return list;
}();
static_assert(list_at_compile_time.size() == 1 && list_at_compile_time[0] == 5);
static_assert(list_at_compile_time.data()[2] == 0, "a constant is initialized as a whole");

TEST(Text, IsPaddedWithNul) {
  using std::string_view_literals::operator""sv;
  Text<4> text;
  EXPECT_EQ(text.size(), 0U);
  EXPECT_TRUE(text.assign("abc"sv));
  EXPECT_EQ(text.size(), 3U);
  EXPECT_TRUE(text.assign("abcd"sv));
  EXPECT_EQ(text.size(), 4U);
  EXPECT_FALSE(text.assign("abcde"sv));
  EXPECT_EQ(std::string_view(text.data(), text.size()), "abcd");
  EXPECT_TRUE(text.assign("x"sv));
  EXPECT_EQ(text.bytes, (std::array<char, 4>{'x', 0, 0, 0}));
  // Only trailing zeros are padding.
  EXPECT_TRUE(text.assign("a\0b"sv));
  EXPECT_EQ(text.size(), 3U);
}

TEST(BoundedText, GrowsUpToItsCapacity) {
  using std::string_view_literals::operator""sv;
  BoundedText<2> text;
  EXPECT_TRUE(text.push_back('a'));
  EXPECT_TRUE(text.assign("bc"sv));
  EXPECT_FALSE(text.push_back('d'));
  EXPECT_FALSE(text.assign("def"sv));
  EXPECT_EQ(std::string_view(text.data(), text.size()), "bc");
  BoundedText<2> other;
  EXPECT_NE(text, other);
  text.clear();
  EXPECT_EQ(text, other);
}

TEST(Optional, IsThereOrNot) {
  Optional<int> value;
  EXPECT_FALSE(value);
  EXPECT_FALSE(value.has_value());
  value = 7;
  ASSERT_TRUE(value);
  EXPECT_EQ(*value, 7);
  EXPECT_NE(value, Optional<int>());
  EXPECT_EQ(value, Optional<int>(7));
  value.reset();
  EXPECT_EQ(value, Optional<int>());
  value.emplace() = 8;
  EXPECT_EQ(value, Optional<int>(8));
  EXPECT_NE(value, Optional<int>(9));
  EXPECT_EQ(Optional<Axes<int>>(Axes<int>{1, 2, 3})->pitch, 2);
}

TEST(Flags, SetAndAsked) {
  msg::BeepModes modes;
  EXPECT_FALSE(modes.has(msg::BeepMode::click));
  modes.set(msg::BeepMode::click).set(msg::BeepMode::intro);
  EXPECT_EQ(modes.raw(), 0x50);
  EXPECT_EQ(modes, msg::BeepMode::click | msg::BeepMode::intro);
  modes.set(msg::BeepMode::click, false);
  EXPECT_EQ(modes, msg::BeepModes(msg::BeepMode::intro));
  EXPECT_EQ((msg::BeepMode::click | msg::BeepMode::intro | msg::BeepMode::error).raw(), 0x54);
}

TEST(Flags, KeepWhatHasNoName) {
  msg::BeepModes modes(0x4000);
  modes.set(msg::BeepMode::click);
  EXPECT_EQ(modes.raw(), 0x4010);
  modes.set(msg::BeepMode::click, false);
  EXPECT_EQ(modes.raw(), 0x4000);
}

template <class A, class B>
concept Combinable = requires(A a, B b) {
  a | b;
};
static_assert(Combinable<msg::BeepMode, msg::BeepMode>);
static_assert(!Combinable<msg::BeepMode, msg::BeeperMode>);
static_assert(!Combinable<msg::FollowMode, msg::FollowMode>, "an enum is no flag");
static_assert(!std::is_convertible_v<msg::BeepModes, int>);

TEST(Packed, PartsDoNotTouchEachOther) {
  msg::ControlMode mode(0x45);
  EXPECT_EQ(mode.mode(), static_cast<msg::ControlModeKind>(5));
  EXPECT_EQ(mode.flags().raw(), 0x40);
  EXPECT_TRUE(mode.set_mode(msg::ControlModeKind::angle));
  EXPECT_EQ(mode.raw(), 0x42);
  EXPECT_TRUE(mode.set_flags(msg::ControlFlag::high_res_speed));
  EXPECT_EQ(mode.raw(), 0x82);
  EXPECT_FALSE(mode.set_mode(static_cast<msg::ControlModeKind>(16)));
  EXPECT_FALSE(mode.set_flags(msg::ControlFlags(0x01)));
  EXPECT_EQ(mode.raw(), 0x82);
}

TEST(Packed, AValueOfTheMainPartIsTheWhole) {
  static_assert(msg::ControlMode(msg::ControlMode::angle).raw() == 2);
  msg::ControlMode mode = msg::ControlMode::speed;
  EXPECT_EQ(mode, msg::ControlMode(1));
  mode.set_flags(msg::ControlFlag::high_res_speed);
  EXPECT_NE(mode, msg::ControlMode::speed);
  EXPECT_EQ(mode.mode(), msg::ControlMode::speed);
  mode = msg::ControlMode::angle;
  EXPECT_EQ(mode.raw(), 2);
  // Bits outside the part do not leak into other parts.
  EXPECT_EQ(msg::ControlMode(static_cast<msg::ControlModeKind>(0x92)).raw(), 2);

  const msg::RcMap map = msg::RcMap::adc2;
  EXPECT_EQ(map.named(), msg::RcInput::adc2);
  static_assert(!std::is_convertible_v<msg::MixTarget, msg::RcMix>, "RcMix has no main part");
}

TEST(Packed, ShiftedParts) {
  msg::RcMix mix;
  EXPECT_TRUE(mix.set_rate(63));
  EXPECT_TRUE(mix.set_target(msg::MixTarget::yaw));
  EXPECT_EQ(mix.raw(), 0xFF);
  EXPECT_FALSE(mix.set_rate(64));
  EXPECT_FALSE(mix.set_target(static_cast<msg::MixTarget>(4)));
  EXPECT_TRUE(mix.set_rate(0));
  EXPECT_EQ(mix.raw(), 0xC0);
  EXPECT_EQ(mix.target(), msg::MixTarget::yaw);
}

TEST(Packed, PartsWithASign) {
  msg::PackedQuaternion packed;
  for (const std::int32_t number : {0x7FFFF, 1, 0, -1, -0x7FFFF}) {
    EXPECT_TRUE(packed.set_b(msg::QuaternionPart(number)));
    EXPECT_EQ(packed.b().raw(), number);
  }
  EXPECT_FALSE(packed.set_b(msg::QuaternionPart(0x80000)));
  EXPECT_FALSE(packed.set_b(msg::QuaternionPart(-0x80000)));
  EXPECT_EQ(packed.raw(), 0xFFFFF00000U) << "19 bits and the sign";
}

TEST(Packed, PartsInTwosComplement) {
  constexpr detail::PartBits part{.mask = 0x70, .shift = 4, .is_signed = true};
  std::uint8_t raw = 0x8F;
  for (const int number : {-4, -1, 0, 3}) {
    EXPECT_TRUE(detail::set_part_number(raw, number, part)) << number;
    EXPECT_EQ(detail::part_number(raw, part), number);
  }
  EXPECT_FALSE(detail::set_part_number(raw, -5, part));
  EXPECT_FALSE(detail::set_part_number(raw, 4, part));
  EXPECT_EQ(raw, 0xBF) << "no other bits change";
}

TEST(Packed, SwitchesAndNamedValues) {
  msg::RcMode mode(0xF0);
  mode.set_inverted(true);
  EXPECT_TRUE(mode.inverted());
  EXPECT_EQ(mode.raw(), 0xF8);
  mode.set_inverted(false);
  EXPECT_EQ(mode.raw(), 0xF0);

  const msg::RcMap map = msg::RcInput::adc2;
  EXPECT_EQ(map.raw(), 34);
  EXPECT_EQ(map.named(), msg::RcInput::adc2);
  EXPECT_EQ(map.source(), msg::RcSource::analog);
  EXPECT_EQ(map.channel(), 2);
}

TEST(Packed, DecimalDigits) {
  const msg::FirmwareVersion version(2439);
  EXPECT_EQ(version.major(), 2);
  EXPECT_EQ(version.minor(), 43);
  EXPECT_EQ(version.beta(), 9);
  EXPECT_LT(version, msg::FirmwareVersion(2440));
}

TEST(Packed, DecimalDigitsAreSet) {
  msg::FirmwareVersion version(999);
  EXPECT_TRUE(version.set_major(2));
  EXPECT_TRUE(version.set_minor(43));
  EXPECT_TRUE(version.set_beta(0));
  EXPECT_EQ(version.raw(), 2430);
  EXPECT_FALSE(version.set_minor(100));
  EXPECT_FALSE(version.set_beta(10));
  EXPECT_FALSE(version.set_major(66)) << "66430 does not fit";
  EXPECT_FALSE(version.set_major(0xFFFFFFFF));
  EXPECT_EQ(version.raw(), 2430);
  EXPECT_TRUE(version.set_major(65));
  EXPECT_EQ(version.raw(), 65430);
}

static_assert(Status{});
static_assert(!Status{Code::too_short, 3, "mode"});
static_assert(WriteResult{4, {}});
static_assert(!WriteResult{0, {Code::invalid_id}});
static_assert(std::string_view(name(Code::too_short)) == "too_short");

constexpr Code last_code = Code::invalid_id;

TEST(Code, HasANameAndASentenceEach) {
  std::set<std::string> names;
  std::set<std::string> texts;
  for (int i = 0; i <= static_cast<int>(last_code); ++i) {
    const auto code = static_cast<Code>(i);
    for (const char* c = name(code); *c != '\0'; ++c) {
      EXPECT_TRUE(std::islower(static_cast<unsigned char>(*c)) != 0 || *c == '_') << name(code);
    }
    EXPECT_EQ(std::string(text(code)).back(), '.');
    names.insert(name(code));
    texts.insert(text(code));
  }
  EXPECT_EQ(names.size(), static_cast<std::size_t>(last_code) + 1);
  EXPECT_EQ(texts.size(), names.size());
  EXPECT_FALSE(names.contains("unknown_code"));
}

TEST(Code, BeyondTheLastIsUnknown) {
  const auto beyond = static_cast<Code>(static_cast<int>(last_code) + 1);
  EXPECT_STREQ(name(beyond), "unknown_code");
  EXPECT_STREQ(text(beyond), "The status code is unknown.");
}

}  // namespace
}  // namespace sbgc::test
