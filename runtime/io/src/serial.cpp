#include <algorithm>
#include <array>
#include <cerrno>
#include <filesystem>
#include <fstream>
#include <tuple>
#include <utility>

#include <asio/posix/stream_descriptor.hpp>
#include <fcntl.h>
#include <grp.h>
#include <pwd.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <sys/sysmacros.h>
#include <unistd.h>

#include <sbgc/io/internal/descriptor.hpp>
#include <sbgc/io/internal/stream_transport.hpp>
#include <sbgc/io/ports.hpp>
#include <sbgc/io/serial.hpp>

#include "termios.hpp"

namespace sbgc::io {

namespace {

namespace fs = std::filesystem;

using Stream = asio::posix::stream_descriptor;

bool is_pseudo_terminal(const struct stat& status) {
  const unsigned number = major(status.st_rdev);
  return number >= 136 && number <= 143;  // fixed by Linux: UNIX98 pseudo-terminal slaves
}

class SerialTransport final : public detail::StreamTransport<Stream>, private LineControl {
 public:
  SerialTransport(Stream stream, std::string path, const LineSettings& settings)
      : StreamTransport(std::move(stream), detail::translate_device),
        path_(std::move(path)),
        settings_(settings) {}

  SerialTransport(const SerialTransport&) = delete;
  SerialTransport& operator=(const SerialTransport&) = delete;
  ~SerialTransport() override { release(); }

  void close() override {
    release();
    StreamTransport::close();
  }

  std::string description() const override {
    return "serial port " + path_ + ", " + to_string(settings_);
  }

  LineControl* line() override { return this; }
  int native_handle() override { return fd(); }

 private:
  Error set(const LineSettings& settings) override {
    if (state()->closed) return closed();
    Error error = detail::make_raw(fd(), settings, path_);
    settings_ = detail::line_of(fd()).value_or(settings_);
    // If the hardware approximates the rate, report the requested one.
    if (!error) settings_ = settings;
    detail::discard_input(fd());
    return error;
  }

  LineSettings current() const override { return settings_; }

  Error flush() override {
    if (state()->closed) return closed();
    detail::discard_both(fd());
    return {};
  }

  Error closed() const { return {asio::error::operation_aborted, path_ + " has been closed."}; }

  int fd() { return stream().native_handle(); }

  void release() {
    if (!state()->closed) detail::set_exclusive(fd(), false);
  }

  std::string path_;
  LineSettings settings_;
};

/// Calls `take` with each entry of a folder until it returns true. Skips unreadable entries.
template <class Take>
bool find_entry(const fs::path& folder, Take take) {
  std::error_code error;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end;
       entry.increment(error)) {
    if (take(entry->path())) return true;
  }
  return false;
}

/// Returns the program that has `path` open, "minicom (process 4711)"; "" if unknown.
std::string holder_of(const std::string& path) {
  std::error_code error;
  const fs::path device = fs::canonical(path, error);
  std::string holder;
  find_entry("/proc", [&](const fs::path& process) {
    const std::string id = process.filename();
    if (id.find_first_not_of("0123456789") != std::string::npos) return false;
    if (id == std::to_string(getpid())) return false;
    return find_entry(process / "fd", [&](const fs::path& file) {
      if (fs::read_symlink(file, error) != device || error) return false;
      std::ifstream comm(process / "comm");
      std::getline(comm, holder);
      holder += " (process " + id + ")";
      return true;
    });
  });
  return holder;
}

Error busy_error(const std::string& path) {
  const std::string holder = holder_of(path);
  return {Errc::busy,
          path + " is in use by " +
              (holder.empty() ? "another program, or by another part of this one" : holder) +
              ". Close it there first."};
}

Error missing_error(const std::string& path) {
  std::string message = "There is no port " + path + ". ";
  const PortList list = list_ports();
  if (list.ports.empty()) {
    message += "There are no serial ports: is the gimbal plugged in?";
  } else {
    message += "Available ports:";
    for (const PortInfo& port : list.ports) {
      message += "\n  " + port.name;
      if (!port.description.empty()) message += " (" + port.description + ")";
    }
  }
  return {Errc::no_such_port, message};
}

bool is_member(gid_t group) {
  const passwd* const user = getpwuid(geteuid());
  if (user == nullptr) return false;
  std::array<gid_t, 256> groups{};
  int count = groups.size();
  if (getgrouplist(user->pw_name, user->pw_gid, groups.data(), &count) < 0) return false;
  return std::find(groups.begin(), groups.begin() + count, group) != groups.begin() + count;
}

DeviceOwner owner_of(const struct stat& status) {
  const group* const owner = getgrgid(status.st_gid);
  return {owner == nullptr ? std::to_string(status.st_gid) : owner->gr_name,
          (status.st_mode & (S_IRGRP | S_IWGRP)) == (S_IRGRP | S_IWGRP), is_member(status.st_gid)};
}

Error system_error(const std::string& path, int reason) {
  return {std::error_code(reason, std::generic_category()),
          path + " cannot be opened: " + std::generic_category().message(reason) + "."};
}

Error open_error(const std::string& path, int reason, const struct stat& status) {
  switch (reason) {
    case EACCES:
    case EPERM: return permission_error(path, owner_of(status));
    case EBUSY: return busy_error(path);
    case ENXIO:
    case ENODEV:
    case EIO: return {Errc::device_lost, path + " exists, but no device is connected to it."};
    default: return system_error(path, reason);
  }
}

/// Takes over an open terminal.
OpenResult transport_over(const asio::any_io_executor& executor, detail::Descriptor fd,
                          const std::string& path, const LineSettings& settings) {
  Stream stream(executor);
  std::error_code error;
  stream.assign(fd.get(), error);
  if (error) return {nullptr, system_error(path, error.value())};
  std::ignore = fd.release();
  return {std::make_unique<SerialTransport>(std::move(stream), path, settings), {}};
}

}  // namespace

Error permission_error(const std::string& path, const DeviceOwner& owner) {
  std::string message = "You do not have permission to open " + path + ". ";
  if (!owner.group_may_open || owner.group == "root") {
    message += "Only its owner does: ask the administrator of this machine for a udev rule.";
  } else if (owner.is_member) {
    message += "You have been added to the group " + owner.group +
               ", but this login session is not in it yet: log out and in again.";
  } else {
    message += "Add yourself to the group " + owner.group + ": sudo usermod -aG " + owner.group +
               " $USER, then log in again.";
  }
  return {Errc::permission_denied, message};
}

OpenResult open_serial(const asio::any_io_executor& executor, const std::string& path,
                       const LineSettings& settings) {
  struct stat status {};
  if (stat(path.c_str(), &status) != 0) {
    const int reason = errno;
    if (reason == ENOENT || reason == ENOTDIR) return {nullptr, missing_error(path)};
    return {nullptr, system_error(path, reason)};
  }
  if (!S_ISCHR(status.st_mode)) {
    const std::string hint =
        S_ISREG(status.st_mode) ? "; write capture:" + path + " for a capture" : "";
    return {nullptr, {Errc::not_a_port, path + " is not a serial port" + hint + "."}};
  }
  detail::Descriptor fd(::open(path.c_str(), O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC));
  if (!fd) return {nullptr, open_error(path, errno, status)};
  if (!detail::is_terminal(fd.get())) {
    return {nullptr, {Errc::not_a_port, path + " is not a serial port."}};
  }
  // Unlike exclusive mode, the lock also excludes root. A pseudo-terminal is not made exclusive:
  // its device outlives this program and would stay exclusive if the program were killed.
  if (flock(fd.get(), LOCK_EX | LOCK_NB) != 0) return {nullptr, busy_error(path)};
  if (!is_pseudo_terminal(status)) detail::set_exclusive(fd.get(), true);
  if (Error error = detail::make_raw(fd.get(), settings, path)) return {nullptr, std::move(error)};
  detail::discard_input(fd.get());
  return transport_over(executor, std::move(fd), path, settings);
}

OpenResult adopt_serial(const asio::any_io_executor& executor, int descriptor) {
  detail::Descriptor fd(descriptor);
  std::array<char, 256> name{};
  const bool is_named = ttyname_r(fd.get(), name.data(), name.size()) == 0;
  const std::string path = is_named ? name.data() : "of another process";
  const std::optional<LineSettings> settings = detail::line_of(fd.get());
  if (!settings) return {nullptr, {Errc::device_lost, path + " no longer responds."}};
  return transport_over(executor, std::move(fd), path, *settings);
}

}  // namespace sbgc::io
