#include "board/local_file.hpp"

#include <cerrno>
#include <filesystem>
#include <string_view>
#include <system_error>

#include <fmt/format.h>
#include <unistd.h>

#include <sbgc/io/internal/atomic_file.hpp>

#include "board/connection.hpp"
#include "command/command_error.hpp"

namespace sbgc::tools {

void check_replaceable(const std::string& file, bool force) {
  if (file == "-") {
    throw CommandError("name a file: this does not go to the standard output", wrong_usage);
  }
  std::error_code ignored;
  if (!force && std::filesystem::exists(std::filesystem::symlink_status(file, ignored))) {
    throw CommandError(fmt::format("{} exists; --force replaces it", file));
  }
}

void check_writable(const std::string& file, bool force) {
  namespace fs = std::filesystem;
  std::error_code error;
  const fs::path target = detail::target_of(file);
  const auto fails = [&](const std::string& reason) {
    throw CommandError(fmt::format("cannot write {}: {}", file, reason));
  };
  const fs::file_status present = fs::status(target, error);
  if (fs::exists(present) && !fs::is_regular_file(present)) fails("not a regular file");
  check_replaceable(file, force);
  const fs::path folder = fs::absolute(target).parent_path();
  if (::access(folder.c_str(), W_OK | X_OK) != 0) fails(std::generic_category().message(errno));
}

void write_local_file(const std::string& file, const std::vector<std::uint8_t>& data, bool force) {
  check_replaceable(file, force);
  const std::string_view content(reinterpret_cast<const char*>(data.data()), data.size());
  value_of(
      detail::write_file_atomically(file, content, force ? Existing::replace : Existing::keep));
}

std::vector<std::uint8_t> read_local_file(const std::string& file, std::size_t most) {
  const std::string content = value_of(detail::read_whole_file(file, most));
  if (content.empty()) throw CommandError(file + " is empty");
  return {content.begin(), content.end()};
}

}  // namespace sbgc::tools
