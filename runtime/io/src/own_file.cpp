#include <sbgc/internal/foreign_kind.hpp>
#include <sbgc/io/internal/atomic_file.hpp>
#include <sbgc/io/internal/own_file.hpp>

namespace sbgc::detail {

Result<std::string> read_text_file(const std::filesystem::path& file, std::size_t most) {
  Result<std::string> text = read_whole_file(file, most);
  const std::string_view kind = text ? foreign_kind(*text) : "";
  if (!kind.empty()) {
    return ClientError{ErrorCode::bad_file, file.string() + ": this is " + std::string(kind)};
  }
  if (!text) return text;
  if (text->find('\0') != std::string::npos) {
    return ClientError{ErrorCode::bad_file,
                       file.string() + " has NUL bytes: it is no text in UTF-8"};
  }
  if (text->starts_with("\xEF\xBB\xBF")) text->erase(0, 3);
  for (std::size_t at = 0; (at = text->find("\r\n", at)) != std::string::npos;) text->erase(at, 1);
  return text;
}

}  // namespace sbgc::detail
