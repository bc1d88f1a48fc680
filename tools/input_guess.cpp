#include "input_guess.hpp"

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include <sbgc/protocol.hpp>

#include "hex_text.hpp"
#include "wording.hpp"

namespace sbgc::tools {

namespace {

using ByteSpan = std::span<const std::uint8_t>;

/// The checksum of the second framing, which later firmware adds; see the errata of the
/// specification.
std::uint16_t crc16(ByteSpan bytes) {
  constexpr std::uint32_t polynomial = 0x8005;
  std::uint32_t sum = 0;
  for (const std::uint8_t byte : bytes) {
    for (unsigned bit = 0; bit < 8; ++bit) {
      const bool is_odd = ((byte >> bit ^ sum >> 15U) & 1U) != 0;
      sum = (sum << 1U ^ (is_odd ? polynomial : 0)) & 0xFFFFU;
    }
  }
  return static_cast<std::uint16_t>(sum);
}

/// Counts frames with the start byte '$', the same header, and a 16-bit checksum after the body.
std::size_t later_frames_in(ByteSpan bytes) {
  std::size_t count = 0;
  for (std::size_t at = 0; at + frame_header_size < bytes.size(); ++at) {
    const ByteSpan header = bytes.subspan(at, frame_header_size);
    const bool is_header =
        header[0] == '$' && header[1] != 0 && ((header[1] + header[2]) & 0xFF) == header[3];
    const std::size_t end = at + frame_header_size + header[2];
    if (!is_header || end + 2 > bytes.size()) continue;
    const unsigned sum = crc16(bytes.subspan(at + 1, end - at - 1));
    if (bytes[end] + bytes[end + 1] * 256U != sum) continue;
    ++count;
    at = end + 1;
  }
  return count;
}

bool begins_with(ByteSpan bytes, std::string_view magic) {
  return bytes.size() >= magic.size() &&
         std::equal(magic.begin(), magic.end(), bytes.begin(),
                    [](char a, std::uint8_t b) { return static_cast<std::uint8_t>(a) == b; });
}

/// Returns the kind of a file with a known signature; "" if there is none.
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
  if (std::ranges::any_of(packets, has)) {
    return "this is a capture of network packets: extract their payload as raw bytes";
  }
  return "";
}

std::string kind_of_text(ByteSpan bytes) {
  HexDecoder hex;
  std::vector<std::uint8_t> decoded;
  if (!hex.feed(bytes, decoded) && !decoded.empty()) {
    return "this looks like hex text: use --hex";
  }
  const auto first = std::ranges::find_if(bytes, [](std::uint8_t byte) { return byte > ' '; });
  if (first == bytes.end()) return "this is white space";
  if (*first == '{') return "this looks like JSON: use sbgc encode";
  return "this is text, but not hex";
}

}  // namespace

bool is_binary(std::span<const std::uint8_t> bytes) {
  return std::ranges::any_of(bytes, [](std::uint8_t byte) {
    const bool is_space = byte >= '\t' && byte <= '\r';
    return (byte < ' ' && !is_space) || byte == 0x7F;
  });
}

std::string guess_input(std::span<const std::uint8_t> begin, bool is_hex) {
  if (const std::size_t count = later_frames_in(begin); count != 0) {
    return fmt::format(
        "it has {} with the start byte '$', the framing of later firmware, which is not supported",
        counted(count, "frame"));
  }
  if (is_hex) return "";
  std::string kind = known_kind(begin);
  if (kind.empty() && !is_binary(begin)) kind = kind_of_text(begin);
  return kind;
}

}  // namespace sbgc::tools
