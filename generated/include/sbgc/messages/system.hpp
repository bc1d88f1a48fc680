// Generated from spec/ by generator/: edit those, then run ./dev generate.

/// Board identity, statistics, confirmations, errors and restarts.
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

struct BoardInfo;
struct BoardInfo3;
struct PassProtectRead;
struct ReadStateVars;
struct Reset;
struct SignMessage;

/// Board version and features.
///
/// CMD_BOARD_INFO (86), from the board; 18 bytes, and later firmware may append more. Source:
/// Incoming commands L158-L166; Variables L1005-L1009.
struct BoardInfo {
  static constexpr CommandFromBoard command = CommandFromBoard::board_info;
  static constexpr Direction direction = Direction::from_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 18;
  static constexpr std::size_t max_size = 18;
  static constexpr Availability since{};

  /// For firmware_ver: unknown; the sensors are often unplugged.
  static constexpr std::uint16_t unknown_firmware{0};

  /// Hardware version.
  BoardVersion board_ver{};
  /// Firmware version.
  FirmwareVersion firmware_ver{};
  /// State of the board; before later firmware, only whether debug output is enabled.
  BoardStateFlags debug_mode{};
  /// Features of the board.
  BoardFeatures board_features{};
  /// How this host is connected.
  ConnectionFlags connection_flags{};
  /// Identifies special firmware builds.
  std::uint32_t frw_extra_id{};
  /// More features of the board.
  BoardFeaturesExt board_features_ext{};
  /// Model of the main IMU's sensor.
  std::uint8_t main_imu_sens_model{};
  /// Model of the frame IMU's sensor.
  std::uint8_t frame_imu_sens_model{};
  /// Build of the firmware version.
  std::uint8_t build_number{};
  /// Main version on which an experimental version is based.
  FirmwareVersion base_frw_ver{};
  /// Bytes appended by later firmware; preserved and written back.
  BoundedBytes<237> tail{};

  bool operator==(const BoardInfo&) const = default;
  using FixedMembers = Members<&BoardInfo::board_ver, &BoardInfo::firmware_ver,
      &BoardInfo::debug_mode, &BoardInfo::board_features, &BoardInfo::connection_flags,
      &BoardInfo::frw_extra_id, &BoardInfo::board_features_ext, &BoardInfo::main_imu_sens_model,
      &BoardInfo::frame_imu_sens_model, &BoardInfo::build_number, &BoardInfo::base_frw_ver>;
};

/// Request the board and firmware version.
///
/// CMD_BOARD_INFO (86), to the board, simple form; 0 bytes. Effect: reads. Source: Outgoing
/// commands L602-L611.
struct BoardInfoRequest {
  static constexpr CommandToBoard command = CommandToBoard::board_info;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::simple;
  static constexpr std::size_t min_size = 0;
  static constexpr std::size_t max_size = 0;
  static constexpr Availability since{};
  using Response = BoardInfo;

  bool operator==(const BoardInfoRequest&) const = default;
};

/// Request the board and firmware version, with a byte that has no meaning.
///
/// CMD_BOARD_INFO (86), to the board, one_byte form; 1 byte. Effect: reads. Source: Outgoing
/// commands L602-L611.
struct BoardInfoRequestOneByte {
  static constexpr CommandToBoard command = CommandToBoard::board_info;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::one_byte;
  static constexpr std::size_t min_size = 1;
  static constexpr std::size_t max_size = 1;
  static constexpr Availability since{};
  using Response = BoardInfo;

  /// Reserved; kept as it is.
  Bytes<1> reserved{};

  bool operator==(const BoardInfoRequestOneByte&) const = default;
  using FixedMembers = Members<&BoardInfoRequestOneByte::reserved>;
};

/// Request the board and firmware version, and configure this serial port. On a port with a
/// password, nothing else is answered before a request with it.
///
/// CMD_BOARD_INFO (86), to the board, extended form; 2 to 255 bytes. Effect: sets. Source: Outgoing
/// commands L602-L611.
struct BoardInfoRequestExt {
  static constexpr CommandToBoard command = CommandToBoard::board_info;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::extended;
  static constexpr std::size_t min_size = 2;
  static constexpr std::size_t max_size = 255;
  static constexpr Availability since{};
  using Response = BoardInfo;

  /// On a UART, the pause between the 20-byte packets of a Bluetooth LE link; no meaning on USB.
  /// Unit: ms.
  Milliseconds cfg{};
  /// Opens a port with a password, from firmware 2.73.6 on. Present if it is all that is left of
  /// the body, not empty, and without control characters. Secret: text and JSON hide it.
  Optional<BoundedText<32>> password{};
  /// Reserved; kept as it is.
  BoundedBytes<253> reserved{};

  bool operator==(const BoardInfoRequestExt&) const = default;
  using FixedMembers = Members<&BoardInfoRequestExt::cfg>;
  SBGC_ALWAYS_INLINE
  static constexpr void varying_members(auto& self, auto& cursor) noexcept {
    cursor.if_fits(self.password, "password");
    cursor.rest(self.reserved, "reserved");
  }
};

/// The board executed a command.
///
/// CMD_CONFIRM (67), from the board; 1 to 6 bytes. Source: Incoming commands L412-L419.
struct Confirm {
  static constexpr CommandFromBoard command = CommandFromBoard::confirm;
  static constexpr Direction direction = Direction::from_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 1;
  static constexpr std::size_t max_size = 6;
  static constexpr Availability since{};

  /// For pin_state: the pin is unavailable.
  static constexpr std::int8_t pin_unavailable{-1};

  /// The confirmed command.
  CommandToBoard cmd{};
  /// Address of the written block. Present if cmd is CMD_EEPROM_WRITE.
  Optional<std::uint32_t> addr{};
  /// Result of the file operation. Present if cmd is CMD_WRITE_FILE or CMD_FS_CLEAR_ALL.
  Optional<FileError> err_code{};
  /// The pin that became an input. Present if cmd is CMD_TRIGGER_PIN.
  Optional<OutputPin> pin_id{};
  /// Its level. Range: 0 to 1. Present if cmd is CMD_TRIGGER_PIN.
  Optional<std::int8_t> pin_state{};
  /// Data of other commands; usually empty, or 0 for success. At most 5.
  BoundedBytes<254> data{};

  bool operator==(const Confirm&) const = default;
  using FixedMembers = Members<&Confirm::cmd>;
  SBGC_ALWAYS_INLINE
  static constexpr void varying_members(auto& self, auto& cursor) noexcept {
    cursor.when_or_missing(self.cmd == CommandToBoard::eeprom_write, self.addr, "addr");
    cursor.when_or_missing(self.cmd == CommandToBoard::write_file || self.cmd ==
        CommandToBoard::fs_clear_all, self.err_code, "err_code");
    cursor.when_or_missing(self.cmd == CommandToBoard::trigger_pin, self.pin_id, "pin_id");
    cursor.when_or_missing(self.cmd == CommandToBoard::trigger_pin, self.pin_state, "pin_state");
    cursor.rest(self.data, "data");
  }
};

/// An error as the specification describes it.
///
/// CMD_ERROR (255), from the board, simple form; 5 bytes. Since board 3.0. Source: Incoming
/// commands L421-L426.
struct Error {
  static constexpr CommandFromBoard command = CommandFromBoard::error;
  static constexpr Direction direction = Direction::from_board;
  static constexpr Form form = Form::simple;
  static constexpr std::size_t min_size = 5;
  static constexpr std::size_t max_size = 5;
  static constexpr Availability since{.board = 30};

  /// Error code.
  BoardErrorCode error_code{};
  /// Details that depend on the code.
  Bytes<4> error_data{};

  bool operator==(const Error&) const = default;
  using FixedMembers = Members<&Error::error_code, &Error::error_data>;
};

/// An error as real boards send it, with the failed command.
///
/// CMD_ERROR (255), from the board, extended form; 6 bytes, and later firmware may append more.
/// Since board 3.0. Source: Incoming commands L421-L426.
struct ErrorExt {
  static constexpr CommandFromBoard command = CommandFromBoard::error;
  static constexpr Direction direction = Direction::from_board;
  static constexpr Form form = Form::extended;
  static constexpr std::size_t min_size = 6;
  static constexpr std::size_t max_size = 6;
  static constexpr Availability since{.board = 30};

  /// The failed command.
  CommandToBoard cmd_id{};
  /// Error code.
  BoardErrorCode error_code{};
  /// Details that depend on the code.
  Bytes<4> error_data{};
  /// Bytes appended by later firmware; preserved and written back.
  BoundedBytes<249> tail{};

  bool operator==(const ErrorExt&) const = default;
  using FixedMembers = Members<&ErrorExt::cmd_id, &ErrorExt::error_code, &ErrorExt::error_data>;
};

/// Serial numbers, memory and scripts of the board.
///
/// CMD_BOARD_INFO_3 (20), from the board; 69 bytes, and later firmware may append more. Since board
/// 3.0. Source: Incoming commands L168-L178.
struct BoardInfo3 {
  static constexpr CommandFromBoard command = CommandFromBoard::board_info_3;
  static constexpr Direction direction = Direction::from_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 69;
  static constexpr std::size_t max_size = 69;
  static constexpr Availability since{.board = 30};

  /// For script_slot_size and script_slot_6_to_10_size: the slot is empty.
  static constexpr std::uint16_t empty_slot{0};
  /// For profile_set_cur: earlier firmware has no profile sets.
  static constexpr std::uint8_t no_profile_set{0};

  /// Identifies the board.
  Bytes<9> device_id{};
  /// Identifies the microcontroller.
  Bytes<12> mcu_id{};
  /// Size of the EEPROM. Unit: byte.
  LongByteCount eeprom_size{};
  /// Size of the user script in each slot. Unit: byte.
  std::array<ByteCount, 5> script_slot_size{};
  /// Profile sets in memory.
  StoredProfileSets profile_set_slots{};
  /// Selected profile set; 6 is the backup. Range: 1 to 6.
  std::uint8_t profile_set_cur{};
  /// Size of the flash memory. Unit: byte.
  FlashSize flash_size{};
  /// Information about the calibrations of the IMUs.
  Bytes<2> imu_calib_info{};
  /// Size of the user script in each of slots 6 to 10. Unit: byte.
  std::array<ByteCount, 5> script_slot_6_to_10_size{};
  /// Hardware on the board.
  HardwareFlags hw_flags{};
  /// More features of the board. Since firmware 2.73.
  BoardFeaturesExt2 board_features_ext2{};
  /// Number of licensed CAN motor drivers for the main axes. Since firmware 2.72b3.
  std::uint8_t can_drv_main_limit{};
  /// Number of licensed CAN motor drivers for auxiliary motors. Since firmware 2.72b3.
  std::uint8_t can_drv_aux_limit{};
  /// Number of adjustable variables. Since firmware 2.73.
  std::uint8_t adj_vars_total_num{};
  /// Reserved; kept as it is.
  Bytes<10> reserved{};
  /// Bytes appended by later firmware; preserved and written back.
  BoundedBytes<186> tail{};

  bool operator==(const BoardInfo3&) const = default;
  using FixedMembers = Members<&BoardInfo3::device_id, &BoardInfo3::mcu_id,
      &BoardInfo3::eeprom_size, &BoardInfo3::script_slot_size, &BoardInfo3::profile_set_slots,
      &BoardInfo3::profile_set_cur, &BoardInfo3::flash_size, &BoardInfo3::imu_calib_info,
      &BoardInfo3::script_slot_6_to_10_size, &BoardInfo3::hw_flags,
      &BoardInfo3::board_features_ext2, &BoardInfo3::can_drv_main_limit,
      &BoardInfo3::can_drv_aux_limit, &BoardInfo3::adj_vars_total_num, &BoardInfo3::reserved>;
};

/// Request serial numbers, memory and scripts of the board.
///
/// CMD_BOARD_INFO_3 (20), to the board; 0 bytes. Effect: reads. Since board 3.0. Source: Outgoing
/// commands L613.
struct BoardInfo3Request {
  static constexpr CommandToBoard command = CommandToBoard::board_info_3;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 0;
  static constexpr std::size_t max_size = 0;
  static constexpr Availability since{.board = 30};
  using Response = BoardInfo3;

  bool operator==(const BoardInfo3Request&) const = default;
};

/// The board is about to restart. Leaves time to close the serial port: the board restarts 1000 ms
/// later, or after the DELAY_MS of the host that requested the restart. It responds again about 5 s
/// later.
///
/// CMD_RESET (114), from the board; 0 bytes, and later firmware may append more. Source: Incoming
/// commands L537-L539.
struct Reset {
  static constexpr CommandFromBoard command = CommandFromBoard::reset;
  static constexpr Direction direction = Direction::from_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 0;
  static constexpr std::size_t max_size = 0;
  static constexpr Availability since{};

  /// Bytes appended by later firmware; preserved and written back.
  BoundedBytes<255> tail{};

  bool operator==(const Reset&) const = default;
};

/// Restart immediately, without notification.
///
/// CMD_RESET (114), to the board, simple form; 0 bytes. Effect: restarts. Source: Outgoing commands
/// L670-L677.
struct ResetRequest {
  static constexpr CommandToBoard command = CommandToBoard::reset;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::simple;
  static constexpr std::size_t min_size = 0;
  static constexpr std::size_t max_size = 0;
  static constexpr Availability since{};
  using Response = void;

  bool operator==(const ResetRequest&) const = default;
};

/// Restart after a delay, with an optional notification.
///
/// CMD_RESET (114), to the board, extended form; 3 bytes. Effect: restarts. Source: Outgoing
/// commands L670-L677.
struct ResetRequestExt {
  static constexpr CommandToBoard command = CommandToBoard::reset;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::extended;
  static constexpr std::size_t min_size = 3;
  static constexpr std::size_t max_size = 3;
  static constexpr Availability since{};
  using Response = sbgc::Maybe<Reset>;

  /// Whether CMD_RESET is sent back first.
  ResetOptions confirm{};
  /// Delay before the restart. Unit: ms.
  Milliseconds delay_ms{};

  bool operator==(const ResetRequestExt&) const = default;
  using FixedMembers = Members<&ResetRequestExt::confirm, &ResetRequestExt::delay_ms>;
};

/// Enter the bootloader immediately, without notification. The bootloader accepts new firmware and
/// none of these commands, and the motors have no power. The board may not return on its own: send
/// this only with new firmware at hand.
///
/// CMD_BOOT_MODE_3 (51), to the board, simple form; 0 bytes. Effect: restarts, disconnects. Since
/// board 3.0. Source: Outgoing commands L679-L686.
struct BootMode3 {
  static constexpr CommandToBoard command = CommandToBoard::boot_mode_3;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::simple;
  static constexpr std::size_t min_size = 0;
  static constexpr std::size_t max_size = 0;
  static constexpr Availability since{.board = 30};
  using Response = void;

  bool operator==(const BootMode3&) const = default;
};

/// Enter the bootloader after a delay, with an optional notification. The bootloader accepts new
/// firmware and none of these commands, and the motors have no power. The board may not return on
/// its own: send this only with new firmware at hand.
///
/// CMD_BOOT_MODE_3 (51), to the board, extended form; 3 bytes. Effect: restarts, disconnects. Since
/// board 3.0. Source: Outgoing commands L679-L686.
struct BootMode3Ext {
  static constexpr CommandToBoard command = CommandToBoard::boot_mode_3;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::extended;
  static constexpr std::size_t min_size = 3;
  static constexpr std::size_t max_size = 3;
  static constexpr Availability since{.board = 30};
  using Response = sbgc::Maybe<Reset>;

  /// Whether CMD_RESET is sent back first.
  ResetOptions confirm{};
  /// Delay before the bootloader starts. Unit: ms.
  Milliseconds delay_ms{};

  bool operator==(const BootMode3Ext&) const = default;
  using FixedMembers = Members<&BootMode3Ext::confirm, &BootMode3Ext::delay_ms>;
};

/// Statistics of the board's whole life.
///
/// CMD_READ_STATE_VARS (111), from the board; 192 bytes, and later firmware may append more. Since
/// firmware 2.68b7, board 3.6. Source: Later firmware.
struct ReadStateVars {
  static constexpr CommandFromBoard command = CommandFromBoard::read_state_vars;
  static constexpr Direction direction = Direction::from_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 192;
  static constexpr std::size_t max_size = 192;
  static constexpr Availability since{.firmware = 2687, .board = 36, .features = 0x40000};

  /// Current value of each step signal.
  std::array<std::uint8_t, 6> step_signal_val{};
  /// Reason for the last emergency stop.
  SystemSubError sub_error{};
  /// Highest acceleration. Unit: g.
  AccelerationPeak max_acc{};
  /// Time in operation. Unit: ms.
  LongSeconds work_time{};
  /// Number of starts.
  std::uint16_t startup_cnt{};
  /// Highest current. Unit: mA.
  Current max_current{};
  /// Lowest temperature of the IMU. Unit: degC.
  PositiveTemperature imu_temp_min{};
  /// Highest temperature of the IMU. Unit: degC.
  PositiveTemperature imu_temp_max{};
  /// Lowest temperature of the microcontroller. Unit: degC.
  PositiveTemperature mcu_temp_min{};
  /// Highest temperature of the microcontroller. Unit: degC.
  PositiveTemperature mcu_temp_max{};
  /// Numbers of shocks.
  std::array<std::uint8_t, 4> shock_cnt{};
  /// Time over which ENERGY is counted. Unit: ms.
  LongSeconds energy_time{};
  /// Energy used. Unit: Wh.
  WattHours energy{};
  /// Time over which AVG_CURRENT is averaged. Unit: ms.
  LongSeconds avg_current_time{};
  /// Average current. Unit: mA.
  AverageCurrent avg_current{};
  /// Reserved; kept as it is.
  Bytes<152> reserved{};
  /// Bytes appended by later firmware; preserved and written back.
  BoundedBytes<63> tail{};

  bool operator==(const ReadStateVars&) const = default;
  using FixedMembers = Members<&ReadStateVars::step_signal_val, &ReadStateVars::sub_error,
      &ReadStateVars::max_acc, &ReadStateVars::work_time, &ReadStateVars::startup_cnt,
      &ReadStateVars::max_current, &ReadStateVars::imu_temp_min, &ReadStateVars::imu_temp_max,
      &ReadStateVars::mcu_temp_min, &ReadStateVars::mcu_temp_max, &ReadStateVars::shock_cnt,
      &ReadStateVars::energy_time, &ReadStateVars::energy, &ReadStateVars::avg_current_time,
      &ReadStateVars::avg_current, &ReadStateVars::reserved>;
};

/// Request the statistics of the board's whole life.
///
/// CMD_READ_STATE_VARS (111), to the board; 0 bytes. Effect: reads. Since firmware 2.68b7, board
/// 3.6. Source: Later firmware.
struct ReadStateVarsRequest {
  static constexpr CommandToBoard command = CommandToBoard::read_state_vars;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 0;
  static constexpr std::size_t max_size = 0;
  static constexpr Availability since{.firmware = 2687, .board = 36, .features = 0x40000};
  using Response = ReadStateVars;

  bool operator==(const ReadStateVarsRequest&) const = default;
};

/// Signature of a message.
///
/// CMD_SIGN_MESSAGE (50), from the board; 32 bytes, and later firmware may append more. Since
/// firmware 2.50, board 3.0. Source: Later firmware.
struct SignMessage {
  static constexpr CommandFromBoard command = CommandFromBoard::sign_message;
  static constexpr Direction direction = Direction::from_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 32;
  static constexpr std::size_t max_size = 32;
  static constexpr Availability since{.firmware = 2500, .board = 30};

  /// The signature.
  Bytes<32> signature{};
  /// Bytes appended by later firmware; preserved and written back.
  BoundedBytes<223> tail{};

  bool operator==(const SignMessage&) const = default;
  using FixedMembers = Members<&SignMessage::signature>;
};

/// Sign a message with the keys of the board.
///
/// CMD_SIGN_MESSAGE (50), to the board; 33 bytes. Effect: reads. Since firmware 2.50, board 3.0.
/// Source: Later firmware.
struct SignMessageRequest {
  static constexpr CommandToBoard command = CommandToBoard::sign_message;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 33;
  static constexpr std::size_t max_size = 33;
  static constexpr Availability since{.firmware = 2500, .board = 30};
  using Response = SignMessage;

  /// Set of keys.
  std::uint8_t sign_type{};
  /// The message.
  Bytes<32> message{};

  bool operator==(const SignMessageRequest&) const = default;
  using FixedMembers = Members<&SignMessageRequest::sign_type, &SignMessageRequest::message>;
};

/// What a password protects.
///
/// CMD_PASS_PROTECT_READ (136), from the board; 8 bytes, and later firmware may append more. Since
/// firmware 2.73.6. Source: Vendor's code of 2026.
struct PassProtectRead {
  static constexpr CommandFromBoard command = CommandFromBoard::pass_protect_read;
  static constexpr Direction direction = Direction::from_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 8;
  static constexpr std::size_t max_size = 8;
  static constexpr Availability since{.firmware = 2736};

  /// What is protected.
  PassProtectFlags flags{};
  /// Reserved; kept as it is.
  Bytes<4> reserved{};
  /// Bytes appended by later firmware; preserved and written back.
  BoundedBytes<247> tail{};

  bool operator==(const PassProtectRead&) const = default;
  using FixedMembers = Members<&PassProtectRead::flags, &PassProtectRead::reserved>;
};

/// Request what a password protects.
///
/// CMD_PASS_PROTECT_READ (136), to the board; 0 bytes. Effect: reads. Since firmware 2.73.6.
/// Source: Vendor's code of 2026.
struct PassProtectReadRequest {
  static constexpr CommandToBoard command = CommandToBoard::pass_protect_read;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 0;
  static constexpr std::size_t max_size = 0;
  static constexpr Availability since{.firmware = 2736};
  using Response = PassProtectRead;

  bool operator==(const PassProtectReadRequest&) const = default;
};

/// Choose what a password protects.
///
/// CMD_PASS_PROTECT_WRITE (137), to the board; 9 to 41 bytes. Effect: stores. Since firmware
/// 2.73.6. Source: Vendor's code of 2026.
struct PassProtectWrite {
  static constexpr CommandToBoard command = CommandToBoard::pass_protect_write;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 9;
  static constexpr std::size_t max_size = 41;
  static constexpr Availability since{.firmware = 2736};
  using Response = void;

  /// What is protected.
  PassProtectFlags flags{};
  /// Reserved; kept as it is.
  Bytes<4> reserved{};
  /// The new password; empty keeps the present one. Secret: text and JSON hide it.
  BoundedText<32> new_password{};

  bool operator==(const PassProtectWrite&) const = default;
  using FixedMembers = Members<&PassProtectWrite::flags, &PassProtectWrite::reserved>;
  SBGC_ALWAYS_INLINE
  static constexpr void varying_members(auto& self, auto& cursor) noexcept {
    cursor.value(self.new_password, "new_password");
  }
};

/// Undocumented body from the board.
///
/// CMD_QUEUE_PARAMS_INFO_3 (30), from the board; 0 to 255 bytes. Since board 3.0. Source: Command
/// ID definitions L108.
struct QueueParamsInfo3 {
  static constexpr CommandFromBoard command = CommandFromBoard::queue_params_info_3;
  static constexpr Direction direction = Direction::from_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 0;
  static constexpr std::size_t max_size = 255;
  static constexpr Availability since{.board = 30};

  /// Undocumented content.
  BoundedBytes<255> data{};

  bool operator==(const QueueParamsInfo3&) const = default;
  SBGC_ALWAYS_INLINE
  static constexpr void varying_members(auto& self, auto& cursor) noexcept {
    cursor.rest(self.data, "data");
  }
};

/// Undocumented body to the board.
///
/// CMD_QUEUE_PARAMS_INFO_3 (30), to the board; 0 to 255 bytes. Effect: unknown. Since board 3.0.
/// Source: Command ID definitions L108.
struct QueueParamsInfo3Request {
  static constexpr CommandToBoard command = CommandToBoard::queue_params_info_3;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 0;
  static constexpr std::size_t max_size = 255;
  static constexpr Availability since{.board = 30};
  using Response = void;

  /// Undocumented content.
  BoundedBytes<255> data{};

  bool operator==(const QueueParamsInfo3Request&) const = default;
  SBGC_ALWAYS_INLINE
  static constexpr void varying_members(auto& self, auto& cursor) noexcept {
    cursor.rest(self.data, "data");
  }
};

/// Undocumented body from the board.
///
/// CMD_SYSTEM_STATE (52), from the board; 0 to 255 bytes. Since board 3.0. Source: Command ID
/// definitions L130.
struct SystemState {
  static constexpr CommandFromBoard command = CommandFromBoard::system_state;
  static constexpr Direction direction = Direction::from_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 0;
  static constexpr std::size_t max_size = 255;
  static constexpr Availability since{.board = 30};

  /// Undocumented content.
  BoundedBytes<255> data{};

  bool operator==(const SystemState&) const = default;
  SBGC_ALWAYS_INLINE
  static constexpr void varying_members(auto& self, auto& cursor) noexcept {
    cursor.rest(self.data, "data");
  }
};

/// Undocumented body to the board.
///
/// CMD_SYSTEM_STATE (52), to the board; 0 to 255 bytes. Effect: unknown. Since board 3.0. Source:
/// Command ID definitions L130.
struct SystemStateRequest {
  static constexpr CommandToBoard command = CommandToBoard::system_state;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 0;
  static constexpr std::size_t max_size = 255;
  static constexpr Availability since{.board = 30};
  using Response = void;

  /// Undocumented content.
  BoundedBytes<255> data{};

  bool operator==(const SystemStateRequest&) const = default;
  SBGC_ALWAYS_INLINE
  static constexpr void varying_members(auto& self, auto& cursor) noexcept {
    cursor.rest(self.data, "data");
  }
};

/// Undocumented body from the board.
///
/// CMD_MAVLINK_INFO (250), from the board; 0 to 255 bytes. Since board 3.0. Source: Command ID
/// definitions L149.
struct MavlinkInfo {
  static constexpr CommandFromBoard command = CommandFromBoard::mavlink_info;
  static constexpr Direction direction = Direction::from_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 0;
  static constexpr std::size_t max_size = 255;
  static constexpr Availability since{.board = 30};

  /// Undocumented content.
  BoundedBytes<255> data{};

  bool operator==(const MavlinkInfo&) const = default;
  SBGC_ALWAYS_INLINE
  static constexpr void varying_members(auto& self, auto& cursor) noexcept {
    cursor.rest(self.data, "data");
  }
};

/// Undocumented body to the board.
///
/// CMD_MAVLINK_INFO (250), to the board; 0 to 255 bytes. Effect: unknown. Since board 3.0. Source:
/// Command ID definitions L149.
struct MavlinkInfoRequest {
  static constexpr CommandToBoard command = CommandToBoard::mavlink_info;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 0;
  static constexpr std::size_t max_size = 255;
  static constexpr Availability since{.board = 30};
  using Response = void;

  /// Undocumented content.
  BoundedBytes<255> data{};

  bool operator==(const MavlinkInfoRequest&) const = default;
  SBGC_ALWAYS_INLINE
  static constexpr void varying_members(auto& self, auto& cursor) noexcept {
    cursor.rest(self.data, "data");
  }
};

/// Undocumented body from the board.
///
/// CMD_MAVLINK_DEBUG (251), from the board; 0 to 255 bytes. Since board 3.0. Source: Command ID
/// definitions L150.
struct MavlinkDebug {
  static constexpr CommandFromBoard command = CommandFromBoard::mavlink_debug;
  static constexpr Direction direction = Direction::from_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 0;
  static constexpr std::size_t max_size = 255;
  static constexpr Availability since{.board = 30};

  /// Undocumented content.
  BoundedBytes<255> data{};

  bool operator==(const MavlinkDebug&) const = default;
  SBGC_ALWAYS_INLINE
  static constexpr void varying_members(auto& self, auto& cursor) noexcept {
    cursor.rest(self.data, "data");
  }
};

/// Undocumented body to the board.
///
/// CMD_MAVLINK_DEBUG (251), to the board; 0 to 255 bytes. Effect: unknown. Since board 3.0. Source:
/// Command ID definitions L150.
struct MavlinkDebugRequest {
  static constexpr CommandToBoard command = CommandToBoard::mavlink_debug;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 0;
  static constexpr std::size_t max_size = 255;
  static constexpr Availability since{.board = 30};
  using Response = void;

  /// Undocumented content.
  BoundedBytes<255> data{};

  bool operator==(const MavlinkDebugRequest&) const = default;
  SBGC_ALWAYS_INLINE
  static constexpr void varying_members(auto& self, auto& cursor) noexcept {
    cursor.rest(self.data, "data");
  }
};

/// Undocumented body from the board.
///
/// CMD_EXT_LICENSE_INFO (124), from the board; 0 to 255 bytes. Since firmware 2.60. Unconfirmed.
/// Source: Later firmware.
struct ExtLicenseInfo {
  static constexpr CommandFromBoard command = CommandFromBoard::ext_license_info;
  static constexpr Direction direction = Direction::from_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 0;
  static constexpr std::size_t max_size = 255;
  static constexpr Availability since{.firmware = 2600};

  /// Undocumented content.
  BoundedBytes<255> data{};

  bool operator==(const ExtLicenseInfo&) const = default;
  SBGC_ALWAYS_INLINE
  static constexpr void varying_members(auto& self, auto& cursor) noexcept {
    cursor.rest(self.data, "data");
  }
};

/// Undocumented body to the board.
///
/// CMD_EXT_LICENSE_INFO (124), to the board; 0 to 255 bytes. Effect: unknown. Since firmware 2.60.
/// Unconfirmed. Source: Later firmware.
struct ExtLicenseInfoRequest {
  static constexpr CommandToBoard command = CommandToBoard::ext_license_info;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 0;
  static constexpr std::size_t max_size = 255;
  static constexpr Availability since{.firmware = 2600};
  using Response = void;

  /// Undocumented content.
  BoundedBytes<255> data{};

  bool operator==(const ExtLicenseInfoRequest&) const = default;
  SBGC_ALWAYS_INLINE
  static constexpr void varying_members(auto& self, auto& cursor) noexcept {
    cursor.rest(self.data, "data");
  }
};

/// Store the statistics of the board's whole life. Write back what you read, and change only what
/// you need.
///
/// CMD_WRITE_STATE_VARS (112), to the board; 192 bytes, and later firmware may append more. Effect:
/// stores. Since firmware 2.68b7, board 3.6. Source: Later firmware.
struct WriteStateVars : ReadStateVars {
  static constexpr CommandToBoard command = CommandToBoard::write_state_vars;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 192;
  static constexpr std::size_t max_size = 192;
  static constexpr Availability since{.firmware = 2687, .board = 36, .features = 0x40000};
  using Response = void;
  using Body = ReadStateVars;

  bool operator==(const WriteStateVars&) const = default;
};

}  // namespace sbgc::msg
