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
