// Generated from spec/ by generator/: edit those, then run ./dev generate.

/// Literals of physical values: `using namespace sbgc::literals;`, then 45_deg.
#pragma once

#include <sbgc/physical.hpp>

namespace sbgc {

/// The units of the quantities. A quantity without a unit has its own unit type. `Accessors` has the
/// functions of each quantity `Q` in this unit. (They are templates because the compiler then skips
/// those that are not called.)
namespace msg::unit {

struct gyro_unit {
  static constexpr const char* text = "gyro unit";

  template <class Q>
  struct Accessors {
    static constexpr Conversion<Q> from_gyro_units(double value) noexcept {
      return Q::from_real(value);
    }
    constexpr double gyro_units() const noexcept { return static_cast<const Q&>(*this).real(); }
  };
};

struct us {
  static constexpr const char* text = "us";

  template <class Q>
  struct Accessors {
    static constexpr Conversion<Q> from_microseconds(double value) noexcept {
      return Q::from_real(value);
    }
    constexpr double microseconds() const noexcept { return static_cast<const Q&>(*this).real(); }
  };
};

struct Wh {
  static constexpr const char* text = "Wh";

  template <class Q>
  struct Accessors {
    static constexpr Conversion<Q> from_watt_hours(double value) noexcept {
      return Q::from_real(value);
    }
    constexpr double watt_hours() const noexcept { return static_cast<const Q&>(*this).real(); }
  };
};

struct degC {
  static constexpr const char* text = "degC";

  template <class Q>
  struct Accessors {
    static constexpr Conversion<Q> from_degrees_celsius(double value) noexcept {
      return Q::from_real(value);
    }
    constexpr double degrees_celsius() const noexcept { return static_cast<const Q&>(*this).real(); }
  };
};

struct g {
  static constexpr const char* text = "g";

  template <class Q>
  struct Accessors {
    static constexpr Conversion<Q> from_g(double value) noexcept {
      return Q::from_real(value);
    }
    constexpr double g() const noexcept { return static_cast<const Q&>(*this).real(); }
  };
};

struct fraction {
  static constexpr const char* text = "";

  template <class Q>
  struct Accessors {
    static constexpr Conversion<Q> from_fraction(double value) noexcept {
      return Q::from_real(value);
    }
    constexpr double fraction() const noexcept { return static_cast<const Q&>(*this).real(); }
  };
};

struct ohm {
  static constexpr const char* text = "ohm";

  template <class Q>
  struct Accessors {
    static constexpr Conversion<Q> from_ohms(double value) noexcept {
      return Q::from_real(value);
    }
    constexpr double ohms() const noexcept { return static_cast<const Q&>(*this).real(); }
  };
};

struct mA {
  static constexpr const char* text = "mA";

  template <class Q>
  struct Accessors {
    static constexpr Conversion<Q> from_milliamperes(double value) noexcept {
      return Q::from_real(value);
    }
    constexpr double milliamperes() const noexcept { return static_cast<const Q&>(*this).real(); }
  };
};

struct percent {
  static constexpr const char* text = "%";

  template <class Q>
  struct Accessors {
    static constexpr Conversion<Q> from_percent(double value) noexcept {
      return Q::from_real(value);
    }
    constexpr double percent() const noexcept { return static_cast<const Q&>(*this).real(); }
  };
};

struct rpm {
  static constexpr const char* text = "rpm";

  template <class Q>
  struct Accessors {
    static constexpr Conversion<Q> from_revolutions_per_minute(double value) noexcept {
      return Q::from_real(value);
    }
    constexpr double revolutions_per_minute() const noexcept { return static_cast<const Q&>(*this).real(); }
  };
};

struct rad {
  static constexpr const char* text = "rad";

  template <class Q>
  struct Accessors {
    static constexpr Conversion<Q> from_radians(double value) noexcept {
      return Q::from_real(value);
    }
    constexpr double radians() const noexcept { return static_cast<const Q&>(*this).real(); }
  };
};

struct ms {
  static constexpr const char* text = "ms";

  template <class Q>
  struct Accessors {
    static constexpr Conversion<Q> from_milliseconds(double value) noexcept {
      return Q::from_real(value);
    }
    constexpr double milliseconds() const noexcept { return static_cast<const Q&>(*this).real(); }
  };
};

struct value {
  static constexpr const char* text = "";

  template <class Q>
  struct Accessors {
    static constexpr Conversion<Q> from_value(double value) noexcept {
      return Q::from_real(value);
    }
    constexpr double value() const noexcept { return static_cast<const Q&>(*this).real(); }
  };
};

struct deg_per_s {
  static constexpr const char* text = "deg/s";

  template <class Q>
  struct Accessors {
    static constexpr Conversion<Q> from_degrees_per_second(double value) noexcept {
      return Q::from_real(value);
    }
    constexpr double degrees_per_second() const noexcept { return static_cast<const Q&>(*this).real(); }
  };
};

struct deg_per_s2 {
  static constexpr const char* text = "deg/s^2";

  template <class Q>
  struct Accessors {
    static constexpr Conversion<Q> from_degrees_per_second_squared(double value) noexcept {
      return Q::from_real(value);
    }
    constexpr double degrees_per_second_squared() const noexcept { return static_cast<const Q&>(*this).real(); }
  };
};

struct rad_per_s {
  static constexpr const char* text = "rad/s";

  template <class Q>
  struct Accessors {
    static constexpr Conversion<Q> from_radians_per_second(double value) noexcept {
      return Q::from_real(value);
    }
    constexpr double radians_per_second() const noexcept { return static_cast<const Q&>(*this).real(); }
  };
};

struct V {
  static constexpr const char* text = "V";

  template <class Q>
  struct Accessors {
    static constexpr Conversion<Q> from_volts(double value) noexcept {
      return Q::from_real(value);
    }
    constexpr double volts() const noexcept { return static_cast<const Q&>(*this).real(); }
  };
};

struct deg {
  static constexpr const char* text = "deg";

  template <class Q>
  struct Accessors {
    static constexpr Conversion<Q> from_degrees(double value) noexcept {
      return Q::from_real(value);
    }
    constexpr double degrees() const noexcept { return static_cast<const Q&>(*this).real(); }
  };
};

struct Hz {
  static constexpr const char* text = "Hz";

  template <class Q>
  struct Accessors {
    static constexpr Conversion<Q> from_hertz(double value) noexcept {
      return Q::from_real(value);
    }
    constexpr double hertz() const noexcept { return static_cast<const Q&>(*this).real(); }
  };
};

struct dB {
  static constexpr const char* text = "dB";

  template <class Q>
  struct Accessors {
    static constexpr Conversion<Q> from_decibels(double value) noexcept {
      return Q::from_real(value);
    }
    constexpr double decibels() const noexcept { return static_cast<const Q&>(*this).real(); }
  };
};

struct byte {
  static constexpr const char* text = "byte";

  template <class Q>
  struct Accessors {
    static constexpr Conversion<Q> from_bytes(double value) noexcept {
      return Q::from_real(value);
    }
    constexpr double bytes() const noexcept { return static_cast<const Q&>(*this).real(); }
  };
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
