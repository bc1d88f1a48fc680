#include "text.hpp"

#include <algorithm>

#include <fmt/format.h>

namespace sbgc::tools {

std::string counted(std::uint64_t number, const char* thing) {
  return fmt::format("{} {}{}", number, thing, number == 1 ? "" : "s");
}

std::string clipped(std::string_view message) {
  constexpr std::size_t longest = 1000;
  std::string result(message.substr(0, longest));
  const auto is_control = [](char c) { return (c >= 0 && c < ' ') || c == '\x7F'; };
  std::replace_if(result.begin(), result.end(), is_control, '?');
  return message.size() > longest ? result + "..." : result;
}

std::string to_text(const DecodedFrame& decoded, const std::string& place) {
  const Frame& frame = decoded.frame;
  std::string result = fmt::format(
      "{}  {} ({})  {}, {}", place, decoded.command.empty() ? "unknown command" : decoded.command,
      frame.id, decoded.direction == Direction::from_board ? "board to host" : "host to board",
      counted(frame.body.size(), "byte"));
  if (decoded.message != nullptr) result += fmt::format("  {}", decoded.message->name);
  result += '\n';
  if (!decoded.status) {
    const Status& status = decoded.status;
    result += fmt::format("    error: {} ({}", text(status.code), name(status.code));
    if (!decoded.error_field.empty()) result += fmt::format(", field {}", decoded.error_field);
    result +=
        fmt::format(", offset {})\n    body: {}\n", status.offset, detail::to_hex(frame.body));
    return result;
  }
  std::size_t path_width = 0;
  std::size_t raw_width = 0;
  for (const Row& row : decoded.rows) {
    path_width = std::max(path_width, row.path.size());
    if (!row.meaning.empty() || !row.objection.empty())
      raw_width = std::max(raw_width, row.raw.size());
  }
  for (const Row& row : decoded.rows) {
    std::string line = fmt::format("    {:<{}}  {:<{}}  {}", row.path, path_width, row.raw,
                                   raw_width, row.meaning);
    if (!row.objection.empty()) {
      line += fmt::format("{}({})", row.meaning.empty() ? "" : " ", row.objection);
    }
    line.erase(line.find_last_not_of(' ') + 1);
    result += line + '\n';
  }
  return result;
}

}  // namespace sbgc::tools
