#include "frame_text.hpp"

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <string_view>

#include <fmt/format.h>

namespace sbgc::tools {

namespace {

void put_heading(TextOutput& out, const DecodedFrame& decoded) {
  const bool is_from_board = decoded.direction == Direction::from_board;
  const std::size_t size = decoded.frame.body.size();
  out.put("  ");
  out.put(*decoded.command == '\0' ? "unknown command" : decoded.command);
  out.put(" (");
  out.put(decoded.frame.id);
  out.put(is_from_board ? ")  board to host, " : ")  host to board, ");
  out.put(size);
  out.put(size == 1 ? " byte" : " bytes");
  if (decoded.message != nullptr) {
    out.put("  ");
    out.put(decoded.message->name);
  }
  if (!decoded.objection.empty()) {
    out.put("  ");
    out.put(decoded.objection);
  }
  out.put('\n');
}

void put_error(TextOutput& out, const DecodedFrame& decoded) {
  const Status& status = decoded.status;
  out.put("    error: ");
  out.put(text(status.code));
  out.put(" (");
  out.put(name(status.code));
  if (!decoded.error_field.empty()) {
    out.put(", field ");
    out.put(decoded.error_field);
  }
  out.put(", offset ");
  out.put(status.offset);
  out.put(")\n    body: ");
  out.put_hex(decoded.frame.body);
  out.put('\n');
}

/// Writes meaning and objection: "1 Hz is below 554 Hz", "MODE_RC needs firmware 2.66".
void put_remark(TextOutput& out, std::string_view meaning, std::string_view objection) {
  if (objection.empty()) return out.put(meaning);
  const bool has_meaning =
      objection.starts_with(meaning) && objection.substr(meaning.size()).starts_with(' ');
  if (!meaning.empty() && !has_meaning) {
    const bool has_subject = objection.front() >= 'A' && objection.front() <= 'Z';
    out.put(meaning);
    out.put(has_subject ? "; " : " ");
  }
  out.put(objection);
}

/// Where the columns of a message begin: path, raw value, meaning and objection.
struct Columns {
  static constexpr std::size_t path = 4;
  std::size_t raw = 0;
  std::size_t remark = 0;
  bool are_short = false;  ///< all paths and raw values fit into TextOutput::most_room
};

bool has_remark(const Row& row) { return row.meaning != row.end || !row.objection.empty(); }

Columns columns_of(const Rows& rows) {
  std::size_t path_width = 0;
  std::size_t raw_width = 0;  // of those with a remark
  std::size_t any_width = 0;
  for (const Row& row : rows) {
    const std::size_t width = row.meaning - row.raw;
    path_width = std::max(path_width, row.path.text().size());
    any_width = std::max(any_width, width);
    if (has_remark(row)) raw_width = std::max(raw_width, width);
  }
  const std::size_t raw = Columns::path + path_width + 2;
  return {raw, raw + raw_width + 2, raw + any_width + 2 <= TextOutput::most_room};
}

/// Writes path and raw value on spaces.
void put_short(TextOutput& out, std::string_view path, std::string_view raw, bool has_remark,
               const Columns& columns) {
  char* const line = out.room(TextOutput::most_room);
  std::memset(line, ' ', columns.remark);
  std::memcpy(line + Columns::path, path.data(), path.size());
  std::memcpy(line + columns.raw, raw.data(), raw.size());
  if (has_remark) return out.advance(line + columns.remark);
  out.advance(raw.empty() ? line + Columns::path + path.size() : line + columns.raw + raw.size());
}

/// As put_short(), for text of any length and with other characters than ASCII.
void put_any(TextOutput& out, std::string_view path, std::string_view raw, bool has_remark,
             const Columns& columns) {
  out.put(' ', Columns::path);
  out.put(path);
  if (raw.empty() && !has_remark) return;
  out.put(' ', columns.raw - Columns::path - path.size());
  if (!has_remark) return out.put(raw);
  out.put(fmt::format("{:<{}}  ", raw, columns.remark - columns.raw - 2));
}

void put_values(TextOutput& out, const Rows& rows) {
  const Columns columns = columns_of(rows);
  for (const Row& row : rows) {
    const std::string_view raw = rows.raw(row);
    if (columns.are_short && !raw.starts_with('"')) {  // only quoted text is not ASCII
      put_short(out, row.path.text(), raw, has_remark(row), columns);
    } else {
      put_any(out, row.path.text(), raw, has_remark(row), columns);
    }
    put_remark(out, rows.meaning(row), row.objection);
    out.put('\n');
  }
}

}  // namespace

void put_text(TextOutput& out, const DecodedFrame& decoded) {
  put_heading(out, decoded);
  if (decoded.status) {
    put_values(out, decoded.rows);
  } else {
    put_error(out, decoded);
  }
}

}  // namespace sbgc::tools
