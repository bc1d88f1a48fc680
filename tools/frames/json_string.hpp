/// Strings of JSON.
#pragma once

#include <string_view>

#include <sbgc/text_output.hpp>

namespace sbgc::tools {

/// Writes a string of JSON. Bytes that are not UTF-8 become replacement characters.
void put_json_string(TextOutput& out, std::string_view text);

}  // namespace sbgc::tools
