#include "state_keeper.hpp"

#include <chrono>
#include <stdexcept>
#include <string>
#include <utility>

namespace sbgc::emulate {

namespace {

constexpr auto wait_before_saving = std::chrono::milliseconds(500);

}  // namespace

StateKeeper::StateKeeper(const asio::any_io_executor& executor, LiveBoard& board,
                         std::unique_ptr<StateFile> file, Log warn)
    : board_(board), file_(std::move(file)), timer_(executor) {
  std::string problem;
  warn_ = [&](const std::string& message) { problem = message; };
  if (!save()) throw std::runtime_error(problem);
  warn_ = std::move(warn);
}

void StateKeeper::changed() {
  is_unsaved_ = true;
  if (std::exchange(is_waiting_, true)) return;
  timer_.expires_after(wait_before_saving);
  timer_.async_wait([this](std::error_code error) {
    if (error) return;
    is_waiting_ = false;
    save();
  });
}

bool StateKeeper::finish() { return !is_unsaved_ || save(); }

bool StateKeeper::save() {
  const tools::MemoryOwner owner = tools::owner_of(board_.emulator().board().options());
  const Result<void> saved = file_->save({owner, board_.memory()});
  is_unsaved_ = !saved;
  if (!saved) warn_(saved.error().message);
  return static_cast<bool>(saved);
}

}  // namespace sbgc::emulate
