/// Frames, and functions that write them.
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
  std::uint64_t offset{};                ///< of its start byte in the stream
};

/// Returns ok if a frame with this id and a body of `body_size` bytes can be written into `space`
/// bytes, else invalid_id, too_long or buffer_too_small.
constexpr Status check_frame(std::uint8_t id, std::size_t body_size, std::size_t space) noexcept {
  if (id == 0) return {Code::invalid_id};
  if (body_size > max_body_size) return {Code::too_long, max_body_size};
  if (space < Framing::frame_size(body_size)) return {Code::buffer_too_small};
  return {};
}

/// Returns the position of the body in the frame at `frame`.
constexpr std::uint8_t* frame_body(std::uint8_t* frame) noexcept {
  return frame + frame_header_size;
}

/// Completes a frame whose body is already at frame_body(frame); returns the size of the frame.
/// Precondition: check_frame() returns ok.
constexpr std::size_t finish_frame(std::uint8_t* frame, std::uint8_t id,
                                   std::size_t body_size) noexcept {
  return Framing::finish(frame, id, body_size, frame_body(frame));
}

/// Writes a frame with this id and body into `out`. On failure (see check_frame()) `out` is
/// unchanged. `body` may already be in place in `out`, but must not overlap `out` otherwise.
constexpr WriteResult write_frame(std::uint8_t id, std::span<const std::uint8_t> body,
                                  std::span<std::uint8_t> out) noexcept {
  if (const Status status = check_frame(id, body.size(), out.size()); !status) return {0, status};
  std::uint8_t* const place = frame_body(out.data());
  if (std::is_constant_evaluated()) {
    for (std::size_t i = 0; i < body.size(); ++i) place[i] = body[i];
  } else if (!body.empty()) {
    __builtin_memmove(place, body.data(), body.size());
  }
  // Summing `body` is correct even if it is in place, where its bytes have not changed.
  return {Framing::finish(out.data(), id, body.size(), body.data()), {}};
}

}  // namespace sbgc
