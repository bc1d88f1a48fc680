/// The file that keeps the memory of one emulated board.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "serving/memory_file.hpp"

namespace sbgc::serving {

/// A file that one emulator uses at a time: it holds the lock FILE.sbgc-lock and removes it at the
/// end. Symbolic links are followed. Temporary files of a killed emulator are removed at the
/// beginning.
class StateFile {
 public:
  /// Throws std::runtime_error if another emulator uses the file or the lock cannot be created, for
  /// example because a file that is not a lock has its name.
  explicit StateFile(const std::string& name);
  StateFile(const StateFile&) = delete;
  StateFile& operator=(const StateFile&) = delete;
  ~StateFile();

  /// The content of the file; empty if there is none. Throws std::runtime_error if it cannot be
  /// used.
  std::optional<SavedMemory> load() const;
  /// Replaces the file atomically.
  Result<void> save(const SavedMemory& saved) const;

 private:
  std::filesystem::path path_;
  std::filesystem::path lock_path_;
  int lock_ = -1;
};

}  // namespace sbgc::serving
