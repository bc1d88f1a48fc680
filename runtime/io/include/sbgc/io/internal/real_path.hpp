/// The paths of files that have several names.
#pragma once

#include <filesystem>
#include <string>
#include <system_error>

namespace sbgc::io::detail {

/// Resolves links such as those in /dev/serial/by-id; returns the path itself if there is no file.
inline std::string real_path(const std::string& path) {
  std::error_code error;
  const std::filesystem::path real = std::filesystem::canonical(path, error);
  return error ? path : real.string();
}

}  // namespace sbgc::io::detail
