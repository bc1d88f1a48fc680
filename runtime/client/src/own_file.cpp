#include <utility>

#include <fmt/format.h>

#include <sbgc/client/atomic_file.hpp>
#include <sbgc/client/own_file.hpp>
#include <sbgc/parse_json.hpp>
#include <sbgc/text/values.hpp>

namespace sbgc::detail {

Result<std::string> read_text_file(const std::filesystem::path& file, std::size_t most) {
  Result<std::string> text = read_whole_file(file, most);
  const std::string_view kind = text ? foreign_kind(*text) : "";
  if (!kind.empty()) {
    return ClientError{ErrorCode::bad_file, fmt::format("{}: this is {}", file.string(), kind)};
  }
  if (!text) return text;
  if (text->find('\0') != std::string::npos) {
    return ClientError{ErrorCode::bad_file,
                       fmt::format("{} has NUL bytes: it is no text in UTF-8", file.string())};
  }
  if (text->starts_with("\xEF\xBB\xBF")) text->erase(0, 3);
  for (std::size_t at = 0; (at = text->find("\r\n", at)) != std::string::npos;) text->erase(at, 1);
  return text;
}

Result<Json> parse_own_json(std::string_view text, const char* format, const char* what) {
  const auto refused = [&](std::string_view kind) {
    return ClientError{ErrorCode::bad_file, fmt::format("this is {}, not {}", kind, what)};
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
  constexpr std::size_t longest = 32;  // that an error quotes
  if (name != format)
    return refused(fmt::format("JSON of the format {}", detail::quoted(name.substr(0, longest))));
  return std::move(document.value);
}

}  // namespace sbgc::detail
