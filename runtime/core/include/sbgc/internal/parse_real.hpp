/// Real numbers from text.
#pragma once

#include <charconv>
#include <cstdlib>
#include <string>
#include <system_error>
#include <version>

namespace sbgc::detail {

/// Does what std::from_chars() does, which libc++ 14 lacks for real numbers.
inline std::from_chars_result parse_real(const char* begin, const char* end, double& out) {
#if defined(__cpp_lib_to_chars)
  return std::from_chars(begin, end, out);
#else
  const std::string text(begin, end);
  char* stop = nullptr;
  const double value = std::strtod(text.c_str(), &stop);
  const char* const at = begin + (stop - text.c_str());
  if (at == begin) return {begin, std::errc::invalid_argument};
  if (value - value != 0) return {at, std::errc::result_out_of_range};
  out = value;
  return {at, std::errc{}};
#endif
}

}  // namespace sbgc::detail
