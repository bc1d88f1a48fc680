// Generated from spec/ by generator/: edit those, then run ./dev generate.

/// Constants of the framing, the line and the protocol.
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
/// <sbgc/framing.hpp> implements this framing and does not compile for an unsupported one.
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

/// The form of a message among the bodies of its command; `only` if there is one.
enum class Form : std::uint8_t {
  only,
  simple,
  extended,
  success,
  error,
  one_byte,
  disabled,
  speed,
  attitude,
  attitude_packed,
  speed_attitude,
  speed_attitude_packed,
  calibrate,
  wide,
  extended_wide,
  no_register,
  wide_register,
  all,
  selected,
};

/// The newest firmware whose protocol is known as a whole, encoded as FIRMWARE_VER; 0 if unknown.
/// Some messages and values of later firmware are also known.
inline constexpr std::uint16_t newest_firmware = 2740;

/// The pause after a command in milliseconds, so that the board's input buffer does not overflow:
/// after a small request with a small response, and after the largest ones.
inline constexpr std::uint32_t shortest_pause_ms = 10;
inline constexpr std::uint32_t longest_pause_ms = 20;

}  // namespace sbgc
