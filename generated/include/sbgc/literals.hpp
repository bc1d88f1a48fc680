// Generated from spec/ by generator/: edit those, then run ./dev generate.

/// Literals of physical values: `using namespace sbgc::literals;`, then 45_deg.
#pragma once

#include <sbgc/physical.hpp>

namespace sbgc {

/// The units of the quantities. A quantity without a unit has its own unit type.
namespace msg::unit {

struct deg {
  static constexpr const char* text = "deg";
};

struct deg_per_s {
  static constexpr const char* text = "deg/s";
};

struct deg_per_s2 {
  static constexpr const char* text = "deg/s^2";
};

struct g {
  static constexpr const char* text = "g";
};

struct ms {
  static constexpr const char* text = "ms";
};

struct Hz {
  static constexpr const char* text = "Hz";
};

struct V {
  static constexpr const char* text = "V";
};

struct mA {
  static constexpr const char* text = "mA";
};

struct degC {
  static constexpr const char* text = "degC";
};

struct value {
  static constexpr const char* text = "";
};

struct dB {
  static constexpr const char* text = "dB";
};

struct gyro_unit {
  static constexpr const char* text = "gyro unit";
};

struct us {
  static constexpr const char* text = "us";
};

struct fraction {
  static constexpr const char* text = "";
};

struct percent {
  static constexpr const char* text = "%";
};

struct byte {
  static constexpr const char* text = "byte";
};

}  // namespace msg::unit

inline namespace literals {

/// Unit: deg.
template <char... text>
constexpr auto operator""_deg() noexcept {
  return detail::physical<msg::unit::deg, text...>();
}

/// Unit: deg/s.
template <char... text>
constexpr auto operator""_deg_per_s() noexcept {
  return detail::physical<msg::unit::deg_per_s, text...>();
}

/// Unit: deg/s^2.
template <char... text>
constexpr auto operator""_deg_per_s2() noexcept {
  return detail::physical<msg::unit::deg_per_s2, text...>();
}

/// Unit: g.
template <char... text>
constexpr auto operator""_g() noexcept {
  return detail::physical<msg::unit::g, text...>();
}

/// Unit: ms.
template <char... text>
constexpr auto operator""_ms() noexcept {
  return detail::physical<msg::unit::ms, text...>();
}

/// Unit: Hz.
template <char... text>
constexpr auto operator""_Hz() noexcept {
  return detail::physical<msg::unit::Hz, text...>();
}

/// Unit: V.
template <char... text>
constexpr auto operator""_V() noexcept {
  return detail::physical<msg::unit::V, text...>();
}

/// Unit: mA.
template <char... text>
constexpr auto operator""_mA() noexcept {
  return detail::physical<msg::unit::mA, text...>();
}

/// Unit: degC.
template <char... text>
constexpr auto operator""_degC() noexcept {
  return detail::physical<msg::unit::degC, text...>();
}

/// Unit: none.
template <char... text>
constexpr auto operator""_value() noexcept {
  return detail::physical<msg::unit::value, text...>();
}

/// Unit: dB.
template <char... text>
constexpr auto operator""_dB() noexcept {
  return detail::physical<msg::unit::dB, text...>();
}

/// Unit: gyro unit.
template <char... text>
constexpr auto operator""_gyro_unit() noexcept {
  return detail::physical<msg::unit::gyro_unit, text...>();
}

/// Unit: us.
template <char... text>
constexpr auto operator""_us() noexcept {
  return detail::physical<msg::unit::us, text...>();
}

/// Unit: none.
template <char... text>
constexpr auto operator""_fraction() noexcept {
  return detail::physical<msg::unit::fraction, text...>();
}

/// Unit: %.
template <char... text>
constexpr auto operator""_percent() noexcept {
  return detail::physical<msg::unit::percent, text...>();
}

/// Unit: byte.
template <char... text>
constexpr auto operator""_byte() noexcept {
  return detail::physical<msg::unit::byte, text...>();
}

}  // namespace literals
}  // namespace sbgc
