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
struct UnitMeta<msg::LogarithmicGain> {
  static constexpr UnitInfo info{"", 5, 1, -5.0 / 1, 1.0156157445197571};
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
struct UnitMeta<msg::LongSeconds> {
  static constexpr UnitInfo info{"ms", 1000, 1};
};

template <>
struct UnitMeta<msg::WattHours> {
  static constexpr UnitInfo info{"Wh", 1, 1};
};

template <>
struct UnitMeta<msg::AverageCurrent> {
  static constexpr UnitInfo info{"mA", 1000, 1};
};

template <>
struct UnitMeta<msg::PositiveTemperature> {
  static constexpr UnitInfo info{"degC", 1, 1};
};

template <>
struct UnitMeta<msg::AccelerationPeak> {
  static constexpr UnitInfo info{"g", 1, 16};
};

template <>
struct UnitMeta<msg::FlashSize> {
  static constexpr UnitInfo info{"byte", 32768, 1};
};

template <>
struct UnitMeta<msg::Seconds> {
  static constexpr UnitInfo info{"ms", 1000, 1};
};

template <>
struct UnitMeta<msg::HundredsOfMilliseconds> {
  static constexpr UnitInfo info{"ms", 100, 1};
};

template <>
struct UnitMeta<msg::HundredthDegrees> {
  static constexpr UnitInfo info{"deg", 1, 100};
};

template <>
struct UnitMeta<msg::TensOfMilliamperes> {
  static constexpr UnitInfo info{"mA", 10, 1};
};

template <>
struct UnitMeta<msg::TenthOhms> {
  static constexpr UnitInfo info{"ohm", 1, 10};
};

template <>
struct UnitMeta<msg::FifthPercent> {
  static constexpr UnitInfo info{"%", 1, 5};
};

template <>
struct UnitMeta<msg::Twentieths> {
  static constexpr UnitInfo info{"", 1, 20};
};

template <>
struct UnitMeta<msg::SignalOffset> {
  static constexpr UnitInfo info{"", 1, 128};
};

template <>
struct UnitMeta<msg::SignalScale> {
  static constexpr UnitInfo info{"%", 1, 1, 80.0 / 1};
};

template <>
struct UnitMeta<msg::TenthDegreesWidth> {
  static constexpr UnitInfo info{"deg", 1, 10};
};

template <>
struct UnitMeta<msg::CoarseCurrent> {
  static constexpr UnitInfo info{"mA", 500, 1};
};

template <>
struct UnitMeta<msg::HundredthOhms> {
  static constexpr UnitInfo info{"ohm", 1, 100};
};

template <>
struct UnitMeta<msg::InverseQuality> {
  static constexpr UnitInfo info{"", 1, 50, 1.0 / 5};
};

template <>
struct UnitMeta<msg::ShakeFrequency> {
  static constexpr UnitInfo info{"Hz", 1, 20, 3.0 / 10};
};

template <>
struct UnitMeta<msg::ShakeResonance> {
  static constexpr UnitInfo info{"Hz", 1, 10, 3.0 / 10};
};

template <>
struct UnitMeta<msg::ShakeFactor> {
  static constexpr UnitInfo info{"", 1, 10, 3.0 / 2};
};

template <>
struct UnitMeta<msg::ShakePause> {
  static constexpr UnitInfo info{"ms", 20, 1, 500.0 / 1};
};

template <>
struct UnitMeta<msg::FifthDecibels> {
  static constexpr UnitInfo info{"dB", 1, 5};
};

template <>
struct UnitMeta<msg::SignedCurrent> {
  static constexpr UnitInfo info{"mA", 1, 1};
};

template <>
struct UnitMeta<msg::CurrentShare> {
  static constexpr UnitInfo info{"%", 25, 8192};
};

template <>
struct UnitMeta<msg::RevolutionsPerMinute> {
  static constexpr UnitInfo info{"rpm", 1, 1};
};

template <>
struct UnitMeta<msg::Radians> {
  static constexpr UnitInfo info{"rad", 1, 1};
};

template <>
struct UnitMeta<msg::Millidegrees> {
  static constexpr UnitInfo info{"deg", 1, 1000};
};

template <>
struct UnitMeta<msg::LongFineSpeed> {
  static constexpr UnitInfo info{"deg/s", 1, 1000};
};

template <>
struct UnitMeta<msg::ControlSpeedLimit> {
  static constexpr UnitInfo info{"deg/s", 4000, 32767};
};

template <>
struct UnitMeta<msg::RadianRate> {
  static constexpr UnitInfo info{"rad/s", 1, 1};
};

template <>
struct UnitMeta<msg::Angle20> {
  static constexpr UnitInfo info{"deg", 45, 131072};
};

template <>
struct UnitMeta<msg::LongAngularAcceleration> {
  static constexpr UnitInfo info{"deg/s^2", 1, 1};
};

template <>
struct UnitMeta<msg::JerkTime> {
  static constexpr UnitInfo info{"ms", 20, 1};
};

template <>
struct UnitMeta<msg::QuaternionPart> {
  static constexpr UnitInfo info{"", 125000, 92681723247};
};

template <>
struct UnitMeta<msg::ExtMotorSpeedLimit> {
  static constexpr UnitInfo info{"deg/s", 2, 1};
};

template <>
struct UnitMeta<msg::ExtMotorAccelerationLimit> {
  static constexpr UnitInfo info{"deg/s^2", 2, 1};
};

template <>
struct UnitMeta<msg::MicroradianRate> {
  static constexpr UnitInfo info{"rad/s", 1, 1000000};
};

template <>
struct UnitMeta<msg::Millivolts> {
  static constexpr UnitInfo info{"V", 1, 1000};
};

template <>
struct UnitMeta<msg::TwoHertz> {
  static constexpr UnitInfo info{"Hz", 2, 1};
};

template <>
struct UnitMeta<msg::WideDegrees> {
  static constexpr UnitInfo info{"deg", 1, 1};
};

template <>
struct UnitMeta<msg::TenthHertz> {
  static constexpr UnitInfo info{"Hz", 1, 10};
};

template <>
struct UnitMeta<msg::TenthDecibels> {
  static constexpr UnitInfo info{"dB", 1, 10};
};

template <>
struct UnitMeta<msg::WordCount> {
  static constexpr UnitInfo info{"byte", 4, 1};
};

template <>
struct UnitMeta<msg::Pages> {
  static constexpr UnitInfo info{"byte", 64, 1};
};

}  // namespace sbgc
