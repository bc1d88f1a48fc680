/// Frames, and functions that write them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <type_traits>
#include <utility>

#include <sbgc/framing.hpp>
#include <sbgc/internal/compiler.hpp>
#include <sbgc/status.hpp>

namespace sbgc {

namespace detail {

template <std::size_t index, class Function>
constexpr decltype(auto) with_framing(Framing framing, Function& function) {
  if constexpr (index + 1 < framings.size()) {
    if (framing != framings[index]) return with_framing<index + 1>(framing, function);
  }
  return function(std::integral_constant<Framing, framings[index]>{});
}

}  // namespace detail

/// A frame found in a stream.
struct Frame {
  std::uint8_t id{};                     ///< command id, never 0
  std::span<const std::uint8_t> body{};  ///< a view: valid as long as the bytes it was found in
  std::uint64_t offset{};                ///< of its start byte in the stream
  Framing framing = basic_framing;       ///< in which it came
};

/// Returns the framing of a valid frame.
constexpr Framing framing_of(const std::uint8_t* frame) noexcept {
  return [frame]<std::size_t... i>(std::index_sequence<i...>) {
    Framing result = basic_framing;
    static_cast<void>(
        ((frame[0] == FramingFacts<framings[i]>::start && (result = framings[i], true)) || ...));
    return result;
  }
  (std::make_index_sequence<framings.size()>{});
}

/// Returns a view of a valid frame.
constexpr Frame frame_at(const std::uint8_t* bytes, std::uint64_t offset = 0) noexcept {
  return {bytes[frame_id_offset],
          {bytes + frame_header_size, bytes[frame_size_offset]},
          offset,
          framing_of(bytes)};
}

/// Calls `function` with the framing as a std::integral_constant.
template <class Function>
constexpr decltype(auto) with_framing(Framing framing, Function&& function) {
  return detail::with_framing<0>(framing, function);
}

/// True if damage is detected only by combining bytes, as in a sum. Damage that does not change the
/// checksums passes: two opposite bit errors at the same bit position, for example, or a lost byte
/// and a duplicated equal one.
constexpr bool has_only_sums(Framing framing) noexcept {
  return with_framing(framing, [](auto f) { return !is_crc(FramingFacts<f()>::trailer_checksum); });
}

/// Returns the size of a frame with a body of `body_size` bytes.
constexpr std::size_t frame_size(Framing framing, std::size_t body_size) noexcept {
  return with_framing(framing, [body_size](auto f) { return frame_size<f()>(body_size); });
}

/// Returns ok if a frame with this id and a body of `body_size` bytes can be written into `space`
/// bytes, else invalid_id, too_long or buffer_too_small.
template <Framing framing = basic_framing>
constexpr Status check_frame(std::uint8_t id, std::size_t body_size, std::size_t space) noexcept {
  if (id == 0) return {Code::invalid_id};
  if (body_size > max_body_size) return {Code::too_long, max_body_size};
  if (space < frame_size<framing>(body_size)) return {Code::buffer_too_small};
  return {};
}

/// Returns the position of the body in the frame at `frame`.
constexpr std::uint8_t* frame_body(std::uint8_t* frame) noexcept {
  return frame + frame_header_size;
}

/// Completes a frame whose body is already at frame_body(frame); returns the size of the frame.
/// Precondition: check_frame() returns ok.
template <Framing framing = basic_framing, CrcTable table = CrcTable::slices>
constexpr std::size_t finish_frame(std::uint8_t* frame, std::uint8_t id,
                                   std::size_t body_size) noexcept {
  return FrameFormat<framing, table>::finish(frame, id, body_size, frame_body(frame));
}

/// Writes a frame with this id and body into `out`. On failure (see check_frame()) `out` is
/// unchanged. `body` may already be in place in `out`, but must not overlap `out` otherwise.
template <Framing framing = basic_framing, CrcTable table = CrcTable::slices>
constexpr WriteResult write_frame(std::uint8_t id, std::span<const std::uint8_t> body,
                                  std::span<std::uint8_t> out) noexcept {
  if (const Status status = check_frame<framing>(id, body.size(), out.size()); !status) {
    return {0, status};
  }
  std::uint8_t* const place = frame_body(out.data());
  if (detail::is_constant_evaluated()) {
    for (std::size_t i = 0; i < body.size(); ++i) place[i] = body[i];
  } else if (!body.empty()) {
    detail::move_memory(place, body.data(), body.size());
  }
  // The checksum of `body` is correct even if it is in place, where its bytes have not changed.
  return {FrameFormat<framing, table>::finish(out.data(), id, body.size(), body.data()), {}};
}

/// The same for a framing selected at run time.
template <CrcTable table = CrcTable::slices>
constexpr WriteResult write_frame(Framing framing, std::uint8_t id,
                                  std::span<const std::uint8_t> body,
                                  std::span<std::uint8_t> out) noexcept {
  return with_framing(framing, [&](auto f) { return write_frame<f(), table>(id, body, out); });
}

}  // namespace sbgc
