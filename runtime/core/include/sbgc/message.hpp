/// Encodes messages as frames.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <type_traits>
#include <utility>

#include <sbgc/checksum.hpp>
#include <sbgc/codec.hpp>
#include <sbgc/detail/layout.hpp>
#include <sbgc/frame.hpp>

namespace sbgc {

namespace detail {

/// True if the bytes of a message, apart from its tail, are the same in memory and on the wire.
template <class M>
inline constexpr bool is_same_in_memory =
    layout<M>.only_blocks && !HasVaryingMembers<M> && !HasTaggedUnions<M>;

template <class M, std::size_t... i>
[[gnu::always_inline]] inline void add_blocks(ByteSum& sum, const M& message,
                                              std::index_sequence<i...>) noexcept {
  constexpr auto block = [](std::size_t index) {
    return layout<M>.places[layout<M>.blocks[index]];
  };
  const auto* const bytes = reinterpret_cast<const std::uint8_t*>(&message);
  (sum.add(bytes + block(i).memory, block(i).block), ...);
}

/// Returns the sum of the bytes of a message. It reads the message, because reading back bytes just
/// written to a frame can stall.
template <class M>
  requires is_same_in_memory<M>
inline std::uint8_t sum_in_memory(const M& message) noexcept {
  ByteSum sum;
  add_blocks(sum, message, std::make_index_sequence<layout<M>.block_count>{});
  if constexpr (HasTail<M>) {
    if (!message.tail.empty()) sum.add(byte_sum(message.tail.data(), message.tail.size()));
  }
  return sum.value();
}

}  // namespace detail

/// Writes `message` as a frame into `out`; returns the size of the frame or the error.
/// max_frame_size bytes are always enough.
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
  if constexpr (detail::is_same_in_memory<detail::CodedAs<M>>) {
    if (!std::is_constant_evaluated()) {
      const std::uint8_t sum = detail::sum_in_memory<detail::CodedAs<M>>(message);
      return {Framing::finish(out.data(), id, body.size, sum), {}};
    }
  }
  return {finish_frame(out.data(), id, body.size), {}};
}

}  // namespace sbgc
