#include <array>
#include <atomic>
#include <cerrno>
#include <cstdio>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <sbgc/internal/foreign_kind.hpp>
#include <sbgc/io/internal/atomic_file.hpp>
#include <sbgc/io/internal/descriptor.hpp>
#include <sbgc/io/internal/own_file.hpp>

namespace sbgc::detail {

bool is_at(int descriptor, const std::filesystem::path& path) {
  struct stat opened {};
  struct stat named {};
  return ::fstat(descriptor, &opened) == 0 && S_ISREG(opened.st_mode) &&
         ::lstat(path.c_str(), &named) == 0 && opened.st_dev == named.st_dev &&
         opened.st_ino == named.st_ino;
}

namespace {

ClientError io_error(const std::string& what, const std::filesystem::path& file, int number) {
  const std::string reason = std::generic_category().message(number);
  const ErrorCode code = number == ENOENT ? ErrorCode::not_found : ErrorCode::io;
  return {code, what + " " + file.string() + ": " + reason, number};
}

using io::detail::Descriptor;

/// Unlinks a file on destruction, unless it was renamed.
class TemporaryFile {
 public:
  explicit TemporaryFile(std::filesystem::path path) noexcept : path_(std::move(path)) {}
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;
  TemporaryFile(TemporaryFile&&) = delete;
  TemporaryFile& operator=(TemporaryFile&&) = delete;
  ~TemporaryFile() { ::unlink(path_.c_str()); }

 private:
  std::filesystem::path path_;
};

std::filesystem::path folder_of(const std::filesystem::path& file) {
  const std::filesystem::path folder = file.parent_path();
  return folder.empty() ? std::filesystem::path(".") : folder;
}

constexpr std::string_view ending = ".sbgc-tmp";

std::filesystem::path name_beside(const std::filesystem::path& file) {
  static std::atomic<unsigned> number{0};
  std::filesystem::path result = file;
  result += "." + std::to_string(::getpid()) + "-" + std::to_string(number++) + std::string(ending);
  return result;
}

/// True if name_beside() can have made the name.
bool is_temporary(std::string_view name) {
  if (!name.ends_with(ending)) return false;
  name.remove_suffix(ending.size());
  const auto drop_number_after = [&](char mark) {
    const std::size_t end = name.find_last_not_of("0123456789");
    const bool is_there =
        end != std::string_view::npos && end + 1 < name.size() && name[end] == mark;
    if (is_there) name = name.substr(0, end);
    return is_there;
  };
  return drop_number_after('-') && drop_number_after('.') && !name.empty();
}

/// Creates a file next to `file`. Returns its descriptor, or -1. A name may already exist, left by
/// a killed process with the same id. The lock marks the file as in use; a cleanup that took the
/// lock before us has removed the file. Without lock support nobody removes anything.
int open_beside(const std::filesystem::path& file, std::filesystem::path& path) {
  constexpr mode_t mode = 0644;
  constexpr int most_names = 1000;
  for (int i = 0; i < most_names; ++i) {
    path = name_beside(file);
    const int opened = ::open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, mode);
    if (opened < 0 && errno != EEXIST) return opened;
    if (opened < 0) continue;
    // Another process that is cleaning up holds the lock and removes the file.
    const bool is_locked = ::flock(opened, LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK;
    if (is_locked && is_at(opened, path)) return opened;
    ::close(opened);
  }
  return -1;
}

/// Gives a new file the mode of the file that it replaces and, if permitted, its owner and group.
/// Never grants more rights than before.
void keep_rights(int descriptor, const std::filesystem::path& replaced) {
  struct stat old {};
  if (::stat(replaced.c_str(), &old) != 0 || !S_ISREG(old.st_mode)) return;
  mode_t mode = old.st_mode & (S_IRWXU | S_IRWXG | S_IRWXO);
  constexpr uid_t same_owner = ~uid_t{0};
  if (::fchown(descriptor, old.st_uid, old.st_gid) != 0 &&
      ::fchown(descriptor, same_owner, old.st_gid) != 0) {
    // The file keeps an arbitrary group, which gets no more rights than others.
    mode &= ~static_cast<mode_t>(S_IRWXG) | ((mode & S_IRWXO) << 3U);
  }
  ::fchmod(descriptor, mode);
}

bool write_all(int descriptor, std::string_view content) {
  while (!content.empty()) {
    const ssize_t written = ::write(descriptor, content.data(), content.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return false;
    content.remove_prefix(static_cast<std::size_t>(written));
  }
  return true;
}

/// Renames a file unless the destination exists. Returns an error number, or 0.
int move_without_replacing(const std::filesystem::path& from, const std::filesystem::path& to) {
  if (::renameat2(AT_FDCWD, from.c_str(), AT_FDCWD, to.c_str(), RENAME_NOREPLACE) == 0) return 0;
  if (errno != EINVAL && errno != ENOSYS) return errno;
  // Unsupported by this file system. A link also fails atomically if the destination exists.
  return ::link(from.c_str(), to.c_str()) == 0 ? 0 : errno;
}

/// Flushes the entries of a folder to disk.
Result<void> sync_folder(const std::filesystem::path& folder) {
  const Descriptor opened(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (!opened || ::fsync(opened.get()) != 0) {
    return io_error("cannot flush to disk:", folder, errno);
  }
  return {};
}

}  // namespace

std::filesystem::path target_of(std::filesystem::path file) {
  constexpr int most_links = 40;  // the limit of Linux
  for (int i = 0; i < most_links; ++i) {
    std::error_code no_link;
    const std::filesystem::path target = std::filesystem::read_symlink(file, no_link);
    if (no_link) break;
    file = file.parent_path() / target;
  }
  return file;
}

Result<void> write_file_atomically(const std::filesystem::path& name, std::string_view content,
                                   Existing existing) {
  const std::filesystem::path file = target_of(name);
  struct stat present {};
  const bool is_present = ::stat(file.c_str(), &present) == 0;
  // Another link, which must not be replaced by a file.
  if (!is_present && errno == ELOOP) return io_error("cannot write", name, ELOOP);
  if (is_present && !S_ISREG(present.st_mode)) {
    // A device, a named pipe or a folder must not be replaced by a file.
    return ClientError{ErrorCode::invalid, file.string() + " is not a regular file"};
  }
  remove_leftovers(folder_of(file));
  std::filesystem::path path;
  const Descriptor opened(open_beside(file, path));
  if (!opened) return io_error("cannot write", file, errno);
  const TemporaryFile temporary(path);
  if (existing == Existing::replace) keep_rights(opened.get(), file);
  // Some file systems report errors only on close. The lock lasts until the last descriptor is
  // closed.
  const bool is_written = write_all(opened.get(), content) && ::fsync(opened.get()) == 0 &&
                          ::close(::dup(opened.get())) == 0;
  if (!is_written) return io_error("cannot write", file, errno);
  const bool replaces = existing == Existing::replace;
  const int error = !replaces                                   ? move_without_replacing(path, file)
                    : ::rename(path.c_str(), file.c_str()) == 0 ? 0
                                                                : errno;
  if (error == EEXIST) {
    return ClientError{ErrorCode::invalid, file.string() + " already exists"};
  }
  if (error != 0) return io_error("cannot write", file, error);
  return sync_folder(folder_of(file));
}

void remove_leftovers(const std::filesystem::path& folder) {
  std::error_code error;
  for (std::filesystem::directory_iterator entry(folder, error), end; !error && entry != end;
       entry.increment(error)) {
    const std::filesystem::path& path = entry->path();
    if (!is_temporary(path.filename().string())) continue;
    const Descriptor opened(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK));
    if (!opened || !is_at(opened.get(), path)) continue;
    if (::flock(opened.get(), LOCK_EX | LOCK_NB) == 0) ::unlink(path.c_str());
  }
}

Result<std::string> read_whole_file(const std::filesystem::path& file, std::size_t most) {
  // Nonblocking, because opening a named pipe waits for a writer.
  const Descriptor opened(::open(file.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
  if (!opened) return io_error("cannot read", file, errno);
  struct stat about {};
  if (::fstat(opened.get(), &about) != 0) return io_error("cannot read", file, errno);
  if (!S_ISREG(about.st_mode)) {
    return ClientError{ErrorCode::bad_file, file.string() + " is not a regular file"};
  }
  std::string content;
  std::array<char, 65536> block{};
  while (true) {
    const ssize_t size = ::read(opened.get(), block.data(), block.size());
    if (size < 0 && errno == EINTR) continue;
    if (size < 0) return io_error("cannot read", file, errno);
    if (size == 0) return content;
    content.append(block.data(), static_cast<std::size_t>(size));
    if (content.size() > most) {
      return ClientError{ErrorCode::bad_file,
                         file.string() + " has more than " + std::to_string(most) + " bytes"};
    }
  }
}

Result<std::string> read_text_file(const std::filesystem::path& file, std::size_t most) {
  Result<std::string> text = read_whole_file(file, most);
  const std::string_view kind = text ? foreign_kind(*text) : "";
  if (!kind.empty()) {
    return ClientError{ErrorCode::bad_file, file.string() + ": this is " + std::string(kind)};
  }
  if (!text) return text;
  if (text->find('\0') != std::string::npos) {
    return ClientError{ErrorCode::bad_file,
                       file.string() + " has NUL bytes: it is no text in UTF-8"};
  }
  if (text->starts_with("\xEF\xBB\xBF")) text->erase(0, 3);
  for (std::size_t at = 0; (at = text->find("\r\n", at)) != std::string::npos;) text->erase(at, 1);
  return text;
}

}  // namespace sbgc::detail
