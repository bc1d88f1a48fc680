/// Keeps the memory of a board in its file.
#pragma once

#include <memory>

#include <asio/any_io_executor.hpp>
#include <asio/steady_timer.hpp>

#include "endpoint.hpp"
#include "live_board.hpp"
#include "state_file.hpp"

namespace sbgc::emulate {

class StateKeeper {
 public:
  /// Writes the file, so that it is known to work: throws std::runtime_error if it does not.
  /// `warn` is told when it does not any more.
  StateKeeper(const asio::any_io_executor& executor, LiveBoard& board,
              std::unique_ptr<StateFile> file, Log warn);

  /// The memory has changed: it is saved some moments later, with what changes meanwhile.
  void changed();
  /// Saves what is not. False if that fails.
  bool finish();

 private:
  bool save();

  LiveBoard& board_;
  std::unique_ptr<StateFile> file_;
  Log warn_;
  asio::steady_timer timer_;
  bool is_waiting_ = false;
  bool is_unsaved_ = false;
};

}  // namespace sbgc::emulate
