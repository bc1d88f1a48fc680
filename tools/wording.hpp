/// Wording of messages.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace sbgc::tools {

/// For example "1 byte" or "2 bytes".
std::string counted(std::uint64_t number, const char* thing);

/// Returns a message that quotes its input on one line, without control characters, and truncated
/// if it is long.
std::string clipped(std::string_view message);

}  // namespace sbgc::tools
