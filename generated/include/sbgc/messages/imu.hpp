// Generated from spec/ by generator/: edit those, then run ./dev generate.

/// Choosing, correcting and replacing the sensors of the board.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <type_traits>

#include <sbgc/codec.hpp>
#include <sbgc/enums.hpp>
#include <sbgc/response.hpp>
#include <sbgc/units.hpp>

namespace sbgc::msg {

using sbgc::get;
using sbgc::put;

static_assert(codec_version == 1, "generated code and runtime do not belong together");

struct AhrsHelper;

/// Choose the IMU that is configured and calibrated.
///
/// CMD_SELECT_IMU_3 (24), to the board, simple form; 1 byte.
/// Effect: sets.
/// Since board 3.0.
/// Source: Outgoing commands L757-L759; Variables L1168-L1169.
struct SelectImu3 {
  static constexpr CommandToBoard command = CommandToBoard::select_imu_3;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::simple;
  static constexpr std::size_t min_size = 1;
  static constexpr std::size_t max_size = 1;
  static constexpr Availability since{0, 30};
  using Response = void;

  /// Which IMU. Errata: E051, E053.
  SelectedImu imu_type{};

  constexpr bool operator==(const SelectImu3&) const = default;
};

constexpr void get(const std::uint8_t* SBGC_RESTRICT from,
                   SelectImu3& SBGC_RESTRICT out) noexcept {
  get(from, out.imu_type);
}
constexpr void put(std::uint8_t* SBGC_RESTRICT to,
                   const SelectImu3& SBGC_RESTRICT in) noexcept {
  put(to, in.imu_type);
}

[[nodiscard]] constexpr Status decode(std::span<const std::uint8_t> body,
                                      SelectImu3& out) noexcept {
  if (body.size() != 1) return detail::wrong_size(body.size(), 1);
  get(body.data(), out);
  return {};
}

[[nodiscard]] constexpr WriteResult encode(const SelectImu3& in,
                                           std::span<std::uint8_t> out) noexcept {
  if (out.size() < 1) return {0, {Code::buffer_too_small}};
  put(out.data(), in);
  return {1, {}};
}

/// Choose an IMU, with parameters that later firmware takes.
///
/// CMD_SELECT_IMU_3 (24), to the board, extended form; 2 to 12 bytes.
/// Effect: sets.
/// Since board 3.0.
/// Source: Outgoing commands L757-L759; Variables L1168-L1169. Errata: E206.
struct SelectImu3Ext {
  static constexpr CommandToBoard command = CommandToBoard::select_imu_3;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::extended;
  static constexpr std::size_t min_size = 2;
  static constexpr std::size_t max_size = 12;
  static constexpr Availability since{0, 30};
  using Response = void;

  /// Which IMU. Errata: E051, E053.
  SelectedImu imu_type{};
  /// Its meaning is not documented. Errata: E206.
  std::uint8_t param{};
  /// Further parameters; not documented. At most 10. Errata: E206.
  BoundedBytes<253> params{};

  constexpr bool operator==(const SelectImu3Ext&) const = default;
};

constexpr void get(const std::uint8_t* SBGC_RESTRICT from,
                   SelectImu3Ext& SBGC_RESTRICT out) noexcept {
  get(from, out.imu_type);
  get(from + 1, out.param);
}
constexpr void put(std::uint8_t* SBGC_RESTRICT to,
                   const SelectImu3Ext& SBGC_RESTRICT in) noexcept {
  put(to, in.imu_type);
  put(to + 1, in.param);
}

[[nodiscard]] constexpr Status decode(std::span<const std::uint8_t> body,
                                      SelectImu3Ext& out) noexcept {
  if (body.size() < 2) return detail::wrong_size(body.size(), 2);
  get(body.data(), out);
  detail::Reader reader(body, 2);
  reader.rest(out.params, "params");
  return reader.end();
}

[[nodiscard]] constexpr WriteResult encode(const SelectImu3Ext& in,
                                           std::span<std::uint8_t> out) noexcept {
  if (out.size() < 2) return {0, {Code::buffer_too_small}};
  put(out.data(), in);
  detail::Writer writer(out, 2);
  writer.array(in.params, "params");
  return writer.end();
}

/// Attitude of an IMU as two unit vectors.
///
/// CMD_AHRS_HELPER (56), from the board; 24 bytes, and later firmware may append more.
/// Since board 3.0.
/// Source: Incoming commands L582-L585; Variables L1192, L1196-L1197.
struct AhrsHelper {
  static constexpr CommandFromBoard command = CommandFromBoard::ahrs_helper;
  static constexpr Direction direction = Direction::from_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 24;
  static constexpr std::size_t max_size = 24;
  static constexpr Availability since{0, 30};

  /// Unit vector that points up (the Z axis in the normal position); later sources say down. Range:
  /// -1 to 1. Errata: E015, E038, E108, E216.
  Xyz<float> z1_vector{};
  /// Unit vector that points north (the Y axis in the normal position). Range: -1 to 1. Errata:
  /// E015, E038, E108.
  Xyz<float> h1_vector{};
  /// What later firmware appends; kept, and written back.
  BoundedBytes<231> tail{};

  constexpr bool operator==(const AhrsHelper&) const = default;
};

constexpr void get(const std::uint8_t* SBGC_RESTRICT from,
                   AhrsHelper& SBGC_RESTRICT out) noexcept {
  get(from, out.z1_vector);
  get(from + 12, out.h1_vector);
}
constexpr void put(std::uint8_t* SBGC_RESTRICT to,
                   const AhrsHelper& SBGC_RESTRICT in) noexcept {
  put(to, in.z1_vector);
  put(to + 12, in.h1_vector);
}

[[nodiscard]] constexpr Status decode(std::span<const std::uint8_t> body,
                                      AhrsHelper& out) noexcept {
  if (body.size() < 24) return detail::wrong_size(body.size(), 24);
  get(body.data(), out);
  return detail::get_tail(body, 24, out.tail);
}

[[nodiscard]] constexpr WriteResult encode(const AhrsHelper& in,
                                           std::span<std::uint8_t> out) noexcept {
  const std::size_t size = 24 + in.tail.size();
  if (out.size() < size) return {0, {Code::buffer_too_small}};
  put(out.data(), in);
  detail::put_tail(out.data() + 24, in.tail);
  return {size, {}};
}

/// Ask for the attitude of an IMU. MODE 0 asks for the main IMU, 2 for the frame IMU.
///
/// CMD_AHRS_HELPER (56), to the board, simple form; 1 byte.
/// Effect: reads.
/// Since board 3.0.
/// Firmware 2.69b5 and later takes AhrsHelperRequestWide instead.
/// Source: Outgoing commands L946-L953; Variables L1192-L1197. Errata: E023.
struct AhrsHelperRequest {
  static constexpr CommandToBoard command = CommandToBoard::ahrs_helper;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::simple;
  static constexpr std::size_t min_size = 1;
  static constexpr std::size_t max_size = 1;
  static constexpr Availability since{0, 30};
  static constexpr Availability until{2695, 0};
  using Response = AhrsHelper;

  /// Which IMU; without SET. Errata: E023.
  AhrsHelperMode mode{};

  constexpr bool operator==(const AhrsHelperRequest&) const = default;
};

constexpr void get(const std::uint8_t* SBGC_RESTRICT from,
                   AhrsHelperRequest& SBGC_RESTRICT out) noexcept {
  get(from, out.mode);
}
constexpr void put(std::uint8_t* SBGC_RESTRICT to,
                   const AhrsHelperRequest& SBGC_RESTRICT in) noexcept {
  put(to, in.mode);
}

[[nodiscard]] constexpr Status decode(std::span<const std::uint8_t> body,
                                      AhrsHelperRequest& out) noexcept {
  if (body.size() != 1) return detail::wrong_size(body.size(), 1);
  get(body.data(), out);
  return {};
}

[[nodiscard]] constexpr WriteResult encode(const AhrsHelperRequest& in,
                                           std::span<std::uint8_t> out) noexcept {
  if (out.size() < 1) return {0, {Code::buffer_too_small}};
  put(out.data(), in);
  return {1, {}};
}

/// Ask for the attitude of an IMU, with a mode of two bytes. MODE 0 asks for the main IMU, 2 for
/// the frame IMU.
///
/// CMD_AHRS_HELPER (56), to the board, wide form; 2 bytes.
/// Effect: reads.
/// Since firmware 2.69b5.
/// Source: Outgoing commands L946-L953; Variables L1192-L1197. Errata: E023, E209.
struct AhrsHelperRequestWide {
  static constexpr CommandToBoard command = CommandToBoard::ahrs_helper;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::wide;
  static constexpr std::size_t min_size = 2;
  static constexpr std::size_t max_size = 2;
  static constexpr Availability since{2695, 0};
  using Response = AhrsHelper;

  /// Which IMU; without SET. Errata: E023, E209.
  AhrsHelperWideMode mode{};

  constexpr bool operator==(const AhrsHelperRequestWide&) const = default;
};

constexpr void get(const std::uint8_t* SBGC_RESTRICT from,
                   AhrsHelperRequestWide& SBGC_RESTRICT out) noexcept {
  get(from, out.mode);
}
constexpr void put(std::uint8_t* SBGC_RESTRICT to,
                   const AhrsHelperRequestWide& SBGC_RESTRICT in) noexcept {
  put(to, in.mode);
}

[[nodiscard]] constexpr Status decode(std::span<const std::uint8_t> body,
                                      AhrsHelperRequestWide& out) noexcept {
  if (body.size() != 2) return detail::wrong_size(body.size(), 2);
  get(body.data(), out);
  return {};
}

[[nodiscard]] constexpr WriteResult encode(const AhrsHelperRequestWide& in,
                                           std::span<std::uint8_t> out) noexcept {
  if (out.size() < 2) return {0, {Code::buffer_too_small}};
  put(out.data(), in);
  return {2, {}};
}

/// Ask for the attitude of an IMU or set it. An IMU of higher grade can replace or correct the
/// board's own: send 50 to 100 of these a second. From a sensor on the camera, MODE 1 replaces its
/// attitude and 5 corrects it. From a sensor on the frame, 3 replaces the attitude of the frame and
/// 7 corrects it; 11 replaces it and corrects that of the camera; 15 corrects both. Z1_ONLY and
/// H1_ONLY may be added to any of these. MODE 0 asks for the main IMU, 2 for the frame IMU.
///
/// CMD_AHRS_HELPER (56), to the board, extended form; 25 bytes.
/// Effect: moves.
/// Since board 3.0.
/// Firmware 2.69b5 and later takes AhrsHelperRequestExtWide instead.
/// Source: Outgoing commands L946-L953; Variables L1192-L1197. Errata: E023, E122.
struct AhrsHelperRequestExt {
  static constexpr CommandToBoard command = CommandToBoard::ahrs_helper;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::extended;
  static constexpr std::size_t min_size = 25;
  static constexpr std::size_t max_size = 25;
  static constexpr Availability since{0, 30};
  static constexpr Availability until{2695, 0};
  using Response = sbgc::Maybe<AhrsHelper>;

  /// What to do.
  AhrsHelperMode mode{};
  /// Unit vector that points up (the Z axis in the normal position), or down by later sources; not
  /// used when asking. Range: -1 to 1. Errata: E015, E038, E108, E216.
  Xyz<float> z1_vector{};
  /// Unit vector that points north (the Y axis in the normal position); not used when asking.
  /// Range: -1 to 1. Errata: E015, E038, E108.
  Xyz<float> h1_vector{};

  constexpr bool operator==(const AhrsHelperRequestExt&) const = default;
};

constexpr void get(const std::uint8_t* SBGC_RESTRICT from,
                   AhrsHelperRequestExt& SBGC_RESTRICT out) noexcept {
  get(from, out.mode);
  get(from + 1, out.z1_vector);
  get(from + 13, out.h1_vector);
}
constexpr void put(std::uint8_t* SBGC_RESTRICT to,
                   const AhrsHelperRequestExt& SBGC_RESTRICT in) noexcept {
  put(to, in.mode);
  put(to + 1, in.z1_vector);
  put(to + 13, in.h1_vector);
}

[[nodiscard]] constexpr Status decode(std::span<const std::uint8_t> body,
                                      AhrsHelperRequestExt& out) noexcept {
  if (body.size() != 25) return detail::wrong_size(body.size(), 25);
  get(body.data(), out);
  return {};
}

[[nodiscard]] constexpr WriteResult encode(const AhrsHelperRequestExt& in,
                                           std::span<std::uint8_t> out) noexcept {
  if (out.size() < 25) return {0, {Code::buffer_too_small}};
  put(out.data(), in);
  return {25, {}};
}

/// Ask for the attitude of an IMU or set it, with a mode of two bytes. The values of MODE that are
/// useful are those of AhrsHelperRequestExt.
///
/// CMD_AHRS_HELPER (56), to the board, extended_wide form; 26 bytes.
/// Effect: moves.
/// Since firmware 2.69b5.
/// Source: Outgoing commands L946-L953; Variables L1192-L1197. Errata: E023, E122, E209.
struct AhrsHelperRequestExtWide {
  static constexpr CommandToBoard command = CommandToBoard::ahrs_helper;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::extended_wide;
  static constexpr std::size_t min_size = 26;
  static constexpr std::size_t max_size = 26;
  static constexpr Availability since{2695, 0};
  using Response = sbgc::Maybe<AhrsHelper>;

  /// What to do. Errata: E209.
  AhrsHelperWideMode mode{};
  /// Unit vector that points up (the Z axis in the normal position), or down by later sources; not
  /// used when asking. Range: -1 to 1. Errata: E015, E038, E108, E216.
  Xyz<float> z1_vector{};
  /// Unit vector that points north (the Y axis in the normal position); not used when asking.
  /// Range: -1 to 1. Errata: E015, E038, E108.
  Xyz<float> h1_vector{};

  constexpr bool operator==(const AhrsHelperRequestExtWide&) const = default;
};

constexpr void get(const std::uint8_t* SBGC_RESTRICT from,
                   AhrsHelperRequestExtWide& SBGC_RESTRICT out) noexcept {
  get(from, out.mode);
  get(from + 2, out.z1_vector);
  get(from + 14, out.h1_vector);
}
constexpr void put(std::uint8_t* SBGC_RESTRICT to,
                   const AhrsHelperRequestExtWide& SBGC_RESTRICT in) noexcept {
  put(to, in.mode);
  put(to + 2, in.z1_vector);
  put(to + 14, in.h1_vector);
}

[[nodiscard]] constexpr Status decode(std::span<const std::uint8_t> body,
                                      AhrsHelperRequestExtWide& out) noexcept {
  if (body.size() != 26) return detail::wrong_size(body.size(), 26);
  get(body.data(), out);
  return {};
}

[[nodiscard]] constexpr WriteResult encode(const AhrsHelperRequestExtWide& in,
                                           std::span<std::uint8_t> out) noexcept {
  if (out.size() < 26) return {0, {Code::buffer_too_small}};
  put(out.data(), in);
  return {26, {}};
}

/// Correct the zero of a gyroscope by hand; the camera drifts if the correction is wrong.
///
/// CMD_GYRO_CORRECTION (75), to the board; 9 bytes.
/// Effect: stores, moves.
/// Since board 3.0.
/// Source: Outgoing commands L955-L961; Variables L1198-L1201. Errata: E142.
struct GyroCorrection {
  static constexpr CommandToBoard command = CommandToBoard::gyro_correction;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 9;
  static constexpr std::size_t max_size = 9;
  static constexpr Availability since{0, 30};
  using Response = void;

  /// Which IMU. Errata: E051, E053.
  ImuIndex imu_type{};
  /// Offset of the zero of each axis. Unit: gyro unit, one count is 1/1000. Errata: E042.
  Xyz<GyroOffset> gyro_zero_corr{};
  /// Offset of the rotation about the vertical, to correct the heading; the board spreads it over
  /// the axes. Unit: gyro unit, one count is 1/1000.
  GyroOffset gyro_zero_heading_corr{};

  constexpr bool operator==(const GyroCorrection&) const = default;
};

constexpr void get(const std::uint8_t* SBGC_RESTRICT from,
                   GyroCorrection& SBGC_RESTRICT out) noexcept {
  get(from, out.imu_type);
  get(from + 1, out.gyro_zero_corr);
  get(from + 7, out.gyro_zero_heading_corr);
}
constexpr void put(std::uint8_t* SBGC_RESTRICT to,
                   const GyroCorrection& SBGC_RESTRICT in) noexcept {
  put(to, in.imu_type);
  put(to + 1, in.gyro_zero_corr);
  put(to + 7, in.gyro_zero_heading_corr);
}

[[nodiscard]] constexpr Status decode(std::span<const std::uint8_t> body,
                                      GyroCorrection& out) noexcept {
  if (body.size() != 9) return detail::wrong_size(body.size(), 9);
  get(body.data(), out);
  return {};
}

[[nodiscard]] constexpr WriteResult encode(const GyroCorrection& in,
                                           std::span<std::uint8_t> out) noexcept {
  if (out.size() < 9) return {0, {Code::buffer_too_small}};
  put(out.data(), in);
  return {9, {}};
}

/// What says the same to firmware that no longer takes the message.
constexpr AhrsHelperRequestWide later_form(const AhrsHelperRequest& message) noexcept {
  AhrsHelperRequestWide later{};
  detail::widen(message.mode, later.mode);
  return later;
}

/// What says the same to firmware that no longer takes the message.
constexpr AhrsHelperRequestExtWide later_form(const AhrsHelperRequestExt& message) noexcept {
  AhrsHelperRequestExtWide later{};
  detail::widen(message.mode, later.mode);
  later.z1_vector = message.z1_vector;
  later.h1_vector = message.h1_vector;
  return later;
}

}  // namespace sbgc::msg
