// Checks that a gateway can use the files that a fleet names. Creates nothing.

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <string>

#include <fcntl.h>
#include <fmt/format.h>
#include <pwd.h>
#include <sys/stat.h>
#include <unistd.h>

#include <sbgc/io/internal/own_file.hpp>

#include "board/password.hpp"
#include "command/command_error.hpp"
#include "gateway/fleet.hpp"
#include "gateway/journal.hpp"
#include "gateway/tls.hpp"

namespace sbgc::tools {

namespace {

constexpr std::size_t largest_fleet_file = std::size_t{1} << 22U;

void require_access(const std::filesystem::path& file, int mode, const char* verb) {
  if (::faccessat(AT_FDCWD, file.c_str(), mode, AT_EACCESS) == 0) return;
  const char* const reason = std::strerror(errno);
  const passwd* const user = ::getpwuid(::geteuid());
  throw CommandError(fmt::format("cannot {} {} as the user {}: {}", verb, file.string(),
                                 user == nullptr ? std::to_string(::geteuid()) : user->pw_name,
                                 reason));
}

void check_journal_file(const std::filesystem::path& file) {
  // SQLite accepts paths up to 512 bytes, and adds files with longer names.
  constexpr std::size_t longest_path = 500;
  constexpr std::size_t longest_name = 240;
  if (file.string().size() > longest_path || file.filename().string().size() > longest_name) {
    throw CommandError(
        fmt::format("a journal has a name of at most {} bytes, and a path of at most {}",
                    longest_name, longest_path));
  }
  require_access(file.parent_path(), W_OK | X_OK, "write to the folder");
  struct stat about {};
  if (::stat(file.c_str(), &about) != 0 && errno == ENOENT) return;
  require_access(file, R_OK | W_OK, "read and write");
  if (!S_ISREG(about.st_mode)) throw CommandError(file.string() + " is not a regular file");
  Journal::check_header(file);
}

void check_fleet_file(const FleetFile& file, const Fleet& fleet) {
  using Kind = FleetFile::Kind;
  if (file.kind == Kind::journal) return check_journal_file(file.path);
  require_access(file.path, R_OK, "read");
  switch (file.kind) {
    case Kind::journal: break;
    case Kind::password: static_cast<void>(read_password(file.path.string(), "")); break;
    case Kind::authorities: require_authorities(file.path); break;
    case Kind::certificate: require_certificate(file.path); break;
    case Kind::key: require_key(file.path, fleet.broker->certificate_file); break;
  }
}

}  // namespace

Fleet read_fleet(const std::filesystem::path& file) {
  require_access(file, R_OK, "read");
  const Result<std::string> text = detail::read_text_file(file, largest_fleet_file);
  if (!text) throw CommandError(text.error().message);
  Fleet fleet = fleet_in(*text, file);
  for (const FleetFile& one : fleet.files) {
    try {
      check_fleet_file(one, fleet);
    } catch (const std::runtime_error& error) {
      reject_configuration(file.string(), one.place, error.what());
    }
  }
  return fleet;
}

}  // namespace sbgc::tools
