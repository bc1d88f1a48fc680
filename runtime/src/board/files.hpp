/// The files of the board, in its EEPROM.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <sbgc/enums.hpp>

#include "eeprom.hpp"

namespace sbgc::board {

/// Files by number, in pages of 64 bytes, with a table and a checksum of it in the EEPROM; so
/// damage by CMD_EEPROM_WRITE shows as FileError::fat or ::crc.
class FileSystem {
 public:
  explicit FileSystem(Memory& memory);

  struct Part {
    FileError error{};
    std::uint16_t file_size{};
    std::vector<std::uint8_t> data{};
  };
  /// `page` in pages. Less than `max_size` at the end of the file, nothing behind it.
  Part read(std::uint16_t file, std::uint16_t page, std::size_t max_size) const;
  /// As CMD_WRITE_FILE: makes the file, gives it the size, writes the data; without data deletes
  /// it. A failure changes nothing.
  FileError write(std::uint16_t file, std::uint16_t size, std::uint16_t page,
                  std::span<const std::uint8_t> data);
  FileError clear();
  /// 0 if there is no such file.
  std::uint16_t size(std::uint16_t file) const;
};

}  // namespace sbgc::board
