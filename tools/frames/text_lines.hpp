/// Parses bytes in a line of text, in various notations.
#pragma once

#include <algorithm>
#include <charconv>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <sbgc/codec.hpp>

namespace sbgc::tools {

/// The text before the bytes of a line: "12:34:56.789 TX: ", "uint8_t frame[] = ".
struct LineFront {
  std::size_t size = 0;
  std::optional<Direction> sender{};  ///< if it is named: TX means the host
};

LineFront front_of(std::string_view line);

/// Returns the sender that the words of a label name, unless they are contradictory.
std::optional<Direction> sender_in(std::string_view label);

/// True for words between lines of bytes, such as "and got this".
bool is_prose(std::string_view line);

/// Returns the line with C comments replaced by spaces.
std::string without_comments(std::string_view line);

/// The reason why a line cannot be read, and the column, counted from 0.
struct LineProblem {
  std::size_t column{};
  std::string reason{};
};

// Each appends the bytes of a line to `out`, up to the first problem.

/// "[62, 67, 15]", also with negative numbers for signed bytes.
std::optional<LineProblem> read_decimal(std::string_view line, std::vector<std::uint8_t>& out);
/// String literals of Python and C: "b'\x3eV\x00'". Text outside of quotes is ignored.
std::optional<LineProblem> read_literals(std::string_view line, std::vector<std::uint8_t>& out);
/// ">V{12}h{1F}": characters, and bytes in hex in braces.
std::optional<LineProblem> read_braced(std::string_view line, std::vector<std::uint8_t>& out);

/// Lines of xxd, hexdump -C, od -t x1 and Wireshark: an offset, bytes in hex, and perhaps the same
/// as characters. A '*' repeats the previous line.
class DumpLines {
 public:
  std::optional<LineProblem> read(std::string_view line, std::vector<std::uint8_t>& out);

 private:
  /// Repeats the last line up to this offset. Returns false if it does not fit.
  bool repeat_row(std::uint64_t end, std::vector<std::uint8_t>& out);

  std::uint64_t next_ = 0;  // the expected offset
  std::vector<std::uint8_t> row_{};
  bool has_star_ = false;
};

inline constexpr std::string_view blanks = " \t\r";
inline constexpr std::string_view decimal_digits = "0123456789";
inline constexpr std::string_view hex_digits = "0123456789abcdefABCDEF";
inline constexpr std::string_view letters = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ_";

inline bool is_one_of(char c, std::string_view set) {
  return set.find(c) != std::string_view::npos;
}

/// Returns the length of the run of characters of `set` in `text` that begins at `at`.
inline std::size_t run_length(std::string_view text, std::size_t at, std::string_view set) {
  const std::size_t end = std::min(text.find_first_not_of(set, at), text.size());
  return end - std::min(at, end);
}

inline bool has(std::string_view text, std::size_t at, std::string_view set) {
  return at < text.size() && is_one_of(text[at], set);
}

inline std::uint64_t number_of(std::string_view digits, int base) {
  std::uint64_t value = 0;
  std::from_chars(digits.data(), digits.data() + digits.size(), value, base);
  return value;
}

inline std::uint8_t byte_of(std::string_view digits, int base = 16) {
  return static_cast<std::uint8_t>(number_of(digits, base));
}

/// Reads one character or escape inside quotes. Returns false for an unknown escape.
bool read_escape(std::string_view line, std::size_t& at, std::vector<std::uint8_t>& out);

}  // namespace sbgc::tools
