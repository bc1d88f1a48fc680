// Generated from spec/ by generator/: edit those, then run ./dev generate.

/// The physical quantities of the protocol. Each is a distinct type over the exact number on the
/// wire, so that units cannot be mixed by mistake.
#pragma once

#include <cstdint>

#include <sbgc/literals.hpp>
#include <sbgc/quantity.hpp>

namespace sbgc::msg {

/// Angle, 16384 counts per turn.
/// Unit: deg, one count is 360/16384.
class Angle14
    : public detail::Quantity<Angle14, std::int16_t, unit::deg, 45, 2048> {
 public:
  using Quantity::Quantity;
  static constexpr Conversion<Angle14> from_degrees(
      double value) noexcept {
    return from_real(value);
  }
  constexpr double degrees() const noexcept { return real(); }
};

/// Angle, 16384 counts per turn, accumulated over full turns.
/// Unit: deg, one count is 360/16384.
class LongAngle14
    : public detail::Quantity<LongAngle14, std::int32_t, unit::deg, 45, 2048> {
 public:
  using Quantity::Quantity;
  static constexpr Conversion<LongAngle14> from_degrees(
      double value) noexcept {
    return from_real(value);
  }
  constexpr double degrees() const noexcept { return real(); }
};

/// Angle in whole degrees.
/// Unit: deg.
class Degrees
    : public detail::Quantity<Degrees, std::int16_t, unit::deg, 1, 1> {
 public:
  using Quantity::Quantity;
  static constexpr Conversion<Degrees> from_degrees(
      double value) noexcept {
    return from_real(value);
  }
  constexpr double degrees() const noexcept { return real(); }
};

/// Small angle in whole degrees.
/// Unit: deg.
class SmallDegrees
    : public detail::Quantity<SmallDegrees, std::uint8_t, unit::deg, 1, 1> {
 public:
  using Quantity::Quantity;
  static constexpr Conversion<SmallDegrees> from_degrees(
      double value) noexcept {
    return from_real(value);
  }
  constexpr double degrees() const noexcept { return real(); }
};

/// Small signed angle in whole degrees.
/// Unit: deg.
class SignedDegrees
    : public detail::Quantity<SignedDegrees, std::int8_t, unit::deg, 1, 1> {
 public:
  using Quantity::Quantity;
  static constexpr Conversion<SignedDegrees> from_degrees(
      double value) noexcept {
    return from_real(value);
  }
  constexpr double degrees() const noexcept { return real(); }
};

/// Angle in steps of 3 degrees.
/// Unit: deg, one count is 3.
class EncoderLimit
    : public detail::Quantity<EncoderLimit, std::int8_t, unit::deg, 3, 1> {
 public:
  using Quantity::Quantity;
  static constexpr Conversion<EncoderLimit> from_degrees(
      double value) noexcept {
    return from_real(value);
  }
  constexpr double degrees() const noexcept { return real(); }
};

/// Angle in tenths of a degree.
/// Unit: deg, one count is 1/10.
class TenthDegrees
    : public detail::Quantity<TenthDegrees, std::int16_t, unit::deg, 1, 10> {
 public:
  using Quantity::Quantity;
  static constexpr Conversion<TenthDegrees> from_degrees(
      double value) noexcept {
    return from_real(value);
  }
  constexpr double degrees() const noexcept { return real(); }
};

/// Angle between an estimated and a reference vector, in tenths of a degree.
/// Unit: deg, one count is 1/10.
class AngleError
    : public detail::Quantity<AngleError, std::uint8_t, unit::deg, 1, 10> {
 public:
  using Quantity::Quantity;
  static constexpr Conversion<AngleError> from_degrees(
      double value) noexcept {
    return from_real(value);
  }
  constexpr double degrees() const noexcept { return real(); }
};

/// Angular speed of commands and targets: full scale is 4000 deg/s.
/// Unit: deg/s, one count is 4000/32767.
class ControlSpeed
    : public detail::Quantity<ControlSpeed, std::int16_t, unit::deg_per_s, 4000, 32767> {
 public:
  using Quantity::Quantity;
  static constexpr Conversion<ControlSpeed> from_degrees_per_second(
      double value) noexcept {
    return from_real(value);
  }
  constexpr double degrees_per_second() const noexcept { return real(); }
};

/// Angular speed for extremely slow motion, in thousandths of a degree per second.
/// Unit: deg/s, one count is 1/1000.
class FineSpeed
    : public detail::Quantity<FineSpeed, std::int16_t, unit::deg_per_s, 1, 1000> {
 public:
  using Quantity::Quantity;
  static constexpr Conversion<FineSpeed> from_degrees_per_second(
      double value) noexcept {
    return from_real(value);
  }
  constexpr double degrees_per_second() const noexcept { return real(); }
};

/// Angular speed from the gyroscope: full scale is 2000 deg/s.
/// Unit: deg/s, one count is 2000/32767.
class GyroRate
    : public detail::Quantity<GyroRate, std::int16_t, unit::deg_per_s, 2000, 32767> {
 public:
  using Quantity::Quantity;
  static constexpr Conversion<GyroRate> from_degrees_per_second(
      double value) noexcept {
    return from_real(value);
  }
  constexpr double degrees_per_second() const noexcept { return real(); }
};

/// Angular acceleration in steps of 5 deg/s^2.
/// Unit: deg/s^2, one count is 5.
class AngularAcceleration
    : public detail::Quantity<AngularAcceleration, std::uint8_t, unit::deg_per_s2, 5, 1> {
 public:
  using Quantity::Quantity;
  static constexpr Conversion<AngularAcceleration> from_degrees_per_second_squared(
      double value) noexcept {
    return from_real(value);
  }
  constexpr double degrees_per_second_squared() const noexcept { return real(); }
};

/// Angular acceleration in whole deg/s^2.
/// Unit: deg/s^2.
class PlainAngularAcceleration
    : public detail::Quantity<PlainAngularAcceleration, std::int16_t, unit::deg_per_s2, 1, 1> {
 public:
  using Quantity::Quantity;
  static constexpr Conversion<PlainAngularAcceleration> from_degrees_per_second_squared(
      double value) noexcept {
    return from_real(value);
  }
  constexpr double degrees_per_second_squared() const noexcept { return real(); }
};

/// Linear acceleration; 512 counts are 1 g.
/// Unit: g, one count is 1/512.
class Acceleration
    : public detail::Quantity<Acceleration, std::int16_t, unit::g, 1, 512> {
 public:
  using Quantity::Quantity;
  static constexpr Conversion<Acceleration> from_g(
      double value) noexcept {
    return from_real(value);
  }
  constexpr double g() const noexcept { return real(); }
};

/// Time stamp that wraps after 65.536 s.
/// Unit: ms.
class MillisecondClock
    : public detail::Quantity<MillisecondClock, std::uint16_t, unit::ms, 1, 1> {
 public:
  using Quantity::Quantity;
  static constexpr Conversion<MillisecondClock> from_milliseconds(
      double value) noexcept {
    return from_real(value);
  }
  constexpr double milliseconds() const noexcept { return real(); }
};

/// Duration in milliseconds.
/// Unit: ms.
class Milliseconds
    : public detail::Quantity<Milliseconds, std::uint16_t, unit::ms, 1, 1> {
 public:
  using Quantity::Quantity;
  static constexpr Conversion<Milliseconds> from_milliseconds(
      double value) noexcept {
    return from_real(value);
  }
  constexpr double milliseconds() const noexcept { return real(); }
};

/// Duration in microseconds.
/// Unit: us.
class Microseconds
    : public detail::Quantity<Microseconds, std::uint16_t, unit::us, 1, 1> {
 public:
  using Quantity::Quantity;
  static constexpr Conversion<Microseconds> from_microseconds(
      double value) noexcept {
    return from_real(value);
  }
  constexpr double microseconds() const noexcept { return real(); }
};

/// Duration in steps of 10 ms.
/// Unit: ms, one count is 10.
class TensOfMilliseconds
    : public detail::Quantity<TensOfMilliseconds, std::uint8_t, unit::ms, 10, 1> {
 public:
  using Quantity::Quantity;
  static constexpr Conversion<TensOfMilliseconds> from_milliseconds(
      double value) noexcept {
    return from_real(value);
  }
  constexpr double milliseconds() const noexcept { return real(); }
};

/// Length of a servo pulse; values up to 0 are special.
/// Unit: us.
class ServoPulse
    : public detail::Quantity<ServoPulse, std::int16_t, unit::us, 1, 1> {
 public:
  using Quantity::Quantity;
  static constexpr Conversion<ServoPulse> from_microseconds(
      double value) noexcept {
    return from_real(value);
  }
  constexpr double microseconds() const noexcept { return real(); }
};

/// Length of a note in steps of 8 ms.
/// Unit: ms, one count is 8.
class NoteLength
    : public detail::Quantity<NoteLength, std::uint8_t, unit::ms, 8, 1> {
 public:
  using Quantity::Quantity;
  static constexpr Conversion<NoteLength> from_milliseconds(
      double value) noexcept {
    return from_real(value);
  }
  constexpr double milliseconds() const noexcept { return real(); }
};

/// Pitch of a note.
/// Unit: Hz.
class NoteFrequency
    : public detail::Quantity<NoteFrequency, std::uint16_t, unit::Hz, 1, 1> {
 public:
  using Quantity::Quantity;
  static constexpr Conversion<NoteFrequency> from_hertz(
      double value) noexcept {
    return from_real(value);
  }
  constexpr double hertz() const noexcept { return real(); }
};

/// PWM frequency in steps of 10 Hz.
/// Unit: Hz, one count is 10.
class ServoRate
    : public detail::Quantity<ServoRate, std::uint8_t, unit::Hz, 10, 1> {
 public:
  using Quantity::Quantity;
  static constexpr Conversion<ServoRate> from_hertz(
      double value) noexcept {
    return from_real(value);
  }
  constexpr double hertz() const noexcept { return real(); }
};

/// Frequency in whole hertz.
/// Unit: Hz.
class Frequency
    : public detail::Quantity<Frequency, std::uint16_t, unit::Hz, 1, 1> {
 public:
  using Quantity::Quantity;
  static constexpr Conversion<Frequency> from_hertz(
      double value) noexcept {
    return from_real(value);
  }
  constexpr double hertz() const noexcept { return real(); }
};

/// Low frequency in whole hertz.
/// Unit: Hz.
class SmallFrequency
    : public detail::Quantity<SmallFrequency, std::uint8_t, unit::Hz, 1, 1> {
 public:
  using Quantity::Quantity;
  static constexpr Conversion<SmallFrequency> from_hertz(
      double value) noexcept {
    return from_real(value);
  }
  constexpr double hertz() const noexcept { return real(); }
};

/// Frequency in steps of 2 Hz.
/// Unit: Hz, one count is 2.
class EvenFrequency
    : public detail::Quantity<EvenFrequency, std::uint8_t, unit::Hz, 2, 1> {
 public:
  using Quantity::Quantity;
  static constexpr Conversion<EvenFrequency> from_hertz(
      double value) noexcept {
    return from_real(value);
  }
  constexpr double hertz() const noexcept { return real(); }
};

/// Frequency in steps of 10 Hz.
/// Unit: Hz, one count is 10.
class CoarseFrequency
    : public detail::Quantity<CoarseFrequency, std::uint8_t, unit::Hz, 10, 1> {
 public:
  using Quantity::Quantity;
  static constexpr Conversion<CoarseFrequency> from_hertz(
      double value) noexcept {
    return from_real(value);
  }
  constexpr double hertz() const noexcept { return real(); }
};

/// Frequency in hundredths of a hertz.
/// Unit: Hz, one count is 1/100.
class FineFrequency
    : public detail::Quantity<FineFrequency, std::uint16_t, unit::Hz, 1, 100> {
 public:
  using Quantity::Quantity;
  static constexpr Conversion<FineFrequency> from_hertz(
      double value) noexcept {
    return from_real(value);
  }
  constexpr double hertz() const noexcept { return real(); }
};

/// Voltage in hundredths of a volt.
/// Unit: V, one count is 1/100.
class Voltage
    : public detail::Quantity<Voltage, std::uint16_t, unit::V, 1, 100> {
 public:
  using Quantity::Quantity;
  static constexpr Conversion<Voltage> from_volts(
      double value) noexcept {
    return from_real(value);
  }
  constexpr double volts() const noexcept { return real(); }
};

/// Voltage in hundredths of a volt; a negative value switches the function off.
/// Unit: V, one count is 1/100.
class VoltageThreshold
    : public detail::Quantity<VoltageThreshold, std::int16_t, unit::V, 1, 100> {
 public:
  using Quantity::Quantity;
  static constexpr Conversion<VoltageThreshold> from_volts(
      double value) noexcept {
    return from_real(value);
  }
  constexpr double volts() const noexcept { return real(); }
};

/// Electric current.
/// Unit: mA.
class Current
    : public detail::Quantity<Current, std::uint16_t, unit::mA, 1, 1> {
 public:
  using Quantity::Quantity;
  static constexpr Conversion<Current> from_milliamperes(
      double value) noexcept {
    return from_real(value);
  }
  constexpr double milliamperes() const noexcept { return real(); }
};

/// Temperature.
/// Unit: degC.
class Temperature
    : public detail::Quantity<Temperature, std::int8_t, unit::degC, 1, 1> {
 public:
  using Quantity::Quantity;
  static constexpr Conversion<Temperature> from_degrees_celsius(
      double value) noexcept {
    return from_real(value);
  }
  constexpr double degrees_celsius() const noexcept { return real(); }
};

/// Number in hundredths.
/// Unit: none, one count is 1/100.
class Hundredths
    : public detail::Quantity<Hundredths, std::uint8_t, unit::value, 1, 100> {
 public:
  using Quantity::Quantity;
  static constexpr Conversion<Hundredths> from_value(
      double value) noexcept {
    return from_real(value);
  }
  constexpr double value() const noexcept { return real(); }
};

/// Number in hundredths, with a wide range.
/// Unit: none, one count is 1/100.
class LongHundredths
    : public detail::Quantity<LongHundredths, std::uint16_t, unit::value, 1, 100> {
 public:
  using Quantity::Quantity;
  static constexpr Conversion<LongHundredths> from_value(
      double value) noexcept {
    return from_real(value);
  }
  constexpr double value() const noexcept { return real(); }
};

/// Number in thousandths.
/// Unit: none, one count is 1/1000.
class Thousandths
    : public detail::Quantity<Thousandths, std::uint16_t, unit::value, 1, 1000> {
 public:
  using Quantity::Quantity;
  static constexpr Conversion<Thousandths> from_value(
      double value) noexcept {
    return from_real(value);
  }
  constexpr double value() const noexcept { return real(); }
};

/// Number with eight integer and eight fractional bits.
/// Unit: none, one count is 1/256.
class FixedPoint8
    : public detail::Quantity<FixedPoint8, std::uint16_t, unit::value, 1, 256> {
 public:
  using Quantity::Quantity;
  static constexpr Conversion<FixedPoint8> from_value(
      double value) noexcept {
    return from_real(value);
  }
  constexpr double value() const noexcept { return real(); }
};

/// Factor on the gains of a PID controller; 0 counts are 0.1.
/// Unit: none, one count is 1/50, counted from 1/10.
class PidGain
    : public detail::Quantity<PidGain, std::uint8_t, unit::value, 1, 50, 1, 10> {
 public:
  using Quantity::Quantity;
  static constexpr Conversion<PidGain> from_value(
      double value) noexcept {
    return from_real(value);
  }
  constexpr double value() const noexcept { return real(); }
};

/// Gain in decibels.
/// Unit: dB.
class Decibels
    : public detail::Quantity<Decibels, std::int8_t, unit::dB, 1, 1> {
 public:
  using Quantity::Quantity;
  static constexpr Conversion<Decibels> from_decibels(
      double value) noexcept {
    return from_real(value);
  }
  constexpr double decibels() const noexcept { return real(); }
};

/// Share of a whole.
/// Unit: %.
class Percent
    : public detail::Quantity<Percent, std::uint8_t, unit::percent, 1, 1> {
 public:
  using Quantity::Quantity;
  static constexpr Conversion<Percent> from_percent(
      double value) noexcept {
    return from_real(value);
  }
  constexpr double percent() const noexcept { return real(); }
};

/// Tenths of the gyroscope's native unit.
/// Unit: gyro unit, one count is 1/10.
class GyroDeadband
    : public detail::Quantity<GyroDeadband, std::uint8_t, unit::gyro_unit, 1, 10> {
 public:
  using Quantity::Quantity;
  static constexpr Conversion<GyroDeadband> from_gyro_units(
      double value) noexcept {
    return from_real(value);
  }
  constexpr double gyro_units() const noexcept { return real(); }
};

/// Thousandths of the gyroscope's native unit.
/// Unit: gyro unit, one count is 1/1000.
class GyroOffset
    : public detail::Quantity<GyroOffset, std::int16_t, unit::gyro_unit, 1, 1000> {
 public:
  using Quantity::Quantity;
  static constexpr Conversion<GyroOffset> from_gyro_units(
      double value) noexcept {
    return from_real(value);
  }
  constexpr double gyro_units() const noexcept { return real(); }
};

/// RC pulse width, or an analog signal normalized to the same range.
/// Unit: us.
class RcSignal
    : public detail::Quantity<RcSignal, std::int16_t, unit::us, 1, 1> {
 public:
  using Quantity::Quantity;
  static constexpr Conversion<RcSignal> from_microseconds(
      double value) noexcept {
    return from_real(value);
  }
  constexpr double microseconds() const noexcept { return real(); }
};

/// High-resolution RC signal; the normal range is -1 to 1.
/// Unit: none, one count is 1/16384.
class FineRcSignal
    : public detail::Quantity<FineRcSignal, std::int16_t, unit::fraction, 1, 16384> {
 public:
  using Quantity::Quantity;
  static constexpr Conversion<FineRcSignal> from_fraction(
      double value) noexcept {
    return from_real(value);
  }
  constexpr double fraction() const noexcept { return real(); }
};

/// RC signal relative to its center; the normal range is -1 to 1.
/// Unit: none, one count is 1/500.
class CentredRcSignal
    : public detail::Quantity<CentredRcSignal, std::int16_t, unit::fraction, 1, 500> {
 public:
  using Quantity::Quantity;
  static constexpr Conversion<CentredRcSignal> from_fraction(
      double value) noexcept {
    return from_real(value);
  }
  constexpr double fraction() const noexcept { return real(); }
};

/// Motor power needed to hold the camera: 0 is perfect balance, 512 counts are 100 %.
/// Unit: %, one count is 100/512.
class BalanceError
    : public detail::Quantity<BalanceError, std::int16_t, unit::percent, 25, 128> {
 public:
  using Quantity::Quantity;
  static constexpr Conversion<BalanceError> from_percent(
      double value) noexcept {
    return from_real(value);
  }
  constexpr double percent() const noexcept { return real(); }
};

/// Number of bytes.
/// Unit: byte.
class ByteCount
    : public detail::Quantity<ByteCount, std::uint16_t, unit::byte, 1, 1> {
 public:
  using Quantity::Quantity;
  static constexpr Conversion<ByteCount> from_bytes(
      double value) noexcept {
    return from_real(value);
  }
  constexpr double bytes() const noexcept { return real(); }
};

/// Small number of bytes.
/// Unit: byte.
class SmallByteCount
    : public detail::Quantity<SmallByteCount, std::uint8_t, unit::byte, 1, 1> {
 public:
  using Quantity::Quantity;
  static constexpr Conversion<SmallByteCount> from_bytes(
      double value) noexcept {
    return from_real(value);
  }
  constexpr double bytes() const noexcept { return real(); }
};

/// Large number of bytes.
/// Unit: byte.
class LongByteCount
    : public detail::Quantity<LongByteCount, std::uint32_t, unit::byte, 1, 1> {
 public:
  using Quantity::Quantity;
  static constexpr Conversion<LongByteCount> from_bytes(
      double value) noexcept {
    return from_real(value);
  }
  constexpr double bytes() const noexcept { return real(); }
};

/// Long duration in whole seconds.
/// Unit: ms, one count is 1000.
class LongSeconds
    : public detail::Quantity<LongSeconds, std::uint32_t, unit::ms, 1000, 1> {
 public:
  using Quantity::Quantity;
  static constexpr Conversion<LongSeconds> from_milliseconds(
      double value) noexcept {
    return from_real(value);
  }
  constexpr double milliseconds() const noexcept { return real(); }
};

/// Electric energy.
/// Unit: Wh.
class WattHours
    : public detail::Quantity<WattHours, float, unit::Wh, 1, 1> {
 public:
  using Quantity::Quantity;
  static constexpr Conversion<WattHours> from_watt_hours(
      double value) noexcept {
    return from_real(value);
  }
  constexpr double watt_hours() const noexcept { return real(); }
};

/// Electric current in amperes.
/// Unit: mA, one count is 1000.
class AverageCurrent
    : public detail::Quantity<AverageCurrent, float, unit::mA, 1000, 1> {
 public:
  using Quantity::Quantity;
  static constexpr Conversion<AverageCurrent> from_milliamperes(
      double value) noexcept {
    return from_real(value);
  }
  constexpr double milliamperes() const noexcept { return real(); }
};

/// Temperature from 0 up.
/// Unit: degC.
class PositiveTemperature
    : public detail::Quantity<PositiveTemperature, std::uint8_t, unit::degC, 1, 1> {
 public:
  using Quantity::Quantity;
  static constexpr Conversion<PositiveTemperature> from_degrees_celsius(
      double value) noexcept {
    return from_real(value);
  }
  constexpr double degrees_celsius() const noexcept { return real(); }
};

/// Linear acceleration in steps of 1/16 g.
/// Unit: g, one count is 1/16.
class AccelerationPeak
    : public detail::Quantity<AccelerationPeak, std::uint8_t, unit::g, 1, 16> {
 public:
  using Quantity::Quantity;
  static constexpr Conversion<AccelerationPeak> from_g(
      double value) noexcept {
    return from_real(value);
  }
  constexpr double g() const noexcept { return real(); }
};

/// Number of pages of 32 KB.
/// Unit: byte, one count is 32768.
class FlashSize
    : public detail::Quantity<FlashSize, std::uint8_t, unit::byte, 32768, 1> {
 public:
  using Quantity::Quantity;
  static constexpr Conversion<FlashSize> from_bytes(
      double value) noexcept {
    return from_real(value);
  }
  constexpr double bytes() const noexcept { return real(); }
};

/// Duration in whole seconds.
/// Unit: ms, one count is 1000.
class Seconds
    : public detail::Quantity<Seconds, std::uint16_t, unit::ms, 1000, 1> {
 public:
  using Quantity::Quantity;
  static constexpr Conversion<Seconds> from_milliseconds(
      double value) noexcept {
    return from_real(value);
  }
  constexpr double milliseconds() const noexcept { return real(); }
};

/// Duration in steps of 100 ms.
/// Unit: ms, one count is 100.
class HundredsOfMilliseconds
    : public detail::Quantity<HundredsOfMilliseconds, std::uint8_t, unit::ms, 100, 1> {
 public:
  using Quantity::Quantity;
  static constexpr Conversion<HundredsOfMilliseconds> from_milliseconds(
      double value) noexcept {
    return from_real(value);
  }
  constexpr double milliseconds() const noexcept { return real(); }
};

/// Angle in hundredths of a degree.
/// Unit: deg, one count is 1/100.
class HundredthDegrees
    : public detail::Quantity<HundredthDegrees, std::int16_t, unit::deg, 1, 100> {
 public:
  using Quantity::Quantity;
  static constexpr Conversion<HundredthDegrees> from_degrees(
      double value) noexcept {
    return from_real(value);
  }
  constexpr double degrees() const noexcept { return real(); }
};

/// Electric current in steps of 10 mA.
/// Unit: mA, one count is 10.
class TensOfMilliamperes
    : public detail::Quantity<TensOfMilliamperes, std::uint16_t, unit::mA, 10, 1> {
 public:
  using Quantity::Quantity;
  static constexpr Conversion<TensOfMilliamperes> from_milliamperes(
      double value) noexcept {
    return from_real(value);
  }
  constexpr double milliamperes() const noexcept { return real(); }
};

/// Electric resistance in tenths of an ohm.
/// Unit: ohm, one count is 1/10.
class TenthOhms
    : public detail::Quantity<TenthOhms, std::uint8_t, unit::ohm, 1, 10> {
 public:
  using Quantity::Quantity;
  static constexpr Conversion<TenthOhms> from_ohms(
      double value) noexcept {
    return from_real(value);
  }
  constexpr double ohms() const noexcept { return real(); }
};

/// Share of a whole in steps of 0.2 %.
/// Unit: %, one count is 1/5.
class FifthPercent
    : public detail::Quantity<FifthPercent, std::uint8_t, unit::percent, 1, 5> {
 public:
  using Quantity::Quantity;
  static constexpr Conversion<FifthPercent> from_percent(
      double value) noexcept {
    return from_real(value);
  }
  constexpr double percent() const noexcept { return real(); }
};

/// Number in steps of 0.05.
/// Unit: none, one count is 1/20.
class Twentieths
    : public detail::Quantity<Twentieths, std::uint8_t, unit::value, 1, 20> {
 public:
  using Quantity::Quantity;
  static constexpr Conversion<Twentieths> from_value(
      double value) noexcept {
    return from_real(value);
  }
  constexpr double value() const noexcept { return real(); }
};

/// Offset of an RC signal; 1 is half its range.
/// Unit: none, one count is 1/128.
class SignalOffset
    : public detail::Quantity<SignalOffset, std::int8_t, unit::fraction, 1, 128> {
 public:
  using Quantity::Quantity;
  static constexpr Conversion<SignalOffset> from_fraction(
      double value) noexcept {
    return from_real(value);
  }
  constexpr double fraction() const noexcept { return real(); }
};

/// Factor on an RC signal; 0 counts are 80 %.
/// Unit: %, counted from 80.
class SignalScale
    : public detail::Quantity<SignalScale, std::uint8_t, unit::percent, 1, 1, 80, 1> {
 public:
  using Quantity::Quantity;
  static constexpr Conversion<SignalScale> from_percent(
      double value) noexcept {
    return from_real(value);
  }
  constexpr double percent() const noexcept { return real(); }
};

/// Small angle in tenths of a degree.
/// Unit: deg, one count is 1/10.
class TenthDegreesWidth
    : public detail::Quantity<TenthDegreesWidth, std::uint8_t, unit::deg, 1, 10> {
 public:
  using Quantity::Quantity;
  static constexpr Conversion<TenthDegreesWidth> from_degrees(
      double value) noexcept {
    return from_real(value);
  }
  constexpr double degrees() const noexcept { return real(); }
};

/// Electric current in steps of 0.5 A.
/// Unit: mA, one count is 500.
class CoarseCurrent
    : public detail::Quantity<CoarseCurrent, std::uint8_t, unit::mA, 500, 1> {
 public:
  using Quantity::Quantity;
  static constexpr Conversion<CoarseCurrent> from_milliamperes(
      double value) noexcept {
    return from_real(value);
  }
  constexpr double milliamperes() const noexcept { return real(); }
};

/// Electric resistance in hundredths of an ohm.
/// Unit: ohm, one count is 1/100.
class HundredthOhms
    : public detail::Quantity<HundredthOhms, std::uint16_t, unit::ohm, 1, 100> {
 public:
  using Quantity::Quantity;
  static constexpr Conversion<HundredthOhms> from_ohms(
      double value) noexcept {
    return from_real(value);
  }
  constexpr double ohms() const noexcept { return real(); }
};

/// Inverse quality factor of a filter; 0 counts are 0.2.
/// Unit: none, one count is 1/50, counted from 1/5.
class InverseQuality
    : public detail::Quantity<InverseQuality, std::uint8_t, unit::value, 1, 50, 1, 5> {
 public:
  using Quantity::Quantity;
  static constexpr Conversion<InverseQuality> from_value(
      double value) noexcept {
    return from_real(value);
  }
  constexpr double value() const noexcept { return real(); }
};

/// Frequency of a shake in steps of 0.05 Hz; 0 counts are 0.3 Hz.
/// Unit: Hz, one count is 1/20, counted from 3/10.
class ShakeFrequency
    : public detail::Quantity<ShakeFrequency, std::uint8_t, unit::Hz, 1, 20, 3, 10> {
 public:
  using Quantity::Quantity;
  static constexpr Conversion<ShakeFrequency> from_hertz(
      double value) noexcept {
    return from_real(value);
  }
  constexpr double hertz() const noexcept { return real(); }
};

/// Frequency of a resonance in steps of 0.1 Hz; 0 counts are 0.3 Hz.
/// Unit: Hz, one count is 1/10, counted from 3/10.
class ShakeResonance
    : public detail::Quantity<ShakeResonance, std::uint8_t, unit::Hz, 1, 10, 3, 10> {
 public:
  using Quantity::Quantity;
  static constexpr Conversion<ShakeResonance> from_hertz(
      double value) noexcept {
    return from_real(value);
  }
  constexpr double hertz() const noexcept { return real(); }
};

/// Factor in steps of 0.1; 0 counts are 1.5.
/// Unit: none, one count is 1/10, counted from 3/2.
class ShakeFactor
    : public detail::Quantity<ShakeFactor, std::uint8_t, unit::value, 1, 10, 3, 2> {
 public:
  using Quantity::Quantity;
  static constexpr Conversion<ShakeFactor> from_value(
      double value) noexcept {
    return from_real(value);
  }
  constexpr double value() const noexcept { return real(); }
};

/// Duration in steps of 20 ms; 0 counts are 500 ms.
/// Unit: ms, one count is 20, counted from 500.
class ShakePause
    : public detail::Quantity<ShakePause, std::uint8_t, unit::ms, 20, 1, 500, 1> {
 public:
  using Quantity::Quantity;
  static constexpr Conversion<ShakePause> from_milliseconds(
      double value) noexcept {
    return from_real(value);
  }
  constexpr double milliseconds() const noexcept { return real(); }
};

/// Gain in steps of 0.2 dB.
/// Unit: dB, one count is 1/5.
class FifthDecibels
    : public detail::Quantity<FifthDecibels, std::uint8_t, unit::dB, 1, 5> {
 public:
  using Quantity::Quantity;
  static constexpr Conversion<FifthDecibels> from_decibels(
      double value) noexcept {
    return from_real(value);
  }
  constexpr double decibels() const noexcept { return real(); }
};

/// Electric current in either direction.
/// Unit: mA.
class SignedCurrent
    : public detail::Quantity<SignedCurrent, std::int16_t, unit::mA, 1, 1> {
 public:
  using Quantity::Quantity;
  static constexpr Conversion<SignedCurrent> from_milliamperes(
      double value) noexcept {
    return from_real(value);
  }
  constexpr double milliamperes() const noexcept { return real(); }
};

/// Share of the largest current: 32768 counts are 100 %.
/// Unit: %, one count is 100/32768.
class CurrentShare
    : public detail::Quantity<CurrentShare, std::int16_t, unit::percent, 25, 8192> {
 public:
  using Quantity::Quantity;
  static constexpr Conversion<CurrentShare> from_percent(
      double value) noexcept {
    return from_real(value);
  }
  constexpr double percent() const noexcept { return real(); }
};

/// Angular speed in revolutions per minute; one is 6 deg/s.
/// Unit: rpm.
class RevolutionsPerMinute
    : public detail::Quantity<RevolutionsPerMinute, std::int16_t, unit::rpm, 1, 1> {
 public:
  using Quantity::Quantity;
  static constexpr Conversion<RevolutionsPerMinute> from_revolutions_per_minute(
      double value) noexcept {
    return from_real(value);
  }
  constexpr double revolutions_per_minute() const noexcept { return real(); }
};

/// Angle in radians.
/// Unit: rad.
class Radians
    : public detail::Quantity<Radians, float, unit::rad, 1, 1> {
 public:
  using Quantity::Quantity;
  static constexpr Conversion<Radians> from_radians(
      double value) noexcept {
    return from_real(value);
  }
  constexpr double radians() const noexcept { return real(); }
};

/// Angular speed in thousandths of a degree per second, with a wide range.
/// Unit: deg/s, one count is 1/1000.
class LongFineSpeed
    : public detail::Quantity<LongFineSpeed, std::int32_t, unit::deg_per_s, 1, 1000> {
 public:
  using Quantity::Quantity;
  static constexpr Conversion<LongFineSpeed> from_degrees_per_second(
      double value) noexcept {
    return from_real(value);
  }
  constexpr double degrees_per_second() const noexcept { return real(); }
};

/// Maximum angular speed, in the unit of ControlSpeed.
/// Unit: deg/s, one count is 4000/32767.
class ControlSpeedLimit
    : public detail::Quantity<ControlSpeedLimit, std::uint16_t, unit::deg_per_s, 4000, 32767> {
 public:
  using Quantity::Quantity;
  static constexpr Conversion<ControlSpeedLimit> from_degrees_per_second(
      double value) noexcept {
    return from_real(value);
  }
  constexpr double degrees_per_second() const noexcept { return real(); }
};

/// Angular speed in radians per second.
/// Unit: rad/s.
class RadianRate
    : public detail::Quantity<RadianRate, float, unit::rad_per_s, 1, 1> {
 public:
  using Quantity::Quantity;
  static constexpr Conversion<RadianRate> from_radians_per_second(
      double value) noexcept {
    return from_real(value);
  }
  constexpr double radians_per_second() const noexcept { return real(); }
};

/// Angle, 1048576 counts per turn, accumulated over full turns.
/// Unit: deg, one count is 360/1048576.
class Angle20
    : public detail::Quantity<Angle20, std::int32_t, unit::deg, 45, 131072> {
 public:
  using Quantity::Quantity;
  static constexpr Conversion<Angle20> from_degrees(
      double value) noexcept {
    return from_real(value);
  }
  constexpr double degrees() const noexcept { return real(); }
};

/// Angular acceleration in whole deg/s^2, with a wide range.
/// Unit: deg/s^2.
class LongAngularAcceleration
    : public detail::Quantity<LongAngularAcceleration, std::uint16_t, unit::deg_per_s2, 1, 1> {
 public:
  using Quantity::Quantity;
  static constexpr Conversion<LongAngularAcceleration> from_degrees_per_second_squared(
      double value) noexcept {
    return from_real(value);
  }
  constexpr double degrees_per_second_squared() const noexcept { return real(); }
};

/// Time in which an acceleration rises to its limit, in steps of 20 ms.
/// Unit: ms, one count is 20.
class JerkTime
    : public detail::Quantity<JerkTime, std::uint8_t, unit::ms, 20, 1> {
 public:
  using Quantity::Quantity;
  static constexpr Conversion<JerkTime> from_milliseconds(
      double value) noexcept {
    return from_real(value);
  }
  constexpr double milliseconds() const noexcept { return real(); }
};

/// Component of a packed quaternion; 524287 counts are the square root of 1/2.
/// Unit: none, one count is 1000000/741453785976.
class QuaternionPart
    : public detail::Quantity<QuaternionPart, std::int32_t, unit::value, 125000, 92681723247> {
 public:
  using Quantity::Quantity;
  static constexpr Conversion<QuaternionPart> from_value(
      double value) noexcept {
    return from_real(value);
  }
  constexpr double value() const noexcept { return real(); }
};

/// Maximum angular speed of an external motor, in steps of 2 deg/s.
/// Unit: deg/s, one count is 2.
class ExtMotorSpeedLimit
    : public detail::Quantity<ExtMotorSpeedLimit, std::uint16_t, unit::deg_per_s, 2, 1> {
 public:
  using Quantity::Quantity;
  static constexpr Conversion<ExtMotorSpeedLimit> from_degrees_per_second(
      double value) noexcept {
    return from_real(value);
  }
  constexpr double degrees_per_second() const noexcept { return real(); }
};

/// Maximum angular acceleration of an external motor, in steps of 2 deg/s^2.
/// Unit: deg/s^2, one count is 2.
class ExtMotorAccelerationLimit
    : public detail::Quantity<ExtMotorAccelerationLimit, std::uint16_t, unit::deg_per_s2, 2, 1> {
 public:
  using Quantity::Quantity;
  static constexpr Conversion<ExtMotorAccelerationLimit> from_degrees_per_second_squared(
      double value) noexcept {
    return from_real(value);
  }
  constexpr double degrees_per_second_squared() const noexcept { return real(); }
};

/// Angular speed in millionths of a radian per second.
/// Unit: rad/s, one count is 1/1000000.
class MicroradianRate
    : public detail::Quantity<MicroradianRate, std::int32_t, unit::rad_per_s, 1, 1000000> {
 public:
  using Quantity::Quantity;
  static constexpr Conversion<MicroradianRate> from_radians_per_second(
      double value) noexcept {
    return from_real(value);
  }
  constexpr double radians_per_second() const noexcept { return real(); }
};

/// Voltage in thousandths of a volt.
/// Unit: V, one count is 1/1000.
class Millivolts
    : public detail::Quantity<Millivolts, std::uint16_t, unit::V, 1, 1000> {
 public:
  using Quantity::Quantity;
  static constexpr Conversion<Millivolts> from_volts(
      double value) noexcept {
    return from_real(value);
  }
  constexpr double volts() const noexcept { return real(); }
};

/// Angle in whole degrees, without a sign.
/// Unit: deg.
class WideDegrees
    : public detail::Quantity<WideDegrees, std::uint16_t, unit::deg, 1, 1> {
 public:
  using Quantity::Quantity;
  static constexpr Conversion<WideDegrees> from_degrees(
      double value) noexcept {
    return from_real(value);
  }
  constexpr double degrees() const noexcept { return real(); }
};

/// Low frequency in tenths of a hertz.
/// Unit: Hz, one count is 1/10.
class TenthHertz
    : public detail::Quantity<TenthHertz, std::uint8_t, unit::Hz, 1, 10> {
 public:
  using Quantity::Quantity;
  static constexpr Conversion<TenthHertz> from_hertz(
      double value) noexcept {
    return from_real(value);
  }
  constexpr double hertz() const noexcept { return real(); }
};

/// Gain in tenths of a decibel.
/// Unit: dB, one count is 1/10.
class TenthDecibels
    : public detail::Quantity<TenthDecibels, std::uint8_t, unit::dB, 1, 10> {
 public:
  using Quantity::Quantity;
  static constexpr Conversion<TenthDecibels> from_decibels(
      double value) noexcept {
    return from_real(value);
  }
  constexpr double decibels() const noexcept { return real(); }
};

/// Offset in pages of 64 bytes.
/// Unit: byte, one count is 64.
class Pages
    : public detail::Quantity<Pages, std::uint16_t, unit::byte, 64, 1> {
 public:
  using Quantity::Quantity;
  static constexpr Conversion<Pages> from_bytes(
      double value) noexcept {
    return from_real(value);
  }
  constexpr double bytes() const noexcept { return real(); }
};

}  // namespace sbgc::msg
