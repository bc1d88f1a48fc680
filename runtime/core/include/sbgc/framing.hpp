/// The framing of the byte stream. Only this file defines it: the parser calls it to inspect a
/// position, the writer to complete a frame. Another framing (another start byte or trailer) would
/// be another case in each of its functions.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <span>
#include <type_traits>

#include <sbgc/checksum.hpp>
#include <sbgc/protocol.hpp>

namespace sbgc {

/// The result of inspecting a position in the stream.
enum class Verdict : std::uint8_t {
  frame,       ///< a valid frame of `size` bytes
  incomplete,  ///< undecided until `size` bytes are available
  no_start,    ///< not a frame: does not begin with the start byte
  bad_header,  ///< not a frame: the id is 0 or the header checksum is wrong
  bad_body,    ///< not a frame: the body checksum is wrong
};

/// A verdict and the number of bytes it refers to (0 without a valid header).
struct Candidate {
  Verdict verdict{};
  std::size_t size{};
};

namespace detail {

constexpr bool are(std::span<const FramePart> parts, std::initializer_list<FramePart> wanted) {
  if (parts.size() != wanted.size()) return false;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (parts[i] != wanted.begin()[i]) return false;
  }
  return true;
}

static_assert(FrameParts::header_checksum == FrameParts::Checksum::sum8 &&
                  are(FrameParts::header_checksum_covers, {FramePart::id, FramePart::size}),
              "another header checksum in spec/simplebgc.yaml requires another is_header(), "
              "skip_blocks() and finish()");
static_assert(are(FrameParts::trailer, {FramePart::body_checksum}) &&
                  FrameParts::body_checksum == FrameParts::Checksum::sum8 &&
                  are(FrameParts::body_checksum_covers, {FramePart::body}),
              "another trailer in spec/simplebgc.yaml requires another inspect() and finish(), and "
              "another sum where byte_sum() and ByteSum are used");

}  // namespace detail

/// The framing that FrameParts describes: a start byte, a header of id, body size and their sum in
/// any order, the body, and its sum.
struct Framing {
  /// Inspects the `available` bytes at `bytes`. Precondition: available >= 1.
  static constexpr Candidate inspect(const std::uint8_t* bytes, std::size_t available) noexcept {
    if (bytes[0] != frame_start) return {Verdict::no_start, 0};
    if (available < frame_header_size) return {Verdict::incomplete, frame_header_size};
    if (!is_header(bytes)) return {Verdict::bad_header, 0};
    const std::size_t body_size = bytes[frame_size_offset];
    const std::size_t size = frame_size(body_size);
    if (available < size) return {Verdict::incomplete, size};
    const std::uint8_t* const content = bytes + frame_header_size;
    // Both verdicts have the same size. If it depended on the checksum, inspecting the next frame
    // would have to wait for this one's.
    if (byte_sum(content, body_size) != content[body_size]) return {Verdict::bad_body, size};
    return {Verdict::frame, size};
  }

  /// Returns the first position in [begin, end) for which inspect() returns neither no_start nor
  /// bad_header, or `end`. Adds the number of bad headers before it to `bad_headers`.
  static constexpr const std::uint8_t* find(const std::uint8_t* begin, const std::uint8_t* end,
                                            std::uint64_t& bad_headers) noexcept {
    for (;; ++begin) {
#if defined(__SSE2__)
      if (!std::is_constant_evaluated()) begin = skip_blocks(begin, end, bad_headers);
#endif
      if (begin == end) return end;
      if (*begin != frame_start) continue;
      if (static_cast<std::size_t>(end - begin) < frame_header_size || is_header(begin)) {
        return begin;
      }
      ++bad_headers;
    }
  }

  /// The id and the body of a valid frame.
  static constexpr std::uint8_t id(const std::uint8_t* frame) noexcept {
    return frame[frame_id_offset];
  }
  static constexpr std::span<const std::uint8_t> body(const std::uint8_t* frame) noexcept {
    return {frame + frame_header_size, frame[frame_size_offset]};
  }

  /// Returns the size of a frame with a body of `body_size` bytes.
  static constexpr std::size_t frame_size(std::size_t body_size) noexcept {
    return frame_header_size + body_size + frame_trailer_size;
  }

  /// Writes header and checksum around the `body_size` bytes (at most max_body_size) at
  /// `frame + frame_header_size`; returns the size of the frame. The checksum is computed from
  /// `content`, the body or the bytes it was copied from: reading bytes just written can stall.
  static constexpr std::size_t finish(std::uint8_t* frame, std::uint8_t id, std::size_t body_size,
                                      const std::uint8_t* content) noexcept {
    return finish(frame, id, body_size, byte_sum(content, body_size));
  }

  /// As above, for a body whose checksum `sum` is already known.
  static constexpr std::size_t finish(std::uint8_t* frame, std::uint8_t id, std::size_t body_size,
                                      std::uint8_t sum) noexcept {
    frame[0] = frame_start;
    frame[frame_id_offset] = id;
    frame[frame_size_offset] = static_cast<std::uint8_t>(body_size);
    frame[frame_header_checksum_offset] = static_cast<std::uint8_t>(id + body_size);
    frame[frame_header_size + body_size] = sum;
    return frame_size(body_size);
  }

 private:
  /// Returns true if the frame_header_size bytes from a start byte on are a valid header.
  static constexpr bool is_header(const std::uint8_t* bytes) noexcept {
    // No command has the id 0, and a start byte followed by zeros would pass both checksums.
    const std::uint8_t id = bytes[frame_id_offset];
    if (max_body_size < 255 && bytes[frame_size_offset] > max_body_size) return false;
    return id != 0 && static_cast<std::uint8_t>(id + bytes[frame_size_offset]) ==
                          bytes[frame_header_checksum_offset];
  }

#if defined(__SSE2__)
  /// Advances to the next start byte with a valid header checksum. Stops early if fewer than 16
  /// headers are left, or after 255 blocks of 16 positions. In noise, a branch per start byte would
  /// often be mispredicted; one per 16 positions hardly ever is.
  static const std::uint8_t* skip_blocks(const std::uint8_t* begin, const std::uint8_t* end,
                                         std::uint64_t& bad_headers) noexcept {
    using detail::Bytes16;
    using detail::load16;
    constexpr std::ptrdiff_t reach = 16 + frame_header_size - 1;
    constexpr std::ptrdiff_t longest = std::ptrdiff_t{254} * 16;
    constexpr Bytes16 start = Bytes16{} + frame_start;
    if (end - begin < reach) return begin;
    const std::uint8_t* const last = end - begin - reach < longest ? end - reach : begin + longest;
    Bytes16 starts_passed{};
    for (; begin <= last; begin += 16) {
      const auto starts = reinterpret_cast<Bytes16>(load16(begin) == start);
      const auto sums = reinterpret_cast<Bytes16>(load16(begin + frame_id_offset) +
                                                      load16(begin + frame_size_offset) ==
                                                  load16(begin + frame_header_checksum_offset));
      if (const unsigned mask = detail::sign_bits(starts & sums); mask != 0) {
        const int position = std::countr_zero(mask);
        unsigned before = detail::sign_bits(starts) & ((1U << position) - 1);
        bad_headers += static_cast<unsigned>(std::popcount(before));
        begin += position;
        break;
      }
      // Equal bytes compare as -1, so a byte of the counter overflows after 255 blocks.
      starts_passed -= starts;
    }
    const detail::Words2 halves = detail::sum_halves(starts_passed);
    bad_headers += static_cast<std::uint64_t>(halves[0] + halves[1]);
    return begin;
  }
#endif
};

}  // namespace sbgc
