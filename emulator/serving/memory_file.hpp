/// The memory of an emulated board as a JSON file.
#pragma once

#include <string>
#include <string_view>

#include <sbgc/emulator/board_options.hpp>
#include <sbgc/emulator/memory.hpp>
#include <sbgc/result.hpp>

namespace sbgc::serving {

/// Identifies the board that owns a memory.
struct MemoryOwner {
  msg::BoardVersion board{};
  msg::FirmwareVersion firmware{};
  Bytes<9> device_id{};
  Bytes<12> mcu_id{};

  bool operator==(const MemoryOwner&) const = default;
};

/// Returns the identity of a board with these options.
MemoryOwner owner_of(const emulator::BoardOptions& options);

struct SavedMemory {
  MemoryOwner owner{};
  emulator::Memory memory{};  ///< the revision is not saved
};

/// Returns the content of a file, with a checksum of all values.
std::string to_json_text(const SavedMemory& saved);
/// Parses the content of a file. Fails with ErrorCode::bad_file, and names the position, if
/// anything is missing, unknown, duplicated, out of range or damaged; with ErrorCode::incompatible
/// if the format is newer.
Result<SavedMemory> parse_memory(std::string_view text);

/// Replaces a file atomically and flushes it to disk. Fails with ErrorCode::invalid if
/// load_memory() would reject it, or with io.
Result<void> save_memory(const std::string& file, const SavedMemory& saved);
/// Fails with ErrorCode::not_found, io, bad_file or incompatible; the message names the file.
Result<SavedMemory> load_memory(const std::string& file);

}  // namespace sbgc::serving
