// Generated from spec/ by generator/: edit those, then run ./dev generate.

/// The board's memory: EEPROM, user data and files.
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

struct EepromRead;
struct ReadExternalData;
struct ReadFile;
struct ReadFileError;

/// Write a block to the EEPROM. Settings and calibrations lie in the EEPROM. Write only what has
/// been read from the same place of the same board: anything else may make it useless, or the
/// camera move. The example writes back what the one of CMD_EEPROM_READ has read.
///
/// CMD_EEPROM_WRITE (47), to the board; 4 to 196 bytes.
/// Effect: stores, moves.
/// Since board 3.0.
/// Source: Outgoing commands L877-L882.
struct EepromWrite {
  static constexpr CommandToBoard command = CommandToBoard::eeprom_write;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 4;
  static constexpr std::size_t max_size = 196;
  static constexpr Availability since{0, 30};
  using Response = void;

  /// Where to write. A multiple of 64.
  std::uint32_t addr{};
  /// What to write. At most 192. A multiple of 64. Errata: E026.
  BoundedBytes<251> data{};

  constexpr bool operator==(const EepromWrite&) const = default;
};

constexpr void get(const std::uint8_t* SBGC_RESTRICT from,
                   EepromWrite& SBGC_RESTRICT out) noexcept {
  get(from, out.addr);
}
constexpr void put(std::uint8_t* SBGC_RESTRICT to,
                   const EepromWrite& SBGC_RESTRICT in) noexcept {
  put(to, in.addr);
}

[[nodiscard]] constexpr Status decode(std::span<const std::uint8_t> body,
                                      EepromWrite& out) noexcept {
  if (body.size() < 4) return detail::wrong_size(body.size(), 4);
  get(body.data(), out);
  detail::Reader reader(body, 4);
  reader.rest(out.data, "data");
  return reader.end();
}

[[nodiscard]] constexpr WriteResult encode(const EepromWrite& in,
                                           std::span<std::uint8_t> out) noexcept {
  if (out.size() < 4) return {0, {Code::buffer_too_small}};
  put(out.data(), in);
  detail::Writer writer(out, 4);
  writer.array(in.data, "data");
  return writer.end();
}

/// Part of a file.
///
/// CMD_READ_FILE (53), from the board, success form; 4 to 255 bytes.
/// Since board 3.0.
/// Source: Incoming commands L565-L575; Outgoing commands L916-L928. Errata: E024.
struct ReadFile {
  static constexpr CommandFromBoard command = CommandFromBoard::read_file;
  static constexpr Direction direction = Direction::from_board;
  static constexpr Form form = Form::success;
  static constexpr std::size_t min_size = 4;
  static constexpr std::size_t max_size = 255;
  static constexpr Availability since{0, 30};

  /// Size of the whole file. Unit: byte.
  ByteCount file_size{};
  /// Where in the file the data begin; as in the request. Unit: byte, one count is 64.
  Pages page_offset{};
  /// As many bytes as were asked for, or less at the end of the file. At most 251. Errata: E026.
  BoundedBytes<251> data{};

  constexpr bool operator==(const ReadFile&) const = default;
};

constexpr void get(const std::uint8_t* SBGC_RESTRICT from,
                   ReadFile& SBGC_RESTRICT out) noexcept {
  get(from, out.file_size);
  get(from + 2, out.page_offset);
}
constexpr void put(std::uint8_t* SBGC_RESTRICT to,
                   const ReadFile& SBGC_RESTRICT in) noexcept {
  put(to, in.file_size);
  put(to + 2, in.page_offset);
}

[[nodiscard]] constexpr Status decode(std::span<const std::uint8_t> body,
                                      ReadFile& out) noexcept {
  if (body.size() < 4) return detail::wrong_size(body.size(), 4);
  get(body.data(), out);
  detail::Reader reader(body, 4);
  reader.rest(out.data, "data");
  return reader.end();
}

[[nodiscard]] constexpr WriteResult encode(const ReadFile& in,
                                           std::span<std::uint8_t> out) noexcept {
  if (out.size() < 4) return {0, {Code::buffer_too_small}};
  put(out.data(), in);
  detail::Writer writer(out, 4);
  writer.array(in.data, "data");
  return writer.end();
}

/// Why a file could not be read.
///
/// CMD_READ_FILE (53), from the board, error form; 1 byte.
/// Since board 3.0.
/// Source: Incoming commands L565-L575; Outgoing commands L916-L928. Errata: E024.
struct ReadFileError {
  static constexpr CommandFromBoard command = CommandFromBoard::read_file;
  static constexpr Direction direction = Direction::from_board;
  static constexpr Form form = Form::error;
  static constexpr std::size_t min_size = 1;
  static constexpr std::size_t max_size = 1;
  static constexpr Availability since{0, 30};

  /// What went wrong.
  FileError err_code{};

  constexpr bool operator==(const ReadFileError&) const = default;
};

constexpr void get(const std::uint8_t* SBGC_RESTRICT from,
                   ReadFileError& SBGC_RESTRICT out) noexcept {
  get(from, out.err_code);
}
constexpr void put(std::uint8_t* SBGC_RESTRICT to,
                   const ReadFileError& SBGC_RESTRICT in) noexcept {
  put(to, in.err_code);
}

[[nodiscard]] constexpr Status decode(std::span<const std::uint8_t> body,
                                      ReadFileError& out) noexcept {
  if (body.size() != 1) return detail::wrong_size(body.size(), 1);
  get(body.data(), out);
  return {};
}

[[nodiscard]] constexpr WriteResult encode(const ReadFileError& in,
                                           std::span<std::uint8_t> out) noexcept {
  if (out.size() < 1) return {0, {Code::buffer_too_small}};
  put(out.data(), in);
  return {1, {}};
}

/// Read part of a file.
///
/// CMD_READ_FILE (53), to the board; 20 bytes.
/// Effect: reads.
/// Since board 3.0.
/// Source: Outgoing commands L898-L905.
struct ReadFileRequest {
  static constexpr CommandToBoard command = CommandToBoard::read_file;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 20;
  static constexpr std::size_t max_size = 20;
  static constexpr Availability since{0, 30};
  using Response = sbgc::TypeList<ReadFile, ReadFileError>;

  /// Which file.
  std::uint16_t file_id{};
  /// Where to begin. Unit: byte, one count is 64.
  Pages page_offset{};
  /// How many bytes to read at most; they must fit into one message. Unit: byte. Range: 0 to 251.
  /// Errata: E026.
  ByteCount max_data_size{};
  /// Reserved; kept as it is.
  Bytes<14> reserved{};

  constexpr bool operator==(const ReadFileRequest&) const = default;
};

constexpr void get(const std::uint8_t* SBGC_RESTRICT from,
                   ReadFileRequest& SBGC_RESTRICT out) noexcept {
  using M = ReadFileRequest;
  if (!std::is_constant_evaluated() &&
      detail::in_parallel(offsetof(M, file_id), offsetof(M, reserved), 6)) {
    detail::get_block(from, out, offsetof(M, file_id), 20);
    return;
  }
  get(from, out.file_id);
  get(from + 2, out.page_offset);
  get(from + 4, out.max_data_size);
  get(from + 6, out.reserved);
}
constexpr void put(std::uint8_t* SBGC_RESTRICT to,
                   const ReadFileRequest& SBGC_RESTRICT in) noexcept {
  using M = ReadFileRequest;
  if (!std::is_constant_evaluated() &&
      detail::in_parallel(offsetof(M, file_id), offsetof(M, reserved), 6)) {
    detail::put_block(to, in, offsetof(M, file_id), 20);
    return;
  }
  put(to, in.file_id);
  put(to + 2, in.page_offset);
  put(to + 4, in.max_data_size);
  put(to + 6, in.reserved);
}

[[nodiscard]] constexpr Status decode(std::span<const std::uint8_t> body,
                                      ReadFileRequest& out) noexcept {
  if (body.size() != 20) return detail::wrong_size(body.size(), 20);
  get(body.data(), out);
  return {};
}

[[nodiscard]] constexpr WriteResult encode(const ReadFileRequest& in,
                                           std::span<std::uint8_t> out) noexcept {
  if (out.size() < 20) return {0, {Code::buffer_too_small}};
  put(out.data(), in);
  return {20, {}};
}

[[gnu::always_inline]] inline bool add_in_memory(detail::ByteSum& sum,
                                                 const ReadFileRequest& in) noexcept {
  using M = ReadFileRequest;
  if (!(detail::in_parallel(offsetof(M, file_id), offsetof(M, reserved), 6))) return false;
  detail::add_block(sum, in, offsetof(M, file_id), 20);
  return true;
}

/// Write part of a file; without data the file is deleted.
///
/// CMD_WRITE_FILE (54), to the board; 6 to 255 bytes.
/// Effect: stores, erases.
/// Since board 3.0.
/// Source: Outgoing commands L907-L928.
struct WriteFile {
  static constexpr CommandToBoard command = CommandToBoard::write_file;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 6;
  static constexpr std::size_t max_size = 255;
  static constexpr Availability since{0, 30};
  using Response = void;

  /// Which file; it is made if there is none.
  std::uint16_t file_id{};
  /// Size that the whole file shall have. Unit: byte.
  ByteCount file_size{};
  /// Where to begin. Unit: byte, one count is 64. Errata: E092.
  Pages page_offset{};
  /// What to write; empty deletes the file. At most 249. Errata: E026.
  BoundedBytes<249> data{};

  constexpr bool operator==(const WriteFile&) const = default;
};

constexpr void get(const std::uint8_t* SBGC_RESTRICT from,
                   WriteFile& SBGC_RESTRICT out) noexcept {
  using M = WriteFile;
  if (!std::is_constant_evaluated() &&
      detail::in_parallel(offsetof(M, file_id), offsetof(M, page_offset), 4)) {
    detail::get_block(from, out, offsetof(M, file_id), 6);
    return;
  }
  get(from, out.file_id);
  get(from + 2, out.file_size);
  get(from + 4, out.page_offset);
}
constexpr void put(std::uint8_t* SBGC_RESTRICT to,
                   const WriteFile& SBGC_RESTRICT in) noexcept {
  using M = WriteFile;
  if (!std::is_constant_evaluated() &&
      detail::in_parallel(offsetof(M, file_id), offsetof(M, page_offset), 4)) {
    detail::put_block(to, in, offsetof(M, file_id), 6);
    return;
  }
  put(to, in.file_id);
  put(to + 2, in.file_size);
  put(to + 4, in.page_offset);
}

[[nodiscard]] constexpr Status decode(std::span<const std::uint8_t> body,
                                      WriteFile& out) noexcept {
  if (body.size() < 6) return detail::wrong_size(body.size(), 6);
  get(body.data(), out);
  detail::Reader reader(body, 6);
  reader.rest(out.data, "data");
  return reader.end();
}

[[nodiscard]] constexpr WriteResult encode(const WriteFile& in,
                                           std::span<std::uint8_t> out) noexcept {
  if (out.size() < 6) return {0, {Code::buffer_too_small}};
  put(out.data(), in);
  detail::Writer writer(out, 6);
  writer.array(in.data, "data");
  return writer.end();
}

/// Delete all files.
///
/// CMD_FS_CLEAR_ALL (55), to the board; 0 bytes.
/// Effect: erases.
/// Since board 3.0.
/// Source: Outgoing commands L930-L932.
struct FsClearAll {
  static constexpr CommandToBoard command = CommandToBoard::fs_clear_all;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 0;
  static constexpr std::size_t max_size = 0;
  static constexpr Availability since{0, 30};
  using Response = void;

  constexpr bool operator==(const FsClearAll&) const = default;
};

[[nodiscard]] constexpr Status decode(std::span<const std::uint8_t> body,
                                      FsClearAll& out) noexcept {
  if (body.size() != 0) return detail::wrong_size(body.size(), 0);
  static_cast<void>(out);
  return {};
}

[[nodiscard]] constexpr WriteResult encode(const FsClearAll& in,
                                           std::span<std::uint8_t> out) noexcept {
  static_cast<void>(in);
  static_cast<void>(out);
  return {0, {}};
}

/// A block of the EEPROM.
///
/// CMD_EEPROM_READ (48), from the board; 4 to 196 bytes.
/// Since board 3.0.
/// Source: Incoming commands L541-L544.
struct EepromRead {
  static constexpr CommandFromBoard command = CommandFromBoard::eeprom_read;
  static constexpr Direction direction = Direction::from_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 4;
  static constexpr std::size_t max_size = 196;
  static constexpr Availability since{0, 30};

  /// Where the block lies. A multiple of 64. Errata: E014.
  std::uint32_t addr{};
  /// What it holds, as many bytes as were asked for. At most 192. Errata: E026.
  BoundedBytes<251> data{};

  constexpr bool operator==(const EepromRead&) const = default;
};

constexpr void get(const std::uint8_t* SBGC_RESTRICT from,
                   EepromRead& SBGC_RESTRICT out) noexcept {
  get(from, out.addr);
}
constexpr void put(std::uint8_t* SBGC_RESTRICT to,
                   const EepromRead& SBGC_RESTRICT in) noexcept {
  put(to, in.addr);
}

[[nodiscard]] constexpr Status decode(std::span<const std::uint8_t> body,
                                      EepromRead& out) noexcept {
  if (body.size() < 4) return detail::wrong_size(body.size(), 4);
  get(body.data(), out);
  detail::Reader reader(body, 4);
  reader.rest(out.data, "data");
  return reader.end();
}

[[nodiscard]] constexpr WriteResult encode(const EepromRead& in,
                                           std::span<std::uint8_t> out) noexcept {
  if (out.size() < 4) return {0, {Code::buffer_too_small}};
  put(out.data(), in);
  detail::Writer writer(out, 4);
  writer.array(in.data, "data");
  return writer.end();
}

/// Read a block of the EEPROM.
///
/// CMD_EEPROM_READ (48), to the board; 6 bytes.
/// Effect: reads.
/// Since board 3.0.
/// Source: Outgoing commands L884-L889.
struct EepromReadRequest {
  static constexpr CommandToBoard command = CommandToBoard::eeprom_read;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 6;
  static constexpr std::size_t max_size = 6;
  static constexpr Availability since{0, 30};
  using Response = EepromRead;

  /// Where to begin. A multiple of 64. Errata: E014.
  std::uint32_t addr{};
  /// How much to read; it must fit into one message. Unit: byte. Range: 0 to 192. A multiple of 64.
  /// Errata: E026, E116.
  ByteCount size{};

  constexpr bool operator==(const EepromReadRequest&) const = default;
};

constexpr void get(const std::uint8_t* SBGC_RESTRICT from,
                   EepromReadRequest& SBGC_RESTRICT out) noexcept {
  get(from, out.addr);
  get(from + 4, out.size);
}
constexpr void put(std::uint8_t* SBGC_RESTRICT to,
                   const EepromReadRequest& SBGC_RESTRICT in) noexcept {
  put(to, in.addr);
  put(to + 4, in.size);
}

[[nodiscard]] constexpr Status decode(std::span<const std::uint8_t> body,
                                      EepromReadRequest& out) noexcept {
  if (body.size() != 6) return detail::wrong_size(body.size(), 6);
  get(body.data(), out);
  return {};
}

[[nodiscard]] constexpr WriteResult encode(const EepromReadRequest& in,
                                           std::span<std::uint8_t> out) noexcept {
  if (out.size() < 6) return {0, {Code::buffer_too_small}};
  put(out.data(), in);
  return {6, {}};
}

/// Data of the user in the EEPROM.
///
/// CMD_READ_EXTERNAL_DATA (42), from the board; 128 bytes, and later firmware may append more.
/// Since board 3.0.
/// Source: Incoming commands L501-L503.
struct ReadExternalData {
  static constexpr CommandFromBoard command = CommandFromBoard::read_external_data;
  static constexpr Direction direction = Direction::from_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 128;
  static constexpr std::size_t max_size = 128;
  static constexpr Availability since{0, 30};

  /// Whatever the user stored.
  Bytes<128> data{};
  /// What later firmware appends; kept, and written back.
  BoundedBytes<127> tail{};

  constexpr bool operator==(const ReadExternalData&) const = default;
};

constexpr void get(const std::uint8_t* SBGC_RESTRICT from,
                   ReadExternalData& SBGC_RESTRICT out) noexcept {
  get(from, out.data);
}
constexpr void put(std::uint8_t* SBGC_RESTRICT to,
                   const ReadExternalData& SBGC_RESTRICT in) noexcept {
  put(to, in.data);
}

[[nodiscard]] constexpr Status decode(std::span<const std::uint8_t> body,
                                      ReadExternalData& out) noexcept {
  if (body.size() < 128) return detail::wrong_size(body.size(), 128);
  get(body.data(), out);
  return detail::get_tail(body, 128, out.tail);
}

[[nodiscard]] constexpr WriteResult encode(const ReadExternalData& in,
                                           std::span<std::uint8_t> out) noexcept {
  const std::size_t size = 128 + in.tail.size();
  if (out.size() < size) return {0, {Code::buffer_too_small}};
  put(out.data(), in);
  detail::put_tail(out.data() + 128, in.tail);
  return {size, {}};
}

/// Ask for the data of the user in the EEPROM.
///
/// CMD_READ_EXTERNAL_DATA (42), to the board; 0 bytes.
/// Effect: reads.
/// Since board 3.0.
/// Source: Outgoing commands L855-L857. Errata: E002.
struct ReadExternalDataRequest {
  static constexpr CommandToBoard command = CommandToBoard::read_external_data;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 0;
  static constexpr std::size_t max_size = 0;
  static constexpr Availability since{0, 30};
  using Response = ReadExternalData;

  constexpr bool operator==(const ReadExternalDataRequest&) const = default;
};

[[nodiscard]] constexpr Status decode(std::span<const std::uint8_t> body,
                                      ReadExternalDataRequest& out) noexcept {
  if (body.size() != 0) return detail::wrong_size(body.size(), 0);
  static_cast<void>(out);
  return {};
}

[[nodiscard]] constexpr WriteResult encode(const ReadExternalDataRequest& in,
                                           std::span<std::uint8_t> out) noexcept {
  static_cast<void>(in);
  static_cast<void>(out);
  return {0, {}};
}

/// Store data of the user in the EEPROM.
///
/// CMD_WRITE_EXTERNAL_DATA (41), to the board; 128 bytes, and later firmware may append more.
/// Effect: stores.
/// Since board 3.0.
/// Source: Outgoing commands L851-L853.
struct WriteExternalData : ReadExternalData {
  static constexpr CommandToBoard command = CommandToBoard::write_external_data;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 128;
  static constexpr std::size_t max_size = 128;
  static constexpr Availability since{0, 30};
  using Response = void;

  constexpr bool operator==(const WriteExternalData&) const = default;
};

}  // namespace sbgc::msg
