/// Firmware versions as users write them.
#pragma once

#include <array>
#include <string>
#include <string_view>

#include <sbgc/enums.hpp>

#include "serving/argument_text.hpp"

namespace sbgc::serving {

/// Any version, for example "2.43b9" or "2.73.1". Throws std::invalid_argument with a sentence that
/// states the error and the expected format.
inline msg::FirmwareVersion read_firmware(const std::string& text) {
  constexpr const char* wanted = "a firmware version, such as 2.59 or 2.43b9";
  const auto [major, rest] = split(text, '.');
  // Later releases have another point, as in 2.73.1.
  const auto [minor, last] = split(rest, rest.find('b') == std::string::npos ? '.' : 'b');
  std::array<unsigned, 3> parts{};
  const bool has_last = minor.size() < rest.size();
  msg::FirmwareVersion version;
  if (minor.size() != 2 || !read(major, 64U, parts[0]) || !read(minor, 99U, parts[1]) ||
      (has_last && !read(last, 9U, parts[2])) || !version.set_major(parts[0]) ||
      !version.set_minor(parts[1]) || !version.set_beta(parts[2])) {
    refuse(text, wanted);
  }
  return version;
}

}  // namespace sbgc::serving
