#include "frames/input_guess.hpp"

#include <algorithm>
#include <array>
#include <string_view>

#include <fmt/format.h>

#include <sbgc/internal/foreign_kind.hpp>
#include <sbgc/parser.hpp>

#include "frames/pasted_text.hpp"

namespace sbgc::tools {

namespace {

using ByteSpan = std::span<const std::uint8_t>;

bool begins_with(ByteSpan bytes, std::string_view magic) {
  return bytes.size() >= magic.size() &&
         std::equal(magic.begin(), magic.end(), bytes.begin(),
                    [](char a, std::uint8_t b) { return static_cast<std::uint8_t>(a) == b; });
}

/// Returns the file type for a known signature; "" if there is none.
std::string known_kind(ByteSpan bytes) {
  using namespace std::string_view_literals;
  constexpr std::array compressed{"\x1f\x8b"sv,
                                  "\xfd"
                                  "7zXZ"sv,
                                  "\x28\xb5\x2f\xfd"sv, "BZh"sv, "PK\x03\x04"sv};
  constexpr std::array packets{"\xd4\xc3\xb2\xa1"sv, "\xa1\xb2\xc3\xd4"sv, "\x4d\x3c\xb2\xa1"sv,
                               "\x0a\x0d\x0d\x0a"sv};
  const auto has = [&](std::string_view magic) { return begins_with(bytes, magic); };
  if (std::ranges::any_of(compressed, has)) return "this is compressed: unpack it first";
  if (has("\xFF\xFE"sv) || has("\xFE\xFF"sv)) return "this may be text in UTF-16: save it in UTF-8";
  if (std::ranges::any_of(packets, has)) {
    return "this is a capture of network packets: extract their payload as raw bytes";
  }
  return "";
}

std::string kind_of_text(ByteSpan bytes) {
  const ReadingChoice choice = choose_reading(bytes);
  if (!choice.problem && choice.has_bytes) {
    return fmt::format("this looks like {}: use --hex", to_text(choice.reading));
  }
  const auto first = std::ranges::find_if(bytes, [](std::uint8_t byte) { return byte > ' '; });
  if (first == bytes.end()) return "this is white space";
  if (*first == '{') return "this looks like JSON: use sbgc encode";
  const std::string_view kind =
      detail::foreign_kind({reinterpret_cast<const char*>(bytes.data()), bytes.size()});
  if (!kind.empty()) return fmt::format("this is {}", kind);
  if (!choice.problem) return "this is text without bytes";
  return fmt::format("this is text, but not of bytes: {}",
                     to_text(choice.reading, *choice.problem));
}

bool has_frames(ByteSpan bytes) {
  ParserOfAll parser;
  parser.feed(bytes, [](const Frame&) {});
  return parser.counters().frames != 0;
}

}  // namespace

bool is_text_of_bytes(std::span<const std::uint8_t> begin) {
  if (is_binary(begin) || has_frames(begin)) return false;
  const ReadingChoice choice = choose_reading(begin);
  return choice.has_bytes && (!choice.problem || choice.is_likely);
}

bool is_binary(std::span<const std::uint8_t> bytes) {
  return std::ranges::any_of(bytes, [](std::uint8_t byte) {
    const bool is_space = byte >= '\t' && byte <= '\r';
    return (byte < ' ' && !is_space) || byte == 0x7F;
  });
}

std::string guess_input(std::span<const std::uint8_t> begin, bool is_text) {
  if (is_text) return "";
  std::string kind = known_kind(begin);
  if (kind.empty() && !is_binary(begin)) kind = kind_of_text(begin);
  return kind;
}

}  // namespace sbgc::tools
