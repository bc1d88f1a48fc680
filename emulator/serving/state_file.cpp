#include "serving/state_file.hpp"

#include <cerrno>
#include <stdexcept>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <sbgc/client/atomic_file.hpp>

namespace sbgc::serving {

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

/// True if the open file still has this path.
bool is_at(int descriptor, const std::filesystem::path& path) {
  struct stat opened {};
  struct stat named {};
  return ::fstat(descriptor, &opened) == 0 && ::lstat(path.c_str(), &named) == 0 &&
         opened.st_dev == named.st_dev && opened.st_ino == named.st_ino;
}

}  // namespace

StateFile::StateFile(const std::string& name)
    : path_(sbgc::detail::target_of(name)), lock_path_(path_.string() + ".sbgc-lock") {
  while (true) {
    constexpr mode_t mode = 0644;
    const int opened = ::open(lock_path_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW, mode);
    if (opened < 0) fail("cannot write", lock_path_, errno);
    if (!is_empty_file(opened)) {
      ::close(opened);
      throw std::runtime_error(
          fmt::format("cannot lock {}: {} is not a lock", name, lock_path_.string()));
    }
    if (::flock(opened, LOCK_EX | LOCK_NB) != 0) {
      const int number = errno;
      ::close(opened);
      if (number != EWOULDBLOCK) fail("cannot lock", lock_path_, number);
      throw std::runtime_error(fmt::format("{} is in use by another emulator", name));
    }
    if (is_at(opened, lock_path_)) {
      lock_ = opened;
      return;
    }
    ::close(opened);  // its emulator has just removed it
  }
}

StateFile::~StateFile() {
  if (is_at(lock_, lock_path_)) ::unlink(lock_path_.c_str());
  ::close(lock_);
}

std::optional<SavedMemory> StateFile::load() const {
  Result<SavedMemory> loaded = load_memory(path_);
  if (loaded) return std::move(*loaded);
  if (loaded.error().code == ErrorCode::not_found) return std::nullopt;
  throw std::runtime_error(loaded.error().message);
}

Result<void> StateFile::save(const SavedMemory& saved) const { return save_memory(path_, saved); }

}  // namespace sbgc::serving
