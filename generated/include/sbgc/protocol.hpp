// Generated from spec/ by generator/: edit those, then run ./dev generate.

/// Constants of the framings, the line and the protocol.
/// Source: Message format (L41-L61); Later firmware; Message format (L35-L41); Variables L1031.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace sbgc {

/// The framings of the protocol: what surrounds the body of a message on the line.
enum class Framing : std::uint8_t { v1, v2 };

/// Bytes before the body: start, id, size, header checksum.
inline constexpr std::size_t frame_header_size = 4;
/// Maximum size of a body.
inline constexpr std::size_t max_body_size = 255;
/// Maximum size of a frame in any framing.
inline constexpr std::size_t max_frame_size =
    frame_header_size + max_body_size + 2;
/// Offsets in the header.
inline constexpr std::size_t frame_id_offset = 1;
inline constexpr std::size_t frame_size_offset = 2;
inline constexpr std::size_t frame_header_checksum_offset = 3;

/// The parts of a frame.
enum class FramePart : std::uint8_t {
  start,
  id,
  size,
  header_checksum,
  body,
  body_checksum,
  frame_checksum,
};

/// The algorithm of a checksum: as the sum of all bytes modulo 256 or 65536, as their exclusive or,
/// or as a cyclic redundancy check.
enum class ChecksumKind : std::uint8_t { sum8, sum16, xor8, crc8, crc16, crc32 };

/// The parameters of a cyclic redundancy check, as catalogues list them; Word has its width.
template <class Word>
struct CrcParameters {
  Word polynomial{};
  Word initial{};
  bool reflect_in{};
  bool reflect_out{};
  Word final_xor{};
};

/// The facts of a framing: its start byte, the order of the parts around the body, and what the
/// checksum in the header and the one in the trailer cover. <sbgc/framing.hpp> implements them and
/// does not compile for unsupported ones.
template <Framing framing>
struct FramingFacts;

/// Source: Message format (L41-L61).
template <>
struct FramingFacts<Framing::v1> {
  /// The first firmware and board versions that know it; 0: all.
  static constexpr std::uint16_t since_firmware = 0;
  static constexpr std::uint8_t since_board = 0;
  static constexpr std::uint8_t start = 0x3E;
  static constexpr std::size_t trailer_size = 1;

  static constexpr auto header =
      std::array{FramePart::start, FramePart::id, FramePart::size, FramePart::header_checksum};
  static constexpr auto trailer = std::array{FramePart::body_checksum};

  static constexpr ChecksumKind header_checksum = ChecksumKind::sum8;
  static constexpr auto header_checksum_covers = std::array{FramePart::id, FramePart::size};

  static constexpr ChecksumKind trailer_checksum = ChecksumKind::sum8;
  static constexpr auto trailer_checksum_covers = std::array{FramePart::body};
};

/// Source: Later firmware.
template <>
struct FramingFacts<Framing::v2> {
  /// The first firmware and board versions that know it; 0: all.
  static constexpr std::uint16_t since_firmware = 2680;
  static constexpr std::uint8_t since_board = 0;
  static constexpr std::uint8_t start = 0x24;
  static constexpr std::size_t trailer_size = 2;

  static constexpr auto header =
      std::array{FramePart::start, FramePart::id, FramePart::size, FramePart::header_checksum};
  static constexpr auto trailer = std::array{FramePart::frame_checksum};

  static constexpr ChecksumKind header_checksum = ChecksumKind::sum8;
  static constexpr auto header_checksum_covers = std::array{FramePart::id, FramePart::size};

  static constexpr ChecksumKind trailer_checksum = ChecksumKind::crc16;
  static constexpr auto trailer_checksum_covers =
      std::array{FramePart::id, FramePart::size, FramePart::header_checksum, FramePart::body};
  static constexpr CrcParameters<std::uint16_t> trailer_checksum_crc{
      .polynomial = 0x8005,
      .initial = 0x00,
      .reflect_in = true,
      .reflect_out = false,
      .final_xor = 0x00};
};

/// All framings.
inline constexpr std::array<Framing, 2> framings{Framing::v1, Framing::v2};
/// The framing that every board understands.
inline constexpr Framing basic_framing = framings[0];

constexpr const char* to_string(Framing framing) noexcept {
  switch (framing) {
    case Framing::v1: return "v1";
    case Framing::v2: return "v2";
  }
  return "";
}

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
  calibrate_short,
  calibrate,
  wide,
  extended_wide,
  four,
  no_register,
  wide_register,
  all,
  selected,
};

/// The effects of requests. A request can have several effects, some of them only with certain
/// values in its fields.
enum class Effect : std::uint8_t {
  /// Reads: changes nothing.
  reads = 0x01,
  /// Sets temporarily: a restart of the board discards the change.
  sets = 0x02,
  /// Writes memory: the change survives a power cycle.
  stores = 0x04,
  /// Moves: the camera can move, or the motors gain or lose power.
  moves = 0x08,
  /// Restarts the board: the motors lose power until it is up again.
  restarts = 0x10,
  /// Erases stored data.
  erases = 0x20,
  /// Disconnects: the line no longer carries the protocol; how to end that is unknown.
  disconnects = 0x40,
  /// Unknown: the specification does not describe the command.
  unknown = 0x80,
};

/// The newest firmware whose protocol is known as a whole, encoded as FIRMWARE_VER; 0 if unknown.
/// Some messages and values of later firmware are also known.
inline constexpr std::uint16_t newest_firmware = 2745;

/// The pause after a command in milliseconds, so that the board's input buffer does not overflow:
/// after a small request with a small response, and after the largest ones.
inline constexpr std::uint32_t shortest_pause_ms = 10;
inline constexpr std::uint32_t longest_pause_ms = 20;

}  // namespace sbgc
