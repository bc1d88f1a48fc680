/// The files of the board, stored in its EEPROM.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include <sbgc/enums.hpp>

#include "device/storage/eeprom.hpp"

namespace sbgc::emulator {

/// Files by id, in pages of 64 bytes, with a table and checksums in the EEPROM. Damage by
/// CMD_EEPROM_WRITE results in FileError::fat (the table) or ::crc (one file).
///
/// Assumptions, because the specification is silent: the table has room for 32 files; each occupies
/// whole pages, one file after the other. Erased memory holds no files. If the table is damaged,
/// only clear() works; a damaged file can only be deleted.
class FileSystem {
 public:
  static constexpr std::size_t most_files = 32;

  explicit FileSystem(Memory& memory);

  struct Part {
    msg::FileError error{};
    std::uint16_t file_size{};
    std::vector<std::uint8_t> data{};
  };
  /// Reads from this page: less than `max_size` bytes at the end of the file, none past it.
  Part read(std::uint16_t file, std::uint16_t page, std::size_t max_size) const;
  /// Implements CMD_WRITE_FILE: creates the file, resizes it and writes the data; without data
  /// deletes it. New bytes that are not written are 0. A failure changes nothing: file_not_found if
  /// there is no file to delete, file_size if the data exceed `size`, fat_is_full if there are
  /// already most_files, no_free_space if the file does not fit.
  msg::FileError write(std::uint16_t file, std::uint16_t size, std::uint16_t page,
                       std::span<const std::uint8_t> data);
  /// Deletes all files and repairs the table.
  msg::FileError clear();
  /// Returns 0 if there is no such file.
  std::uint16_t size(std::uint16_t file) const;

 private:
  struct File {
    std::uint16_t id{};
    std::uint32_t checksum{};
    std::vector<std::uint8_t> content{};
  };

  /// Returns nothing if the table is damaged.
  std::optional<std::vector<File>> load() const;
  void store(const std::vector<File>& files);

  Eeprom eeprom_;
};

}  // namespace sbgc::emulator
