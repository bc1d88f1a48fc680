/// The text form of `sbgc decode`.
#pragma once

#include <string>
#include <string_view>

#include "decoded_frame.hpp"

namespace sbgc::tools {

/// "1 byte", "2 bytes".
std::string counted(std::uint64_t number, const char* thing);

/// A message that quotes its input: in one line, without characters that control a terminal, and
/// cut off where it gets long.
std::string clipped(std::string_view message);

/// A heading line that begins with `place`, then a line for each value: name, raw value, meaning.
std::string to_text(const DecodedFrame& decoded, const std::string& place);

}  // namespace sbgc::tools
