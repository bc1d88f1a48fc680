// Generated from spec/ by generator/: edit those, then run ./dev generate.

/// Identity of the board, confirmations and errors, restarting.
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

struct BoardInfo;
struct BoardInfo3;
struct Reset;

/// Version and features of the board.
///
/// CMD_BOARD_INFO (86), from the board; 18 bytes, and later firmware may append more.
/// Source: Incoming commands L158-L166; Variables L1005-L1009.
struct BoardInfo {
  static constexpr CommandFromBoard command = CommandFromBoard::board_info;
  static constexpr Direction direction = Direction::from_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 18;
  static constexpr std::size_t max_size = 18;
  static constexpr Availability since{};

  /// Hardware version.
  BoardVersion board_ver{};
  /// Firmware version.
  FirmwareVersion firmware_ver{};
  /// Whether debugging output is wanted. 0: a host should hide its debug output.
  std::uint8_t debug_mode{};
  /// What the board can do.
  BoardFeatures board_features{};
  /// How this host is connected. Errata: E032.
  ConnectionFlags connection_flags{};
  /// Identifies special builds of the firmware.
  std::uint32_t frw_extra_id{};
  /// Later firmware keeps more feature bits, IMU models and a base firmware version here. Errata:
  /// E201.
  Bytes<7> reserved{};
  /// What later firmware appends; kept, and written back.
  BoundedBytes<237> tail{};

  constexpr bool operator==(const BoardInfo&) const = default;
};

constexpr void get(const std::uint8_t* SBGC_RESTRICT from,
                   BoardInfo& SBGC_RESTRICT out) noexcept {
  get(from, out.board_ver);
  get(from + 1, out.firmware_ver);
  get(from + 3, out.debug_mode);
  get(from + 4, out.board_features);
  get(from + 6, out.connection_flags);
  get(from + 7, out.frw_extra_id);
  get(from + 11, out.reserved);
}
constexpr void put(std::uint8_t* SBGC_RESTRICT to,
                   const BoardInfo& SBGC_RESTRICT in) noexcept {
  put(to, in.board_ver);
  put(to + 1, in.firmware_ver);
  put(to + 3, in.debug_mode);
  put(to + 4, in.board_features);
  put(to + 6, in.connection_flags);
  put(to + 7, in.frw_extra_id);
  put(to + 11, in.reserved);
}

[[nodiscard]] constexpr Status decode(std::span<const std::uint8_t> body,
                                      BoardInfo& out) noexcept {
  if (body.size() < 18) return detail::wrong_size(body.size(), 18);
  get(body.data(), out);
  return detail::get_tail(body, 18, out.tail);
}

[[nodiscard]] constexpr WriteResult encode(const BoardInfo& in,
                                           std::span<std::uint8_t> out) noexcept {
  const std::size_t size = 18 + in.tail.size();
  if (out.size() < size) return {0, {Code::buffer_too_small}};
  put(out.data(), in);
  detail::put_tail(out.data() + 18, in.tail);
  return {size, {}};
}

/// Ask for the version of board and firmware.
///
/// CMD_BOARD_INFO (86), to the board, simple form; 0 bytes.
/// Effect: reads.
/// Source: Outgoing commands L602-L611. Errata: E084, E091.
struct BoardInfoRequest {
  static constexpr CommandToBoard command = CommandToBoard::board_info;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::simple;
  static constexpr std::size_t min_size = 0;
  static constexpr std::size_t max_size = 0;
  static constexpr Availability since{};
  using Response = BoardInfo;

  constexpr bool operator==(const BoardInfoRequest&) const = default;
};

[[nodiscard]] constexpr Status decode(std::span<const std::uint8_t> body,
                                      BoardInfoRequest& out) noexcept {
  if (body.size() != 0) return detail::wrong_size(body.size(), 0);
  static_cast<void>(out);
  return {};
}

[[nodiscard]] constexpr WriteResult encode(const BoardInfoRequest& in,
                                           std::span<std::uint8_t> out) noexcept {
  static_cast<void>(in);
  static_cast<void>(out);
  return {0, {}};
}

/// Ask for the version of board and firmware, with a byte that means nothing.
///
/// CMD_BOARD_INFO (86), to the board, one_byte form; 1 byte.
/// Effect: reads.
/// Source: Outgoing commands L602-L611. Errata: E084, E091, E214.
struct BoardInfoRequestOneByte {
  static constexpr CommandToBoard command = CommandToBoard::board_info;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::one_byte;
  static constexpr std::size_t min_size = 1;
  static constexpr std::size_t max_size = 1;
  static constexpr Availability since{};
  using Response = BoardInfo;

  /// Reserved; kept as it is. Errata: E214.
  Bytes<1> reserved{};

  constexpr bool operator==(const BoardInfoRequestOneByte&) const = default;
};

constexpr void get(const std::uint8_t* SBGC_RESTRICT from,
                   BoardInfoRequestOneByte& SBGC_RESTRICT out) noexcept {
  get(from, out.reserved);
}
constexpr void put(std::uint8_t* SBGC_RESTRICT to,
                   const BoardInfoRequestOneByte& SBGC_RESTRICT in) noexcept {
  put(to, in.reserved);
}

[[nodiscard]] constexpr Status decode(std::span<const std::uint8_t> body,
                                      BoardInfoRequestOneByte& out) noexcept {
  if (body.size() != 1) return detail::wrong_size(body.size(), 1);
  get(body.data(), out);
  return {};
}

[[nodiscard]] constexpr WriteResult encode(const BoardInfoRequestOneByte& in,
                                           std::span<std::uint8_t> out) noexcept {
  if (out.size() < 1) return {0, {Code::buffer_too_small}};
  put(out.data(), in);
  return {1, {}};
}

/// Ask for the version of board and firmware, and configure this serial port.
///
/// CMD_BOARD_INFO (86), to the board, extended form; 2 to 255 bytes.
/// Effect: sets.
/// Source: Outgoing commands L602-L611. Errata: E084, E091, E009.
struct BoardInfoRequestExt {
  static constexpr CommandToBoard command = CommandToBoard::board_info;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::extended;
  static constexpr std::size_t min_size = 2;
  static constexpr std::size_t max_size = 255;
  static constexpr Availability since{};
  using Response = BoardInfo;

  /// On a UART, the pause between the 20-byte packets of a Bluetooth LE link; without meaning on
  /// USB. Unit: ms. Errata: E008.
  Milliseconds cfg{};
  /// Of undefined size; send it empty. Errata: E009.
  BoundedBytes<253> reserved{};

  constexpr bool operator==(const BoardInfoRequestExt&) const = default;
};

constexpr void get(const std::uint8_t* SBGC_RESTRICT from,
                   BoardInfoRequestExt& SBGC_RESTRICT out) noexcept {
  get(from, out.cfg);
}
constexpr void put(std::uint8_t* SBGC_RESTRICT to,
                   const BoardInfoRequestExt& SBGC_RESTRICT in) noexcept {
  put(to, in.cfg);
}

[[nodiscard]] constexpr Status decode(std::span<const std::uint8_t> body,
                                      BoardInfoRequestExt& out) noexcept {
  if (body.size() < 2) return detail::wrong_size(body.size(), 2);
  get(body.data(), out);
  detail::Reader reader(body, 2);
  reader.rest(out.reserved, "reserved");
  return reader.end();
}

[[nodiscard]] constexpr WriteResult encode(const BoardInfoRequestExt& in,
                                           std::span<std::uint8_t> out) noexcept {
  if (out.size() < 2) return {0, {Code::buffer_too_small}};
  put(out.data(), in);
  detail::Writer writer(out, 2);
  writer.array(in.reserved, "reserved");
  return writer.end();
}

/// The board has carried out a command.
///
/// CMD_CONFIRM (67), from the board; 1 to 6 bytes.
/// Source: Incoming commands L412-L419. Errata: E021, E081, E203.
struct Confirm {
  static constexpr CommandFromBoard command = CommandFromBoard::confirm;
  static constexpr Direction direction = Direction::from_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 1;
  static constexpr std::size_t max_size = 6;
  static constexpr Availability since{};

  /// The command that is confirmed.
  CommandToBoard cmd{};
  /// Address of the block that was written. Present when cmd is CMD_EEPROM_WRITE. Errata: E022.
  Optional<std::uint32_t> addr{};
  /// How the file operation ended. Present when cmd is CMD_WRITE_FILE or CMD_FS_CLEAR_ALL.
  Optional<FileError> err_code{};
  /// Data of other commands; mostly empty. At most 5.
  BoundedBytes<254> data{};

  constexpr bool operator==(const Confirm&) const = default;
};

constexpr void get(const std::uint8_t* SBGC_RESTRICT from,
                   Confirm& SBGC_RESTRICT out) noexcept {
  get(from, out.cmd);
}
constexpr void put(std::uint8_t* SBGC_RESTRICT to,
                   const Confirm& SBGC_RESTRICT in) noexcept {
  put(to, in.cmd);
}

[[nodiscard]] constexpr Status decode(std::span<const std::uint8_t> body,
                                      Confirm& out) noexcept {
  if (body.size() < 1) return detail::wrong_size(body.size(), 1);
  get(body.data(), out);
  detail::Reader reader(body, 1);
  reader.when(out.cmd == CommandToBoard::eeprom_write,
              detail::may_be_missing, out.addr, "addr");
  reader.when(out.cmd == CommandToBoard::write_file || out.cmd == CommandToBoard::fs_clear_all,
              detail::may_be_missing, out.err_code, "err_code");
  reader.rest(out.data, "data");
  return reader.end();
}

[[nodiscard]] constexpr WriteResult encode(const Confirm& in,
                                           std::span<std::uint8_t> out) noexcept {
  if (out.size() < 1) return {0, {Code::buffer_too_small}};
  put(out.data(), in);
  detail::Writer writer(out, 1);
  writer.when(in.cmd == CommandToBoard::eeprom_write,
              detail::may_be_missing, in.addr, "addr");
  writer.when(in.cmd == CommandToBoard::write_file || in.cmd == CommandToBoard::fs_clear_all,
              detail::may_be_missing, in.err_code, "err_code");
  writer.array(in.data, "data");
  return writer.end();
}

/// An error, as the specification describes it.
///
/// CMD_ERROR (255), from the board, simple form; 5 bytes.
/// Since board 3.0.
/// Source: Incoming commands L421-L426. Errata: E086.
struct Error {
  static constexpr CommandFromBoard command = CommandFromBoard::error;
  static constexpr Direction direction = Direction::from_board;
  static constexpr Form form = Form::simple;
  static constexpr std::size_t min_size = 5;
  static constexpr std::size_t max_size = 5;
  static constexpr Availability since{0, 30};

  /// What went wrong. Errata: E086.
  BoardErrorCode error_code{};
  /// Details that depend on the code.
  Bytes<4> error_data{};

  constexpr bool operator==(const Error&) const = default;
};

constexpr void get(const std::uint8_t* SBGC_RESTRICT from,
                   Error& SBGC_RESTRICT out) noexcept {
  get(from, out.error_code);
  get(from + 1, out.error_data);
}
constexpr void put(std::uint8_t* SBGC_RESTRICT to,
                   const Error& SBGC_RESTRICT in) noexcept {
  put(to, in.error_code);
  put(to + 1, in.error_data);
}

[[nodiscard]] constexpr Status decode(std::span<const std::uint8_t> body,
                                      Error& out) noexcept {
  if (body.size() != 5) return detail::wrong_size(body.size(), 5);
  get(body.data(), out);
  return {};
}

[[nodiscard]] constexpr WriteResult encode(const Error& in,
                                           std::span<std::uint8_t> out) noexcept {
  if (out.size() < 5) return {0, {Code::buffer_too_small}};
  put(out.data(), in);
  return {5, {}};
}

/// An error, as real boards send it: with the command that failed.
///
/// CMD_ERROR (255), from the board, extended form; 6 bytes, and later firmware may append more.
/// Since board 3.0.
/// Source: Incoming commands L421-L426. Errata: E086.
struct ErrorExt {
  static constexpr CommandFromBoard command = CommandFromBoard::error;
  static constexpr Direction direction = Direction::from_board;
  static constexpr Form form = Form::extended;
  static constexpr std::size_t min_size = 6;
  static constexpr std::size_t max_size = 6;
  static constexpr Availability since{0, 30};

  /// The command that failed. Errata: E086.
  CommandToBoard cmd_id{};
  /// What went wrong. Errata: E086.
  BoardErrorCode error_code{};
  /// Details that depend on the code.
  Bytes<4> error_data{};
  /// What later firmware appends; kept, and written back.
  BoundedBytes<249> tail{};

  constexpr bool operator==(const ErrorExt&) const = default;
};

constexpr void get(const std::uint8_t* SBGC_RESTRICT from,
                   ErrorExt& SBGC_RESTRICT out) noexcept {
  using M = ErrorExt;
  if (!std::is_constant_evaluated() &&
      detail::in_parallel(offsetof(M, cmd_id), offsetof(M, error_data), 2)) {
    detail::get_block(from, out, offsetof(M, cmd_id), 6);
    return;
  }
  get(from, out.cmd_id);
  get(from + 1, out.error_code);
  get(from + 2, out.error_data);
}
constexpr void put(std::uint8_t* SBGC_RESTRICT to,
                   const ErrorExt& SBGC_RESTRICT in) noexcept {
  using M = ErrorExt;
  if (!std::is_constant_evaluated() &&
      detail::in_parallel(offsetof(M, cmd_id), offsetof(M, error_data), 2)) {
    detail::put_block(to, in, offsetof(M, cmd_id), 6);
    return;
  }
  put(to, in.cmd_id);
  put(to + 1, in.error_code);
  put(to + 2, in.error_data);
}

[[nodiscard]] constexpr Status decode(std::span<const std::uint8_t> body,
                                      ErrorExt& out) noexcept {
  if (body.size() < 6) return detail::wrong_size(body.size(), 6);
  get(body.data(), out);
  return detail::get_tail(body, 6, out.tail);
}

[[nodiscard]] constexpr WriteResult encode(const ErrorExt& in,
                                           std::span<std::uint8_t> out) noexcept {
  const std::size_t size = 6 + in.tail.size();
  if (out.size() < size) return {0, {Code::buffer_too_small}};
  put(out.data(), in);
  detail::put_tail(out.data() + 6, in.tail);
  return {size, {}};
}

[[gnu::always_inline]] inline bool add_in_memory(detail::ByteSum& sum,
                                                 const ErrorExt& in) noexcept {
  using M = ErrorExt;
  if (!(detail::in_parallel(offsetof(M, cmd_id), offsetof(M, error_data), 2))) return false;
  detail::add_block(sum, in, offsetof(M, cmd_id), 6);
  if (!in.tail.empty()) sum.add(byte_sum(in.tail.data(), in.tail.size()));
  return true;
}

/// Serial numbers, memory and scripts of the board.
///
/// CMD_BOARD_INFO_3 (20), from the board; 69 bytes, and later firmware may append more.
/// Since board 3.0.
/// Source: Incoming commands L168-L178. Errata: E114.
struct BoardInfo3 {
  static constexpr CommandFromBoard command = CommandFromBoard::board_info_3;
  static constexpr Direction direction = Direction::from_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 69;
  static constexpr std::size_t max_size = 69;
  static constexpr Availability since{0, 30};

  /// For script_slot_size: the slot is empty.
  static constexpr std::uint16_t empty_slot = 0;

  /// Identifies the board. Errata: E112.
  Bytes<9> device_id{};
  /// Identifies the microcontroller. Errata: E112.
  Bytes<12> mcu_id{};
  /// Size of the EEPROM. Unit: byte. Errata: E014, E116.
  LongByteCount eeprom_size{};
  /// Size of the user-written script in each slot. Unit: byte. empty_slot (0): the slot is empty.
  /// Errata: E097, E116.
  std::array<ByteCount, 5> script_slot_size{};
  /// Reserved; kept as it is.
  Bytes<34> reserved{};
  /// What later firmware appends; kept, and written back.
  BoundedBytes<186> tail{};

  constexpr bool operator==(const BoardInfo3&) const = default;
};

constexpr void get(const std::uint8_t* SBGC_RESTRICT from,
                   BoardInfo3& SBGC_RESTRICT out) noexcept {
  using M = BoardInfo3;
  if (!std::is_constant_evaluated() &&
      detail::in_parallel(offsetof(M, device_id), offsetof(M, mcu_id), 9) &&
      detail::in_parallel(offsetof(M, eeprom_size), offsetof(M, reserved), 14)) {
    detail::get_block(from, out, offsetof(M, device_id), 21);
    detail::get_block(from + 21, out, offsetof(M, eeprom_size), 48);
    return;
  }
  get(from, out.device_id);
  get(from + 9, out.mcu_id);
  get(from + 21, out.eeprom_size);
  get(from + 25, out.script_slot_size);
  get(from + 35, out.reserved);
}
constexpr void put(std::uint8_t* SBGC_RESTRICT to,
                   const BoardInfo3& SBGC_RESTRICT in) noexcept {
  using M = BoardInfo3;
  if (!std::is_constant_evaluated() &&
      detail::in_parallel(offsetof(M, device_id), offsetof(M, mcu_id), 9) &&
      detail::in_parallel(offsetof(M, eeprom_size), offsetof(M, reserved), 14)) {
    detail::put_block(to, in, offsetof(M, device_id), 21);
    detail::put_block(to + 21, in, offsetof(M, eeprom_size), 48);
    return;
  }
  put(to, in.device_id);
  put(to + 9, in.mcu_id);
  put(to + 21, in.eeprom_size);
  put(to + 25, in.script_slot_size);
  put(to + 35, in.reserved);
}

[[nodiscard]] constexpr Status decode(std::span<const std::uint8_t> body,
                                      BoardInfo3& out) noexcept {
  if (body.size() < 69) return detail::wrong_size(body.size(), 69);
  get(body.data(), out);
  return detail::get_tail(body, 69, out.tail);
}

[[nodiscard]] constexpr WriteResult encode(const BoardInfo3& in,
                                           std::span<std::uint8_t> out) noexcept {
  const std::size_t size = 69 + in.tail.size();
  if (out.size() < size) return {0, {Code::buffer_too_small}};
  put(out.data(), in);
  detail::put_tail(out.data() + 69, in.tail);
  return {size, {}};
}

[[gnu::always_inline]] inline bool add_in_memory(detail::ByteSum& sum,
                                                 const BoardInfo3& in) noexcept {
  using M = BoardInfo3;
  if (!(detail::in_parallel(offsetof(M, device_id), offsetof(M, mcu_id), 9) &&
      detail::in_parallel(offsetof(M, eeprom_size), offsetof(M, reserved), 14))) return false;
  detail::add_block(sum, in, offsetof(M, device_id), 21);
  detail::add_block(sum, in, offsetof(M, eeprom_size), 48);
  if (!in.tail.empty()) sum.add(byte_sum(in.tail.data(), in.tail.size()));
  return true;
}

/// Ask for serial numbers, memory and scripts of the board.
///
/// CMD_BOARD_INFO_3 (20), to the board; 0 bytes.
/// Effect: reads.
/// Since board 3.0.
/// Source: Outgoing commands L613.
struct BoardInfo3Request {
  static constexpr CommandToBoard command = CommandToBoard::board_info_3;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 0;
  static constexpr std::size_t max_size = 0;
  static constexpr Availability since{0, 30};
  using Response = BoardInfo3;

  constexpr bool operator==(const BoardInfo3Request&) const = default;
};

[[nodiscard]] constexpr Status decode(std::span<const std::uint8_t> body,
                                      BoardInfo3Request& out) noexcept {
  if (body.size() != 0) return detail::wrong_size(body.size(), 0);
  static_cast<void>(out);
  return {};
}

[[nodiscard]] constexpr WriteResult encode(const BoardInfo3Request& in,
                                           std::span<std::uint8_t> out) noexcept {
  static_cast<void>(in);
  static_cast<void>(out);
  return {0, {}};
}

/// The board is about to restart. Time to close the serial port: the board restarts 1000 ms later,
/// or after the DELAY_MS of the host that asked for the restart.
///
/// CMD_RESET (114), from the board; 0 bytes, and later firmware may append more.
/// Source: Incoming commands L537-L539. Errata: E083, E119.
struct Reset {
  static constexpr CommandFromBoard command = CommandFromBoard::reset;
  static constexpr Direction direction = Direction::from_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 0;
  static constexpr std::size_t max_size = 0;
  static constexpr Availability since{};
  /// What later firmware appends; kept, and written back.
  BoundedBytes<255> tail{};

  constexpr bool operator==(const Reset&) const = default;
};

[[nodiscard]] constexpr Status decode(std::span<const std::uint8_t> body,
                                      Reset& out) noexcept {
  return detail::get_tail(body, 0, out.tail);
}

[[nodiscard]] constexpr WriteResult encode(const Reset& in,
                                           std::span<std::uint8_t> out) noexcept {
  const std::size_t size = 0 + in.tail.size();
  if (out.size() < size) return {0, {Code::buffer_too_small}};
  detail::put_tail(out.data(), in.tail);
  return {size, {}};
}

/// Restart at once and without notice.
///
/// CMD_RESET (114), to the board, simple form; 0 bytes.
/// Effect: restarts.
/// Source: Outgoing commands L670-L677. Errata: E083.
struct ResetRequest {
  static constexpr CommandToBoard command = CommandToBoard::reset;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::simple;
  static constexpr std::size_t min_size = 0;
  static constexpr std::size_t max_size = 0;
  static constexpr Availability since{};
  using Response = void;

  constexpr bool operator==(const ResetRequest&) const = default;
};

[[nodiscard]] constexpr Status decode(std::span<const std::uint8_t> body,
                                      ResetRequest& out) noexcept {
  if (body.size() != 0) return detail::wrong_size(body.size(), 0);
  static_cast<void>(out);
  return {};
}

[[nodiscard]] constexpr WriteResult encode(const ResetRequest& in,
                                           std::span<std::uint8_t> out) noexcept {
  static_cast<void>(in);
  static_cast<void>(out);
  return {0, {}};
}

/// Restart after a while, with notice if that is asked for.
///
/// CMD_RESET (114), to the board, extended form; 3 bytes.
/// Effect: restarts.
/// Source: Outgoing commands L670-L677. Errata: E083.
struct ResetRequestExt {
  static constexpr CommandToBoard command = CommandToBoard::reset;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::extended;
  static constexpr std::size_t min_size = 3;
  static constexpr std::size_t max_size = 3;
  static constexpr Availability since{};
  using Response = sbgc::Maybe<Reset>;

  /// Whether CMD_RESET is sent back first. Errata: E204.
  ResetOptions confirm{};
  /// How long to wait before the restart. Unit: ms. Errata: E083.
  Milliseconds delay_ms{};

  constexpr bool operator==(const ResetRequestExt&) const = default;
};

constexpr void get(const std::uint8_t* SBGC_RESTRICT from,
                   ResetRequestExt& SBGC_RESTRICT out) noexcept {
  get(from, out.confirm);
  get(from + 1, out.delay_ms);
}
constexpr void put(std::uint8_t* SBGC_RESTRICT to,
                   const ResetRequestExt& SBGC_RESTRICT in) noexcept {
  put(to, in.confirm);
  put(to + 1, in.delay_ms);
}

[[nodiscard]] constexpr Status decode(std::span<const std::uint8_t> body,
                                      ResetRequestExt& out) noexcept {
  if (body.size() != 3) return detail::wrong_size(body.size(), 3);
  get(body.data(), out);
  return {};
}

[[nodiscard]] constexpr WriteResult encode(const ResetRequestExt& in,
                                           std::span<std::uint8_t> out) noexcept {
  if (out.size() < 3) return {0, {Code::buffer_too_small}};
  put(out.data(), in);
  return {3, {}};
}

/// Enter the bootloader at once and without notice. The bootloader takes new firmware and none of
/// these commands, and the motors have no power. Nothing says that the board comes back by itself:
/// send this only with new firmware at hand.
///
/// CMD_BOOT_MODE_3 (51), to the board, simple form; 0 bytes.
/// Effect: restarts.
/// Since board 3.0.
/// Source: Outgoing commands L679-L686. Errata: E082.
struct BootMode3 {
  static constexpr CommandToBoard command = CommandToBoard::boot_mode_3;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::simple;
  static constexpr std::size_t min_size = 0;
  static constexpr std::size_t max_size = 0;
  static constexpr Availability since{0, 30};
  using Response = void;

  constexpr bool operator==(const BootMode3&) const = default;
};

[[nodiscard]] constexpr Status decode(std::span<const std::uint8_t> body,
                                      BootMode3& out) noexcept {
  if (body.size() != 0) return detail::wrong_size(body.size(), 0);
  static_cast<void>(out);
  return {};
}

[[nodiscard]] constexpr WriteResult encode(const BootMode3& in,
                                           std::span<std::uint8_t> out) noexcept {
  static_cast<void>(in);
  static_cast<void>(out);
  return {0, {}};
}

/// Enter the bootloader after a while, with notice if that is asked for. The bootloader takes new
/// firmware and none of these commands, and the motors have no power. Nothing says that the board
/// comes back by itself: send this only with new firmware at hand.
///
/// CMD_BOOT_MODE_3 (51), to the board, extended form; 3 bytes.
/// Effect: restarts.
/// Since board 3.0.
/// Source: Outgoing commands L679-L686. Errata: E082.
struct BootMode3Ext {
  static constexpr CommandToBoard command = CommandToBoard::boot_mode_3;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::extended;
  static constexpr std::size_t min_size = 3;
  static constexpr std::size_t max_size = 3;
  static constexpr Availability since{0, 30};
  using Response = sbgc::Maybe<Reset>;

  /// Whether CMD_RESET is sent back first. Errata: E082, E204.
  ResetOptions confirm{};
  /// How long to wait before the bootloader starts. Unit: ms.
  Milliseconds delay_ms{};

  constexpr bool operator==(const BootMode3Ext&) const = default;
};

constexpr void get(const std::uint8_t* SBGC_RESTRICT from,
                   BootMode3Ext& SBGC_RESTRICT out) noexcept {
  get(from, out.confirm);
  get(from + 1, out.delay_ms);
}
constexpr void put(std::uint8_t* SBGC_RESTRICT to,
                   const BootMode3Ext& SBGC_RESTRICT in) noexcept {
  put(to, in.confirm);
  put(to + 1, in.delay_ms);
}

[[nodiscard]] constexpr Status decode(std::span<const std::uint8_t> body,
                                      BootMode3Ext& out) noexcept {
  if (body.size() != 3) return detail::wrong_size(body.size(), 3);
  get(body.data(), out);
  return {};
}

[[nodiscard]] constexpr WriteResult encode(const BootMode3Ext& in,
                                           std::span<std::uint8_t> out) noexcept {
  if (out.size() < 3) return {0, {Code::buffer_too_small}};
  put(out.data(), in);
  return {3, {}};
}

/// Body from the board, not documented.
///
/// CMD_QUEUE_PARAMS_INFO_3 (30), from the board; 0 to 255 bytes.
/// Since board 3.0.
/// Source: Command ID definitions L108.
struct QueueParamsInfo3 {
  static constexpr CommandFromBoard command = CommandFromBoard::queue_params_info_3;
  static constexpr Direction direction = Direction::from_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 0;
  static constexpr std::size_t max_size = 255;
  static constexpr Availability since{0, 30};

  /// Whatever it holds.
  BoundedBytes<255> data{};

  constexpr bool operator==(const QueueParamsInfo3&) const = default;
};

[[nodiscard]] constexpr Status decode(std::span<const std::uint8_t> body,
                                      QueueParamsInfo3& out) noexcept {
  detail::Reader reader(body, 0);
  reader.rest(out.data, "data");
  return reader.end();
}

[[nodiscard]] constexpr WriteResult encode(const QueueParamsInfo3& in,
                                           std::span<std::uint8_t> out) noexcept {
  detail::Writer writer(out, 0);
  writer.array(in.data, "data");
  return writer.end();
}

/// Body to the board, not documented.
///
/// CMD_QUEUE_PARAMS_INFO_3 (30), to the board; 0 to 255 bytes.
/// Effect: unknown.
/// Since board 3.0.
/// Source: Command ID definitions L108.
struct QueueParamsInfo3Request {
  static constexpr CommandToBoard command = CommandToBoard::queue_params_info_3;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 0;
  static constexpr std::size_t max_size = 255;
  static constexpr Availability since{0, 30};
  using Response = void;

  /// Whatever it holds.
  BoundedBytes<255> data{};

  constexpr bool operator==(const QueueParamsInfo3Request&) const = default;
};

[[nodiscard]] constexpr Status decode(std::span<const std::uint8_t> body,
                                      QueueParamsInfo3Request& out) noexcept {
  detail::Reader reader(body, 0);
  reader.rest(out.data, "data");
  return reader.end();
}

[[nodiscard]] constexpr WriteResult encode(const QueueParamsInfo3Request& in,
                                           std::span<std::uint8_t> out) noexcept {
  detail::Writer writer(out, 0);
  writer.array(in.data, "data");
  return writer.end();
}

/// Body from the board, not documented.
///
/// CMD_SYSTEM_STATE (52), from the board; 0 to 255 bytes.
/// Since board 3.0.
/// Source: Command ID definitions L130.
struct SystemState {
  static constexpr CommandFromBoard command = CommandFromBoard::system_state;
  static constexpr Direction direction = Direction::from_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 0;
  static constexpr std::size_t max_size = 255;
  static constexpr Availability since{0, 30};

  /// Whatever it holds.
  BoundedBytes<255> data{};

  constexpr bool operator==(const SystemState&) const = default;
};

[[nodiscard]] constexpr Status decode(std::span<const std::uint8_t> body,
                                      SystemState& out) noexcept {
  detail::Reader reader(body, 0);
  reader.rest(out.data, "data");
  return reader.end();
}

[[nodiscard]] constexpr WriteResult encode(const SystemState& in,
                                           std::span<std::uint8_t> out) noexcept {
  detail::Writer writer(out, 0);
  writer.array(in.data, "data");
  return writer.end();
}

/// Body to the board, not documented.
///
/// CMD_SYSTEM_STATE (52), to the board; 0 to 255 bytes.
/// Effect: unknown.
/// Since board 3.0.
/// Source: Command ID definitions L130.
struct SystemStateRequest {
  static constexpr CommandToBoard command = CommandToBoard::system_state;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 0;
  static constexpr std::size_t max_size = 255;
  static constexpr Availability since{0, 30};
  using Response = void;

  /// Whatever it holds.
  BoundedBytes<255> data{};

  constexpr bool operator==(const SystemStateRequest&) const = default;
};

[[nodiscard]] constexpr Status decode(std::span<const std::uint8_t> body,
                                      SystemStateRequest& out) noexcept {
  detail::Reader reader(body, 0);
  reader.rest(out.data, "data");
  return reader.end();
}

[[nodiscard]] constexpr WriteResult encode(const SystemStateRequest& in,
                                           std::span<std::uint8_t> out) noexcept {
  detail::Writer writer(out, 0);
  writer.array(in.data, "data");
  return writer.end();
}

/// Body from the board, not documented.
///
/// CMD_MAVLINK_INFO (250), from the board; 0 to 255 bytes.
/// Since board 3.0.
/// Source: Command ID definitions L149.
struct MavlinkInfo {
  static constexpr CommandFromBoard command = CommandFromBoard::mavlink_info;
  static constexpr Direction direction = Direction::from_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 0;
  static constexpr std::size_t max_size = 255;
  static constexpr Availability since{0, 30};

  /// Whatever it holds.
  BoundedBytes<255> data{};

  constexpr bool operator==(const MavlinkInfo&) const = default;
};

[[nodiscard]] constexpr Status decode(std::span<const std::uint8_t> body,
                                      MavlinkInfo& out) noexcept {
  detail::Reader reader(body, 0);
  reader.rest(out.data, "data");
  return reader.end();
}

[[nodiscard]] constexpr WriteResult encode(const MavlinkInfo& in,
                                           std::span<std::uint8_t> out) noexcept {
  detail::Writer writer(out, 0);
  writer.array(in.data, "data");
  return writer.end();
}

/// Body to the board, not documented.
///
/// CMD_MAVLINK_INFO (250), to the board; 0 to 255 bytes.
/// Effect: unknown.
/// Since board 3.0.
/// Source: Command ID definitions L149.
struct MavlinkInfoRequest {
  static constexpr CommandToBoard command = CommandToBoard::mavlink_info;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 0;
  static constexpr std::size_t max_size = 255;
  static constexpr Availability since{0, 30};
  using Response = void;

  /// Whatever it holds.
  BoundedBytes<255> data{};

  constexpr bool operator==(const MavlinkInfoRequest&) const = default;
};

[[nodiscard]] constexpr Status decode(std::span<const std::uint8_t> body,
                                      MavlinkInfoRequest& out) noexcept {
  detail::Reader reader(body, 0);
  reader.rest(out.data, "data");
  return reader.end();
}

[[nodiscard]] constexpr WriteResult encode(const MavlinkInfoRequest& in,
                                           std::span<std::uint8_t> out) noexcept {
  detail::Writer writer(out, 0);
  writer.array(in.data, "data");
  return writer.end();
}

/// Body from the board, not documented.
///
/// CMD_MAVLINK_DEBUG (251), from the board; 0 to 255 bytes.
/// Since board 3.0.
/// Source: Command ID definitions L150.
struct MavlinkDebug {
  static constexpr CommandFromBoard command = CommandFromBoard::mavlink_debug;
  static constexpr Direction direction = Direction::from_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 0;
  static constexpr std::size_t max_size = 255;
  static constexpr Availability since{0, 30};

  /// Whatever it holds.
  BoundedBytes<255> data{};

  constexpr bool operator==(const MavlinkDebug&) const = default;
};

[[nodiscard]] constexpr Status decode(std::span<const std::uint8_t> body,
                                      MavlinkDebug& out) noexcept {
  detail::Reader reader(body, 0);
  reader.rest(out.data, "data");
  return reader.end();
}

[[nodiscard]] constexpr WriteResult encode(const MavlinkDebug& in,
                                           std::span<std::uint8_t> out) noexcept {
  detail::Writer writer(out, 0);
  writer.array(in.data, "data");
  return writer.end();
}

/// Body to the board, not documented.
///
/// CMD_MAVLINK_DEBUG (251), to the board; 0 to 255 bytes.
/// Effect: unknown.
/// Since board 3.0.
/// Source: Command ID definitions L150.
struct MavlinkDebugRequest {
  static constexpr CommandToBoard command = CommandToBoard::mavlink_debug;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 0;
  static constexpr std::size_t max_size = 255;
  static constexpr Availability since{0, 30};
  using Response = void;

  /// Whatever it holds.
  BoundedBytes<255> data{};

  constexpr bool operator==(const MavlinkDebugRequest&) const = default;
};

[[nodiscard]] constexpr Status decode(std::span<const std::uint8_t> body,
                                      MavlinkDebugRequest& out) noexcept {
  detail::Reader reader(body, 0);
  reader.rest(out.data, "data");
  return reader.end();
}

[[nodiscard]] constexpr WriteResult encode(const MavlinkDebugRequest& in,
                                           std::span<std::uint8_t> out) noexcept {
  detail::Writer writer(out, 0);
  writer.array(in.data, "data");
  return writer.end();
}

}  // namespace sbgc::msg
