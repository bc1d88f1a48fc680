/// Errors in words.
#pragma once

#include <string>

namespace sbgc::detail {

/// A sentence as this library writes them: without the final stop.
inline std::string without_stop(std::string sentence) {
  if (sentence.ends_with('.')) sentence.pop_back();
  return sentence;
}

}  // namespace sbgc::detail
