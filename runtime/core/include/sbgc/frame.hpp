/// One frame, and how to write one.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <type_traits>

#include <sbgc/framing.hpp>
#include <sbgc/status.hpp>

namespace sbgc {

/// A frame found in a stream.
struct Frame {
  std::uint8_t id{};                     ///< command id, never 0
  std::span<const std::uint8_t> body{};  ///< a view: valid as long as the bytes it was found in
  std::uint64_t offset{};                ///< of its start byte, counted from the stream's first
};

/// Whether a frame with this id and a body of `body_size` bytes can be written into `space`
/// bytes: ok, or invalid_id, too_long, buffer_too_small.
constexpr Status check_frame(std::uint8_t id, std::size_t body_size, std::size_t space) noexcept {
  if (id == 0) return {Code::invalid_id};
  if (body_size > max_body_size) return {Code::too_long, max_body_size};
  if (space < Framing::frame_size(body_size)) return {Code::buffer_too_small};
  return {};
}

/// Where the body of the frame at `frame` goes.
constexpr std::uint8_t* frame_body(std::uint8_t* frame) noexcept {
  return frame + frame_header_size;
}

/// Completes a frame whose body already stands at frame_body(frame); returns the frame's size.
/// The caller has made sure that check_frame() allows it.
constexpr std::size_t finish_frame(std::uint8_t* frame, std::uint8_t id,
                                   std::size_t body_size) noexcept {
  return Framing::finish(frame, id, body_size, frame_body(frame));
}

/// Writes a frame with this id and body into `out`. On failure (see check_frame()) `out` is
/// untouched. `body` may already stand in its place in `out`, but must not overlap it otherwise.
constexpr WriteResult write_frame(std::uint8_t id, std::span<const std::uint8_t> body,
                                  std::span<std::uint8_t> out) noexcept {
  if (const Status status = check_frame(id, body.size(), out.size()); !status) return {0, status};
  std::uint8_t* const place = frame_body(out.data());
  if (std::is_constant_evaluated()) {
    for (std::size_t i = 0; i < body.size(); ++i) place[i] = body[i];
  } else if (!body.empty()) {
    __builtin_memmove(place, body.data(), body.size());
  }
  // A body that stands in its place keeps its bytes; any other is read where it came from.
  return {Framing::finish(out.data(), id, body.size(), body.data()), {}};
}

}  // namespace sbgc
