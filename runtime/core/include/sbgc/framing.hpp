/// The framings of the byte stream. Only this file defines them: the parser calls it to inspect a
/// position, the writer to complete a frame.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <utility>

#include <sbgc/checksum.hpp>
#include <sbgc/crc.hpp>
#include <sbgc/internal/compiler.hpp>
#include <sbgc/protocol.hpp>

namespace sbgc {

/// True for cyclic redundancy checks, which detect nearly all damage.
constexpr bool is_crc(ChecksumKind kind) noexcept { return kind >= ChecksumKind::crc8; }

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
  Verdict verdict{};   ///< whether a frame begins here
  std::size_t size{};  ///< in bytes; see Verdict
};

namespace detail {

template <std::size_t n, std::size_t m>
consteval bool are(const std::array<FramePart, n>& parts, const std::array<FramePart, m>& wanted) {
  if (n != m) return false;
  for (std::size_t i = 0; i < n; ++i) {
    if (parts[i] != wanted[i]) return false;
  }
  return true;
}

/// True if the trailer's checksum covers the body and the header from some part on.
template <class Facts>
consteval bool covers_all_from(std::size_t part) {
  for (const FramePart covered : Facts::trailer_checksum_covers) {
    if (covered != (part < Facts::header.size() ? Facts::header[part] : FramePart::body)) {
      return false;
    }
    ++part;
  }
  return true;
}

/// All framings have the same header, so that id and size are known before the framing is.
template <Framing framing>
consteval bool has_usual_header() {
  using Facts = FramingFacts<framing>;
  constexpr std::array covered{FramePart::id, FramePart::size};
  const bool is_sum = Facts::header_checksum == ChecksumKind::sum8;
  return is_sum && are(Facts::header, FramingFacts<basic_framing>::header) &&
         are(Facts::header_checksum_covers, covered);
}

/// Returns the algorithm for a kind of checksum in the trailer.
template <class Facts, CrcTable table>
consteval auto trailer_check() {
  if constexpr (Facts::trailer_checksum == ChecksumKind::sum8) {
    return Sum<std::uint8_t>{};
  } else if constexpr (Facts::trailer_checksum == ChecksumKind::sum16) {
    return Sum<std::uint16_t>{};
  } else if constexpr (Facts::trailer_checksum == ChecksumKind::xor8) {
    return ExclusiveOr{};
  } else {
    return Crc<Facts::trailer_checksum_crc, table>{};
  }
}

/// The checksum in the trailer, little-endian. It covers the body, or all bytes from some part of
/// the header on.
template <Framing framing, CrcTable table>
struct Trailer {
  using Facts = FramingFacts<framing>;
  using Check = decltype(trailer_check<Facts, table>());
  using Word = typename Check::Word;
  using Bytes = std::make_index_sequence<sizeof(Word)>;
  static_assert(Facts::trailer_size == sizeof(Word));

  /// The offset of the first byte that it covers.
  static constexpr std::size_t offset =
      frame_header_size + 1 - Facts::trailer_checksum_covers.size();
  static_assert(covers_all_from<Facts>(offset), "another coverage requires another Trailer");

  static constexpr Word sum(const std::uint8_t* frame, const std::uint8_t* content,
                            std::size_t size) noexcept {
    Check check{};
    if constexpr (offset != frame_header_size) {
      check.add(frame + offset, frame_header_size - offset);
    }
    return check.add(content, size).value();
  }
  static constexpr bool matches(const std::uint8_t* frame, std::size_t body_size) noexcept {
    const std::size_t size = frame_header_size - offset + body_size;
    return Check{}.add(frame + offset, size).value() ==
           read(frame + frame_header_size + body_size, Bytes{});
  }
  static constexpr void write(std::uint8_t* place, Word sum) noexcept {
    write(place, sum, Bytes{});
  }

 private:
  template <std::size_t... i>
  static constexpr Word read(const std::uint8_t* place, std::index_sequence<i...>) noexcept {
    return static_cast<Word>(((std::uint32_t{place[i]} << (8 * i)) | ...));
  }
  template <std::size_t... i>
  static constexpr void write(std::uint8_t* place, Word sum, std::index_sequence<i...>) noexcept {
    ((place[i] = static_cast<std::uint8_t>(std::uint32_t{sum} >> (8 * i))), ...);
  }
};

/// True if the trailer is the sum of the bytes of the body.
template <Framing framing>
inline constexpr bool has_body_sum =
    FramingFacts<framing>::trailer_checksum ==
    ChecksumKind::sum8&& FramingFacts<framing>::trailer_checksum_covers.size() == 1;

/// Returns true if the frame_header_size bytes from a start byte on are a valid header.
constexpr bool is_header(const std::uint8_t* bytes) noexcept {
  // No command has the id 0, and a start byte followed by zeros would pass the checks of v1.
  const std::uint8_t id = bytes[frame_id_offset];
  if (max_body_size < 255 && bytes[frame_size_offset] > max_body_size) return false;
  return id != 0 && static_cast<std::uint8_t>(id + bytes[frame_size_offset]) ==
                        bytes[frame_header_checksum_offset];
}

}  // namespace detail

/// Returns the size of a frame with a body of `body_size` bytes.
template <Framing framing = basic_framing>
constexpr std::size_t frame_size(std::size_t body_size) noexcept {
  return frame_header_size + body_size + FramingFacts<framing>::trailer_size;
}

/// One framing: a start byte, a header of id, body size and their sum in any order, the body, and a
/// checksum. `table` is the table of its cyclic redundancy check, if it has one.
template <Framing framing, CrcTable table = CrcTable::slices>
struct FrameFormat {
  /// The facts of the specification about this framing.
  using Facts = FramingFacts<framing>;
  static_assert(detail::has_usual_header<framing>() && Facts::trailer.size() == 1,
                "another header or trailer in the spec requires another is_header(), "
                "skip_blocks() and finish()");

  static constexpr std::uint8_t start = Facts::start;  ///< the first byte of each frame

  /// Inspects the `available` bytes at `bytes`. Precondition: available >= 1.
  static constexpr Candidate inspect(const std::uint8_t* bytes, std::size_t available) noexcept {
    if (bytes[0] != start) return {Verdict::no_start, 0};
    if (available < frame_header_size) return {Verdict::incomplete, frame_header_size};
    if (!detail::is_header(bytes)) return {Verdict::bad_header, 0};
    const std::size_t body_size = bytes[frame_size_offset];
    const std::size_t size = frame_size<framing>(body_size);
    if (available < size) return {Verdict::incomplete, size};
    // Both verdicts have the same size. If it depended on the checksum, inspecting the next frame
    // would have to wait for this one's.
    if (!Trailer::matches(bytes, body_size)) return {Verdict::bad_body, size};
    return {Verdict::frame, size};
  }

  /// Writes header and checksum around the `body_size` bytes (at most max_body_size) at
  /// `frame + frame_header_size`; returns the size of the frame. The checksum is computed from
  /// `content`, the body or the bytes it was copied from: reading bytes just written can stall.
  static constexpr std::size_t finish(std::uint8_t* frame, std::uint8_t id, std::size_t body_size,
                                      const std::uint8_t* content) noexcept {
    write_header(frame, id, body_size);
    Trailer::write(frame + frame_header_size + body_size, Trailer::sum(frame, content, body_size));
    return frame_size<framing>(body_size);
  }

  /// The same for a body whose sum is already known.
  static constexpr std::size_t finish(std::uint8_t* frame, std::uint8_t id, std::size_t body_size,
                                      std::uint8_t sum) noexcept
      requires(detail::has_body_sum<framing>) {
    write_header(frame, id, body_size);
    Trailer::write(frame + frame_header_size + body_size, sum);
    return frame_size<framing>(body_size);
  }

 private:
  using Trailer = detail::Trailer<framing, table>;

  static constexpr void write_header(std::uint8_t* frame, std::uint8_t id,
                                     std::size_t body_size) noexcept {
    frame[0] = start;
    frame[frame_id_offset] = id;
    frame[frame_size_offset] = static_cast<std::uint8_t>(body_size);
    frame[frame_header_checksum_offset] = static_cast<std::uint8_t>(id + body_size);
  }
};

namespace detail {

#if SBGC_HAS_SSE2
/// Advances to the next start byte with a valid header checksum. Stops early if fewer than 16
/// headers are left, or after 255 blocks of 16 positions. In noise, a branch per start byte would
/// often be mispredicted; one per 16 positions hardly ever is.
template <class Starts>
inline const std::uint8_t* skip_blocks(const std::uint8_t* begin, const std::uint8_t* end,
                                       std::uint64_t& bad_headers, const Starts& starts) noexcept {
  constexpr std::ptrdiff_t reach = 16 + frame_header_size - 1;
  constexpr std::ptrdiff_t longest = std::ptrdiff_t{254} * 16;
  if (end - begin < reach) return begin;
  const std::uint8_t* const last = end - begin - reach < longest ? end - reach : begin + longest;
  Bytes16 starts_passed{};
  for (; begin <= last; begin += 16) {
    const Bytes16 here = load16(begin);
    Bytes16 found{};
    for (const std::uint8_t start : starts) {
      found |= reinterpret_cast<Bytes16>(here == Bytes16{} + start);
    }
    const auto sums = reinterpret_cast<Bytes16>(load16(begin + frame_id_offset) +
                                                    load16(begin + frame_size_offset) ==
                                                load16(begin + frame_header_checksum_offset));
    if (const unsigned mask = sign_bits(found & sums); mask != 0) {
      const int position = std::countr_zero(mask);
      const unsigned before = sign_bits(found) & ((1U << position) - 1);
      bad_headers += static_cast<unsigned>(std::popcount(before));
      begin += position;
      break;
    }
    // Equal bytes compare as -1, so a byte of the counter overflows after 255 blocks.
    starts_passed -= found;
  }
  const Words2 halves = sum_halves(starts_passed);
  bad_headers += static_cast<std::uint64_t>(halves[0] + halves[1]);
  return begin;
}
#endif

/// Returns the first position in [begin, end) at which one of the start bytes begins a valid or
/// incomplete header, or `end`. Adds the number of bad headers before it to `bad_headers`.
template <class Starts>
SBGC_ALWAYS_INLINE constexpr const std::uint8_t* find_header(const std::uint8_t* begin,
                                                             const std::uint8_t* end,
                                                             std::uint64_t& bad_headers,
                                                             const Starts& starts) noexcept {
  for (;; ++begin) {
#if SBGC_HAS_SSE2
    if (!detail::is_constant_evaluated()) begin = skip_blocks(begin, end, bad_headers, starts);
#endif
    if (begin == end) return end;
    bool is_start = false;
    for (const std::uint8_t start : starts) is_start = is_start || *begin == start;
    if (!is_start) continue;
    if (static_cast<std::size_t>(end - begin) < frame_header_size || is_header(begin)) {
      return begin;
    }
    ++bad_headers;
  }
}

template <CrcTable table, Framing... known>
constexpr Candidate inspect(const std::uint8_t* bytes, std::size_t available) noexcept {
  Candidate result{Verdict::no_start, 0};
  static_cast<void>(((bytes[0] == FramingFacts<known>::start &&
                      (result = FrameFormat<known, table>::inspect(bytes, available), true)) ||
                     ...));
  return result;
}

/// Completes a frame in one of the known framings; see FrameFormat::finish().
template <CrcTable table, Framing... known>
constexpr std::size_t finish(Framing framing, std::uint8_t* frame, std::uint8_t id,
                             std::size_t body_size, const std::uint8_t* content) noexcept {
  std::size_t size = 0;
  static_cast<void>(
      ((framing == known &&
        (size = FrameFormat<known, table>::finish(frame, id, body_size, content), true)) ||
       ...));
  return size;
}

}  // namespace detail

/// The framings that a parser accepts. The start byte of a candidate selects one of them.
template <CrcTable table, Framing... accepted>
struct FrameFormats {
  static constexpr Framing first = std::array{accepted...}[0];  ///< the default for writing
  static constexpr bool is_one = sizeof...(accepted) == 1;      ///< whether it is the only one

  /// Returns true if a frame may begin with `byte`.
  static constexpr bool is_start(std::uint8_t byte) noexcept {
    return ((byte == FramingFacts<accepted>::start) || ...);
  }

  /// Inspects the `available` bytes at `bytes`. Precondition: available >= 1.
  static constexpr Candidate inspect(const std::uint8_t* bytes, std::size_t available) noexcept {
    return detail::inspect<table, accepted...>(bytes, available);
  }

  /// Returns the first position in [begin, end) for which inspect() returns neither no_start nor
  /// bad_header, or `end`. Adds the number of bad headers before it to `bad_headers`.
  static constexpr const std::uint8_t* find(const std::uint8_t* begin, const std::uint8_t* end,
                                            std::uint64_t& bad_headers) noexcept {
    constexpr std::array starts{FramingFacts<accepted>::start...};
    return detail::find_header(begin, end, bad_headers, starts);
  }

  /// Completes a frame in one of these framings; see FrameFormat::finish().
  static constexpr std::size_t finish(Framing framing, std::uint8_t* frame, std::uint8_t id,
                                      std::size_t body_size, const std::uint8_t* content) noexcept {
    return detail::finish<table, accepted...>(framing, frame, id, body_size, content);
  }
};

/// The same for framings that are selected at run time: initially all `known` ones.
template <CrcTable table, Framing... known>
class SelectedFrameFormats {
 public:
  static constexpr Framing first = std::array{known...}[0];  ///< the default for writing
  static constexpr bool is_one = sizeof...(known) == 1;      ///< true if only one framing is known

  /// Finds frames of all known framings from now on.
  constexpr void accept_all() noexcept { starts_ = {FramingFacts<known>::start...}; }
  /// Finds only frames of this framing from now on.
  constexpr void accept_only(Framing framing) noexcept {
    static_cast<void>(
        ((framing == known && (starts_.fill(FramingFacts<known>::start), true)) || ...));
  }

  /// True if a frame of an accepted framing can begin with this byte.
  constexpr bool is_start(std::uint8_t byte) const noexcept {
    bool result = false;
    for (const std::uint8_t start : starts_) result |= byte == start;
    return result;
  }

  /// Inspects the `available` bytes at `bytes`. Precondition: available >= 1.
  constexpr Candidate inspect(const std::uint8_t* bytes, std::size_t available) const noexcept {
    if (!is_start(bytes[0])) return {Verdict::no_start, 0};
    return detail::inspect<table, known...>(bytes, available);
  }

  /// Returns the first byte that can begin a frame, or `end`.
  constexpr const std::uint8_t* find(const std::uint8_t* begin, const std::uint8_t* end,
                                     std::uint64_t& bad_headers) const noexcept {
    return detail::find_header(begin, end, bad_headers, starts_);
  }

  /// Writes header and checksum around a body that is in place; returns the size of the frame.
  static constexpr std::size_t finish(Framing framing, std::uint8_t* frame, std::uint8_t id,
                                      std::size_t body_size, const std::uint8_t* content) noexcept {
    return detail::finish<table, known...>(framing, frame, id, body_size, content);
  }

 private:
  std::array<std::uint8_t, sizeof...(known)> starts_{FramingFacts<known>::start...};
};

namespace detail {

template <template <CrcTable, Framing...> class Formats, CrcTable table, std::size_t... i>
auto of_all(std::index_sequence<i...>) -> Formats<table, framings[i]...>;

}  // namespace detail

/// All framings of the protocol.
using AllFrameFormats = decltype(detail::of_all<FrameFormats, CrcTable::slices>(
    std::make_index_sequence<framings.size()>{}));
/// The same, selected at run time, with a small table.
using AnyFrameFormats = decltype(detail::of_all<SelectedFrameFormats, CrcTable::bytes>(
    std::make_index_sequence<framings.size()>{}));

}  // namespace sbgc
