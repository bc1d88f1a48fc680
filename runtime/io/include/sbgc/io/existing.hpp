/// Policies for a file that exists.
#pragma once

#include <cstdint>

namespace sbgc {

/// The action if the file already exists.
enum class Existing : std::uint8_t {
  keep,     ///< fail with ErrorCode::invalid
  replace,  ///< replace it atomically
};

}  // namespace sbgc
