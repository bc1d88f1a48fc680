#include "frames/hex_text.hpp"

#include <string_view>
#include <utility>

#include <fmt/format.h>

namespace sbgc::tools {

namespace {

int digit_value(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  if (c >= 'a' && c <= 'f') return c - 'a' + 10;
  if (c >= 'A' && c <= 'F') return c - 'A' + 10;
  return -1;
}

std::string no_digit(char c) {
  const bool printable = c > 0x20 && c < 0x7F;
  return printable ? fmt::format("'{}' is not a hex digit", c)
                   : fmt::format("byte 0x{:02x} is not a hex digit", static_cast<std::uint8_t>(c));
}

}  // namespace

std::optional<TextError> HexDecoder::feed(std::span<const std::uint8_t> text,
                                          std::vector<std::uint8_t>& out) {
  for (const std::uint8_t byte : text) {
    const char c = static_cast<char>(byte);
    ++column_;
    if (c == '\n') {
      if (!end_word(out)) return error("half a byte at the end of the line");
      comment_ = false;
      ++line_;
      column_ = 0;
      continue;
    }
    if (comment_) continue;
    const int digit = digit_value(c);
    if (digit >= 0 && half_) {
      out.push_back(static_cast<std::uint8_t>(high_ << 4 | digit));
      has_two_ = has_two_ || (!is_prefixed_ && (high_ == 0 || !alone_));
      half_ = false;
      alone_ = false;
    } else if (digit >= 0) {
      high_ = static_cast<std::uint8_t>(digit);
      half_ = true;
    } else if (std::string reason = other(c, out); !reason.empty()) {
      return error(std::move(reason));
    }
  }
  return std::nullopt;
}

bool HexDecoder::end_word(std::vector<std::uint8_t>& out) {
  // In a text that writes 05, a single 5 is a truncated byte.
  if (half_ && (!alone_ || (has_two_ && !is_prefixed_))) return false;
  if (half_) out.push_back(high_);
  half_ = false;
  alone_ = true;
  is_prefixed_ = false;
  return true;
}

std::string HexDecoder::other(char c, std::vector<std::uint8_t>& out) {
  const bool is_escape = std::exchange(escape_, c == '\\');
  if ((c == 'x' || c == 'X') && ((half_ && high_ == 0) || is_escape)) {
    half_ = false;  // it was the prefix of a byte
    alone_ = true;
    is_prefixed_ = true;
    return {};
  }
  // The last two are a no-break space of web pages.
  constexpr std::string_view separators = " \t\r,:;.-{}[]()|$\xC2\xA0";
  const bool is_suffix = (c == 'h' || c == 'H') && !half_ && !alone_;  // 3Eh
  // <3E>, but not an arrow.
  const bool was_angle = std::exchange(angle_, c == '<' ? column_ : 0) + 1 == column_;
  const bool is_angle = c == '<' || (c == '>' && (half_ || !alone_));
  if (was_angle && column_ != 1) return "a hex digit must follow '<'";
  const bool is_separator = separators.find(c) != std::string_view::npos || is_suffix || is_angle;
  constexpr std::string_view quotes = "\"'\\";
  const bool is_quote = quotes.find(c) != std::string_view::npos;
  // The b of b'...' is not a digit.
  const bool ends_word = is_separator || c == '#' || (is_prefixed_ && is_quote);
  if ((half_ && !ends_word) || !end_word(out))
    return fmt::format("half a byte: a second digit is missing before '{}'", c);
  if (c == '#') {
    comment_ = true;
    return {};
  }
  return is_separator || is_quote ? std::string() : no_digit(c);
}

std::optional<TextError> HexDecoder::finish(std::vector<std::uint8_t>& out) {
  if (!end_word(out)) return error("half a byte at the end: the number of hex digits is odd");
  return std::nullopt;
}

}  // namespace sbgc::tools
