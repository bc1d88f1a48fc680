#include "memory/local_file.hpp"

#include <filesystem>
#include <string_view>

#include <fmt/format.h>

#include <sbgc/client/atomic_file.hpp>

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
