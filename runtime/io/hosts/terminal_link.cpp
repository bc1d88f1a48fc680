#include "hosts/terminal_link.hpp"

#include <cerrno>
#include <filesystem>
#include <stdexcept>
#include <system_error>
#include <utility>

#include <fmt/format.h>
#include <unistd.h>

namespace sbgc::hosts {

namespace {

namespace fs = std::filesystem;

std::string reason(int error) { return std::generic_category().message(error); }

/// Returns why the link must not be replaced; "" if it may.
std::string objection(const std::string& path, const std::string& terminal) {
  std::error_code error;
  if (!fs::is_symlink(fs::symlink_status(path, error))) return "it exists and is not a link";
  const std::string target = fs::read_symlink(path, error).string();
  if (error) return reason(error.value());
  if (target == terminal) return "";
  if (!target.starts_with("/dev/pts/")) return "it is a link to " + target;
  if (fs::exists(fs::status(target, error))) {
    return "it is a link to " + target + ", which may be in use; remove it if it is not";
  }
  return "";
}

}  // namespace

TerminalLink::TerminalLink(std::string path, std::string terminal)
    : path_(std::move(path)), terminal_(std::move(terminal)) {
  const auto fail = [&](const std::string& why) {
    throw std::runtime_error(fmt::format("the link {} cannot be created: {}", path_, why));
  };
  // Fails if the name exists.
  if (symlink(terminal_.c_str(), path_.c_str()) == 0) return;
  if (errno != EEXIST) fail(reason(errno));
  if (const std::string why = objection(path_, terminal_); !why.empty()) fail(why);
  // Atomic, so that the name always exists. A killed program may have left the other name.
  const std::string fresh = path_ + ".sbgc-new";
  if (symlink(terminal_.c_str(), fresh.c_str()) != 0) {
    if (errno != EEXIST) fail(reason(errno));
    if (const std::string why = objection(fresh, terminal_); !why.empty()) {
      fail(fmt::format("{}: {}", fresh, why));
    }
    unlink(fresh.c_str());
    if (symlink(terminal_.c_str(), fresh.c_str()) != 0) fail(reason(errno));
  }
  std::error_code error;
  fs::rename(fresh, path_, error);
  if (!error) return;
  std::error_code ignored;
  fs::remove(fresh, ignored);
  fail(reason(error.value()));
}

TerminalLink::~TerminalLink() {
  std::error_code error;
  if (fs::read_symlink(path_, error).string() == terminal_ && !error) fs::remove(path_, error);
}

}  // namespace sbgc::hosts
