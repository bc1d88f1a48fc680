#include "serving/state_keeper.hpp"

#include <cerrno>
#include <stdexcept>
#include <system_error>
#include <utility>

#include <asio/executor_work_guard.hpp>
#include <asio/post.hpp>
#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <sbgc/io/internal/atomic_file.hpp>

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

namespace {

[[noreturn]] void fail(const std::string& problem, const std::filesystem::path& path, int number) {
  throw std::runtime_error(
      fmt::format("{} {}: {}", problem, path.string(), std::generic_category().message(number)));
}

/// True if the file may be a lock: locks are empty.
bool is_empty_file(int descriptor) {
  struct stat about {};
  return ::fstat(descriptor, &about) == 0 && S_ISREG(about.st_mode) && about.st_size == 0;
}

}  // namespace

StateFile::StateFile(const std::string& name)
    : path_(sbgc::detail::target_of(name)), lock_path_(path_.string() + ".sbgc-lock") {
  while (true) {
    constexpr mode_t mode = 0644;
    io::detail::Descriptor opened(
        ::open(lock_path_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW, mode));
    if (!opened) fail("cannot write", lock_path_, errno);
    if (!is_empty_file(opened.get())) {
      throw std::runtime_error(
          fmt::format("cannot lock {}: {} is not a lock", name, lock_path_.string()));
    }
    if (::flock(opened.get(), LOCK_EX | LOCK_NB) != 0) {
      if (errno != EWOULDBLOCK) fail("cannot lock", lock_path_, errno);
      throw std::runtime_error(fmt::format("{} is in use by another emulator", name));
    }
    if (!sbgc::detail::is_at(opened.get(), lock_path_)) continue;  // it has just been removed
    lock_ = std::move(opened);
    return;
  }
}

StateFile::~StateFile() {
  if (sbgc::detail::is_at(lock_.get(), lock_path_)) ::unlink(lock_path_.c_str());
}

std::optional<SavedMemory> StateFile::load() const {
  Result<SavedMemory> loaded = load_memory(path_);
  if (loaded) return std::move(*loaded);
  if (loaded.error().code == ErrorCode::not_found) return std::nullopt;
  throw std::runtime_error(loaded.error().message);
}

Result<void> StateFile::save(const SavedMemory& saved) const { return save_memory(path_, saved); }

}  // namespace sbgc::serving
