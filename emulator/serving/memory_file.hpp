/// The memory of an emulated board as a JSON file.
#pragma once

#include <string>
#include <string_view>

#include <sbgc/client/result.hpp>
#include <sbgc/emulator/board_options.hpp>
#include <sbgc/emulator/memory.hpp>

namespace sbgc::serving {

/// Which board the memory belongs to.
struct MemoryOwner {
  msg::BoardVersion board{};
  msg::FirmwareVersion firmware{};
  Bytes<9> device_id{};
  Bytes<12> mcu_id{};

  bool operator==(const MemoryOwner&) const = default;
};

/// The owner that is a board with these options.
MemoryOwner owner_of(const emulator::BoardOptions& options);

struct SavedMemory {
  MemoryOwner owner{};
  emulator::Memory memory{};  ///< its revision is not saved
};

/// The content of a file, with a checksum over all values.
std::string to_json_text(const SavedMemory& saved);
/// Memory from the content of a file. ErrorCode::bad_file with the place if anything is missing,
/// unknown, duplicated, out of range or damaged; ErrorCode::incompatible if the format is newer.
Result<SavedMemory> parse_memory(std::string_view text);

/// Replaces a file atomically; it is on the disk when this returns. ErrorCode::invalid if
/// load_memory() would not accept it, io.
Result<void> save_memory(const std::string& file, const SavedMemory& saved);
/// ErrorCode::not_found, io, bad_file or incompatible; the message names the file.
Result<SavedMemory> load_memory(const std::string& file);

}  // namespace sbgc::serving
