/// The file that keeps the memory of one emulated board.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "serving/memory_file.hpp"

namespace sbgc::serving {

/// A file that no other emulator uses at the same time: FILE.sbgc-lock beside it says so, and is
/// removed at the end. What it is a symbolic link to is what is read and replaced. Temporary files
/// that an emulator has left behind when it was killed are removed at the beginning.
class StateFile {
 public:
  /// Throws std::runtime_error if another emulator uses the file, or the lock can not be made:
  /// for example, because its name belongs to a file that is no lock.
  explicit StateFile(const std::string& name);
  StateFile(const StateFile&) = delete;
  StateFile& operator=(const StateFile&) = delete;
  ~StateFile();

  /// What the file has; nothing if there is none. Throws std::runtime_error if it can not be used.
  std::optional<SavedMemory> load() const;
  /// Replaces the file in one step.
  Result<void> save(const SavedMemory& saved) const;

 private:
  std::filesystem::path path_;
  std::filesystem::path lock_path_;
  int lock_ = -1;
};

}  // namespace sbgc::serving
