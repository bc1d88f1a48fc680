#include "frame_text.hpp"

#include <algorithm>
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
}

void put_error(TextOutput& out, const DecodedFrame& decoded) {
  const Status& status = decoded.status;
  out.put("\n    error: ");
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

/// Writes a raw value in a column of `width` bytes.
void put_raw(TextOutput& out, std::string_view raw, std::size_t width) {
  // Only quoted text has other characters than ASCII; fmt knows how wide they are.
  if (raw.starts_with('"')) return out.put(fmt::format("{:<{}}", raw, width));
  out.put_column(raw, width);
}

void put_values(TextOutput& out, const Rows& rows) {
  std::size_t path_width = 0;
  std::size_t raw_width = 0;
  const auto has_remark = [&](const Row& row) {
    return row.meaning != row.end || !row.objection.empty();
  };
  for (const Row& row : rows) {
    path_width = std::max(path_width, row.path.text().size());
    if (has_remark(row)) raw_width = std::max(raw_width, rows.raw(row).size());
  }
  for (const Row& row : rows) {
    const std::string_view path = row.path.text();
    const std::string_view raw = rows.raw(row);
    out.put("\n    ");
    if (has_remark(row)) {
      out.put_column(path, path_width + 2);
      put_raw(out, raw, raw_width);
      out.put("  ");
      put_remark(out, rows.meaning(row), row.objection);
    } else {
      out.put_column(path, raw.empty() ? path.size() : path_width + 2);
      out.put(raw);
    }
  }
  out.put('\n');
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
