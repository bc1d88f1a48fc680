/// The text form of `sbgc decode`.
#pragma once

#include <string>

#include "decoded_frame.hpp"

namespace sbgc::tools {

/// A heading line that begins with `place`, then a line for each value: path, raw value, meaning.
std::string to_text(const DecodedFrame& decoded, const std::string& place);

}  // namespace sbgc::tools
