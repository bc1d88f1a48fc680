// Generated from spec/ by generator/: edit those, then run ./dev generate.

/// The physical quantities of the protocol. Each is a distinct type over the exact number on the
/// wire, so that units cannot be mixed by mistake. The functions that convert it from and to its unit
/// are named by the unit, as in Angle14::from_degrees(45.0); literals.hpp has them.
///
/// A number does not convert to a quantity: the deleted constructor names the reason. It is a
/// template, so that the compiler prefers the one of the whole number of the wire where both are
/// possible; g++ 12 would not see that it is deleted if the quantities inherited it.
#pragma once

#include <cstdint>

#include <sbgc/literals.hpp>
#include <sbgc/quantity.hpp>

namespace sbgc::msg {

/// Angle, 16384 counts per turn.
/// Unit: deg, one count is 360/16384.
class Angle14
    : public detail::Quantity<Angle14, std::int16_t, unit::deg, 45, 2048>,
      public unit::deg::Accessors<Angle14> {
 public:
  using Quantity::Quantity;
  constexpr Angle14() = default;
  template <class =
                detail::a_number_has_no_unit_write_a_literal_such_as_30_deg_or_use_from_degrees>
  constexpr Angle14(raw_type) = delete;  // NOLINT(google-explicit-constructor)
};

/// Angle, 16384 counts per turn, accumulated over full turns.
/// Unit: deg, one count is 360/16384.
class LongAngle14
    : public detail::Quantity<LongAngle14, std::int32_t, unit::deg, 45, 2048>,
      public unit::deg::Accessors<LongAngle14> {
 public:
  using Quantity::Quantity;
  constexpr LongAngle14() = default;
  template <class =
                detail::a_number_has_no_unit_write_a_literal_such_as_30_deg_or_use_from_degrees>
  constexpr LongAngle14(raw_type) = delete;  // NOLINT(google-explicit-constructor)
};

/// Angle in whole degrees.
/// Unit: deg.
class Degrees
    : public detail::Quantity<Degrees, std::int16_t, unit::deg, 1, 1>,
      public unit::deg::Accessors<Degrees> {
 public:
  using Quantity::Quantity;
  constexpr Degrees() = default;
  template <class =
                detail::a_number_has_no_unit_write_a_literal_such_as_30_deg_or_use_from_degrees>
  constexpr Degrees(raw_type) = delete;  // NOLINT(google-explicit-constructor)
};

/// Small angle in whole degrees.
/// Unit: deg.
class SmallDegrees
    : public detail::Quantity<SmallDegrees, std::uint8_t, unit::deg, 1, 1>,
      public unit::deg::Accessors<SmallDegrees> {
 public:
  using Quantity::Quantity;
  constexpr SmallDegrees() = default;
  template <class =
                detail::a_number_has_no_unit_write_a_literal_such_as_30_deg_or_use_from_degrees>
  constexpr SmallDegrees(raw_type) = delete;  // NOLINT(google-explicit-constructor)
};

/// Small signed angle in whole degrees.
/// Unit: deg.
class SignedDegrees
    : public detail::Quantity<SignedDegrees, std::int8_t, unit::deg, 1, 1>,
      public unit::deg::Accessors<SignedDegrees> {
 public:
  using Quantity::Quantity;
  constexpr SignedDegrees() = default;
  template <class =
                detail::a_number_has_no_unit_write_a_literal_such_as_30_deg_or_use_from_degrees>
  constexpr SignedDegrees(raw_type) = delete;  // NOLINT(google-explicit-constructor)
};

/// Angle in steps of 3 degrees.
/// Unit: deg, one count is 3.
class EncoderLimit
    : public detail::Quantity<EncoderLimit, std::int8_t, unit::deg, 3, 1>,
      public unit::deg::Accessors<EncoderLimit> {
 public:
  using Quantity::Quantity;
  constexpr EncoderLimit() = default;
  template <class =
                detail::a_number_has_no_unit_write_a_literal_such_as_30_deg_or_use_from_degrees>
  constexpr EncoderLimit(raw_type) = delete;  // NOLINT(google-explicit-constructor)
};

/// Angle in tenths of a degree.
/// Unit: deg, one count is 1/10.
class TenthDegrees
    : public detail::Quantity<TenthDegrees, std::int16_t, unit::deg, 1, 10>,
      public unit::deg::Accessors<TenthDegrees> {
 public:
  using Quantity::Quantity;
  constexpr TenthDegrees() = default;
  template <class =
                detail::a_number_has_no_unit_write_a_literal_such_as_30_deg_or_use_from_degrees>
  constexpr TenthDegrees(raw_type) = delete;  // NOLINT(google-explicit-constructor)
};

/// Angle between an estimated and a reference vector, in tenths of a degree.
/// Unit: deg, one count is 1/10.
class AngleError
    : public detail::Quantity<AngleError, std::uint8_t, unit::deg, 1, 10>,
      public unit::deg::Accessors<AngleError> {
 public:
  using Quantity::Quantity;
  constexpr AngleError() = default;
  template <class =
                detail::a_number_has_no_unit_write_a_literal_such_as_30_deg_or_use_from_degrees>
  constexpr AngleError(raw_type) = delete;  // NOLINT(google-explicit-constructor)
};

/// Angular speed of commands and targets: full scale is 4000 deg/s.
/// Unit: deg/s, one count is 4000/32767.
class ControlSpeed
    : public detail::Quantity<ControlSpeed, std::int16_t, unit::deg_per_s, 4000, 32767>,
      public unit::deg_per_s::Accessors<ControlSpeed> {
 public:
  using Quantity::Quantity;
  constexpr ControlSpeed() = default;
  template <class =
                detail::a_number_has_no_unit_write_a_literal_such_as_30_deg_or_use_from_degrees>
  constexpr ControlSpeed(raw_type) = delete;  // NOLINT(google-explicit-constructor)
};

/// Angular speed for extremely slow motion, in thousandths of a degree per second.
/// Unit: deg/s, one count is 1/1000.
class FineSpeed
    : public detail::Quantity<FineSpeed, std::int16_t, unit::deg_per_s, 1, 1000>,
      public unit::deg_per_s::Accessors<FineSpeed> {
 public:
  using Quantity::Quantity;
  constexpr FineSpeed() = default;
  template <class =
                detail::a_number_has_no_unit_write_a_literal_such_as_30_deg_or_use_from_degrees>
  constexpr FineSpeed(raw_type) = delete;  // NOLINT(google-explicit-constructor)
};

/// Angular speed from the gyroscope: full scale is 2000 deg/s.
/// Unit: deg/s, one count is 2000/32767.
class GyroRate
    : public detail::Quantity<GyroRate, std::int16_t, unit::deg_per_s, 2000, 32767>,
      public unit::deg_per_s::Accessors<GyroRate> {
 public:
  using Quantity::Quantity;
  constexpr GyroRate() = default;
  template <class =
                detail::a_number_has_no_unit_write_a_literal_such_as_30_deg_or_use_from_degrees>
  constexpr GyroRate(raw_type) = delete;  // NOLINT(google-explicit-constructor)
};

/// Angular acceleration in steps of 5 deg/s^2.
/// Unit: deg/s^2, one count is 5.
class AngularAcceleration
    : public detail::Quantity<AngularAcceleration, std::uint8_t, unit::deg_per_s2, 5, 1>,
      public unit::deg_per_s2::Accessors<AngularAcceleration> {
 public:
  using Quantity::Quantity;
  constexpr AngularAcceleration() = default;
  template <class =
                detail::a_number_has_no_unit_write_a_literal_such_as_30_deg_or_use_from_degrees>
  constexpr AngularAcceleration(raw_type) = delete;  // NOLINT(google-explicit-constructor)
};

/// Angular acceleration in whole deg/s^2.
/// Unit: deg/s^2.
class PlainAngularAcceleration
    : public detail::Quantity<PlainAngularAcceleration, std::int16_t, unit::deg_per_s2, 1, 1>,
      public unit::deg_per_s2::Accessors<PlainAngularAcceleration> {
 public:
  using Quantity::Quantity;
  constexpr PlainAngularAcceleration() = default;
  template <class =
                detail::a_number_has_no_unit_write_a_literal_such_as_30_deg_or_use_from_degrees>
  constexpr PlainAngularAcceleration(raw_type) = delete;  // NOLINT(google-explicit-constructor)
};

/// Linear acceleration; 512 counts are 1 g.
/// Unit: g, one count is 1/512.
class Acceleration
    : public detail::Quantity<Acceleration, std::int16_t, unit::g, 1, 512>,
      public unit::g::Accessors<Acceleration> {
 public:
  using Quantity::Quantity;
  constexpr Acceleration() = default;
  template <class =
                detail::a_number_has_no_unit_write_a_literal_such_as_30_deg_or_use_from_degrees>
  constexpr Acceleration(raw_type) = delete;  // NOLINT(google-explicit-constructor)
};

/// Time stamp that wraps after 65.536 s.
/// Unit: ms.
class MillisecondClock
    : public detail::Quantity<MillisecondClock, std::uint16_t, unit::ms, 1, 1>,
      public unit::ms::Accessors<MillisecondClock> {
 public:
  using Quantity::Quantity;
  constexpr MillisecondClock() = default;
  template <class =
                detail::a_number_has_no_unit_write_a_literal_such_as_30_deg_or_use_from_degrees>
  constexpr MillisecondClock(raw_type) = delete;  // NOLINT(google-explicit-constructor)
};

/// Duration in milliseconds.
/// Unit: ms.
class Milliseconds
    : public detail::Quantity<Milliseconds, std::uint16_t, unit::ms, 1, 1>,
      public unit::ms::Accessors<Milliseconds> {
 public:
  using Quantity::Quantity;
  constexpr Milliseconds() = default;
  template <class =
                detail::a_number_has_no_unit_write_a_literal_such_as_30_deg_or_use_from_degrees>
  constexpr Milliseconds(raw_type) = delete;  // NOLINT(google-explicit-constructor)
};

/// Duration in microseconds.
/// Unit: us.
class Microseconds
    : public detail::Quantity<Microseconds, std::uint16_t, unit::us, 1, 1>,
      public unit::us::Accessors<Microseconds> {
 public:
  using Quantity::Quantity;
  constexpr Microseconds() = default;
  template <class =
                detail::a_number_has_no_unit_write_a_literal_such_as_30_deg_or_use_from_degrees>
  constexpr Microseconds(raw_type) = delete;  // NOLINT(google-explicit-constructor)
};

/// Duration in steps of 10 ms.
/// Unit: ms, one count is 10.
class TensOfMilliseconds
    : public detail::Quantity<TensOfMilliseconds, std::uint8_t, unit::ms, 10, 1>,
      public unit::ms::Accessors<TensOfMilliseconds> {
 public:
  using Quantity::Quantity;
  constexpr TensOfMilliseconds() = default;
  template <class =
                detail::a_number_has_no_unit_write_a_literal_such_as_30_deg_or_use_from_degrees>
  constexpr TensOfMilliseconds(raw_type) = delete;  // NOLINT(google-explicit-constructor)
};

/// Length of a servo pulse; values up to 0 are special.
/// Unit: us.
class ServoPulse
    : public detail::Quantity<ServoPulse, std::int16_t, unit::us, 1, 1>,
      public unit::us::Accessors<ServoPulse> {
 public:
  using Quantity::Quantity;
  constexpr ServoPulse() = default;
  template <class =
                detail::a_number_has_no_unit_write_a_literal_such_as_30_deg_or_use_from_degrees>
  constexpr ServoPulse(raw_type) = delete;  // NOLINT(google-explicit-constructor)
};

/// Length of a note in steps of 8 ms.
/// Unit: ms, one count is 8.
class NoteLength
    : public detail::Quantity<NoteLength, std::uint8_t, unit::ms, 8, 1>,
      public unit::ms::Accessors<NoteLength> {
 public:
  using Quantity::Quantity;
  constexpr NoteLength() = default;
  template <class =
                detail::a_number_has_no_unit_write_a_literal_such_as_30_deg_or_use_from_degrees>
  constexpr NoteLength(raw_type) = delete;  // NOLINT(google-explicit-constructor)
};

/// Pitch of a note.
/// Unit: Hz.
class NoteFrequency
    : public detail::Quantity<NoteFrequency, std::uint16_t, unit::Hz, 1, 1>,
      public unit::Hz::Accessors<NoteFrequency> {
 public:
  using Quantity::Quantity;
  constexpr NoteFrequency() = default;
  template <class =
                detail::a_number_has_no_unit_write_a_literal_such_as_30_deg_or_use_from_degrees>
  constexpr NoteFrequency(raw_type) = delete;  // NOLINT(google-explicit-constructor)
};

/// PWM frequency in steps of 10 Hz.
/// Unit: Hz, one count is 10.
class ServoRate
    : public detail::Quantity<ServoRate, std::uint8_t, unit::Hz, 10, 1>,
      public unit::Hz::Accessors<ServoRate> {
 public:
  using Quantity::Quantity;
  constexpr ServoRate() = default;
  template <class =
                detail::a_number_has_no_unit_write_a_literal_such_as_30_deg_or_use_from_degrees>
  constexpr ServoRate(raw_type) = delete;  // NOLINT(google-explicit-constructor)
};

/// Frequency in whole hertz.
/// Unit: Hz.
class Frequency
    : public detail::Quantity<Frequency, std::uint16_t, unit::Hz, 1, 1>,
      public unit::Hz::Accessors<Frequency> {
 public:
  using Quantity::Quantity;
  constexpr Frequency() = default;
  template <class =
                detail::a_number_has_no_unit_write_a_literal_such_as_30_deg_or_use_from_degrees>
  constexpr Frequency(raw_type) = delete;  // NOLINT(google-explicit-constructor)
};

/// Low frequency in whole hertz.
/// Unit: Hz.
class SmallFrequency
    : public detail::Quantity<SmallFrequency, std::uint8_t, unit::Hz, 1, 1>,
      public unit::Hz::Accessors<SmallFrequency> {
 public:
  using Quantity::Quantity;
  constexpr SmallFrequency() = default;
  template <class =
                detail::a_number_has_no_unit_write_a_literal_such_as_30_deg_or_use_from_degrees>
  constexpr SmallFrequency(raw_type) = delete;  // NOLINT(google-explicit-constructor)
};

/// Frequency in steps of 2 Hz.
/// Unit: Hz, one count is 2.
class EvenFrequency
    : public detail::Quantity<EvenFrequency, std::uint8_t, unit::Hz, 2, 1>,
      public unit::Hz::Accessors<EvenFrequency> {
 public:
  using Quantity::Quantity;
  constexpr EvenFrequency() = default;
  template <class =
                detail::a_number_has_no_unit_write_a_literal_such_as_30_deg_or_use_from_degrees>
  constexpr EvenFrequency(raw_type) = delete;  // NOLINT(google-explicit-constructor)
};

/// Frequency in steps of 10 Hz.
/// Unit: Hz, one count is 10.
class CoarseFrequency
    : public detail::Quantity<CoarseFrequency, std::uint8_t, unit::Hz, 10, 1>,
      public unit::Hz::Accessors<CoarseFrequency> {
 public:
  using Quantity::Quantity;
  constexpr CoarseFrequency() = default;
  template <class =
                detail::a_number_has_no_unit_write_a_literal_such_as_30_deg_or_use_from_degrees>
  constexpr CoarseFrequency(raw_type) = delete;  // NOLINT(google-explicit-constructor)
};

/// Frequency in hundredths of a hertz.
/// Unit: Hz, one count is 1/100.
class FineFrequency
    : public detail::Quantity<FineFrequency, std::uint16_t, unit::Hz, 1, 100>,
      public unit::Hz::Accessors<FineFrequency> {
 public:
  using Quantity::Quantity;
  constexpr FineFrequency() = default;
  template <class =
                detail::a_number_has_no_unit_write_a_literal_such_as_30_deg_or_use_from_degrees>
  constexpr FineFrequency(raw_type) = delete;  // NOLINT(google-explicit-constructor)
};

/// Voltage in hundredths of a volt.
/// Unit: V, one count is 1/100.
class Voltage
    : public detail::Quantity<Voltage, std::uint16_t, unit::V, 1, 100>,
      public unit::V::Accessors<Voltage> {
 public:
  using Quantity::Quantity;
  constexpr Voltage() = default;
  template <class =
                detail::a_number_has_no_unit_write_a_literal_such_as_30_deg_or_use_from_degrees>
  constexpr Voltage(raw_type) = delete;  // NOLINT(google-explicit-constructor)
};

/// Voltage in hundredths of a volt; a negative value switches the function off.
/// Unit: V, one count is 1/100.
class VoltageThreshold
    : public detail::Quantity<VoltageThreshold, std::int16_t, unit::V, 1, 100>,
      public unit::V::Accessors<VoltageThreshold> {
 public:
  using Quantity::Quantity;
  constexpr VoltageThreshold() = default;
  template <class =
                detail::a_number_has_no_unit_write_a_literal_such_as_30_deg_or_use_from_degrees>
  constexpr VoltageThreshold(raw_type) = delete;  // NOLINT(google-explicit-constructor)
};

/// Electric current.
/// Unit: mA.
class Current
    : public detail::Quantity<Current, std::uint16_t, unit::mA, 1, 1>,
      public unit::mA::Accessors<Current> {
 public:
  using Quantity::Quantity;
  constexpr Current() = default;
  template <class =
                detail::a_number_has_no_unit_write_a_literal_such_as_30_deg_or_use_from_degrees>
  constexpr Current(raw_type) = delete;  // NOLINT(google-explicit-constructor)
};

/// Temperature.
/// Unit: degC.
class Temperature
    : public detail::Quantity<Temperature, std::int8_t, unit::degC, 1, 1>,
      public unit::degC::Accessors<Temperature> {
 public:
  using Quantity::Quantity;
  constexpr Temperature() = default;
  template <class =
                detail::a_number_has_no_unit_write_a_literal_such_as_30_deg_or_use_from_degrees>
  constexpr Temperature(raw_type) = delete;  // NOLINT(google-explicit-constructor)
};

/// Number in hundredths.
/// Unit: none, one count is 1/100.
class Hundredths
    : public detail::Quantity<Hundredths, std::uint8_t, unit::value, 1, 100>,
      public unit::value::Accessors<Hundredths> {
 public:
  using Quantity::Quantity;
  constexpr Hundredths() = default;
  template <class =
                detail::a_number_has_no_unit_write_a_literal_such_as_30_deg_or_use_from_degrees>
  constexpr Hundredths(raw_type) = delete;  // NOLINT(google-explicit-constructor)
};

/// Number in hundredths, with a wide range.
/// Unit: none, one count is 1/100.
class LongHundredths
    : public detail::Quantity<LongHundredths, std::uint16_t, unit::value, 1, 100>,
      public unit::value::Accessors<LongHundredths> {
 public:
  using Quantity::Quantity;
  constexpr LongHundredths() = default;
  template <class =
                detail::a_number_has_no_unit_write_a_literal_such_as_30_deg_or_use_from_degrees>
  constexpr LongHundredths(raw_type) = delete;  // NOLINT(google-explicit-constructor)
};

/// Number in thousandths.
/// Unit: none, one count is 1/1000.
class Thousandths
    : public detail::Quantity<Thousandths, std::uint16_t, unit::value, 1, 1000>,
      public unit::value::Accessors<Thousandths> {
 public:
  using Quantity::Quantity;
  constexpr Thousandths() = default;
  template <class =
                detail::a_number_has_no_unit_write_a_literal_such_as_30_deg_or_use_from_degrees>
  constexpr Thousandths(raw_type) = delete;  // NOLINT(google-explicit-constructor)
};

/// Number with eight integer and eight fractional bits.
/// Unit: none, one count is 1/256.
class FixedPoint8
    : public detail::Quantity<FixedPoint8, std::uint16_t, unit::value, 1, 256>,
      public unit::value::Accessors<FixedPoint8> {
 public:
  using Quantity::Quantity;
  constexpr FixedPoint8() = default;
  template <class =
                detail::a_number_has_no_unit_write_a_literal_such_as_30_deg_or_use_from_degrees>
  constexpr FixedPoint8(raw_type) = delete;  // NOLINT(google-explicit-constructor)
};

/// Factor on the gains of a PID controller; 0 counts are 0.1.
/// Unit: none, one count is 1/50, counted from 1/10.
class PidGain
    : public detail::Quantity<PidGain, std::uint8_t, unit::value, 1, 50, 1, 10>,
      public unit::value::Accessors<PidGain> {
 public:
  using Quantity::Quantity;
  constexpr PidGain() = default;
  template <class =
                detail::a_number_has_no_unit_write_a_literal_such_as_30_deg_or_use_from_degrees>
  constexpr PidGain(raw_type) = delete;  // NOLINT(google-explicit-constructor)
};

/// Gain of a PID controller, 0 to 255, in fine steps where it is small.
/// Unit: none, the value is 5 * 52^(raw / 255) - 5.
class LogarithmicGain
    : public detail::Quantity<LogarithmicGain, std::uint8_t, unit::value, 5, 1, -5, 1>,
      public unit::value::Accessors<LogarithmicGain> {
 public:
  using Quantity::Quantity;
  constexpr LogarithmicGain() = default;
  template <class =
                detail::a_number_has_no_unit_write_a_literal_such_as_30_deg_or_use_from_degrees>
  constexpr LogarithmicGain(raw_type) = delete;  // NOLINT(google-explicit-constructor)
  /// The factor between adjacent values.
  static constexpr double growth = 1.0156157445197571;
};

/// Gain in decibels.
/// Unit: dB.
class Decibels
    : public detail::Quantity<Decibels, std::int8_t, unit::dB, 1, 1>,
      public unit::dB::Accessors<Decibels> {
 public:
  using Quantity::Quantity;
  constexpr Decibels() = default;
  template <class =
                detail::a_number_has_no_unit_write_a_literal_such_as_30_deg_or_use_from_degrees>
  constexpr Decibels(raw_type) = delete;  // NOLINT(google-explicit-constructor)
};

/// Share of a whole.
/// Unit: %.
class Percent
    : public detail::Quantity<Percent, std::uint8_t, unit::percent, 1, 1>,
      public unit::percent::Accessors<Percent> {
 public:
  using Quantity::Quantity;
  constexpr Percent() = default;
  template <class =
                detail::a_number_has_no_unit_write_a_literal_such_as_30_deg_or_use_from_degrees>
  constexpr Percent(raw_type) = delete;  // NOLINT(google-explicit-constructor)
};

/// Tenths of the gyroscope's native unit.
/// Unit: gyro unit, one count is 1/10.
class GyroDeadband
    : public detail::Quantity<GyroDeadband, std::uint8_t, unit::gyro_unit, 1, 10>,
      public unit::gyro_unit::Accessors<GyroDeadband> {
 public:
  using Quantity::Quantity;
  constexpr GyroDeadband() = default;
  template <class =
                detail::a_number_has_no_unit_write_a_literal_such_as_30_deg_or_use_from_degrees>
  constexpr GyroDeadband(raw_type) = delete;  // NOLINT(google-explicit-constructor)
};

/// Thousandths of the gyroscope's native unit.
/// Unit: gyro unit, one count is 1/1000.
class GyroOffset
    : public detail::Quantity<GyroOffset, std::int16_t, unit::gyro_unit, 1, 1000>,
      public unit::gyro_unit::Accessors<GyroOffset> {
 public:
  using Quantity::Quantity;
  constexpr GyroOffset() = default;
  template <class =
                detail::a_number_has_no_unit_write_a_literal_such_as_30_deg_or_use_from_degrees>
  constexpr GyroOffset(raw_type) = delete;  // NOLINT(google-explicit-constructor)
};

/// RC pulse width, or an analog signal normalized to the same range.
/// Unit: us.
class RcSignal
    : public detail::Quantity<RcSignal, std::int16_t, unit::us, 1, 1>,
      public unit::us::Accessors<RcSignal> {
 public:
  using Quantity::Quantity;
  constexpr RcSignal() = default;
  template <class =
                detail::a_number_has_no_unit_write_a_literal_such_as_30_deg_or_use_from_degrees>
  constexpr RcSignal(raw_type) = delete;  // NOLINT(google-explicit-constructor)
};

/// High-resolution RC signal; the normal range is -1 to 1.
/// Unit: none, one count is 1/16384.
class FineRcSignal
    : public detail::Quantity<FineRcSignal, std::int16_t, unit::fraction, 1, 16384>,
      public unit::fraction::Accessors<FineRcSignal> {
 public:
  using Quantity::Quantity;
  constexpr FineRcSignal() = default;
  template <class =
                detail::a_number_has_no_unit_write_a_literal_such_as_30_deg_or_use_from_degrees>
  constexpr FineRcSignal(raw_type) = delete;  // NOLINT(google-explicit-constructor)
};

/// RC signal relative to its center; the normal range is -1 to 1.
/// Unit: none, one count is 1/500.
class CentredRcSignal
    : public detail::Quantity<CentredRcSignal, std::int16_t, unit::fraction, 1, 500>,
      public unit::fraction::Accessors<CentredRcSignal> {
 public:
  using Quantity::Quantity;
  constexpr CentredRcSignal() = default;
  template <class =
                detail::a_number_has_no_unit_write_a_literal_such_as_30_deg_or_use_from_degrees>
  constexpr CentredRcSignal(raw_type) = delete;  // NOLINT(google-explicit-constructor)
};

/// Motor power needed to hold the camera: 0 is perfect balance, 512 counts are 100 %.
/// Unit: %, one count is 100/512.
class BalanceError
    : public detail::Quantity<BalanceError, std::int16_t, unit::percent, 25, 128>,
      public unit::percent::Accessors<BalanceError> {
 public:
  using Quantity::Quantity;
  constexpr BalanceError() = default;
  template <class =
                detail::a_number_has_no_unit_write_a_literal_such_as_30_deg_or_use_from_degrees>
  constexpr BalanceError(raw_type) = delete;  // NOLINT(google-explicit-constructor)
};

/// Number of bytes.
/// Unit: byte.
class ByteCount
    : public detail::Quantity<ByteCount, std::uint16_t, unit::byte, 1, 1>,
      public unit::byte::Accessors<ByteCount> {
 public:
  using Quantity::Quantity;
  constexpr ByteCount() = default;
  template <class =
                detail::a_number_has_no_unit_write_a_literal_such_as_30_deg_or_use_from_degrees>
  constexpr ByteCount(raw_type) = delete;  // NOLINT(google-explicit-constructor)
};

/// Small number of bytes.
/// Unit: byte.
class SmallByteCount
    : public detail::Quantity<SmallByteCount, std::uint8_t, unit::byte, 1, 1>,
      public unit::byte::Accessors<SmallByteCount> {
 public:
  using Quantity::Quantity;
  constexpr SmallByteCount() = default;
  template <class =
                detail::a_number_has_no_unit_write_a_literal_such_as_30_deg_or_use_from_degrees>
  constexpr SmallByteCount(raw_type) = delete;  // NOLINT(google-explicit-constructor)
};

/// Large number of bytes.
/// Unit: byte.
class LongByteCount
    : public detail::Quantity<LongByteCount, std::uint32_t, unit::byte, 1, 1>,
      public unit::byte::Accessors<LongByteCount> {
 public:
  using Quantity::Quantity;
  constexpr LongByteCount() = default;
  template <class =
                detail::a_number_has_no_unit_write_a_literal_such_as_30_deg_or_use_from_degrees>
  constexpr LongByteCount(raw_type) = delete;  // NOLINT(google-explicit-constructor)
};

/// Long duration in whole seconds.
/// Unit: ms, one count is 1000.
class LongSeconds
    : public detail::Quantity<LongSeconds, std::uint32_t, unit::ms, 1000, 1>,
      public unit::ms::Accessors<LongSeconds> {
 public:
  using Quantity::Quantity;
  constexpr LongSeconds() = default;
  template <class =
                detail::a_number_has_no_unit_write_a_literal_such_as_30_deg_or_use_from_degrees>
  constexpr LongSeconds(raw_type) = delete;  // NOLINT(google-explicit-constructor)
};

/// Electric energy.
/// Unit: Wh.
class WattHours
    : public detail::Quantity<WattHours, float, unit::Wh, 1, 1>,
      public unit::Wh::Accessors<WattHours> {
 public:
  using Quantity::Quantity;
  constexpr WattHours() = default;
  template <class =
                detail::a_number_has_no_unit_write_a_literal_such_as_30_deg_or_use_from_degrees>
  constexpr WattHours(raw_type) = delete;  // NOLINT(google-explicit-constructor)
};

/// Electric current in amperes.
/// Unit: mA, one count is 1000.
class AverageCurrent
    : public detail::Quantity<AverageCurrent, float, unit::mA, 1000, 1>,
      public unit::mA::Accessors<AverageCurrent> {
 public:
  using Quantity::Quantity;
  constexpr AverageCurrent() = default;
  template <class =
                detail::a_number_has_no_unit_write_a_literal_such_as_30_deg_or_use_from_degrees>
  constexpr AverageCurrent(raw_type) = delete;  // NOLINT(google-explicit-constructor)
};

/// Temperature from 0 up.
/// Unit: degC.
class PositiveTemperature
    : public detail::Quantity<PositiveTemperature, std::uint8_t, unit::degC, 1, 1>,
      public unit::degC::Accessors<PositiveTemperature> {
 public:
  using Quantity::Quantity;
  constexpr PositiveTemperature() = default;
  template <class =
                detail::a_number_has_no_unit_write_a_literal_such_as_30_deg_or_use_from_degrees>
  constexpr PositiveTemperature(raw_type) = delete;  // NOLINT(google-explicit-constructor)
};

/// Linear acceleration in steps of 1/16 g.
/// Unit: g, one count is 1/16.
class AccelerationPeak
    : public detail::Quantity<AccelerationPeak, std::uint8_t, unit::g, 1, 16>,
      public unit::g::Accessors<AccelerationPeak> {
 public:
  using Quantity::Quantity;
  constexpr AccelerationPeak() = default;
  template <class =
                detail::a_number_has_no_unit_write_a_literal_such_as_30_deg_or_use_from_degrees>
  constexpr AccelerationPeak(raw_type) = delete;  // NOLINT(google-explicit-constructor)
};

/// Number of pages of 32 KB.
/// Unit: byte, one count is 32768.
class FlashSize
    : public detail::Quantity<FlashSize, std::uint8_t, unit::byte, 32768, 1>,
      public unit::byte::Accessors<FlashSize> {
 public:
  using Quantity::Quantity;
  constexpr FlashSize() = default;
  template <class =
                detail::a_number_has_no_unit_write_a_literal_such_as_30_deg_or_use_from_degrees>
  constexpr FlashSize(raw_type) = delete;  // NOLINT(google-explicit-constructor)
};

/// Duration in whole seconds.
/// Unit: ms, one count is 1000.
class Seconds
    : public detail::Quantity<Seconds, std::uint16_t, unit::ms, 1000, 1>,
      public unit::ms::Accessors<Seconds> {
 public:
  using Quantity::Quantity;
  constexpr Seconds() = default;
  template <class =
                detail::a_number_has_no_unit_write_a_literal_such_as_30_deg_or_use_from_degrees>
  constexpr Seconds(raw_type) = delete;  // NOLINT(google-explicit-constructor)
};

/// Duration in steps of 100 ms.
/// Unit: ms, one count is 100.
class HundredsOfMilliseconds
    : public detail::Quantity<HundredsOfMilliseconds, std::uint8_t, unit::ms, 100, 1>,
      public unit::ms::Accessors<HundredsOfMilliseconds> {
 public:
  using Quantity::Quantity;
  constexpr HundredsOfMilliseconds() = default;
  template <class =
                detail::a_number_has_no_unit_write_a_literal_such_as_30_deg_or_use_from_degrees>
  constexpr HundredsOfMilliseconds(raw_type) = delete;  // NOLINT(google-explicit-constructor)
};

/// Angle in hundredths of a degree.
/// Unit: deg, one count is 1/100.
class HundredthDegrees
    : public detail::Quantity<HundredthDegrees, std::int16_t, unit::deg, 1, 100>,
      public unit::deg::Accessors<HundredthDegrees> {
 public:
  using Quantity::Quantity;
  constexpr HundredthDegrees() = default;
  template <class =
                detail::a_number_has_no_unit_write_a_literal_such_as_30_deg_or_use_from_degrees>
  constexpr HundredthDegrees(raw_type) = delete;  // NOLINT(google-explicit-constructor)
};

/// Electric current in steps of 10 mA.
/// Unit: mA, one count is 10.
class TensOfMilliamperes
    : public detail::Quantity<TensOfMilliamperes, std::uint16_t, unit::mA, 10, 1>,
      public unit::mA::Accessors<TensOfMilliamperes> {
 public:
  using Quantity::Quantity;
  constexpr TensOfMilliamperes() = default;
  template <class =
                detail::a_number_has_no_unit_write_a_literal_such_as_30_deg_or_use_from_degrees>
  constexpr TensOfMilliamperes(raw_type) = delete;  // NOLINT(google-explicit-constructor)
};

/// Electric resistance in tenths of an ohm.
/// Unit: ohm, one count is 1/10.
class TenthOhms
    : public detail::Quantity<TenthOhms, std::uint8_t, unit::ohm, 1, 10>,
      public unit::ohm::Accessors<TenthOhms> {
 public:
  using Quantity::Quantity;
  constexpr TenthOhms() = default;
  template <class =
                detail::a_number_has_no_unit_write_a_literal_such_as_30_deg_or_use_from_degrees>
  constexpr TenthOhms(raw_type) = delete;  // NOLINT(google-explicit-constructor)
};

/// Share of a whole in steps of 0.2 %.
/// Unit: %, one count is 1/5.
class FifthPercent
    : public detail::Quantity<FifthPercent, std::uint8_t, unit::percent, 1, 5>,
      public unit::percent::Accessors<FifthPercent> {
 public:
  using Quantity::Quantity;
  constexpr FifthPercent() = default;
  template <class =
                detail::a_number_has_no_unit_write_a_literal_such_as_30_deg_or_use_from_degrees>
  constexpr FifthPercent(raw_type) = delete;  // NOLINT(google-explicit-constructor)
};

/// Number in steps of 0.05.
/// Unit: none, one count is 1/20.
class Twentieths
    : public detail::Quantity<Twentieths, std::uint8_t, unit::value, 1, 20>,
      public unit::value::Accessors<Twentieths> {
 public:
  using Quantity::Quantity;
  constexpr Twentieths() = default;
  template <class =
                detail::a_number_has_no_unit_write_a_literal_such_as_30_deg_or_use_from_degrees>
  constexpr Twentieths(raw_type) = delete;  // NOLINT(google-explicit-constructor)
};

/// Offset of an RC signal; 1 is half its range.
/// Unit: none, one count is 1/128.
class SignalOffset
    : public detail::Quantity<SignalOffset, std::int8_t, unit::fraction, 1, 128>,
      public unit::fraction::Accessors<SignalOffset> {
 public:
  using Quantity::Quantity;
  constexpr SignalOffset() = default;
  template <class =
                detail::a_number_has_no_unit_write_a_literal_such_as_30_deg_or_use_from_degrees>
  constexpr SignalOffset(raw_type) = delete;  // NOLINT(google-explicit-constructor)
};

/// Factor on an RC signal; 0 counts are 80 %.
/// Unit: %, counted from 80.
class SignalScale
    : public detail::Quantity<SignalScale, std::uint8_t, unit::percent, 1, 1, 80, 1>,
      public unit::percent::Accessors<SignalScale> {
 public:
  using Quantity::Quantity;
  constexpr SignalScale() = default;
  template <class =
                detail::a_number_has_no_unit_write_a_literal_such_as_30_deg_or_use_from_degrees>
  constexpr SignalScale(raw_type) = delete;  // NOLINT(google-explicit-constructor)
};

/// Small angle in tenths of a degree.
/// Unit: deg, one count is 1/10.
class TenthDegreesWidth
    : public detail::Quantity<TenthDegreesWidth, std::uint8_t, unit::deg, 1, 10>,
      public unit::deg::Accessors<TenthDegreesWidth> {
 public:
  using Quantity::Quantity;
  constexpr TenthDegreesWidth() = default;
  template <class =
                detail::a_number_has_no_unit_write_a_literal_such_as_30_deg_or_use_from_degrees>
  constexpr TenthDegreesWidth(raw_type) = delete;  // NOLINT(google-explicit-constructor)
};

/// Electric current in steps of 0.5 A.
/// Unit: mA, one count is 500.
class CoarseCurrent
    : public detail::Quantity<CoarseCurrent, std::uint8_t, unit::mA, 500, 1>,
      public unit::mA::Accessors<CoarseCurrent> {
 public:
  using Quantity::Quantity;
  constexpr CoarseCurrent() = default;
  template <class =
                detail::a_number_has_no_unit_write_a_literal_such_as_30_deg_or_use_from_degrees>
  constexpr CoarseCurrent(raw_type) = delete;  // NOLINT(google-explicit-constructor)
};

/// Electric resistance in hundredths of an ohm.
/// Unit: ohm, one count is 1/100.
class HundredthOhms
    : public detail::Quantity<HundredthOhms, std::uint16_t, unit::ohm, 1, 100>,
      public unit::ohm::Accessors<HundredthOhms> {
 public:
  using Quantity::Quantity;
  constexpr HundredthOhms() = default;
  template <class =
                detail::a_number_has_no_unit_write_a_literal_such_as_30_deg_or_use_from_degrees>
  constexpr HundredthOhms(raw_type) = delete;  // NOLINT(google-explicit-constructor)
};

/// Inverse quality factor of a filter; 0 counts are 0.2.
/// Unit: none, one count is 1/50, counted from 1/5.
class InverseQuality
    : public detail::Quantity<InverseQuality, std::uint8_t, unit::value, 1, 50, 1, 5>,
      public unit::value::Accessors<InverseQuality> {
 public:
  using Quantity::Quantity;
  constexpr InverseQuality() = default;
  template <class =
                detail::a_number_has_no_unit_write_a_literal_such_as_30_deg_or_use_from_degrees>
  constexpr InverseQuality(raw_type) = delete;  // NOLINT(google-explicit-constructor)
};

/// Frequency of a shake in steps of 0.05 Hz; 0 counts are 0.3 Hz.
/// Unit: Hz, one count is 1/20, counted from 3/10.
class ShakeFrequency
    : public detail::Quantity<ShakeFrequency, std::uint8_t, unit::Hz, 1, 20, 3, 10>,
      public unit::Hz::Accessors<ShakeFrequency> {
 public:
  using Quantity::Quantity;
  constexpr ShakeFrequency() = default;
  template <class =
                detail::a_number_has_no_unit_write_a_literal_such_as_30_deg_or_use_from_degrees>
  constexpr ShakeFrequency(raw_type) = delete;  // NOLINT(google-explicit-constructor)
};

/// Frequency of a resonance in steps of 0.1 Hz; 0 counts are 0.3 Hz.
/// Unit: Hz, one count is 1/10, counted from 3/10.
class ShakeResonance
    : public detail::Quantity<ShakeResonance, std::uint8_t, unit::Hz, 1, 10, 3, 10>,
      public unit::Hz::Accessors<ShakeResonance> {
 public:
  using Quantity::Quantity;
  constexpr ShakeResonance() = default;
  template <class =
                detail::a_number_has_no_unit_write_a_literal_such_as_30_deg_or_use_from_degrees>
  constexpr ShakeResonance(raw_type) = delete;  // NOLINT(google-explicit-constructor)
};

/// Factor in steps of 0.1; 0 counts are 1.5.
/// Unit: none, one count is 1/10, counted from 3/2.
class ShakeFactor
    : public detail::Quantity<ShakeFactor, std::uint8_t, unit::value, 1, 10, 3, 2>,
      public unit::value::Accessors<ShakeFactor> {
 public:
  using Quantity::Quantity;
  constexpr ShakeFactor() = default;
  template <class =
                detail::a_number_has_no_unit_write_a_literal_such_as_30_deg_or_use_from_degrees>
  constexpr ShakeFactor(raw_type) = delete;  // NOLINT(google-explicit-constructor)
};

/// Duration in steps of 20 ms; 0 counts are 500 ms.
/// Unit: ms, one count is 20, counted from 500.
class ShakePause
    : public detail::Quantity<ShakePause, std::uint8_t, unit::ms, 20, 1, 500, 1>,
      public unit::ms::Accessors<ShakePause> {
 public:
  using Quantity::Quantity;
  constexpr ShakePause() = default;
  template <class =
                detail::a_number_has_no_unit_write_a_literal_such_as_30_deg_or_use_from_degrees>
  constexpr ShakePause(raw_type) = delete;  // NOLINT(google-explicit-constructor)
};

/// Gain in steps of 0.2 dB.
/// Unit: dB, one count is 1/5.
class FifthDecibels
    : public detail::Quantity<FifthDecibels, std::uint8_t, unit::dB, 1, 5>,
      public unit::dB::Accessors<FifthDecibels> {
 public:
  using Quantity::Quantity;
  constexpr FifthDecibels() = default;
  template <class =
                detail::a_number_has_no_unit_write_a_literal_such_as_30_deg_or_use_from_degrees>
  constexpr FifthDecibels(raw_type) = delete;  // NOLINT(google-explicit-constructor)
};

/// Electric current in either direction.
/// Unit: mA.
class SignedCurrent
    : public detail::Quantity<SignedCurrent, std::int16_t, unit::mA, 1, 1>,
      public unit::mA::Accessors<SignedCurrent> {
 public:
  using Quantity::Quantity;
  constexpr SignedCurrent() = default;
  template <class =
                detail::a_number_has_no_unit_write_a_literal_such_as_30_deg_or_use_from_degrees>
  constexpr SignedCurrent(raw_type) = delete;  // NOLINT(google-explicit-constructor)
};

/// Share of the largest current: 32768 counts are 100 %.
/// Unit: %, one count is 100/32768.
class CurrentShare
    : public detail::Quantity<CurrentShare, std::int16_t, unit::percent, 25, 8192>,
      public unit::percent::Accessors<CurrentShare> {
 public:
  using Quantity::Quantity;
  constexpr CurrentShare() = default;
  template <class =
                detail::a_number_has_no_unit_write_a_literal_such_as_30_deg_or_use_from_degrees>
  constexpr CurrentShare(raw_type) = delete;  // NOLINT(google-explicit-constructor)
};

/// Angular speed in revolutions per minute; one is 6 deg/s.
/// Unit: rpm.
class RevolutionsPerMinute
    : public detail::Quantity<RevolutionsPerMinute, std::int16_t, unit::rpm, 1, 1>,
      public unit::rpm::Accessors<RevolutionsPerMinute> {
 public:
  using Quantity::Quantity;
  constexpr RevolutionsPerMinute() = default;
  template <class =
                detail::a_number_has_no_unit_write_a_literal_such_as_30_deg_or_use_from_degrees>
  constexpr RevolutionsPerMinute(raw_type) = delete;  // NOLINT(google-explicit-constructor)
};

/// Angle in radians.
/// Unit: rad.
class Radians
    : public detail::Quantity<Radians, float, unit::rad, 1, 1>,
      public unit::rad::Accessors<Radians> {
 public:
  using Quantity::Quantity;
  constexpr Radians() = default;
  template <class =
                detail::a_number_has_no_unit_write_a_literal_such_as_30_deg_or_use_from_degrees>
  constexpr Radians(raw_type) = delete;  // NOLINT(google-explicit-constructor)
};

/// Size of an angle in thousandths of a degree.
/// Unit: deg, one count is 1/1000.
class Millidegrees
    : public detail::Quantity<Millidegrees, std::uint16_t, unit::deg, 1, 1000>,
      public unit::deg::Accessors<Millidegrees> {
 public:
  using Quantity::Quantity;
  constexpr Millidegrees() = default;
  template <class =
                detail::a_number_has_no_unit_write_a_literal_such_as_30_deg_or_use_from_degrees>
  constexpr Millidegrees(raw_type) = delete;  // NOLINT(google-explicit-constructor)
};

/// Angular speed in thousandths of a degree per second, with a wide range.
/// Unit: deg/s, one count is 1/1000.
class LongFineSpeed
    : public detail::Quantity<LongFineSpeed, std::int32_t, unit::deg_per_s, 1, 1000>,
      public unit::deg_per_s::Accessors<LongFineSpeed> {
 public:
  using Quantity::Quantity;
  constexpr LongFineSpeed() = default;
  template <class =
                detail::a_number_has_no_unit_write_a_literal_such_as_30_deg_or_use_from_degrees>
  constexpr LongFineSpeed(raw_type) = delete;  // NOLINT(google-explicit-constructor)
};

/// Maximum angular speed, in the unit of ControlSpeed.
/// Unit: deg/s, one count is 4000/32767.
class ControlSpeedLimit
    : public detail::Quantity<ControlSpeedLimit, std::uint16_t, unit::deg_per_s, 4000, 32767>,
      public unit::deg_per_s::Accessors<ControlSpeedLimit> {
 public:
  using Quantity::Quantity;
  constexpr ControlSpeedLimit() = default;
  template <class =
                detail::a_number_has_no_unit_write_a_literal_such_as_30_deg_or_use_from_degrees>
  constexpr ControlSpeedLimit(raw_type) = delete;  // NOLINT(google-explicit-constructor)
};

/// Angular speed in radians per second.
/// Unit: rad/s.
class RadianRate
    : public detail::Quantity<RadianRate, float, unit::rad_per_s, 1, 1>,
      public unit::rad_per_s::Accessors<RadianRate> {
 public:
  using Quantity::Quantity;
  constexpr RadianRate() = default;
  template <class =
                detail::a_number_has_no_unit_write_a_literal_such_as_30_deg_or_use_from_degrees>
  constexpr RadianRate(raw_type) = delete;  // NOLINT(google-explicit-constructor)
};

/// Angle, 1048576 counts per turn, accumulated over full turns.
/// Unit: deg, one count is 360/1048576.
class Angle20
    : public detail::Quantity<Angle20, std::int32_t, unit::deg, 45, 131072>,
      public unit::deg::Accessors<Angle20> {
 public:
  using Quantity::Quantity;
  constexpr Angle20() = default;
  template <class =
                detail::a_number_has_no_unit_write_a_literal_such_as_30_deg_or_use_from_degrees>
  constexpr Angle20(raw_type) = delete;  // NOLINT(google-explicit-constructor)
};

/// Angular acceleration in whole deg/s^2, with a wide range.
/// Unit: deg/s^2.
class LongAngularAcceleration
    : public detail::Quantity<LongAngularAcceleration, std::uint16_t, unit::deg_per_s2, 1, 1>,
      public unit::deg_per_s2::Accessors<LongAngularAcceleration> {
 public:
  using Quantity::Quantity;
  constexpr LongAngularAcceleration() = default;
  template <class =
                detail::a_number_has_no_unit_write_a_literal_such_as_30_deg_or_use_from_degrees>
  constexpr LongAngularAcceleration(raw_type) = delete;  // NOLINT(google-explicit-constructor)
};

/// Time in which an acceleration rises to its limit, in steps of 20 ms.
/// Unit: ms, one count is 20.
class JerkTime
    : public detail::Quantity<JerkTime, std::uint8_t, unit::ms, 20, 1>,
      public unit::ms::Accessors<JerkTime> {
 public:
  using Quantity::Quantity;
  constexpr JerkTime() = default;
  template <class =
                detail::a_number_has_no_unit_write_a_literal_such_as_30_deg_or_use_from_degrees>
  constexpr JerkTime(raw_type) = delete;  // NOLINT(google-explicit-constructor)
};

/// Component of a packed quaternion; 524287 counts are the square root of 1/2.
/// Unit: none, one count is 1000000/741453785976.
class QuaternionPart
    : public detail::Quantity<QuaternionPart, std::int32_t, unit::value, 125000, 92681723247>,
      public unit::value::Accessors<QuaternionPart> {
 public:
  using Quantity::Quantity;
  constexpr QuaternionPart() = default;
  template <class =
                detail::a_number_has_no_unit_write_a_literal_such_as_30_deg_or_use_from_degrees>
  constexpr QuaternionPart(raw_type) = delete;  // NOLINT(google-explicit-constructor)
};

/// Maximum angular speed of an external motor, in steps of 2 deg/s.
/// Unit: deg/s, one count is 2.
class ExtMotorSpeedLimit
    : public detail::Quantity<ExtMotorSpeedLimit, std::uint16_t, unit::deg_per_s, 2, 1>,
      public unit::deg_per_s::Accessors<ExtMotorSpeedLimit> {
 public:
  using Quantity::Quantity;
  constexpr ExtMotorSpeedLimit() = default;
  template <class =
                detail::a_number_has_no_unit_write_a_literal_such_as_30_deg_or_use_from_degrees>
  constexpr ExtMotorSpeedLimit(raw_type) = delete;  // NOLINT(google-explicit-constructor)
};

/// Maximum angular acceleration of an external motor, in steps of 2 deg/s^2.
/// Unit: deg/s^2, one count is 2.
class ExtMotorAccelerationLimit
    : public detail::Quantity<ExtMotorAccelerationLimit, std::uint16_t, unit::deg_per_s2, 2, 1>,
      public unit::deg_per_s2::Accessors<ExtMotorAccelerationLimit> {
 public:
  using Quantity::Quantity;
  constexpr ExtMotorAccelerationLimit() = default;
  template <class =
                detail::a_number_has_no_unit_write_a_literal_such_as_30_deg_or_use_from_degrees>
  constexpr ExtMotorAccelerationLimit(raw_type) = delete;  // NOLINT(google-explicit-constructor)
};

/// Angular speed in millionths of a radian per second.
/// Unit: rad/s, one count is 1/1000000.
class MicroradianRate
    : public detail::Quantity<MicroradianRate, std::int32_t, unit::rad_per_s, 1, 1000000>,
      public unit::rad_per_s::Accessors<MicroradianRate> {
 public:
  using Quantity::Quantity;
  constexpr MicroradianRate() = default;
  template <class =
                detail::a_number_has_no_unit_write_a_literal_such_as_30_deg_or_use_from_degrees>
  constexpr MicroradianRate(raw_type) = delete;  // NOLINT(google-explicit-constructor)
};

/// Voltage in thousandths of a volt.
/// Unit: V, one count is 1/1000.
class Millivolts
    : public detail::Quantity<Millivolts, std::uint16_t, unit::V, 1, 1000>,
      public unit::V::Accessors<Millivolts> {
 public:
  using Quantity::Quantity;
  constexpr Millivolts() = default;
  template <class =
                detail::a_number_has_no_unit_write_a_literal_such_as_30_deg_or_use_from_degrees>
  constexpr Millivolts(raw_type) = delete;  // NOLINT(google-explicit-constructor)
};

/// Frequency in steps of 2 Hz.
/// Unit: Hz, one count is 2.
class TwoHertz
    : public detail::Quantity<TwoHertz, std::uint8_t, unit::Hz, 2, 1>,
      public unit::Hz::Accessors<TwoHertz> {
 public:
  using Quantity::Quantity;
  constexpr TwoHertz() = default;
  template <class =
                detail::a_number_has_no_unit_write_a_literal_such_as_30_deg_or_use_from_degrees>
  constexpr TwoHertz(raw_type) = delete;  // NOLINT(google-explicit-constructor)
};

/// Angle in whole degrees, without a sign.
/// Unit: deg.
class WideDegrees
    : public detail::Quantity<WideDegrees, std::uint16_t, unit::deg, 1, 1>,
      public unit::deg::Accessors<WideDegrees> {
 public:
  using Quantity::Quantity;
  constexpr WideDegrees() = default;
  template <class =
                detail::a_number_has_no_unit_write_a_literal_such_as_30_deg_or_use_from_degrees>
  constexpr WideDegrees(raw_type) = delete;  // NOLINT(google-explicit-constructor)
};

/// Low frequency in tenths of a hertz.
/// Unit: Hz, one count is 1/10.
class TenthHertz
    : public detail::Quantity<TenthHertz, std::uint8_t, unit::Hz, 1, 10>,
      public unit::Hz::Accessors<TenthHertz> {
 public:
  using Quantity::Quantity;
  constexpr TenthHertz() = default;
  template <class =
                detail::a_number_has_no_unit_write_a_literal_such_as_30_deg_or_use_from_degrees>
  constexpr TenthHertz(raw_type) = delete;  // NOLINT(google-explicit-constructor)
};

/// Gain in tenths of a decibel.
/// Unit: dB, one count is 1/10.
class TenthDecibels
    : public detail::Quantity<TenthDecibels, std::uint8_t, unit::dB, 1, 10>,
      public unit::dB::Accessors<TenthDecibels> {
 public:
  using Quantity::Quantity;
  constexpr TenthDecibels() = default;
  template <class =
                detail::a_number_has_no_unit_write_a_literal_such_as_30_deg_or_use_from_degrees>
  constexpr TenthDecibels(raw_type) = delete;  // NOLINT(google-explicit-constructor)
};

/// Size in 32-bit words.
/// Unit: byte, one count is 4.
class WordCount
    : public detail::Quantity<WordCount, std::uint32_t, unit::byte, 4, 1>,
      public unit::byte::Accessors<WordCount> {
 public:
  using Quantity::Quantity;
  constexpr WordCount() = default;
  template <class =
                detail::a_number_has_no_unit_write_a_literal_such_as_30_deg_or_use_from_degrees>
  constexpr WordCount(raw_type) = delete;  // NOLINT(google-explicit-constructor)
};

/// Offset in pages of 64 bytes.
/// Unit: byte, one count is 64.
class Pages
    : public detail::Quantity<Pages, std::uint16_t, unit::byte, 64, 1>,
      public unit::byte::Accessors<Pages> {
 public:
  using Quantity::Quantity;
  constexpr Pages() = default;
  template <class =
                detail::a_number_has_no_unit_write_a_literal_such_as_30_deg_or_use_from_degrees>
  constexpr Pages(raw_type) = delete;  // NOLINT(google-explicit-constructor)
};

}  // namespace sbgc::msg
