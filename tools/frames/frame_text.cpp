#include "frames/frame_text.hpp"

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <string_view>

#include <fmt/format.h>

#include "frames/command_lookup.hpp"

namespace sbgc::tools {

namespace {

void put_heading(TextOutput& out, const DecodedFrame& decoded, const Colors& colors) {
  const bool is_from_board = decoded.direction == Direction::from_board;
  const std::size_t size = decoded.frame.body.size();
  out.put("  ");
  out.put(colors.begin(Color::bold));
  out.put(*decoded.command == '\0' ? "unknown command" : decoded.command);
  out.put(colors.end());
  out.put(" (");
  out.put(decoded.frame.id);
  out.put(is_from_board ? ")  board to host" : ")  host to board");
  out.put(decoded.is_guess ? " (a guess), " : ", ");
  out.put(size);
  out.put(size == 1 ? " byte" : " bytes");
  if (decoded.message != nullptr) {
    out.put("  ");
    out.put(decoded.message->name);
  }
  if (!decoded.objection.empty()) {
    out.put("  ");
    out.put(colors.begin(Color::yellow));
    out.put(decoded.objection);
    out.put(colors.end());
  }
  out.put('\n');
}

void put_error(TextOutput& out, const DecodedFrame& decoded, const Colors& colors) {
  const Status& status = decoded.status;
  out.put("    ");
  out.put(colors.begin(Color::red));
  out.put("error: ");
  out.put(decoded.explanation);
  out.put(" (");
  out.put(name(status.code));
  if (!decoded.error_field.empty()) {
    out.put(", field ");
    out.put(decoded.error_field);
  }
  out.put(", offset ");
  out.put(status.offset);
  if (status.code == Code::unknown_form) {
    out.put(", valid: ");
    out.put(body_sizes(decoded.direction, decoded.frame.id));
  }
  out.put(')');
  out.put(colors.end());
  out.put("\n    body: ");
  put_body(out, decoded);
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

bool has_remark(const Row& row) { return row.meaning != row.end || !row.objection.empty(); }

/// The columns of a message's lines: where path, raw value and remark begin.
struct Columns {
  static constexpr std::size_t path = 4;
  std::size_t raw{};
  std::size_t remark{};
  bool are_short{};  ///< lines without an objection fit into TextOutput::most_room
};

Columns columns_of(const Rows& rows) {
  std::size_t path_width = 0;
  std::size_t raw_width = 0;  // of values with a remark
  std::size_t most_text = 0;
  for (const Row& row : rows) {
    path_width = std::max(path_width, row.path.text().size());
    if (has_remark(row)) raw_width = std::max(raw_width, row.meaning - row.raw);
    most_text = std::max(most_text, row.end - row.raw);
  }
  const std::size_t raw = Columns::path + path_width + 2;
  const std::size_t remark = raw + raw_width + 2;
  return {raw, remark, remark + most_text < TextOutput::most_room};
}

char* copy(std::string_view text, char* to) {
  std::memcpy(to, text.data(), text.size());
  return to + text.size();
}

/// Writes a line without an objection, padded with spaces.
void put_short(TextOutput& out, std::string_view path, std::string_view raw,
               std::string_view meaning, const Columns& columns) {
  char* const line = out.room(TextOutput::most_room);
  std::memset(line, ' ', columns.remark);
  char* end = copy(path, line + Columns::path);
  if (!raw.empty()) end = copy(raw, line + columns.raw);
  if (!meaning.empty()) end = copy(meaning, line + columns.remark);
  *end = '\n';
  out.advance(end + 1);
}

/// Writes any line.
void put_line(TextOutput& out, std::string_view path, std::string_view raw,
              std::string_view meaning, std::string_view objection, const Columns& columns,
              const Colors& colors) {
  const bool has_remark = !meaning.empty() || !objection.empty();
  out.put(' ', Columns::path);
  out.put(path);
  if (!raw.empty() || has_remark) out.put(' ', columns.raw - Columns::path - path.size());
  if (!has_remark) {
    out.put(raw);
  } else {
    const std::size_t width = columns.remark - columns.raw;
    if (raw.starts_with('"')) {
      out.put(fmt::format("{:<{}}", raw, width));  // fmt knows how wide characters are
    } else {
      out.put(raw);
      out.put(' ', width - raw.size());
    }
    out.put(colors.begin(objection.empty() ? Color::cyan : Color::yellow));
    put_remark(out, meaning, objection);
    out.put(colors.end());
  }
  out.put('\n');
}

void put_values(TextOutput& out, const Rows& rows, const Colors& colors) {
  const Columns columns = columns_of(rows);
  for (const Row& row : rows) {
    const std::string_view path = row.path.text();
    const std::string_view raw = rows.raw(row);
    const std::string_view meaning = rows.meaning(row);
    // Only quoted text contains characters other than ASCII.
    const bool is_plain = columns.are_short && !colors.are_on();
    if (is_plain && row.objection.empty() && !raw.starts_with('"')) {
      put_short(out, path, raw, meaning, columns);
    } else {
      put_line(out, path, raw, meaning, row.objection, columns, colors);
    }
  }
}

}  // namespace

void put_text(TextOutput& out, const DecodedFrame& decoded, const Colors& colors) {
  put_heading(out, decoded, colors);
  if (!decoded.status) put_error(out, decoded, colors);
  if (!decoded.note.empty()) {
    out.put("    ");
    out.put(colors.begin(Color::yellow));
    out.put(decoded.note);
    out.put(colors.end());
    out.put('\n');
  }
  put_values(out, decoded.rows, colors);
  for (const OtherReading& other : decoded.others) {
    out.put("    The request decides what this is: after ");
    out.put(other.request);
    out.put(", it is ");
    out.put(other.message->name);
    out.put(":\n");
    put_values(out, other.rows, colors);
  }
}

}  // namespace sbgc::tools
