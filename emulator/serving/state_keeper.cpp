#include "serving/state_keeper.hpp"

#include <stdexcept>
#include <utility>

#include <asio/executor_work_guard.hpp>
#include <asio/post.hpp>

namespace sbgc::serving {

StateKeeper::StateKeeper(asio::any_io_executor executor, asio::thread_pool& pool, LiveBoard& board,
                         Save save, hosts::Log warn)
    : executor_(std::move(executor)),
      pool_(pool),
      board_(board),
      save_(std::move(save)),
      warn_(std::move(warn)) {
  const Result<void> result = save_(snapshot());
  if (!result) throw std::runtime_error(result.error().message);
  saved_ = board.memory().revision;
  board.memory_saved(saved_);
}

SavedMemory StateKeeper::snapshot() const {
  return {owner_of(board_.emulator().board().options()), board_.memory()};
}

void StateKeeper::changed() {
  if (!result_.valid()) begin_saving();
}

void StateKeeper::begin_saving() {
  saving_ = board_.memory().revision;
  auto task = std::make_shared<std::packaged_task<Result<void>()>>(
      [save = save_, memory = snapshot()] { return save(memory); });
  result_ = task->get_future();
  // Keeps the executor busy until there is a result.
  asio::post(pool_, [this, task, work = asio::make_work_guard(executor_),
                     alive = std::weak_ptr(is_alive_)]() mutable {
    (*task)();
    asio::post(work.get_executor(), [this, alive = std::move(alive)] {
      if (!alive.expired()) end_saving();
    });
  });
}

void StateKeeper::end_saving() {
  take(result_.get());
  // A revision that could not be saved is retried after the next change and at the end.
  if (!result_.valid() && board_.memory().revision != saving_) begin_saving();
}

bool StateKeeper::take(const Result<void>& result) {
  if (result) {
    saved_ = saving_;
    board_.memory_saved(saving_);
  } else {
    warn_(result.error().message);
    board_.memory_not_saved(saving_);
  }
  return static_cast<bool>(result);
}

bool StateKeeper::finish() {
  if (result_.valid()) take(result_.get());
  while (board_.memory().revision != saved_) {
    if (!result_.valid()) begin_saving();
    if (!take(result_.get())) return false;
  }
  return true;
}

}  // namespace sbgc::serving
