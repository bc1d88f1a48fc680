/// Text of error messages.
#pragma once

#include <string>

namespace sbgc::detail {

/// Removes the final period, which messages of this library do not have.
inline std::string without_period(std::string sentence) {
  if (sentence.ends_with('.')) sentence.pop_back();
  return sentence;
}

}  // namespace sbgc::detail
