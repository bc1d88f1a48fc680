// Generated from spec/ by generator/: edit those, then run ./dev generate.

/// The units of the quantities.
#pragma once

#include <sbgc/meta.hpp>
#include <sbgc/units.hpp>

namespace sbgc {

template <>
struct UnitMeta<msg::Angle14> {
  static constexpr UnitInfo info{"deg", 45, 2048};
};

template <>
struct UnitMeta<msg::LongAngle14> {
  static constexpr UnitInfo info{"deg", 45, 2048};
};

template <>
struct UnitMeta<msg::Degrees> {
  static constexpr UnitInfo info{"deg", 1, 1};
};

template <>
struct UnitMeta<msg::SmallDegrees> {
  static constexpr UnitInfo info{"deg", 1, 1};
};

template <>
struct UnitMeta<msg::SignedDegrees> {
  static constexpr UnitInfo info{"deg", 1, 1};
};

template <>
struct UnitMeta<msg::EncoderLimit> {
  static constexpr UnitInfo info{"deg", 3, 1};
};

template <>
struct UnitMeta<msg::TenthDegrees> {
  static constexpr UnitInfo info{"deg", 1, 10};
};

template <>
struct UnitMeta<msg::AngleError> {
  static constexpr UnitInfo info{"deg", 1, 10};
};

template <>
struct UnitMeta<msg::ControlSpeed> {
  static constexpr UnitInfo info{"deg/s", 4000, 32767};
};

template <>
struct UnitMeta<msg::FineSpeed> {
  static constexpr UnitInfo info{"deg/s", 1, 1000};
};

template <>
struct UnitMeta<msg::GyroRate> {
  static constexpr UnitInfo info{"deg/s", 2000, 32767};
};

template <>
struct UnitMeta<msg::AngularAcceleration> {
  static constexpr UnitInfo info{"deg/s^2", 5, 1};
};

template <>
struct UnitMeta<msg::PlainAngularAcceleration> {
  static constexpr UnitInfo info{"deg/s^2", 1, 1};
};

template <>
struct UnitMeta<msg::Acceleration> {
  static constexpr UnitInfo info{"g", 1, 512};
};

template <>
struct UnitMeta<msg::MillisecondClock> {
  static constexpr UnitInfo info{"ms", 1, 1};
};

template <>
struct UnitMeta<msg::Milliseconds> {
  static constexpr UnitInfo info{"ms", 1, 1};
};

template <>
struct UnitMeta<msg::Microseconds> {
  static constexpr UnitInfo info{"us", 1, 1};
};

template <>
struct UnitMeta<msg::TensOfMilliseconds> {
  static constexpr UnitInfo info{"ms", 10, 1};
};

template <>
struct UnitMeta<msg::ServoPulse> {
  static constexpr UnitInfo info{"us", 1, 1};
};

template <>
struct UnitMeta<msg::NoteLength> {
  static constexpr UnitInfo info{"ms", 8, 1};
};

template <>
struct UnitMeta<msg::NoteFrequency> {
  static constexpr UnitInfo info{"Hz", 1, 1};
};

template <>
struct UnitMeta<msg::ServoRate> {
  static constexpr UnitInfo info{"Hz", 10, 1};
};

template <>
struct UnitMeta<msg::Frequency> {
  static constexpr UnitInfo info{"Hz", 1, 1};
};

template <>
struct UnitMeta<msg::SmallFrequency> {
  static constexpr UnitInfo info{"Hz", 1, 1};
};

template <>
struct UnitMeta<msg::EvenFrequency> {
  static constexpr UnitInfo info{"Hz", 2, 1};
};

template <>
struct UnitMeta<msg::CoarseFrequency> {
  static constexpr UnitInfo info{"Hz", 10, 1};
};

template <>
struct UnitMeta<msg::FineFrequency> {
  static constexpr UnitInfo info{"Hz", 1, 100};
};

template <>
struct UnitMeta<msg::Voltage> {
  static constexpr UnitInfo info{"V", 1, 100};
};

template <>
struct UnitMeta<msg::VoltageThreshold> {
  static constexpr UnitInfo info{"V", 1, 100};
};

template <>
struct UnitMeta<msg::Current> {
  static constexpr UnitInfo info{"mA", 1, 1};
};

template <>
struct UnitMeta<msg::Temperature> {
  static constexpr UnitInfo info{"degC", 1, 1};
};

template <>
struct UnitMeta<msg::Hundredths> {
  static constexpr UnitInfo info{"", 1, 100};
};

template <>
struct UnitMeta<msg::LongHundredths> {
  static constexpr UnitInfo info{"", 1, 100};
};

template <>
struct UnitMeta<msg::Thousandths> {
  static constexpr UnitInfo info{"", 1, 1000};
};

template <>
struct UnitMeta<msg::FixedPoint8> {
  static constexpr UnitInfo info{"", 1, 256};
};

template <>
struct UnitMeta<msg::PidGain> {
  static constexpr UnitInfo info{"", 1, 50, 1.0 / 10};
};

template <>
struct UnitMeta<msg::Decibels> {
  static constexpr UnitInfo info{"dB", 1, 1};
};

template <>
struct UnitMeta<msg::Percent> {
  static constexpr UnitInfo info{"%", 1, 1};
};

template <>
struct UnitMeta<msg::GyroDeadband> {
  static constexpr UnitInfo info{"gyro unit", 1, 10};
};

template <>
struct UnitMeta<msg::GyroOffset> {
  static constexpr UnitInfo info{"gyro unit", 1, 1000};
};

template <>
struct UnitMeta<msg::RcSignal> {
  static constexpr UnitInfo info{"us", 1, 1};
};

template <>
struct UnitMeta<msg::FineRcSignal> {
  static constexpr UnitInfo info{"", 1, 16384};
};

template <>
struct UnitMeta<msg::CentredRcSignal> {
  static constexpr UnitInfo info{"", 1, 500};
};

template <>
struct UnitMeta<msg::BalanceError> {
  static constexpr UnitInfo info{"%", 25, 128};
};

template <>
struct UnitMeta<msg::ByteCount> {
  static constexpr UnitInfo info{"byte", 1, 1};
};

template <>
struct UnitMeta<msg::SmallByteCount> {
  static constexpr UnitInfo info{"byte", 1, 1};
};

template <>
struct UnitMeta<msg::LongByteCount> {
  static constexpr UnitInfo info{"byte", 1, 1};
};

template <>
struct UnitMeta<msg::Pages> {
  static constexpr UnitInfo info{"byte", 64, 1};
};

}  // namespace sbgc
