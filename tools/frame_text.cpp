#include "frame_text.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "wording.hpp"

namespace sbgc::tools {

namespace {

std::string heading(const DecodedFrame& decoded, const std::string& place) {
  const bool is_from_board = decoded.direction == Direction::from_board;
  return fmt::format("{}  {} ({})  {}, {}{}{}{}{}\n", place,
                     decoded.command.empty() ? "unknown command" : decoded.command,
                     decoded.frame.id, is_from_board ? "board to host" : "host to board",
                     counted(decoded.frame.body.size(), "byte"),
                     decoded.message == nullptr ? "" : "  ",
                     decoded.message == nullptr ? "" : decoded.message->name,
                     decoded.objection.empty() ? "" : "  ", decoded.objection);
}

std::string error_lines(const DecodedFrame& decoded) {
  const Status& status = decoded.status;
  return fmt::format("    error: {} ({}{}{}, offset {})\n    body: {}\n", text(status.code),
                     name(status.code), decoded.error_field.empty() ? "" : ", field ",
                     decoded.error_field, status.offset, detail::to_hex(decoded.frame.body));
}

/// Joins meaning and objection: "1 Hz is below 554 Hz", "MODE_RC needs firmware 2.66".
std::string remark(const Row& row) {
  if (row.meaning.empty() || row.objection.empty()) return row.meaning + row.objection;
  if (row.objection.starts_with(row.meaning + " ")) return row.objection;
  const bool has_subject = row.objection.front() >= 'A' && row.objection.front() <= 'Z';
  return row.meaning + (has_subject ? "; " : " ") + row.objection;
}

std::string value_lines(const std::vector<Row>& rows) {
  std::size_t path_width = 0;
  std::size_t raw_width = 0;
  for (const Row& row : rows) {
    path_width = std::max(path_width, row.path.size());
    if (!remark(row).empty()) raw_width = std::max(raw_width, row.raw.size());
  }
  std::string result;
  for (const Row& row : rows) {
    std::string line = fmt::format("    {:<{}}  {:<{}}  {}", row.path, path_width, row.raw,
                                   raw_width, remark(row));
    line.erase(line.find_last_not_of(' ') + 1);
    result += line + '\n';
  }
  return result;
}

}  // namespace

std::string to_text(const DecodedFrame& decoded, const std::string& place) {
  return heading(decoded, place) +
         (decoded.status ? value_lines(decoded.rows) : error_lines(decoded));
}

}  // namespace sbgc::tools
