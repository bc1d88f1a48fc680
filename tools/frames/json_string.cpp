#include "frames/json_string.hpp"

#include <sbgc/internal/characters.hpp>
#include <sbgc/json/text_sink.hpp>

namespace sbgc::tools {

void put_json_string(TextOutput& out, std::string_view text) {
  out.put('"');
  detail::for_each_sequence(text, [&](std::string_view sequence, bool is_utf8) {
    detail::put_escaped(out, is_utf8 ? sequence : "\xEF\xBF\xBD");
  });
  out.put('"');
}

}  // namespace sbgc::tools
