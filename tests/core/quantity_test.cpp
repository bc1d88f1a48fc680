// Tests of physical quantities: conversion is exact or rounded to nearest, and units do not mix.

#include <concepts>
#include <optional>
#include <type_traits>
#include <typeindex>

#include <gtest/gtest.h>

#include <sbgc/later_unit.hpp>
#include <sbgc/meta/all.hpp>

#include "support.hpp"

namespace sbgc::test {
namespace {

template <class T>
concept IsQuantity = RawValue<T> && requires {
  T::unit;
};

/// Calls `use` with raw values: all of 8 and 16 bits, a sample of wider ones.
template <class Raw, class Use>
void for_raw_values(const Use& use) {
  if constexpr (std::is_floating_point_v<Raw>) {
    for (const Raw raw : {Raw{-1.5}, Raw{0}, Raw{0.25}, Raw{1000000}}) use(raw);
    return;
  } else {
    constexpr std::int64_t lowest = std::numeric_limits<Raw>::min();
    constexpr std::int64_t highest = std::numeric_limits<Raw>::max();
    constexpr std::int64_t step = sizeof(Raw) > 2 ? 999983 : 1;
    for (std::int64_t raw = lowest; raw <= highest; raw += step) use(static_cast<Raw>(raw));
    use(static_cast<Raw>(highest));
  }
}

/// A real number of a floating type is the raw value, times its scale.
template <class Q>
void check_floating_quantity() {
  for_raw_values<typename Q::raw_type>([](auto raw) {
    const auto same = Q::from_real(Q(raw).real());
    ASSERT_TRUE(same);
    EXPECT_EQ((*same).raw(), raw);
  });
  EXPECT_LT(Q(1), Q(2));
}

template <class Q>
void check_quantity() {
  using Raw = typename Q::raw_type;
  if constexpr (std::is_floating_point_v<Raw>) return check_floating_quantity<Q>();
  const double step = Q(Raw{1}).real() - Q(Raw{0}).real();
  ASSERT_GT(step, 0);
  for_raw_values<Raw>([&](Raw raw) {
    const double real = Q(raw).real();
    const auto same = Q::from_real(real);
    ASSERT_TRUE(same) << +raw;
    ASSERT_EQ((*same).raw(), raw);
    const auto above = Q::from_real(real + 0.49 * step);
    const auto below = Q::from_real(real - 0.49 * step);
    ASSERT_TRUE(above && below) << +raw;
    ASSERT_EQ((*above).raw(), raw) << "not the nearest";
    ASSERT_EQ((*below).raw(), raw) << "not the nearest";
  });
  const double lowest = Q(std::numeric_limits<Raw>::min()).real();
  const double highest = Q(std::numeric_limits<Raw>::max()).real();
  EXPECT_FALSE(Q::from_real(lowest - 0.51 * step));
  EXPECT_FALSE(Q::from_real(highest + 0.51 * step));
  EXPECT_FALSE(Q::from_real(std::nan("")));
  EXPECT_FALSE(Q::from_real(std::numeric_limits<double>::infinity()));
  EXPECT_FALSE(Q::from_real(-std::numeric_limits<double>::infinity()));
  EXPECT_FALSE(Q::from_real(1e300));
  EXPECT_EQ(Q::from_real(1e300).value_or(Q(Raw{7})), Q(Raw{7}));
  EXPECT_LT(Q(Raw{1}), Q(Raw{2}));
}

/// Finds the quantities among the members of all messages.
class Finder {
 public:
  template <class T>
  void look_at(std::type_identity<T>) {
    if (!seen_.insert(typeid(T)).second) return;
    if constexpr (IsQuantity<T>) {
      SCOPED_TRACE(T::unit);
      ++quantities_;
      check_quantity<T>();
    } else if constexpr (requires { Meta<T>::fields; }) {
      const T value{};
      Meta<T>::visit(value, [&](const FieldInfo&, const auto& member) {
        look_at(std::type_identity<std::remove_cvref_t<decltype(member)>>{});
      });
    }
  }
  template <class T, std::size_t n>
  void look_at(std::type_identity<std::array<T, n>>) {
    look_at(std::type_identity<T>{});
  }
  template <class T, std::size_t n>
  void look_at(std::type_identity<BoundedArray<T, n>>) {
    look_at(std::type_identity<T>{});
  }
  template <class T>
  void look_at(std::type_identity<Optional<T>>) {
    look_at(std::type_identity<T>{});
  }

  int quantities() const { return quantities_; }

 private:
  std::set<std::type_index> seen_;
  int quantities_ = 0;
};

struct Metres {
  static constexpr const char* text = "m";
};
template <class Number>
struct Millimetres : detail::Quantity<Millimetres<Number>, Number, Metres, 1, 1000> {
  using detail::Quantity<Millimetres<Number>, Number, Metres, 1, 1000>::Quantity;
};

template <class Q>
bool takes(double value, typename Q::raw_type raw) {
  const auto converted = Q::from_real(value);
  return converted && (*converted).raw() == raw;
}

TEST(Quantity, Of24BitsEndsWhereTheWireDoes) {
  using Signed = Millimetres<I24>;
  using Unsigned = Millimetres<U24>;
  static_assert(wire_size<Signed> == 3 && wire_size<Unsigned> == 3);
  EXPECT_TRUE(takes<Signed>(8388.607, 0x7FFFFF) && takes<Signed>(-8388.608, -0x800000));
  EXPECT_FALSE(Signed::from_real(8388.6076) || Signed::from_real(-8388.6086));
  EXPECT_TRUE(takes<Unsigned>(16777.2154, 0xFFFFFF) && takes<Unsigned>(-0.0004, 0));
  EXPECT_FALSE(Unsigned::from_real(16777.2156) || Unsigned::from_real(-0.0006));
  EXPECT_DOUBLE_EQ(Signed(-1500).real(), -1.5);
  EXPECT_LT(Signed(-1), Signed(1));
  EXPECT_DEATH(Unsigned(0x1000000), "");
}

TEST(Quantity, Of64BitsEndsWhereTheWireDoes) {
  using Signed = Millimetres<std::int64_t>;
  using Unsigned = Millimetres<std::uint64_t>;
  constexpr double end = 9223372036854775.808;  // 2^63 mm
  EXPECT_TRUE(takes<Signed>(-end, std::numeric_limits<std::int64_t>::min()));
  EXPECT_FALSE(Signed::from_real(end) || Signed::from_real(-end * 1.0000001));
  EXPECT_TRUE(takes<Signed>(-2.0006, -2001) && takes<Signed>(2.0004, 2000));
  EXPECT_TRUE(takes<Unsigned>(end, std::uint64_t{1} << 63) && takes<Unsigned>(-0.0004, 0));
  EXPECT_FALSE(Unsigned::from_real(2 * end) || Unsigned::from_real(-0.0006));
  EXPECT_DOUBLE_EQ(Unsigned(~std::uint64_t{0}).real(), 2 * end);
}

TEST(Quantity, IsOf24BitsInLaterFirmwareOrBefore) {
  U24 field(5);
  using Later = detail::LaterType<2730, Millimetres<U24>>;
  EXPECT_FALSE(detail::set_in_firmware<Later>(field, 0x1000000, {}));
  EXPECT_TRUE(detail::set_in_firmware<Later>(field, 1.5, {.firmware = 2730}));
  EXPECT_EQ(field, U24(1500));
  EXPECT_DOUBLE_EQ(detail::real_in_firmware<Later>(field, {.firmware = 2730}), 1.5);
}

TEST(Quantity, EveryQuantityOfEveryMessageIsExactAndRoundsToNearest) {
  Finder finder;
  AllMessages::for_each([&]<class M>(Type<M>) { finder.look_at(std::type_identity<M>{}); });
  EXPECT_GE(finder.quantities(), 20);
}

TEST(Quantity, ValuesOfTheSpecification) {
  EXPECT_EQ(msg::Angle14(2048).degrees(), 45);
  EXPECT_EQ(msg::Angle14(-16384).degrees(), -360);
  EXPECT_EQ(msg::ControlSpeed(32767).degrees_per_second(), 4000);
  EXPECT_EQ(msg::Voltage(1234).volts(), 12.34);
  EXPECT_EQ(msg::Pages(3).bytes(), 192);
  EXPECT_EQ(msg::BalanceError(-512).percent(), -100);
  EXPECT_EQ(msg::NoteLength(125).milliseconds(), 1000);
  EXPECT_EQ((*msg::Angle14::from_degrees(0.0109)).raw(), 0);
  EXPECT_EQ((*msg::Angle14::from_degrees(0.0111)).raw(), 1);
  EXPECT_EQ((*msg::Angle14::from_degrees(-0.0109)).raw(), 0);
  EXPECT_EQ((*msg::Angle14::from_degrees(-0.0111)).raw(), -1);
}

// ---- what compiles and what does not ----

template <class To, class From>
concept Assignable = requires(To to, From from) {
  to = from;
};
template <class A, class B>
concept Comparable = requires(A a, B b) {
  a == b;
}
|| requires(A a, B b) { a < b; };

// A quantity accepts neither another unit nor a bare number.
static_assert(Assignable<msg::Angle14&, msg::Angle14>);
static_assert(!Assignable<msg::Angle14&, msg::Degrees>);
static_assert(!Assignable<msg::Angle14&, msg::LongAngle14>);
static_assert(!Assignable<msg::Angle14&, msg::ControlSpeed>);
static_assert(!Assignable<msg::Angle14&, int>);
static_assert(!Assignable<msg::Angle14&, double>);
static_assert(!std::constructible_from<msg::Angle14, msg::Degrees>);
static_assert(!std::constructible_from<msg::Voltage, msg::VoltageThreshold>);
static_assert(!std::convertible_to<msg::Angle14, int>);
static_assert(!std::convertible_to<msg::Angle14, double>);
static_assert(Comparable<msg::Angle14, msg::Angle14>);
static_assert(!Comparable<msg::Angle14, msg::Degrees>);
static_assert(!Comparable<msg::Angle14, msg::LongAngle14>);
static_assert(!Comparable<msg::Angle14, int>);
static_assert(!Comparable<msg::ControlSpeed, msg::GyroRate>);

// A literal converts to every quantity of its unit, and to no other.
static_assert(msg::Angle14(-30_deg).raw() == -1365);
static_assert(msg::Angle14(-30_deg) == *msg::Angle14::from_degrees(-30));
static_assert(std::convertible_to<decltype(45_deg), msg::Angle14>);
static_assert(std::convertible_to<decltype(45_deg), msg::TenthDegrees>);
static_assert(!std::convertible_to<decltype(45_deg), msg::ControlSpeed>);
static_assert(!std::convertible_to<decltype(45_deg_per_s), msg::Angle14>);
static_assert(!std::convertible_to<decltype(45_deg), double>);
static_assert(!std::convertible_to<decltype(1_value), msg::CentredRcSignal>);
static_assert(std::convertible_to<decltype(45_deg), Optional<msg::Angle14>>);
static_assert(std::convertible_to<decltype(45_deg), std::optional<msg::Angle14>>);
static_assert(!std::convertible_to<decltype(45_V), Optional<msg::Angle14>>);

// Regardless of how the number is written.
static_assert(msg::Voltage(12.6_V).raw() == 1260);
static_assert(msg::Voltage(.5_V).raw() == 50);
static_assert(msg::Voltage(1.26e1_V).raw() == 1260);
static_assert(msg::Voltage(126E-1_V).raw() == 1260);
static_assert(msg::Milliseconds(1'000_ms).raw() == 1000);
static_assert(msg::Milliseconds(1e3_ms).raw() == 1000);
static_assert(msg::Milliseconds(0_ms).raw() == 0);
static_assert(msg::Milliseconds(+0.6_ms).raw() == 1);
static_assert(msg::Degrees(-0.5_deg).raw() == -1);
static_assert((0.1_deg).real() == 0.1);
static_assert((123456789.012345_deg).real() == 123456789.012345);
static_assert((-2.5e-3_deg).real() == -2.5e-3);

TEST(Literal, InitialisesFieldsOfMessages) {
  const msg::Control control{.control_mode = msg::ControlMode::angle,
                             .axes = {.yaw = {.speed = 20_deg_per_s, .angle = 45_deg}}};
  EXPECT_EQ(control.control_mode.raw(), 2);
  EXPECT_EQ(control.axes.yaw.speed, *msg::ControlSpeed::from_degrees_per_second(20));
  EXPECT_EQ(control.axes.yaw.angle.raw(), 2048);
  EXPECT_GT(control.axes.yaw.angle, 44.9_deg);

  msg::RealtimeDataCustom data;
  data.stator_rotor_angle = Axes<msg::Angle14>{.yaw = 45_deg};
  EXPECT_EQ(data.stator_rotor_angle->yaw.raw(), 2048);
}

/// A quantity with a floating-point raw value is not rounded but still limited in range.
class Radians : public detail::Quantity<Radians, float, msg::unit::deg, 1, 2> {
 public:
  using Quantity::Quantity;
};
static_assert(Radians(3.0F).real() == 1.5);
static_assert((*Radians::from_real(1.5)).raw() == 3.0F);
static_assert((*Radians::from_real(-0.125)).raw() == -0.25F);
static_assert(!Radians::from_real(1e39));

TEST(Conversion, ToFloatingPointIsLimitedToItsRange) {
  constexpr float raw = std::numeric_limits<float>::max();
  constexpr double highest = static_cast<double>(raw) / 2;
  constexpr double above = highest * (1 + std::numeric_limits<double>::epsilon());
  EXPECT_EQ(Radians::from_real(highest).value_or(Radians()), Radians(raw));
  EXPECT_EQ(Radians::from_real(-highest).value_or(Radians()), Radians(-raw));
  EXPECT_FALSE(Radians::from_real(above));
  EXPECT_FALSE(Radians::from_real(-above));
  EXPECT_FALSE(Radians::from_real(std::nan("")));
}

TEST(Conversion, RoundsHalvesAwayFromZero) {
  const auto whole = [](double degrees) {
    return msg::Degrees::from_degrees(degrees).value_or(msg::Degrees(77)).raw();
  };
  EXPECT_EQ(whole(0.5), 1);
  EXPECT_EQ(whole(-0.5), -1);
  EXPECT_EQ(whole(2.5), 3);
  EXPECT_EQ(whole(-2.5), -3);
}

TEST(ConversionDeathTest, StopsTheProgramThatDoesNotTest) {
  volatile double degrees = 4500;
  EXPECT_DEATH(static_cast<void>(*msg::Angle14::from_degrees(degrees)), "");
}

}  // namespace
}  // namespace sbgc::test
