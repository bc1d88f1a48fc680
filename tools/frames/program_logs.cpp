#include "frames/program_logs.hpp"

#include <algorithm>
#include <array>
#include <span>

#include <fmt/format.h>

#include <sbgc/framing.hpp>
#include <sbgc/internal/words.hpp>

#include "frames/hex_text.hpp"
#include "frames/text_lines.hpp"

namespace sbgc::tools {

namespace {

using Bytes = std::vector<std::uint8_t>;

/// Parses a number of `digits` and surrounding blanks. Returns false if there is none.
bool take_number(std::string_view line, std::size_t& at, std::string_view digits,
                 std::uint64_t& number) {
  at += run_length(line, at, blanks);
  const std::size_t size = run_length(line, at, digits);
  if (size == 0 || size > 8) return false;
  number = number_of(line.substr(at, size), digits == hex_digits ? 16 : 10);
  at += size;
  at += run_length(line, at, blanks);
  return true;
}

bool take(std::string_view line, std::size_t& at, char wanted) {
  at += run_length(line, at, blanks);
  if (at >= line.size() || line[at] != wanted) return false;
  ++at;
  return true;
}

/// Parses bytes in hex; `from` is the column in the line.
std::optional<LineProblem> read_hex(std::string_view text, std::size_t from, Bytes& out) {
  HexDecoder hex;
  auto error = hex.feed({reinterpret_cast<const std::uint8_t*>(text.data()), text.size()}, out);
  if (!error) error = hex.finish(out);
  if (!error) return {};
  return LineProblem{from + error->column - 1, error->reason};
}

/// Returns the position after the name and the parenthesis of a call, as in "read(3, ..."; npos if
/// there is none.
std::size_t find_call(std::string_view line, std::string_view name) {
  for (std::size_t at = 0; (at = line.find(name, at)) != std::string_view::npos; ++at) {
    const std::size_t end = at + name.size();
    const bool is_word = at == 0 || !(has(line, at - 1, letters) || has(line, at - 1, "."));
    if (is_word && (has(line, end, "(") || line.substr(end).starts_with(" resumed>"))) return end;
  }
  return std::string_view::npos;
}

}  // namespace

std::optional<LineProblem> read_debug_tab(std::string_view line, Bytes& out) {
  constexpr std::size_t longest_character = 4;  // in UTF-8
  std::size_t at = line.find('[');
  if (at == std::string_view::npos) return {};
  if (detail::trimmed(line.substr(0, at)).size() > longest_character) {
    return LineProblem{0, "a line begins with the character of a command"};
  }
  std::uint64_t id = 0;
  std::uint64_t size = 0;
  const std::size_t header = at++;
  if (!take_number(line, at, decimal_digits, id) || !take(line, at, ',') ||
      !take_number(line, at, decimal_digits, size) || !take(line, at, ']') || id > 255 ||
      size > max_body_size) {
    return LineProblem{header, "expected [ID,SIZE]"};
  }
  if (!take(line, at, '[')) return LineProblem{at, "expected the body in brackets"};
  const std::size_t begin = at;
  const std::size_t end = line.find(']', at);
  if (end == std::string_view::npos) return LineProblem{line.size(), "']' is missing"};
  Bytes body;
  if (auto problem = read_hex(line.substr(begin, end - begin), begin, body)) return problem;
  if (body.size() != size) {
    return LineProblem{begin, fmt::format("the body has {} bytes, not {}", body.size(), size)};
  }
  at = end + 1;
  std::array<std::uint8_t, max_frame_size> frame{};
  std::copy(body.begin(), body.end(), frame.begin() + frame_header_size);
  AllFrameFormats::finish(basic_framing, frame.data(), static_cast<std::uint8_t>(id), body.size(),
                          body.data());
  const auto shown = std::span(frame).first(frame_header_size + body.size());
  out.insert(out.end(), shown.begin(), shown.end());
  return read_hex(line.substr(at), at, out);  // its own checksum, which may be wrong
}

std::optional<LineProblem> read_strace(std::string_view line, Bytes& out,
                                       std::optional<Direction>& sender) {
  constexpr std::array<std::pair<std::string_view, Direction>, 8> calls{
      {{"write", Direction::to_board},
       {"writev", Direction::to_board},
       {"send", Direction::to_board},
       {"sendto", Direction::to_board},
       {"read", Direction::from_board},
       {"readv", Direction::from_board},
       {"recv", Direction::from_board},
       {"recvfrom", Direction::from_board}}};
  for (const auto& [name, direction] : calls) {
    std::size_t at = find_call(line, name);
    if (at == std::string_view::npos) continue;
    // The bytes that the call has transferred: "= 5"; nothing if it has failed.
    const std::size_t equals = line.rfind(") = ");
    const bool is_done = equals != std::string_view::npos && equals >= at;
    if (is_done && !has(line, equals + 4, decimal_digits)) return {};
    const std::uint64_t transferred =
        is_done
            ? number_of(line.substr(equals + 4, run_length(line, equals + 4, decimal_digits)), 10)
            : line.size();
    sender = direction;
    const std::size_t before = out.size();
    for (; at < line.size() && out.size() - before < transferred; ++at) {
      if (line[at] != '"') continue;
      for (++at; at < line.size() && line[at] != '"';) {
        const std::size_t start = at;
        if (!read_escape(line, at, out)) return LineProblem{start, "unknown escape"};
      }
    }
    out.resize(static_cast<std::size_t>(std::min<std::uint64_t>(out.size(), before + transferred)));
    return {};
  }
  return {};
}

std::optional<LineProblem> read_candump(std::string_view line, Bytes& out,
                                        std::optional<Direction>& sender) {
  std::size_t at = run_length(line, 0, blanks);
  if (has(line, at, "(")) at = std::min(line.find(')', at), line.size() - 1) + 1;
  at += run_length(line, at, blanks);
  const std::size_t interface = line.find_first_of(blanks, at);
  if (interface == std::string_view::npos) return {};
  at = interface + run_length(line, interface, blanks);
  std::size_t digits = run_length(line, at, hex_digits);
  if (const bool is_of_log = digits != 0 && has(line, at + digits, "#"); is_of_log) {
    at += digits + 1;
    if (has(line, at, "#")) at = std::min(at + 2, line.size());  // CAN FD: a digit of flags
    return read_hex(line.substr(at, run_length(line, at, hex_digits)), at, out);
  }
  // With -x: TX or RX, and two flags.
  const std::size_t bracket = line.find('[', at);
  if (bracket == std::string_view::npos) return {};
  if (const auto said = sender_in(line.substr(at, bracket - at))) sender = said;
  std::uint64_t size = 0;
  at = bracket + 1;
  if (!take_number(line, at, decimal_digits, size) || !take(line, at, ']')) return {};
  for (std::uint64_t i = 0; i < size; ++i) {
    at += run_length(line, at, blanks);
    digits = run_length(line, at, hex_digits);
    if (digits != 2) return LineProblem{at, "expected a byte in hex"};
    out.push_back(byte_of(line.substr(at, digits)));
    at += digits;
  }
  return {};
}

std::optional<LineProblem> SocatLines::read(std::string_view line, Bytes& out) {
  constexpr std::string_view length = " length=";
  std::size_t at = run_length(line, 0, blanks);
  const std::size_t announced = line.find(length);
  if (has(line, at, "<>") && announced != std::string_view::npos) {
    if (left_ != 0) return LineProblem{at, fmt::format("{} bytes are missing before it", left_)};
    const std::size_t number = announced + length.size();
    left_ = number_of(line.substr(number, run_length(line, number, decimal_digits)), 10);
    return {};
  }
  for (; left_ != 0; --left_) {
    at += run_length(line, at, blanks);
    if (at == line.size() || run_length(line, at, hex_digits) < 2) break;
    out.push_back(byte_of(line.substr(at, 2)));
    at += 2;
  }
  return {};
}

std::optional<LineProblem> ByteTable::read(std::string_view line, Bytes& out,
                                           std::optional<Direction>& sender) {
  if (detail::trimmed(line).empty()) return {};
  if (delimiter_ == '\0') {
    const std::size_t found = line.find_first_of(",;\t");
    if (found == std::string_view::npos) return LineProblem{0, "expected the titles of columns"};
    delimiter_ = line[found];
  }
  std::vector<std::string_view> cells;
  for (std::size_t at = 0; at <= line.size();) {
    const bool is_quoted = has(line, at, "\"");
    const std::size_t quote = is_quoted ? std::min(line.find('"', at + 1), line.size()) : at;
    const std::size_t end = std::min(line.find(delimiter_, quote), line.size());
    std::string_view cell = detail::trimmed(line.substr(at, end - at));
    if (is_quoted && cell.size() > 1) cell = cell.substr(1, cell.size() - 2);
    cells.push_back(cell);
    at = end + 1;
  }
  if (data_ == none) return read_titles(cells);
  const auto cell = [&](std::size_t column) {
    return column < cells.size() ? cells[column] : std::string_view();
  };
  if (type_ != none && !detail::is_same_word(cell(type_), "data")) return {};
  const std::string_view data = cell(data_);
  if (data.empty()) return {};
  const auto column = static_cast<std::size_t>(data.data() - line.data());
  if (const auto said = sender_in(cell(name_))) sender = said;
  const bool is_hex = data.size() > 2 && data.starts_with("0x");
  const std::string_view digits = is_hex ? data.substr(2) : data;
  const bool is_number =
      digits.size() <= 3 &&
      run_length(digits, 0, is_hex ? hex_digits : decimal_digits) == digits.size();
  const std::uint64_t number = is_number ? number_of(digits, is_hex ? 16 : 10) : 256;
  if (number > 255) return LineProblem{column, "expected a byte, such as 0x3E or 62"};
  out.push_back(static_cast<std::uint8_t>(number));
  return {};
}

std::optional<LineProblem> ByteTable::read_titles(const std::vector<std::string_view>& cells) {
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const auto is_one = [&](std::string_view title) {
      return detail::is_same_word(cells[i], title);
    };
    if (is_one("data") || is_one("value")) data_ = i;
    if (is_one("type")) type_ = i;
    if (is_one("name")) name_ = i;
  }
  if (data_ != none) return {};
  return LineProblem{0, "no column has the title 'data'"};
}

}  // namespace sbgc::tools
