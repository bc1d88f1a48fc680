/// The file that stores the memory of one emulated board, and saving to it.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <future>
#include <memory>
#include <optional>
#include <string>

#include <asio/any_io_executor.hpp>
#include <asio/thread_pool.hpp>

#include <sbgc/io/internal/descriptor.hpp>

#include "hosts/endpoint.hpp"
#include "serving/live_board.hpp"
#include "serving/memory_file.hpp"

namespace sbgc::serving {

/// Saves changes, then lets the board report them. Threads of the pool do the saving, one at a time
/// per board, so that other boards do not wait. Changes that arrive meanwhile are saved next.
class StateKeeper {
 public:
  /// Writes a memory to disk. Called on a thread of the pool.
  using Save = std::function<Result<void>(const SavedMemory&)>;

  /// Saves once to detect problems early: throws std::runtime_error if that fails. Calls `warn` on
  /// later failures. The pool must be destroyed before the executor and before anything that `save`
  /// uses.
  StateKeeper(asio::any_io_executor executor, asio::thread_pool& pool, LiveBoard& board, Save save,
              hosts::Log warn);
  StateKeeper(const StateKeeper&) = delete;
  StateKeeper& operator=(const StateKeeper&) = delete;
  ~StateKeeper() = default;

  /// Call when the memory has changed.
  void changed();
  /// Saves the remaining changes after the executor has stopped. Returns false if that fails.
  bool finish();

 private:
  SavedMemory snapshot() const;
  void begin_saving();
  void end_saving();
  /// Handles the result of saving the revision `saving_`.
  bool take(const Result<void>& result);

  asio::any_io_executor executor_;
  asio::thread_pool& pool_;
  LiveBoard& board_;
  Save save_;
  hosts::Log warn_;
  std::uint32_t saving_{};              ///< revision being saved
  std::uint32_t saved_{};               ///< last saved revision
  std::future<Result<void>> result_{};  ///< valid while a save is running
  std::shared_ptr<bool> is_alive_ = std::make_shared<bool>(true);
};

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
