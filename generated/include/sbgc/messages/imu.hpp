// Generated from spec/ by generator/: edit those, then run ./dev generate.

/// Selecting, correcting and replacing the board's sensors.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include <sbgc/codec.hpp>
#include <sbgc/internal/compiler.hpp>
#include <sbgc/enums.hpp>
#include <sbgc/response.hpp>
#include <sbgc/units.hpp>

namespace sbgc::msg {

static_assert(codec_version == 3, "generated code and runtime do not match");

struct AhrsHelper;
struct ExtImuDebugInfo;

/// State of the attitude estimation.
struct AhrsDebugInfo {
  /// What corrects the attitude of the main IMU.
  AhrsReferences main_imu_ref_src{};
  /// What corrects the attitude of the frame IMU.
  AhrsReferences frame_imu_ref_src{};
  /// Error of the main IMU's gravity vector. Unit: deg.
  AngleError main_z_err{};
  /// Error of the main IMU's heading vector. Unit: deg.
  AngleError main_h_err{};
  /// Error of the frame IMU's gravity vector. Unit: deg.
  AngleError frame_z_err{};
  /// Error of the frame IMU's heading vector. Unit: deg.
  AngleError frame_h_err{};
  /// State of the external IMU.
  ExtImuStatus ext_imu_status{};
  /// Number of packets from the external IMU.
  std::uint16_t ext_imu_packets{};
  /// Number of damaged packets from the external IMU.
  std::uint16_t ext_imu_parse_err{};
  /// Error of the external heading correction. Unit: deg.
  AngleError ext_corr_h_err{};
  /// Error of the external gravity correction. Unit: deg.
  AngleError ext_corr_z_err{};
  /// Reserved; kept as it is.
  Bytes<13> reserved{};

  bool operator==(const AhrsDebugInfo&) const = default;
  using FixedMembers = Members<&AhrsDebugInfo::main_imu_ref_src, &AhrsDebugInfo::frame_imu_ref_src,
      &AhrsDebugInfo::main_z_err, &AhrsDebugInfo::main_h_err, &AhrsDebugInfo::frame_z_err,
      &AhrsDebugInfo::frame_h_err, &AhrsDebugInfo::ext_imu_status, &AhrsDebugInfo::ext_imu_packets,
      &AhrsDebugInfo::ext_imu_parse_err, &AhrsDebugInfo::ext_corr_h_err,
      &AhrsDebugInfo::ext_corr_z_err, &AhrsDebugInfo::reserved>;
};

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

/// Select an IMU, with parameters that no source describes.
///
/// CMD_SELECT_IMU_3 (24), to the board, extended form; 2 to 10 bytes. Effect: sets. Since firmware
/// 2.60. Unconfirmed. Source: Outgoing commands L757-L759; Variables L1168-L1169.
struct SelectImu3Ext {
  static constexpr CommandToBoard command = CommandToBoard::select_imu_3;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::extended;
  static constexpr std::size_t min_size = 2;
  static constexpr std::size_t max_size = 10;
  static constexpr Availability since{.firmware = 2600};
  using Response = void;

  /// The IMU.
  SelectedImu imu_type{};
  /// Undocumented.
  std::uint8_t param{};
  /// Further undocumented parameters. At most 8.
  BoundedBytes<253> params{};

  bool operator==(const SelectImu3Ext&) const = default;
  using FixedMembers = Members<&SelectImu3Ext::imu_type, &SelectImu3Ext::param>;
  SBGC_ALWAYS_INLINE
  static constexpr void varying_members(auto& self, auto& cursor) noexcept {
    cursor.rest(self.params, "params");
  }
};

/// The same, with one byte less.
///
/// CMD_SELECT_IMU_3 (24), to the board, calibrate_short form; 11 bytes. Effect: stores, restarts,
/// erases. Since firmware 2.60. Unconfirmed. Source: Vendor's code of 2026.
struct SelectImu3CalibrateShort {
  static constexpr CommandToBoard command = CommandToBoard::select_imu_3;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::calibrate_short;
  static constexpr std::size_t min_size = 11;
  static constexpr std::size_t max_size = 11;
  static constexpr Availability since{.firmware = 2600};
  using Response = void;

  /// The IMU.
  CalibImu imu_type{};
  /// Operation.
  CalibAction action{};
  /// Duration of the operation. Unit: ms.
  Milliseconds time_ms{};
  /// Reserved; kept as it is.
  Bytes<7> reserved{};

  bool operator==(const SelectImu3CalibrateShort&) const = default;
  using FixedMembers = Members<&SelectImu3CalibrateShort::imu_type,
      &SelectImu3CalibrateShort::action, &SelectImu3CalibrateShort::time_ms,
      &SelectImu3CalibrateShort::reserved>;
};

/// Select an IMU and calibrate it, or manage its calibrations.
///
/// CMD_SELECT_IMU_3 (24), to the board, calibrate form; 12 bytes. Effect: stores, restarts, erases.
/// Since firmware 2.60. Source: Later firmware.
struct SelectImu3Calibrate {
  static constexpr CommandToBoard command = CommandToBoard::select_imu_3;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::calibrate;
  static constexpr std::size_t min_size = 12;
  static constexpr std::size_t max_size = 12;
  static constexpr Availability since{.firmware = 2600};
  using Response = void;

  /// The IMU.
  CalibImu imu_type{};
  /// Operation.
  CalibAction action{};
  /// Duration of the operation. Unit: ms.
  Milliseconds time_ms{};
  /// Reserved; kept as it is.
  Bytes<8> reserved{};

  bool operator==(const SelectImu3Calibrate&) const = default;
  using FixedMembers = Members<&SelectImu3Calibrate::imu_type, &SelectImu3Calibrate::action,
      &SelectImu3Calibrate::time_ms, &SelectImu3Calibrate::reserved>;
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
  /// sources. Range: -1 to 1. Unconfirmed.
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
  static constexpr Availability until{.firmware = 2695}
;
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
  static constexpr Availability until{.firmware = 2695}
;
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

/// State of the attitude estimation and of the external IMU.
///
/// CMD_EXT_IMU_DEBUG_INFO (106), from the board; 74 bytes, and later firmware may append more.
/// Since firmware 2.66. Source: Later firmware.
struct ExtImuDebugInfo {
  static constexpr CommandFromBoard command = CommandFromBoard::ext_imu_debug_info;
  static constexpr Direction direction = Direction::from_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 74;
  static constexpr std::size_t max_size = 74;
  static constexpr Availability since{.firmware = 2660, .features = 0x10000};

  /// State of the attitude estimation.
  AhrsDebugInfo ahrs_debug_info{};
  /// Attitude as a rotation matrix, row by row.
  std::array<float, 9> dcm{};
  /// Acceleration of the sensor.
  std::array<float, 3> acc_body{};
  /// Bytes appended by later firmware; preserved and written back.
  BoundedBytes<181> tail{};

  bool operator==(const ExtImuDebugInfo&) const = default;
  using FixedMembers = Members<&ExtImuDebugInfo::ahrs_debug_info, &ExtImuDebugInfo::dcm,
      &ExtImuDebugInfo::acc_body>;
};

/// Request the state of the attitude estimation and of the external IMU.
///
/// CMD_EXT_IMU_DEBUG_INFO (106), to the board; 0 bytes. Effect: reads. Since firmware 2.66. Source:
/// Later firmware.
struct ExtImuDebugInfoRequest {
  static constexpr CommandToBoard command = CommandToBoard::ext_imu_debug_info;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 0;
  static constexpr std::size_t max_size = 0;
  static constexpr Availability since{.firmware = 2660, .features = 0x10000};
  using Response = ExtImuDebugInfo;

  bool operator==(const ExtImuDebugInfoRequest&) const = default;
};

/// A message of the external IMU.
///
/// CMD_EXT_IMU_CMD (110), in both directions; 1 to 255 bytes. Effect: sets, stores, moves. Since
/// firmware 2.60. Source: Later firmware.
struct ExtImuCmd {
  static constexpr CommandToBoard command = CommandToBoard::ext_imu_cmd;
  static constexpr Direction direction = Direction::both;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 1;
  static constexpr std::size_t max_size = 255;
  static constexpr Availability since{.firmware = 2600, .features = 0x10000};
  using Response = void;

  /// Command of the external IMU.
  std::uint8_t cmd_id{};
  /// Body of the command.
  BoundedBytes<254> data{};

  bool operator==(const ExtImuCmd&) const = default;
  using FixedMembers = Members<&ExtImuCmd::cmd_id>;
  SBGC_ALWAYS_INLINE
  static constexpr void varying_members(auto& self, auto& cursor) noexcept {
    cursor.rest(self.data, "data");
  }
};

/// A message of the external sensor.
///
/// CMD_EXT_SENS_CMD (150), from the board; 1 to 255 bytes. Since firmware 2.68b7, board 3.6.
/// Unconfirmed. Source: Later firmware.
struct ExtSensCmd {
  static constexpr CommandFromBoard command = CommandFromBoard::ext_sens_cmd;
  static constexpr Direction direction = Direction::from_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 1;
  static constexpr std::size_t max_size = 255;
  static constexpr Availability since{.firmware = 2687, .board = 36, .features = 0x10000};

  /// Command of the sensor.
  ExtSensCommand cmd_id{};
  /// Body of the command.
  BoundedBytes<254> data{};

  bool operator==(const ExtSensCmd&) const = default;
  using FixedMembers = Members<&ExtSensCmd::cmd_id>;
  SBGC_ALWAYS_INLINE
  static constexpr void varying_members(auto& self, auto& cursor) noexcept {
    cursor.rest(self.data, "data");
  }
};

/// Forward a command to an external sensor.
///
/// CMD_EXT_SENS_CMD (150), to the board; 2 to 255 bytes. Effect: sets, stores, moves. Since
/// firmware 2.68b7, board 3.6. Source: Later firmware.
struct ExtSensCmdRequest {
  static constexpr CommandToBoard command = CommandToBoard::ext_sens_cmd;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 2;
  static constexpr std::size_t max_size = 255;
  static constexpr Availability since{.firmware = 2687, .board = 36, .features = 0x10000};
  using Response = void;

  /// Options.
  ExtSensOptions flags{};
  /// Command of the sensor.
  ExtSensCommand cmd_id{};
  /// Body of the command.
  BoundedBytes<253> data{};

  bool operator==(const ExtSensCmdRequest&) const = default;
  using FixedMembers = Members<&ExtSensCmdRequest::flags, &ExtSensCmdRequest::cmd_id>;
  SBGC_ALWAYS_INLINE
  static constexpr void varying_members(auto& self, auto& cursor) noexcept {
    cursor.rest(self.data, "data");
  }
};

/// Undocumented body from the board.
///
/// CMD_IMU_ADVANCED_CALIB (115), from the board; 0 to 255 bytes. Since firmware 2.60. Source: Later
/// firmware.
struct ImuAdvancedCalib {
  static constexpr CommandFromBoard command = CommandFromBoard::imu_advanced_calib;
  static constexpr Direction direction = Direction::from_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 0;
  static constexpr std::size_t max_size = 255;
  static constexpr Availability since{.firmware = 2600};

  /// Undocumented content.
  BoundedBytes<255> data{};

  bool operator==(const ImuAdvancedCalib&) const = default;
  SBGC_ALWAYS_INLINE
  static constexpr void varying_members(auto& self, auto& cursor) noexcept {
    cursor.rest(self.data, "data");
  }
};

/// Undocumented body to the board.
///
/// CMD_IMU_ADVANCED_CALIB (115), to the board; 0 to 255 bytes. Effect: unknown. Since firmware
/// 2.60. Source: Later firmware.
struct ImuAdvancedCalibRequest {
  static constexpr CommandToBoard command = CommandToBoard::imu_advanced_calib;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 0;
  static constexpr std::size_t max_size = 255;
  static constexpr Availability since{.firmware = 2600};
  using Response = void;

  /// Undocumented content.
  BoundedBytes<255> data{};

  bool operator==(const ImuAdvancedCalibRequest&) const = default;
  SBGC_ALWAYS_INLINE
  static constexpr void varying_members(auto& self, auto& cursor) noexcept {
    cursor.rest(self.data, "data");
  }
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
