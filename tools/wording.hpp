/// Small parts of messages for people.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace sbgc::tools {

/// "1 byte", "2 bytes".
std::string counted(std::uint64_t number, const char* thing);

/// A message that quotes its input: in one line, without characters that control a terminal, and
/// cut off where it gets long.
std::string clipped(std::string_view message);

}  // namespace sbgc::tools
