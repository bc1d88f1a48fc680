#include <fmt/format.h>

#include <sbgc/client/atomic_file.hpp>
#include <sbgc/client/own_file.hpp>

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

}  // namespace sbgc::detail
