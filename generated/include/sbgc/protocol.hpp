// Generated from spec/ by generator/: edit those, then run ./dev generate.

/// Constants of the framing.
/// Source: Message format (L41-L61).
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

}  // namespace sbgc
