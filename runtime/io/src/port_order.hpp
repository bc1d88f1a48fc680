/// The order in which ports are listed.
#pragma once

#include <cstddef>
#include <string>
#include <tuple>

namespace sbgc::io::detail {

/// Orders ttyUSB2 before ttyUSB10: of two numbers, the shorter one is smaller.
inline bool comes_before(const std::string& a, const std::string& b) {
  const auto key = [](const std::string& name) {
    const std::size_t digits = name.find_last_not_of("0123456789") + 1;
    return std::tuple(name.substr(0, digits), name.size(), name);
  };
  return key(a) < key(b);
}

}  // namespace sbgc::io::detail
