/// JSON strings.
#pragma once

#include <string_view>

#include <sbgc/internal/characters.hpp>
#include <sbgc/json/text_sink.hpp>
#include <sbgc/text_output.hpp>

namespace sbgc::tools {

/// Writes a JSON string. Bytes that are not UTF-8 become replacement characters.
inline void put_json_string(TextOutput& out, std::string_view text) {
  out.put('"');
  detail::for_each_sequence(text, [&](std::string_view sequence, bool is_utf8) {
    detail::put_escaped(out, is_utf8 ? sequence : "\xEF\xBF\xBD");
  });
  out.put('"');
}

}  // namespace sbgc::tools
