// Generated from spec/ by generator/: edit those, then run ./dev generate.

/// Literals of physical values: `using namespace sbgc::literals;`, then 45_deg.
#pragma once

#include <sbgc/physical.hpp>

namespace sbgc {

/// The units of the quantities. A quantity without a unit has its own unit type.
namespace msg::unit {

struct gyro_unit {
  static constexpr const char* text = "gyro unit";
};

struct us {
  static constexpr const char* text = "us";
};

struct Wh {
  static constexpr const char* text = "Wh";
};

struct degC {
  static constexpr const char* text = "degC";
};

struct g {
  static constexpr const char* text = "g";
};

struct fraction {
  static constexpr const char* text = "";
};

struct ohm {
  static constexpr const char* text = "ohm";
};

struct mA {
  static constexpr const char* text = "mA";
};

struct percent {
  static constexpr const char* text = "%";
};

struct rpm {
  static constexpr const char* text = "rpm";
};

struct rad {
  static constexpr const char* text = "rad";
};

struct ms {
  static constexpr const char* text = "ms";
};

struct value {
  static constexpr const char* text = "";
};

struct deg_per_s {
  static constexpr const char* text = "deg/s";
};

struct deg_per_s2 {
  static constexpr const char* text = "deg/s^2";
};

struct rad_per_s {
  static constexpr const char* text = "rad/s";
};

struct V {
  static constexpr const char* text = "V";
};

struct deg {
  static constexpr const char* text = "deg";
};

struct Hz {
  static constexpr const char* text = "Hz";
};

struct dB {
  static constexpr const char* text = "dB";
};

struct byte {
  static constexpr const char* text = "byte";
};

}  // namespace msg::unit

inline namespace literals {

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

/// Unit: Wh.
template <char... text>
constexpr auto operator""_Wh() noexcept {
  return detail::physical<msg::unit::Wh, text...>();
}

/// Unit: degC.
template <char... text>
constexpr auto operator""_degC() noexcept {
  return detail::physical<msg::unit::degC, text...>();
}

/// Unit: g.
template <char... text>
constexpr auto operator""_g() noexcept {
  return detail::physical<msg::unit::g, text...>();
}

/// Unit: none.
template <char... text>
constexpr auto operator""_fraction() noexcept {
  return detail::physical<msg::unit::fraction, text...>();
}

/// Unit: ohm.
template <char... text>
constexpr auto operator""_ohm() noexcept {
  return detail::physical<msg::unit::ohm, text...>();
}

/// Unit: mA.
template <char... text>
constexpr auto operator""_mA() noexcept {
  return detail::physical<msg::unit::mA, text...>();
}

/// Unit: %.
template <char... text>
constexpr auto operator""_percent() noexcept {
  return detail::physical<msg::unit::percent, text...>();
}

/// Unit: rpm.
template <char... text>
constexpr auto operator""_rpm() noexcept {
  return detail::physical<msg::unit::rpm, text...>();
}

/// Unit: rad.
template <char... text>
constexpr auto operator""_rad() noexcept {
  return detail::physical<msg::unit::rad, text...>();
}

/// Unit: ms.
template <char... text>
constexpr auto operator""_ms() noexcept {
  return detail::physical<msg::unit::ms, text...>();
}

/// Unit: none.
template <char... text>
constexpr auto operator""_value() noexcept {
  return detail::physical<msg::unit::value, text...>();
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

/// Unit: rad/s.
template <char... text>
constexpr auto operator""_rad_per_s() noexcept {
  return detail::physical<msg::unit::rad_per_s, text...>();
}

/// Unit: V.
template <char... text>
constexpr auto operator""_V() noexcept {
  return detail::physical<msg::unit::V, text...>();
}

/// Unit: deg.
template <char... text>
constexpr auto operator""_deg() noexcept {
  return detail::physical<msg::unit::deg, text...>();
}

/// Unit: Hz.
template <char... text>
constexpr auto operator""_Hz() noexcept {
  return detail::physical<msg::unit::Hz, text...>();
}

/// Unit: dB.
template <char... text>
constexpr auto operator""_dB() noexcept {
  return detail::physical<msg::unit::dB, text...>();
}

/// Unit: byte.
template <char... text>
constexpr auto operator""_byte() noexcept {
  return detail::physical<msg::unit::byte, text...>();
}

}  // namespace literals
}  // namespace sbgc
