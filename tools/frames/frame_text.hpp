/// The text format of `sbgc decode`.
#pragma once

#include <sbgc/text_output.hpp>

#include "command/terminal_text.hpp"
#include "frames/decoded_frame.hpp"

namespace sbgc::tools {

/// Writes the rest of a heading that begins with the position of the frame, then a line per value:
/// path, raw value, meaning.
void put_text(TextOutput& out, const DecodedFrame& decoded, const Colors& colors = {});

}  // namespace sbgc::tools
