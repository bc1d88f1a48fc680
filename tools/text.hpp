/// The text form of `sbgc decode`.
#pragma once

#include <string>

#include "decoded_frame.hpp"

namespace sbgc::tools {

/// "1 byte", "2 bytes".
std::string counted(std::uint64_t number, const char* thing);

/// A heading line that begins with `place`, then a line for each value: name, raw value, meaning.
std::string to_text(const DecodedFrame& decoded, const std::string& place);

}  // namespace sbgc::tools
