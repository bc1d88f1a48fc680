/// Keeps the memory of a board in its file.
#pragma once

#include <cstdint>
#include <functional>
#include <future>
#include <memory>

#include <asio/any_io_executor.hpp>
#include <asio/thread_pool.hpp>

#include "serving/endpoint.hpp"
#include "serving/live_board.hpp"
#include "serving/memory_file.hpp"

namespace sbgc::serving {

/// Saves changes and then lets the board report them. Threads of the pool do the saving, one at a
/// time for each board, so that no other board waits; further changes are saved next.
class StateKeeper {
 public:
  /// Writes a memory to the disk. Called in a thread of the pool.
  using Save = std::function<Result<void>(const SavedMemory&)>;

  /// Saves once, to be sure that it works: throws std::runtime_error if it does not. Calls `warn`
  /// when it fails later. The pool must end before what `save` uses, and before the executor.
  StateKeeper(asio::any_io_executor executor, asio::thread_pool& pool, LiveBoard& board, Save save,
              Log warn);
  StateKeeper(const StateKeeper&) = delete;
  StateKeeper& operator=(const StateKeeper&) = delete;
  ~StateKeeper() = default;

  /// The memory has changed.
  void changed();
  /// Saves remaining changes, after the executor has stopped. False if that fails.
  bool finish();

 private:
  SavedMemory snapshot() const;
  void begin_saving();
  void end_saving();
  /// Takes the result of saving the revision `saving_`.
  bool take(const Result<void>& result);

  asio::any_io_executor executor_;
  asio::thread_pool& pool_;
  LiveBoard& board_;
  Save save_;
  Log warn_;
  std::uint32_t saving_{};              ///< revision that is being saved
  std::uint32_t saved_{};               ///< last saved revision
  std::future<Result<void>> result_{};  ///< valid while something is being saved
  std::shared_ptr<bool> is_alive_ = std::make_shared<bool>(true);
};

}  // namespace sbgc::serving
