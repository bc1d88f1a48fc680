// Generated from spec/ by generator/: edit those, then run ./dev generate.

/// Constants of the framing, of the line, and of the protocol as a whole.
/// Source: Message format (L41-L61); Message format (L35-L41); Variables L1031.
#pragma once

#include <cstddef>
#include <cstdint>

namespace sbgc {

/// First byte of every frame.
inline constexpr std::uint8_t frame_start = 0x3E;
/// Bytes in front of the body: start byte, command id, body size, header checksum.
inline constexpr std::size_t frame_header_size = 4;
/// Bytes behind the body: its checksum.
inline constexpr std::size_t frame_trailer_size = 1;
/// Most bytes of a body.
inline constexpr std::size_t max_body_size = 255;
/// Most bytes of a whole frame.
inline constexpr std::size_t max_frame_size =
    frame_header_size + max_body_size + frame_trailer_size;

/// Which of the bodies of a command a message is; `only` if there is one.
enum class Form : std::uint8_t {
  only,
  simple,
  extended,
  success,
  error,
  one_byte,
  wide,
  extended_wide,
};

/// The newest firmware that the protocol as a whole is known of, as FIRMWARE_VER has it; 0 if that
/// is not known. Some messages and values of later firmware are known beside it.
inline constexpr std::uint16_t newest_firmware = 2599;

/// Break behind a command in milliseconds, so that the board's input buffer does not overflow:
/// behind a small request with a small answer, and behind the largest.
inline constexpr std::uint32_t shortest_pause_ms = 10;
inline constexpr std::uint32_t longest_pause_ms = 20;

}  // namespace sbgc
