// Generated from spec/ by generator/: edit those, then run ./dev generate.

/// Selecting, correcting and replacing the board's sensors.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include <sbgc/codec.hpp>
#include <sbgc/enums.hpp>
#include <sbgc/response.hpp>
#include <sbgc/units.hpp>

namespace sbgc::msg {

static_assert(codec_version == 2, "generated code and runtime do not match");

struct AhrsHelper;

/// Select the IMU to configure and calibrate.
///
/// CMD_SELECT_IMU_3 (24), to the board, simple form; 1 byte. Effect: sets. Since board 3.0. Source:
/// Outgoing commands L757-L759; Variables L1168-L1169.
struct SelectImu3 {
  static constexpr CommandToBoard command = CommandToBoard::select_imu_3;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::simple;
  static constexpr std::size_t min_size = 1;
  static constexpr std::size_t max_size = 1;
  static constexpr Availability since{.board = 30};
  using Response = void;

  /// The IMU.
  SelectedImu imu_type{};

  bool operator==(const SelectImu3&) const = default;
  using FixedMembers = Members<&SelectImu3::imu_type>;
};

/// Select an IMU, with parameters of later firmware.
///
/// CMD_SELECT_IMU_3 (24), to the board, extended form; 2 to 12 bytes. Effect: sets. Since board
/// 3.0. Source: Outgoing commands L757-L759; Variables L1168-L1169.
struct SelectImu3Ext {
  static constexpr CommandToBoard command = CommandToBoard::select_imu_3;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::extended;
  static constexpr std::size_t min_size = 2;
  static constexpr std::size_t max_size = 12;
  static constexpr Availability since{.board = 30};
  using Response = void;

  /// The IMU.
  SelectedImu imu_type{};
  /// Undocumented.
  std::uint8_t param{};
  /// Further undocumented parameters. At most 10.
  BoundedBytes<253> params{};

  bool operator==(const SelectImu3Ext&) const = default;
  using FixedMembers = Members<&SelectImu3Ext::imu_type, &SelectImu3Ext::param>;
  [[gnu::always_inline]]
  static constexpr void varying_members(auto& self, auto& cursor) noexcept {
    cursor.rest(self.params, "params");
  }
};

/// Attitude of an IMU as two unit vectors.
///
/// CMD_AHRS_HELPER (56), from the board; 24 bytes, and later firmware may append more. Since board
/// 3.0. Source: Incoming commands L582-L585; Variables L1192, L1196-L1197.
struct AhrsHelper {
  static constexpr CommandFromBoard command = CommandFromBoard::ahrs_helper;
  static constexpr Direction direction = Direction::from_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 24;
  static constexpr std::size_t max_size = 24;
  static constexpr Availability since{.board = 30};

  /// Unit vector that points up (the Z axis in the normal position); down according to later
  /// sources. Range: -1 to 1.
  Xyz<float> z1_vector{};
  /// Unit vector that points north (the Y axis in the normal position). Range: -1 to 1.
  Xyz<float> h1_vector{};
  /// Bytes appended by later firmware; preserved and written back.
  BoundedBytes<231> tail{};

  bool operator==(const AhrsHelper&) const = default;
  using FixedMembers = Members<&AhrsHelper::z1_vector, &AhrsHelper::h1_vector>;
};

/// Query the attitude of an IMU. MODE 0 queries the main IMU, 2 the frame IMU.
///
/// CMD_AHRS_HELPER (56), to the board, simple form; 1 byte. Effect: reads. Since board 3.0.
/// Firmware 2.69b5 and later accepts AhrsHelperRequestWide instead. Source: Outgoing commands
/// L946-L953; Variables L1192-L1197.
struct AhrsHelperRequest {
  static constexpr CommandToBoard command = CommandToBoard::ahrs_helper;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::simple;
  static constexpr std::size_t min_size = 1;
  static constexpr std::size_t max_size = 1;
  static constexpr Availability since{.board = 30};
  static constexpr Availability until{.firmware = 2695};
  using Response = AhrsHelper;

  /// The IMU to query; without SET.
  AhrsHelperMode mode{};

  bool operator==(const AhrsHelperRequest&) const = default;
  using FixedMembers = Members<&AhrsHelperRequest::mode>;
};

/// Query the attitude of an IMU, with a two-byte mode. MODE 0 queries the main IMU, 2 the frame
/// IMU.
///
/// CMD_AHRS_HELPER (56), to the board, wide form; 2 bytes. Effect: reads. Since firmware 2.69b5.
/// Source: Outgoing commands L946-L953; Variables L1192-L1197.
struct AhrsHelperRequestWide {
  static constexpr CommandToBoard command = CommandToBoard::ahrs_helper;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::wide;
  static constexpr std::size_t min_size = 2;
  static constexpr std::size_t max_size = 2;
  static constexpr Availability since{.firmware = 2695};
  using Response = AhrsHelper;

  /// The IMU to query; without SET.
  AhrsHelperWideMode mode{};

  bool operator==(const AhrsHelperRequestWide&) const = default;
  using FixedMembers = Members<&AhrsHelperRequestWide::mode>;
};

/// Query or set the attitude of an IMU. A higher-grade IMU can replace or correct the board's own:
/// send 50 to 100 of these messages per second. For a sensor on the camera, MODE 1 replaces the
/// camera's attitude and 5 corrects it. For a sensor on the frame, 3 replaces the attitude of the
/// frame and 7 corrects it; 11 replaces it and corrects that of the camera; 15 corrects both.
/// Z1_ONLY and H1_ONLY may be added to each. MODE 0 queries the main IMU, 2 the frame IMU.
///
/// CMD_AHRS_HELPER (56), to the board, extended form; 25 bytes. Effect: moves. Since board 3.0.
/// Firmware 2.69b5 and later accepts AhrsHelperRequestExtWide instead. Source: Outgoing commands
/// L946-L953; Variables L1192-L1197.
struct AhrsHelperRequestExt {
  static constexpr CommandToBoard command = CommandToBoard::ahrs_helper;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::extended;
  static constexpr std::size_t min_size = 25;
  static constexpr std::size_t max_size = 25;
  static constexpr Availability since{.board = 30};
  static constexpr Availability until{.firmware = 2695};
  using Response = sbgc::Maybe<AhrsHelper>;

  /// Operation.
  AhrsHelperMode mode{};
  /// Unit vector that points up (the Z axis in the normal position), or down according to later
  /// sources; unused in a query. Range: -1 to 1.
  Xyz<float> z1_vector{};
  /// Unit vector that points north (the Y axis in the normal position); unused in a query. Range:
  /// -1 to 1.
  Xyz<float> h1_vector{};

  bool operator==(const AhrsHelperRequestExt&) const = default;
  using FixedMembers = Members<&AhrsHelperRequestExt::mode, &AhrsHelperRequestExt::z1_vector,
      &AhrsHelperRequestExt::h1_vector>;
};

/// Query or set the attitude of an IMU, with a two-byte mode. The useful values of MODE are those
/// of AhrsHelperRequestExt.
///
/// CMD_AHRS_HELPER (56), to the board, extended_wide form; 26 bytes. Effect: moves. Since firmware
/// 2.69b5. Source: Outgoing commands L946-L953; Variables L1192-L1197.
struct AhrsHelperRequestExtWide {
  static constexpr CommandToBoard command = CommandToBoard::ahrs_helper;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::extended_wide;
  static constexpr std::size_t min_size = 26;
  static constexpr std::size_t max_size = 26;
  static constexpr Availability since{.firmware = 2695};
  using Response = sbgc::Maybe<AhrsHelper>;

  /// Operation.
  AhrsHelperWideMode mode{};
  /// Unit vector that points up (the Z axis in the normal position), or down according to later
  /// sources; unused in a query. Range: -1 to 1.
  Xyz<float> z1_vector{};
  /// Unit vector that points north (the Y axis in the normal position); unused in a query. Range:
  /// -1 to 1.
  Xyz<float> h1_vector{};

  bool operator==(const AhrsHelperRequestExtWide&) const = default;
  using FixedMembers = Members<&AhrsHelperRequestExtWide::mode,
      &AhrsHelperRequestExtWide::z1_vector, &AhrsHelperRequestExtWide::h1_vector>;
};

/// Correct the zero of a gyroscope manually; the camera drifts if the correction is wrong.
///
/// CMD_GYRO_CORRECTION (75), to the board; 9 bytes. Effect: stores, moves. Since board 3.0. Source:
/// Outgoing commands L955-L961; Variables L1198-L1201.
struct GyroCorrection {
  static constexpr CommandToBoard command = CommandToBoard::gyro_correction;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 9;
  static constexpr std::size_t max_size = 9;
  static constexpr Availability since{.board = 30};
  using Response = void;

  /// The IMU.
  ImuIndex imu_type{};
  /// Zero offset of each axis. Unit: gyro unit.
  Xyz<GyroOffset> gyro_zero_corr{};
  /// Offset of the rotation about the vertical, to correct the heading; the board distributes it
  /// over the axes. Unit: gyro unit.
  GyroOffset gyro_zero_heading_corr{};

  bool operator==(const GyroCorrection&) const = default;
  using FixedMembers = Members<&GyroCorrection::imu_type, &GyroCorrection::gyro_zero_corr,
      &GyroCorrection::gyro_zero_heading_corr>;
};

/// Returns the equivalent message for firmware that no longer accepts this one.
constexpr AhrsHelperRequestWide later_form(const AhrsHelperRequest& message) noexcept {
  AhrsHelperRequestWide later{};
  detail::widen(message.mode, later.mode);
  return later;
}

/// Returns the equivalent message for firmware that no longer accepts this one.
constexpr AhrsHelperRequestExtWide later_form(const AhrsHelperRequestExt& message) noexcept {
  AhrsHelperRequestExtWide later{};
  detail::widen(message.mode, later.mode);
  later.z1_vector = message.z1_vector;
  later.h1_vector = message.h1_vector;
  return later;
}

}  // namespace sbgc::msg
