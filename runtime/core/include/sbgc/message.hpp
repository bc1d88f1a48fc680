/// Messages in frames.
#pragma once

#include <concepts>
#include <type_traits>

#include <sbgc/codec.hpp>
#include <sbgc/frame.hpp>

namespace sbgc {

/// What every generated message has.
template <class M>
concept Message = requires(const M& message, std::span<std::uint8_t> out) {
  M::command;
  M::direction;
  M::form;
  M::min_size;
  M::max_size;
  { encode(message, out) } -> std::same_as<WriteResult>;
};

namespace detail {

/// The sum of a message's bytes without reading back what has just been written, which is slow; for
/// messages that stand in memory as on the wire.
template <class M>
inline Optional<std::uint8_t> sum_in_memory(const M& message) noexcept {
  if constexpr (requires(ByteSum sum) { add_in_memory(sum, message); }) {
    if (ByteSum sum; add_in_memory(sum, message)) return sum.value();
  }
  return {};
}

}  // namespace detail

/// Writes a message with its frame around it into `out`; returns the size of the frame, or why it
/// could not be written. max_frame_size bytes are always enough.
template <Message M>
[[nodiscard]] constexpr WriteResult encode_frame(const M& message,
                                                 std::span<std::uint8_t> out) noexcept {
  constexpr std::size_t overhead = frame_header_size + frame_trailer_size;
  if (out.size() < overhead) return {0, {Code::buffer_too_small}};
  const std::size_t space = out.size() - overhead;
  const WriteResult body =
      encode(message, {frame_body(out.data()), space < max_body_size ? space : max_body_size});
  if (!body) {
    const bool any_frame_fits = space >= max_body_size;
    const bool full = body.status.code == Code::buffer_too_small;
    const Code code = full && any_frame_fits ? Code::too_long : body.status.code;
    return {0, {code, body.status.offset, body.status.field}};
  }
  constexpr auto id = static_cast<std::uint8_t>(M::command);
  if (!std::is_constant_evaluated()) {
    if (const auto sum = detail::sum_in_memory(message)) {
      return {Framing::finish(out.data(), id, body.size, *sum), {}};
    }
  }
  return {finish_frame(out.data(), id, body.size), {}};
}

}  // namespace sbgc
