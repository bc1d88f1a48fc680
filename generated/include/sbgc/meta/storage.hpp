// Generated from spec/ by generator/: edit those, then run ./dev generate.

/// Run-time metadata of the messages in <sbgc/messages/storage.hpp>.
#pragma once

#include <cstddef>

#include <sbgc/internal/table.hpp>
#include <sbgc/messages/storage.hpp>
#include <sbgc/meta.hpp>
#include <sbgc/meta/enums.hpp>
#include <sbgc/meta/units.hpp>

namespace sbgc {

template <>
struct Meta<msg::EepromWrite> {
  static constexpr MessageInfo info{
      .name = "EepromWrite", .command = "CMD_EEPROM_WRITE",
      .summary = "Write a block to the EEPROM.", .id = 47, .direction = Direction::to_board,
      .min_size = 4, .max_size = 196, .since = {.board = 30},
      .effects = Effects(Effect::stores) | Effect::moves};
  static constexpr FieldInfo fields[] = {
      {.name = "addr", .spec_name = "ADDR", .summary = "Address to write to.", .align = 64},
      {.name = "data", .spec_name = "DATA", .summary = "Data to write.", .max_count = 192,
       .align = 64},
  };
  template <class T> static constexpr detail::Slot slots[] = {
      {offsetof(T, addr), &detail::value_type<decltype(T::addr)>},
      {offsetof(T, data), &detail::value_type<decltype(T::data)>},
  };

  static constexpr void visit(auto& value, auto&& visitor) {
    visitor(fields[0], value.addr);
    visitor(fields[1], value.data);
  }
};

template <>
struct Meta<msg::ReadFile> {
  static constexpr MessageInfo info{
      .name = "ReadFile", .command = "CMD_READ_FILE", .summary = "Part of a file.", .id = 53,
      .direction = Direction::from_board, .min_size = 4, .max_size = 255, .since = {.board = 30}};
  static constexpr FieldInfo fields[] = {
      {.name = "file_size", .spec_name = "FILE_SIZE", .summary = "Size of the whole file.",
       .unit = &UnitMeta<msg::ByteCount>::info},
      {.name = "page_offset", .spec_name = "PAGE_OFFSET",
       .summary = "Offset of the data in the file, as in the request.",
       .unit = &UnitMeta<msg::Pages>::info},
      {.name = "data", .spec_name = "DATA",
       .summary = "As many bytes as requested, or fewer at the end of the file.", .max_count = 251},
  };
  template <class T> static constexpr detail::Slot slots[] = {
      {offsetof(T, file_size), &detail::value_type<decltype(T::file_size)>},
      {offsetof(T, page_offset), &detail::value_type<decltype(T::page_offset)>},
      {offsetof(T, data), &detail::value_type<decltype(T::data)>},
  };

  static constexpr void visit(auto& value, auto&& visitor) {
    visitor(fields[0], value.file_size);
    visitor(fields[1], value.page_offset);
    visitor(fields[2], value.data);
  }
};

template <>
struct Meta<msg::ReadFileError> {
  static constexpr MessageInfo info{
      .name = "ReadFileError", .command = "CMD_READ_FILE",
      .summary = "Why a file could not be read.", .id = 53, .direction = Direction::from_board,
      .min_size = 1, .max_size = 1, .since = {.board = 30}};
  static constexpr FieldInfo fields[] = {
      {.name = "err_code", .spec_name = "ERR_CODE", .summary = "Error code."},
  };
  template <class T> static constexpr detail::Slot slots[] = {
      {offsetof(T, err_code), &detail::value_type<decltype(T::err_code)>},
  };

  static constexpr void visit(auto& value, auto&& visitor) {
    visitor(fields[0], value.err_code);
  }
};

template <>
struct Meta<msg::ReadFileRequest> {
  static constexpr const char* answers[] = {"ReadFile", "ReadFileError"};
  static constexpr MessageInfo info{
      .name = "ReadFileRequest", .command = "CMD_READ_FILE", .summary = "Read part of a file.",
      .id = 53, .direction = Direction::to_board, .min_size = 20, .max_size = 20,
      .since = {.board = 30}, .answers = answers, .effects = Effects(Effect::reads)};
  static constexpr Range max_data_size_range{0, 251};
  static constexpr FieldInfo fields[] = {
      {.name = "file_id", .spec_name = "FILE_ID", .summary = "File id."},
      {.name = "page_offset", .spec_name = "PAGE_OFFSET", .summary = "Start of the block.",
       .unit = &UnitMeta<msg::Pages>::info},
      {.name = "max_data_size", .spec_name = "MAX_SIZE",
       .summary = "Maximum number of bytes to read; they must fit into one message.",
       .unit = &UnitMeta<msg::ByteCount>::info, .range = &max_data_size_range},
      {.name = "reserved", .spec_name = "RESERVED", .summary = "Reserved; kept as it is.",
       .reserved = true},
  };
  template <class T> static constexpr detail::Slot slots[] = {
      {offsetof(T, file_id), &detail::value_type<decltype(T::file_id)>},
      {offsetof(T, page_offset), &detail::value_type<decltype(T::page_offset)>},
      {offsetof(T, max_data_size), &detail::value_type<decltype(T::max_data_size)>},
      {offsetof(T, reserved), &detail::value_type<decltype(T::reserved)>},
  };

  static constexpr void visit(auto& value, auto&& visitor) {
    visitor(fields[0], value.file_id);
    visitor(fields[1], value.page_offset);
    visitor(fields[2], value.max_data_size);
    visitor(fields[3], value.reserved);
  }
};

template <>
struct Meta<msg::WriteFile> {
  static constexpr MessageInfo info{
      .name = "WriteFile", .command = "CMD_WRITE_FILE",
      .summary = "Write part of a file; without data, delete it.", .id = 54,
      .direction = Direction::to_board, .min_size = 6, .max_size = 255, .since = {.board = 30},
      .effects = Effects(Effect::stores) | Effect::erases};
  static constexpr FieldInfo fields[] = {
      {.name = "file_id", .spec_name = "FILE_ID", .summary = "File id; a missing file is created."},
      {.name = "file_size", .spec_name = "FILE_SIZE", .summary = "Size of the whole file.",
       .unit = &UnitMeta<msg::ByteCount>::info},
      {.name = "page_offset", .spec_name = "PAGE_OFFSET", .summary = "Start of the block.",
       .unit = &UnitMeta<msg::Pages>::info},
      {.name = "data", .spec_name = "DATA", .summary = "Data to write; empty deletes the file.",
       .max_count = 249},
  };
  template <class T> static constexpr detail::Slot slots[] = {
      {offsetof(T, file_id), &detail::value_type<decltype(T::file_id)>},
      {offsetof(T, file_size), &detail::value_type<decltype(T::file_size)>},
      {offsetof(T, page_offset), &detail::value_type<decltype(T::page_offset)>},
      {offsetof(T, data), &detail::value_type<decltype(T::data)>},
  };

  static constexpr void visit(auto& value, auto&& visitor) {
    visitor(fields[0], value.file_id);
    visitor(fields[1], value.file_size);
    visitor(fields[2], value.page_offset);
    visitor(fields[3], value.data);
  }
};

template <>
struct Meta<msg::FsClearAll> {
  static constexpr MessageInfo info{
      .name = "FsClearAll", .command = "CMD_FS_CLEAR_ALL", .summary = "Delete all files.", .id = 55,
      .direction = Direction::to_board, .min_size = 0, .max_size = 0, .since = {.board = 30},
      .effects = Effects(Effect::erases)};

  static constexpr void visit(auto&, auto&&) {
  }
};

template <>
struct Meta<msg::EepromRead> {
  static constexpr MessageInfo info{
      .name = "EepromRead", .command = "CMD_EEPROM_READ", .summary = "A block of the EEPROM.",
      .id = 48, .direction = Direction::from_board, .min_size = 4, .max_size = 196,
      .since = {.board = 30}};
  static constexpr FieldInfo fields[] = {
      {.name = "addr", .spec_name = "ADDR", .summary = "Address of the block.", .align = 64},
      {.name = "data", .spec_name = "DATA",
       .summary = "Content of the block, as many bytes as requested.", .max_count = 192},
  };
  template <class T> static constexpr detail::Slot slots[] = {
      {offsetof(T, addr), &detail::value_type<decltype(T::addr)>},
      {offsetof(T, data), &detail::value_type<decltype(T::data)>},
  };

  static constexpr void visit(auto& value, auto&& visitor) {
    visitor(fields[0], value.addr);
    visitor(fields[1], value.data);
  }
};

template <>
struct Meta<msg::EepromReadRequest> {
  static constexpr const char* answers[] = {"EepromRead"};
  static constexpr MessageInfo info{
      .name = "EepromReadRequest", .command = "CMD_EEPROM_READ",
      .summary = "Read a block of the EEPROM.", .id = 48, .direction = Direction::to_board,
      .min_size = 6, .max_size = 6, .since = {.board = 30}, .answers = answers,
      .effects = Effects(Effect::reads)};
  static constexpr Range size_range{0, 192};
  static constexpr FieldInfo fields[] = {
      {.name = "addr", .spec_name = "ADDR", .summary = "Start of the block.", .align = 64},
      {.name = "size", .spec_name = "SIZE",
       .summary = "Number of bytes to read; they must fit into one message.",
       .unit = &UnitMeta<msg::ByteCount>::info, .range = &size_range, .align = 64},
  };
  template <class T> static constexpr detail::Slot slots[] = {
      {offsetof(T, addr), &detail::value_type<decltype(T::addr)>},
      {offsetof(T, size), &detail::value_type<decltype(T::size)>},
  };

  static constexpr void visit(auto& value, auto&& visitor) {
    visitor(fields[0], value.addr);
    visitor(fields[1], value.size);
  }
};

template <>
struct Meta<msg::ReadExternalData> {
  static constexpr MessageInfo info{
      .name = "ReadExternalData", .command = "CMD_READ_EXTERNAL_DATA",
      .summary = "User data in the EEPROM.", .id = 42, .direction = Direction::from_board,
      .min_size = 128, .max_size = 128, .since = {.board = 30}};
  static constexpr FieldInfo fields[] = {
      {.name = "data", .spec_name = "data", .summary = "The user data."},
  };
  template <class T> static constexpr detail::Slot slots[] = {
      {offsetof(T, data), &detail::value_type<decltype(T::data)>},
  };

  static constexpr void visit(auto& value, auto&& visitor) {
    visitor(fields[0], value.data);
    visitor(tail_field, value.tail);
  }
};

template <>
struct Meta<msg::ReadExternalDataRequest> {
  static constexpr const char* answers[] = {"ReadExternalData"};
  static constexpr MessageInfo info{
      .name = "ReadExternalDataRequest", .command = "CMD_READ_EXTERNAL_DATA",
      .summary = "Request the user data in the EEPROM.", .id = 42, .direction = Direction::to_board,
      .min_size = 0, .max_size = 0, .since = {.board = 30}, .answers = answers,
      .effects = Effects(Effect::reads)};

  static constexpr void visit(auto&, auto&&) {
  }
};

template <>
struct Meta<msg::WriteExternalData> : Meta<msg::ReadExternalData> {
  static constexpr MessageInfo info{
      .name = "WriteExternalData", .command = "CMD_WRITE_EXTERNAL_DATA",
      .summary = "Store user data in the EEPROM.", .id = 41, .direction = Direction::to_board,
      .min_size = 128, .max_size = 128, .since = {.board = 30}, .stores = "ReadExternalData",
      .effects = Effects(Effect::stores)};
};

}  // namespace sbgc
