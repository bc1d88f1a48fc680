// Generated from spec/ by generator/: edit those, then run ./dev generate.

/// The board's memory: EEPROM, user data and files.
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

struct EepromRead;
struct ReadExternalData;
struct ReadFile;
struct ReadFileError;

/// Write a block to the EEPROM. The EEPROM holds parameters and calibrations. Write only what you
/// read from the same address of the same board: anything else may make the board unusable or move
/// the camera. The example writes back what the example of CMD_EEPROM_READ reads.
///
/// CMD_EEPROM_WRITE (47), to the board; 4 to 196 bytes. Effect: stores, moves. Since board 3.0.
/// Source: Outgoing commands L877-L882.
struct EepromWrite {
  static constexpr CommandToBoard command = CommandToBoard::eeprom_write;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 4;
  static constexpr std::size_t max_size = 196;
  static constexpr Availability since{.board = 30};
  using Response = void;

  /// Address to write to. A multiple of 64.
  std::uint32_t addr{};
  /// Data to write. At most 192. A multiple of 64.
  BoundedBytes<251> data{};

  bool operator==(const EepromWrite&) const = default;
  using FixedMembers = Members<&EepromWrite::addr>;
  SBGC_ALWAYS_INLINE
  static constexpr void varying_members(auto& self, auto& cursor) noexcept {
    cursor.rest(self.data, "data");
  }
};

/// Part of a file.
///
/// CMD_READ_FILE (53), from the board, success form; 4 to 255 bytes. Since board 3.0. Source:
/// Incoming commands L565-L575; Outgoing commands L916-L928.
struct ReadFile {
  static constexpr CommandFromBoard command = CommandFromBoard::read_file;
  static constexpr Direction direction = Direction::from_board;
  static constexpr Form form = Form::success;
  static constexpr std::size_t min_size = 4;
  static constexpr std::size_t max_size = 255;
  static constexpr Availability since{.board = 30};

  /// Size of the whole file. Unit: byte.
  ByteCount file_size{};
  /// Offset of the data in the file, as in the request. Unit: byte.
  Pages page_offset{};
  /// As many bytes as requested, or fewer at the end of the file. At most 251.
  BoundedBytes<251> data{};

  bool operator==(const ReadFile&) const = default;
  using FixedMembers = Members<&ReadFile::file_size, &ReadFile::page_offset>;
  SBGC_ALWAYS_INLINE
  static constexpr void varying_members(auto& self, auto& cursor) noexcept {
    cursor.rest(self.data, "data");
  }
};

/// Why a file could not be read.
///
/// CMD_READ_FILE (53), from the board, error form; 1 byte. Since board 3.0. Source: Incoming
/// commands L565-L575; Outgoing commands L916-L928.
struct ReadFileError {
  static constexpr CommandFromBoard command = CommandFromBoard::read_file;
  static constexpr Direction direction = Direction::from_board;
  static constexpr Form form = Form::error;
  static constexpr std::size_t min_size = 1;
  static constexpr std::size_t max_size = 1;
  static constexpr Availability since{.board = 30};

  /// Error code.
  FileError err_code{};

  bool operator==(const ReadFileError&) const = default;
  using FixedMembers = Members<&ReadFileError::err_code>;
};

/// Read part of a file.
///
/// CMD_READ_FILE (53), to the board; 20 bytes. Effect: reads. Since board 3.0. Source: Outgoing
/// commands L898-L905.
struct ReadFileRequest {
  static constexpr CommandToBoard command = CommandToBoard::read_file;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 20;
  static constexpr std::size_t max_size = 20;
  static constexpr Availability since{.board = 30};
  using Response = sbgc::TypeList<ReadFile, ReadFileError>;

  /// File id.
  std::uint16_t file_id{};
  /// Start of the block. Unit: byte.
  Pages page_offset{};
  /// Maximum number of bytes to read; they must fit into one message. Range: 0 to 251 byte.
  ByteCount max_data_size{};
  /// Reserved; kept as it is.
  Bytes<14> reserved{};

  bool operator==(const ReadFileRequest&) const = default;
  using FixedMembers = Members<&ReadFileRequest::file_id, &ReadFileRequest::page_offset,
      &ReadFileRequest::max_data_size, &ReadFileRequest::reserved>;
};

/// Write part of a file; without data, delete it.
///
/// CMD_WRITE_FILE (54), to the board; 6 to 255 bytes. Effect: stores, erases. Since board 3.0.
/// Source: Outgoing commands L907-L928.
struct WriteFile {
  static constexpr CommandToBoard command = CommandToBoard::write_file;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 6;
  static constexpr std::size_t max_size = 255;
  static constexpr Availability since{.board = 30};
  using Response = void;

  /// File id; a missing file is created.
  std::uint16_t file_id{};
  /// Size of the whole file. Unit: byte.
  ByteCount file_size{};
  /// Start of the block. Unit: byte.
  Pages page_offset{};
  /// Data to write; empty deletes the file. At most 249.
  BoundedBytes<249> data{};

  bool operator==(const WriteFile&) const = default;
  using FixedMembers = Members<&WriteFile::file_id, &WriteFile::file_size, &WriteFile::page_offset>;
  SBGC_ALWAYS_INLINE
  static constexpr void varying_members(auto& self, auto& cursor) noexcept {
    cursor.rest(self.data, "data");
  }
};

/// Delete all files.
///
/// CMD_FS_CLEAR_ALL (55), to the board; 0 bytes. Effect: erases. Since board 3.0. Source: Outgoing
/// commands L930-L932.
struct FsClearAll {
  static constexpr CommandToBoard command = CommandToBoard::fs_clear_all;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 0;
  static constexpr std::size_t max_size = 0;
  static constexpr Availability since{.board = 30};
  using Response = void;

  bool operator==(const FsClearAll&) const = default;
};

/// A block of the EEPROM.
///
/// CMD_EEPROM_READ (48), from the board; 4 to 196 bytes. Since board 3.0. Source: Incoming commands
/// L541-L544.
struct EepromRead {
  static constexpr CommandFromBoard command = CommandFromBoard::eeprom_read;
  static constexpr Direction direction = Direction::from_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 4;
  static constexpr std::size_t max_size = 196;
  static constexpr Availability since{.board = 30};

  /// Address of the block. A multiple of 64.
  std::uint32_t addr{};
  /// Content of the block, as many bytes as requested. At most 192.
  BoundedBytes<251> data{};

  bool operator==(const EepromRead&) const = default;
  using FixedMembers = Members<&EepromRead::addr>;
  SBGC_ALWAYS_INLINE
  static constexpr void varying_members(auto& self, auto& cursor) noexcept {
    cursor.rest(self.data, "data");
  }
};

/// Read a block of the EEPROM.
///
/// CMD_EEPROM_READ (48), to the board; 6 bytes. Effect: reads. Since board 3.0. Source: Outgoing
/// commands L884-L889.
struct EepromReadRequest {
  static constexpr CommandToBoard command = CommandToBoard::eeprom_read;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 6;
  static constexpr std::size_t max_size = 6;
  static constexpr Availability since{.board = 30};
  using Response = EepromRead;

  /// Start of the block. A multiple of 64.
  std::uint32_t addr{};
  /// Number of bytes to read; they must fit into one message. Range: 0 to 192 byte. A multiple of
  /// 64.
  ByteCount size{};

  bool operator==(const EepromReadRequest&) const = default;
  using FixedMembers = Members<&EepromReadRequest::addr, &EepromReadRequest::size>;
};

/// User data in the EEPROM.
///
/// CMD_READ_EXTERNAL_DATA (42), from the board; 128 bytes, and later firmware may append more.
/// Since board 3.0. Source: Incoming commands L501-L503.
struct ReadExternalData {
  static constexpr CommandFromBoard command = CommandFromBoard::read_external_data;
  static constexpr Direction direction = Direction::from_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 128;
  static constexpr std::size_t max_size = 128;
  static constexpr Availability since{.board = 30};

  /// The user data.
  Bytes<128> data{};
  /// Bytes appended by later firmware; preserved and written back.
  BoundedBytes<127> tail{};

  bool operator==(const ReadExternalData&) const = default;
  using FixedMembers = Members<&ReadExternalData::data>;
};

/// Request the user data in the EEPROM.
///
/// CMD_READ_EXTERNAL_DATA (42), to the board; 0 bytes. Effect: reads. Since board 3.0. Source:
/// Outgoing commands L855-L857.
struct ReadExternalDataRequest {
  static constexpr CommandToBoard command = CommandToBoard::read_external_data;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 0;
  static constexpr std::size_t max_size = 0;
  static constexpr Availability since{.board = 30};
  using Response = ReadExternalData;

  bool operator==(const ReadExternalDataRequest&) const = default;
};

/// Store user data in the EEPROM.
///
/// CMD_WRITE_EXTERNAL_DATA (41), to the board; 128 bytes, and later firmware may append more.
/// Effect: stores. Since board 3.0. Source: Outgoing commands L851-L853.
struct WriteExternalData : ReadExternalData {
  static constexpr CommandToBoard command = CommandToBoard::write_external_data;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 128;
  static constexpr std::size_t max_size = 128;
  static constexpr Availability since{.board = 30};
  using Response = void;
  using Body = ReadExternalData;

  bool operator==(const WriteExternalData&) const = default;
};

}  // namespace sbgc::msg
