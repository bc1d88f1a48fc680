/// The text format of `sbgc decode`.
#pragma once

#include <string>

#include "decoded_frame.hpp"

namespace sbgc::tools {

/// Returns a heading that begins with `place`, then a line per value: path, raw value, meaning.
std::string to_text(const DecodedFrame& decoded, const std::string& place);

}  // namespace sbgc::tools
