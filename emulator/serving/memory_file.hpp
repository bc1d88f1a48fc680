/// The memory of an emulated board as a JSON file.
#pragma once

#include <string>
#include <string_view>

#include <sbgc/client/result.hpp>
#include <sbgc/emulator/board_options.hpp>
#include <sbgc/emulator/memory.hpp>

namespace sbgc::serving {

/// Which board it is.
struct MemoryOwner {
  msg::BoardVersion board{};
  msg::FirmwareVersion firmware{};
  Bytes<9> device_id{};
  Bytes<12> mcu_id{};

  bool operator==(const MemoryOwner&) const = default;
};

/// That of a board with these options.
MemoryOwner owner_of(const emulator::BoardOptions& options);

struct SavedMemory {
  MemoryOwner owner{};
  emulator::Memory memory{};  ///< its revision is not saved
};

/// The content of a file. It has a checksum over all values, so that none can change unnoticed.
std::string to_json_text(const SavedMemory& saved);
/// Memory from the content of a file. ErrorCode::bad_file with the place if anything in it is
/// missing, unknown, there twice, out of range or damaged, ErrorCode::incompatible if the format is
/// a newer one.
Result<SavedMemory> parse_memory(std::string_view text);

/// Replaces a file in one step: at any moment it is the old one or the whole new one, on the disk
/// when this returns. ErrorCode::invalid if load_memory() would not take it, io.
Result<void> save_memory(const std::string& file, const SavedMemory& saved);
/// ErrorCode::not_found, io, bad_file or incompatible; the message names the file.
Result<SavedMemory> load_memory(const std::string& file);

}  // namespace sbgc::serving
