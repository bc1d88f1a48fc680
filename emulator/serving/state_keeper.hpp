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

/// Saves what has changed and then lets the board tell of it. Threads of the pool do so, one at a
/// time for each board, so that no other board waits; what changes meanwhile is saved next.
class StateKeeper {
 public:
  /// Brings a memory to the disk. Called in a thread of the pool.
  using Save = std::function<Result<void>(const SavedMemory&)>;

  /// Saves, so that it is known to work: throws std::runtime_error if it does not. `warn` is told
  /// when it does not any more. The pool ends before what `save` uses, and before the executor.
  StateKeeper(asio::any_io_executor executor, asio::thread_pool& pool, LiveBoard& board, Save save,
              Log warn);
  StateKeeper(const StateKeeper&) = delete;
  StateKeeper& operator=(const StateKeeper&) = delete;
  ~StateKeeper() = default;

  /// The memory has changed.
  void changed();
  /// Saves what is not, when the executor runs no more. False if that fails.
  bool finish();

 private:
  SavedMemory snapshot() const;
  void begin_saving();
  void end_saving();
  /// Takes the result of saving the memory as it was at `saving_`.
  bool take(const Result<void>& result);

  asio::any_io_executor executor_;
  asio::thread_pool& pool_;
  LiveBoard& board_;
  Save save_;
  Log warn_;
  std::uint32_t saving_{};              ///< revision that is being saved
  std::uint32_t saved_{};               ///< last one that has been saved
  std::future<Result<void>> result_{};  ///< valid while something is being saved
  std::shared_ptr<bool> is_alive_ = std::make_shared<bool>(true);
};

}  // namespace sbgc::serving
