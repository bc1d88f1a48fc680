// Generated from spec/ by generator/: edit those, then run ./dev generate.

/// Constants of the framing, of the line, and of the protocol as a whole.
/// Source: Message format (L41-L61); Message format (L35-L41); Variables L1031.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace sbgc {

/// First byte of every frame.
inline constexpr std::uint8_t frame_start = 0x3E;
/// Bytes before the body: start, id, size, header checksum.
inline constexpr std::size_t frame_header_size = 4;
/// Bytes after the body: body checksum.
inline constexpr std::size_t frame_trailer_size = 1;
/// Maximum size of a body.
inline constexpr std::size_t max_body_size = 255;
/// Maximum size of a frame.
inline constexpr std::size_t max_frame_size =
    frame_header_size + max_body_size + frame_trailer_size;
/// Offsets in the header.
inline constexpr std::size_t frame_id_offset = 1;
inline constexpr std::size_t frame_size_offset = 2;
inline constexpr std::size_t frame_header_checksum_offset = 3;

/// The parts of a frame.
enum class FramePart : std::uint8_t { start, id, size, body, header_checksum, body_checksum };

/// The order of the parts before and after the body, and what each checksum covers.
/// <sbgc/framing.hpp> implements this framing and does not compile for one that it cannot handle.
struct FrameParts {
  /// How a checksum is computed; sum8 is the sum of all bytes modulo 256.
  enum class Checksum : std::uint8_t { sum8 };

  static constexpr auto header =
      std::array{FramePart::start, FramePart::id, FramePart::size, FramePart::header_checksum};
  static constexpr auto trailer = std::array{FramePart::body_checksum};

  static constexpr Checksum header_checksum = Checksum::sum8;
  static constexpr auto header_checksum_covers = std::array{FramePart::id, FramePart::size};

  static constexpr Checksum body_checksum = Checksum::sum8;
  static constexpr auto body_checksum_covers = std::array{FramePart::body};
};

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
