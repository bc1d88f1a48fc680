/// The file that stores the memory of one emulated board.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include <sbgc/io/internal/descriptor.hpp>

#include "serving/memory_file.hpp"

namespace sbgc::serving {

/// A file that only one emulator uses at a time: it holds the lock FILE.sbgc-lock and removes it at
/// the end. Follows symbolic links. The constructor removes temporary files of killed emulators.
class StateFile {
 public:
  /// Throws std::runtime_error if another emulator uses the file or the lock cannot be created, for
  /// example because a file with its name is not a lock.
  explicit StateFile(const std::string& name);
  StateFile(const StateFile&) = delete;
  StateFile& operator=(const StateFile&) = delete;
  ~StateFile();

  /// Returns the content of the file; nothing if there is no file. Throws std::runtime_error if the
  /// file cannot be used.
  std::optional<SavedMemory> load() const;
  /// Replaces the file atomically.
  Result<void> save(const SavedMemory& saved) const;

 private:
  std::filesystem::path path_;
  std::filesystem::path lock_path_;
  io::detail::Descriptor lock_{};
};

}  // namespace sbgc::serving
