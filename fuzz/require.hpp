#pragma once

#include <cstdlib>

namespace sbgc::fuzz {

/// Ends a fuzzer, which thereby reports its input, if an invariant does not hold.
inline void require(bool condition) {
  if (!condition) std::abort();
}

}  // namespace sbgc::fuzz
