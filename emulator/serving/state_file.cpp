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

#include <sbgc/io/internal/atomic_file.hpp>

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
