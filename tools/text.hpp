/// The text form of `sbgc decode`.
#pragma once

#include <string>

#include "decoded_frame.hpp"

namespace sbgc::tools {

/// A heading line, then a line for each value: name, raw value, meaning.
std::string to_text(const DecodedFrame& decoded);

}  // namespace sbgc::tools
