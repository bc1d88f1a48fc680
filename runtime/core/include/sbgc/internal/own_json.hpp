/// JSON files of this project.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <utility>

#include <sbgc/internal/foreign_kind.hpp>
#include <sbgc/parse_json.hpp>
#include <sbgc/result.hpp>
#include <sbgc/text/values.hpp>

namespace sbgc::detail {

/// Parses a JSON object with this `format`. Fails with ErrorCode::bad_file for anything other than
/// `what`, such as "an sbgc backup".
inline Result<Json> parse_own_json(std::string_view text, const char* format, const char* what) {
  if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);  // an editor wrote it
  const auto refused = [&](std::string_view kind) {
    return ClientError{ErrorCode::bad_file, "this is " + std::string(kind) + ", not " + what};
  };
  const std::size_t start = text.find_first_not_of(" \t\r\n");
  if (const std::string_view kind = foreign_kind(text); !kind.empty()) return refused(kind);
  if (start == std::string_view::npos) return refused("an empty file");
  if (text[start] != '{' && text[start] != '[') return refused("text");
  ParsedJson document = parse_json(text);
  if (!document) return ClientError{ErrorCode::bad_file, to_string(*document.problem)};
  const Json& value = document.value;
  const auto said = value.is_object() ? value.find("format") : value.end();
  if (said == value.end() || !said->is_string()) return refused("other JSON");
  const auto& name = said->get_ref<const std::string&>();
  constexpr std::size_t longest = 32;  // the longest format that an error quotes
  if (name != format)
    return refused("JSON of the format " + detail::quoted(name.substr(0, longest)));
  return std::move(document.value);
}

}  // namespace sbgc::detail
