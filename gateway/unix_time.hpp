/// Times as payloads and the journal have them.
#pragma once

#include <chrono>
#include <cstdint>

namespace sbgc::tools {

inline std::int64_t unix_milliseconds(std::chrono::system_clock::time_point time) {
  return std::chrono::duration_cast<std::chrono::milliseconds>(time.time_since_epoch()).count();
}

}  // namespace sbgc::tools
