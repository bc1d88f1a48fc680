#include "frames/text_lines.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <initializer_list>
#include <utility>

#include <fmt/format.h>

#include <sbgc/internal/words.hpp>

namespace sbgc::tools {

namespace {

constexpr std::string_view other_letters = "ghijklmnopqrstuvwxyzGHIJKLMNOPQRSTUVWXYZ";

/// Words in logs that name the sender of the bytes.
constexpr std::array<std::pair<std::string_view, Direction>, 17> sender_words{
    {{"tx", Direction::to_board},
     {"rx", Direction::from_board},
     {"sent", Direction::to_board},
     {"send", Direction::to_board},
     {"received", Direction::from_board},
     {"recv", Direction::from_board},
     {"->", Direction::to_board},
     {"<-", Direction::from_board},
     {">>", Direction::to_board},
     {"<<", Direction::from_board},
     {"sending", Direction::to_board},
     {"receiving", Direction::from_board},
     {"request", Direction::to_board},
     {"command", Direction::to_board},
     {"response", Direction::from_board},
     {"answer", Direction::from_board},
     {"reply", Direction::from_board}}};

/// Parses a time, a sender and a label at the front of a line.
class FrontReader {
 public:
  explicit FrontReader(std::string_view line) : line_(line) { skip_blanks(); }

  LineFront read() {
    skip_separator();  // of quoted lines: "> 3e 56"
    // They can come in any order.
    while (take_time() || take_label() || take_sender()) skip_separator();
    take_assignment();
    return {at_, sender_};
  }

 private:
  void skip_blanks() { at_ += run_length(line_, at_, blanks); }

  void skip_separator() {
    skip_blanks();
    // Many frames begin with '>'.
    const bool is_prompt = has(line_, at_, "<>-") && has(line_, at_ + 1, blanks);
    if (is_prompt || has(line_, at_, ":|,=")) ++at_;
    skip_blanks();
  }

  /// "12:34:56.789", "[2026-11-26 12:34:56]", "(12.345)", "12.345 s".
  bool take_time() {
    std::size_t at = at_;
    const bool is_bracketed = has(line_, at, "[(");
    if (is_bracketed) ++at;
    at += date_at(at);
    const std::size_t size = clock_at(at) != 0 ? clock_at(at) : seconds_at(at);
    if (size == 0) return false;
    at += size;
    if (is_bracketed && !has(line_, at++, "])")) return false;
    if (at < line_.size() && !has(line_, at, " \t:|,")) return false;
    at_ = at;
    return true;
  }

  /// "2026-11-26T", "26.11.2026 ".
  std::size_t date_at(std::size_t at) const {
    const std::size_t first = run_length(line_, at, decimal_digits) == 4 ? 4 : 2;
    const std::size_t last = at + first + 4;
    const bool is_date =
        run_length(line_, at, decimal_digits) == first && has(line_, at + first, "-/.") &&
        run_length(line_, at + first + 1, decimal_digits) == 2 && has(line_, last - 1, "-/.") &&
        run_length(line_, last, decimal_digits) == 6 - first && has(line_, at + 10, " T");
    return is_date ? 11 : 0;
  }

  std::size_t clock_at(std::size_t at) const {
    const std::size_t hours = run_length(line_, at, decimal_digits);
    const std::size_t colon = at + hours;
    if (hours == 0 || hours > 2 || !has(line_, colon, ":") || !has(line_, colon + 3, ":")) return 0;
    std::size_t end = colon + 6;
    if (run_length(line_, colon + 1, decimal_digits) != 2 ||
        run_length(line_, colon + 4, decimal_digits) != 2) {
      return 0;
    }
    if (has(line_, end, ".,") && has(line_, end + 1, decimal_digits)) {
      end += 1 + run_length(line_, end + 1, decimal_digits);
    }
    return end + suffix_at(end, {"Z", " AM", " PM"}) - at;
  }

  std::size_t seconds_at(std::size_t at) const {
    const std::size_t whole = run_length(line_, at, decimal_digits);
    const std::size_t point = at + whole;
    if (whole == 0 || !has(line_, point, ".")) return 0;
    const std::size_t fraction = run_length(line_, point + 1, decimal_digits);
    const std::size_t end = point + 1 + fraction;
    if (fraction == 0) return 0;
    return end + suffix_at(end, {"s", " s", "ms", " ms"}) - at;
  }

  /// Returns the size of the suffix at this position if it is a whole word.
  std::size_t suffix_at(std::size_t at, std::initializer_list<std::string_view> suffixes) const {
    for (const std::string_view one : suffixes) {
      if (line_.substr(at).starts_with(one) && !has(line_, at + one.size(), letters)) {
        return one.size();
      }
    }
    return 0;
  }

  bool take_sender() {
    const std::size_t start = at_ + (has(line_, at_, "[(") ? 1 : 0);
    for (const auto& [word, sender] : sender_words) {
      const std::string_view found = line_.substr(std::min(start, line_.size()), word.size());
      const std::size_t end = start + word.size();
      if (!detail::is_same_word(found, word)) continue;
      if (is_one_of(word.front(), letters) &&
          (has(line_, end, letters) || has(line_, end, hex_digits))) {
        continue;
      }
      at_ = end + (has(line_, end, "])") ? 1 : 0);
      sender_ = sender;
      return true;
    }
    return false;
  }

  /// "Data: ", "uart-1: ", "[INFO] - TX: ": words with a colon that cannot be bytes.
  bool take_label() {
    constexpr std::string_view more = "0123456789 \t()[]._-#/&<>";
    std::size_t end = at_;
    while (has(line_, end, letters) || has(line_, end, more)) ++end;
    const std::string_view label = line_.substr(at_, end - at_);
    const bool is_begin = has(line_, at_, letters) || has(line_, at_, "[(");
    const bool is_end = end + 1 == line_.size() || has(line_, end + 1, blanks);
    if (!is_begin || !has(line_, end, ":") || !is_end) return false;
    if (label.find_first_of(other_letters) == std::string_view::npos) return false;
    if (const auto said = sender_in(label)) sender_ = said;
    at_ = end + 1;
    return true;
  }

  /// "uint8_t frame[] = ", "bytes(", "Uint8Array(5) ", "<Buffer ".
  void take_assignment() {
    const std::size_t equals = line_.find('=', at_);
    const std::string_view name = line_.substr(std::min(at_, line_.size()), equals - at_);
    const bool is_name = !name.empty() && is_one_of(name.front(), letters) &&
                         name.find_first_of("'\"{,") == std::string_view::npos;
    if (equals != std::string_view::npos && is_name) at_ = equals + 1;
    skip_blanks();
    constexpr std::string_view buffer = "<Buffer ";
    if (line_.substr(at_).starts_with(buffer)) at_ += buffer.size();
    std::size_t open = at_ + run_length(line_, at_, letters);
    while (open != at_ && (has(line_, open, letters) || has(line_, open, "0123456789."))) ++open;
    if (open == at_ || !has(line_, open, "(")) return;
    at_ = open + 1;
    const std::size_t size = run_length(line_, at_, decimal_digits);
    if (size != 0 && has(line_, at_ + size, ")")) at_ += size + 1;
  }

  std::string_view line_;
  std::size_t at_ = 0;
  std::optional<Direction> sender_{};
};

}  // namespace

bool read_escape(std::string_view line, std::size_t& at, std::vector<std::uint8_t>& out) {
  if (line[at] != '\\') {
    out.push_back(static_cast<std::uint8_t>(line[at++]));
    return true;
  }
  constexpr std::string_view names = "abfnrtv\\'\"";
  constexpr std::string_view values = "\a\b\f\n\r\t\v\\'\"";
  ++at;
  if (has(line, at, "x") && run_length(line, at + 1, hex_digits) >= 2) {
    out.push_back(byte_of(line.substr(at + 1, 2)));
    at += 3;
    return true;
  }
  if (const std::size_t size = std::min(run_length(line, at, "01234567"), std::size_t{3});
      size != 0) {
    out.push_back(byte_of(line.substr(at, size), 8));
    at += size;
    return true;
  }
  if (!has(line, at, names)) return false;
  out.push_back(static_cast<std::uint8_t>(values[names.find(line[at++])]));
  return true;
}

std::optional<Direction> sender_in(std::string_view label) {
  std::optional<Direction> said;
  for (std::size_t at = 0; at < label.size(); ++at) {
    const std::string_view word = label.substr(at, run_length(label, at, letters));
    for (const auto& [one, sender] : sender_words) {
      if (!detail::is_same_word(word, one)) continue;
      if (said && *said != sender) return {};
      said = sender;
    }
    at += word.size();
  }
  return said;
}

LineFront front_of(std::string_view line) { return FrontReader(line).read(); }

bool is_prose(std::string_view line) {
  const std::string_view text = detail::trimmed(line);
  if (text.starts_with("```")) return true;  // the fence of a block in a forum
  if (text.find_first_of("0123456789'\"\\{}=>") != std::string_view::npos) return false;
  constexpr std::size_t least = 4;  // a shorter word can be a mistyped byte
  for (std::size_t at = 0; at < text.size(); ++at) {
    const std::string_view word = text.substr(at, run_length(text, at, letters));
    const bool is_other = word.find_first_of(other_letters) != std::string_view::npos;
    if (word.size() >= least && is_other) return true;
    at += word.size();
  }
  return false;
}

std::string without_comments(std::string_view line) {
  std::string result(line);
  for (std::size_t at = 0; (at = result.find('/', at)) != std::string::npos; ++at) {
    std::size_t end = result.size();
    if (has(result, at + 1, "*")) {
      end = result.find("*/", at + 2);
      if (end == std::string::npos) break;
      end += 2;
    } else if (!has(result, at + 1, "/")) {
      continue;
    }
    result.replace(at, end - at, end - at, ' ');
  }
  return result;
}

std::optional<LineProblem> read_decimal(std::string_view line, std::vector<std::uint8_t>& out) {
  constexpr std::string_view separators = " \t\r,;{}[]()";
  for (std::size_t at = 0; at < line.size();) {
    if (line[at] == '#') return {};
    if (is_one_of(line[at], separators)) {
      ++at;
      continue;
    }
    const std::size_t end = std::min(line.find_first_of(separators, at), line.size());
    int value = 0;
    const auto [stopped, error] = std::from_chars(line.data() + at, line.data() + end, value);
    const bool is_byte = error == std::errc{} && stopped == line.data() + end;
    if (!is_byte || value < -128 || value > 255) {
      return LineProblem{at, "expected a number from -128 to 255"};
    }
    out.push_back(static_cast<std::uint8_t>(value));
    at = end;
  }
  return {};
}

std::optional<LineProblem> read_literals(std::string_view line, std::vector<std::uint8_t>& out) {
  const bool is_comment = has(line, run_length(line, 0, blanks), "#");
  for (std::size_t at = 0; at < line.size() && !is_comment;) {
    const char quote = line[at++];
    if (quote != '\'' && quote != '"') {
      if (!is_one_of(quote, " \t\r,;[](){}+:bB")) return LineProblem{at - 1, "expected a quote"};
      continue;
    }
    while (at < line.size() && line[at] != quote) {
      const std::size_t start = at;
      if (!read_escape(line, at, out)) return LineProblem{start, "unknown escape"};
    }
    if (at == line.size()) return LineProblem{at, fmt::format("{} is missing", quote)};
    ++at;
  }
  return {};
}

std::optional<LineProblem> read_braced(std::string_view line, std::vector<std::uint8_t>& out) {
  if (line.ends_with('\r')) line.remove_suffix(1);
  for (std::size_t at = 0; at < line.size();) {
    const char c = line[at];
    if (c != '{') {
      if (c < ' ' || c > '~') return LineProblem{at, "this byte is not a character of ASCII"};
      out.push_back(static_cast<std::uint8_t>(c));
      ++at;
      continue;
    }
    if (run_length(line, at + 1, hex_digits) != 2 || !has(line, at + 3, "}")) {
      return LineProblem{at, "two hex digits and '}' must follow '{'"};
    }
    out.push_back(byte_of(line.substr(at + 1, 2)));
    at += 4;
  }
  return {};
}

std::optional<LineProblem> DumpLines::read(std::string_view line, std::vector<std::uint8_t>& out) {
  std::size_t at = run_length(line, 0, blanks);
  if (at == line.size() || line[at] == '#') return {};
  if (line[at] == '*') {
    has_star_ = true;
    return {};
  }
  const std::size_t digits = run_length(line, at, hex_digits);
  const std::string_view offset = line.substr(at, digits);
  const bool has_offset = digits >= 4 && digits <= 16;
  const std::size_t end_of_offset = at + digits + (has(line, at + digits, ":") ? 1 : 0);
  if (!has_offset || (end_of_offset != line.size() && !has(line, end_of_offset, blanks))) {
    return LineProblem{at, "a line of a dump begins with an offset"};
  }
  // od uses octal offsets with 7 digits. A dump of several frames restarts at 0.
  const bool is_of_od = digits == 7;
  const std::uint64_t number = number_of(offset, 16);
  if (number == 0) next_ = 0;
  if (std::exchange(has_star_, false)) {
    if (!repeat_row(number_of(offset, is_of_od ? 8 : 16), out)) {
      return LineProblem{at, "'*' stands for lines that are not clear; dump all with -v"};
    }
  } else if (number != next_ && number_of(offset, 8) != next_) {
    return LineProblem{at, fmt::format("the offset of this line should be {:#x}", next_)};
  }
  at = end_of_offset;
  std::size_t bytes = 0;
  row_.clear();
  while (true) {
    const std::size_t gap = run_length(line, at, blanks);
    at += gap;
    const std::size_t size = run_length(line, at, hex_digits);
    const bool is_end = at + size == line.size() || has(line, at + size, blanks);
    const bool is_group = size != 0 && size % 2 == 0 && is_end;
    // The halves of a line may be separated; then the same bytes follow as characters.
    const bool is_apart = bytes != 0 && gap >= 2 && !(bytes == 8 && gap == 2 && size == 2);
    if (at == line.size() || is_apart) break;
    if (!is_group) {
      if (bytes == 8 && gap == 2) break;
      return LineProblem{at, "expected a byte in hex"};
    }
    if (is_of_od && size == 4) {
      return LineProblem{at + size - 1,
                         "the order of the bytes in these words is not clear; use hexdump -C"};
    }
    for (std::size_t i = 0; i < size; i += 2) row_.push_back(byte_of(line.substr(at + i, 2)));
    bytes += size / 2;
    at += size;
  }
  out.insert(out.end(), row_.begin(), row_.end());
  next_ += bytes;
  return {};
}

bool DumpLines::repeat_row(std::uint64_t end, std::vector<std::uint8_t>& out) {
  constexpr std::uint64_t most = 16U << 20U;
  if (row_.empty() || end <= next_ || end - next_ > most || (end - next_) % row_.size() != 0) {
    return false;
  }
  for (; next_ != end; next_ += row_.size()) out.insert(out.end(), row_.begin(), row_.end());
  return true;
}

}  // namespace sbgc::tools
