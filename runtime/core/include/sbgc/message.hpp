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
#include <sbgc/detail/value_sum.hpp>
#include <sbgc/frame.hpp>
#include <sbgc/internal/compiler.hpp>

namespace sbgc {

namespace detail {

/// True if the bytes of a message, apart from its tail, are the same in memory and on the wire.
template <class M>
inline constexpr bool is_same_in_memory = layout<M>.only_blocks && !HasVaryingMembers<M> &&
                                          !HasTaggedUnions<M> && std::is_standard_layout_v<M>;

template <class M, std::size_t... i>
SBGC_ALWAYS_INLINE inline void add_blocks(ByteSum& sum, const M& message,
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

/// True if all bodies of a message have the same size.
template <class M>
inline constexpr bool is_of_fixed_size =
    !HasVaryingMembers<M> && !HasTaggedUnions<M> && !HasTail<M>;

/// Completes the frame whose body was encoded from `message`; returns its size.
template <Framing framing, CrcTable table, class M>
SBGC_ALWAYS_INLINE constexpr std::size_t finish_frame_of(const M& message, std::uint8_t* frame,
                                                         std::uint8_t id,
                                                         std::size_t body_size) noexcept {
  // Summing the values of a small message is faster than summing its bytes: they may still be in
  // registers, and reading back members that were just set one by one would stall.
  constexpr bool is_small = is_of_fixed_size<M> && fixed_size<M> <= 24;
  if constexpr (has_body_sum<framing> && !prefers_small_code) {
    using Format = FrameFormat<framing>;
    if constexpr (is_small) {
      return Format::finish(frame, id, body_size, static_cast<std::uint8_t>(sum_of_value(message)));
    } else if constexpr (is_same_in_memory<M>) {
      if (!detail::is_constant_evaluated()) {
        return Format::finish(frame, id, body_size, sum_in_memory(message));
      }
    }
  }
  return finish_frame<framing, table>(frame, id, body_size);
}

}  // namespace detail

/// Writes the body of a frame into `out`; returns its size or the error, which is too_long for a
/// body that no frame can carry.
template <Message M>
[[nodiscard]] constexpr WriteResult encode_body(const M& message,
                                                std::span<std::uint8_t> out) noexcept {
  const bool any_body_fits = out.size() >= max_body_size;
  const WriteResult body = encode(message, any_body_fits ? out.first(max_body_size) : out);
  if (body) return body;
  const bool is_full = body.status.code == Code::buffer_too_small;
  const Code code = is_full && any_body_fits ? Code::too_long : body.status.code;
  return {0, {code, body.status.offset, body.status.field}};
}

/// Writes `message` as a frame into `out`; returns the size of the frame or the error.
/// max_frame_size bytes are always enough.
template <Framing framing = basic_framing, CrcTable table = CrcTable::slices, Message M>
[[nodiscard]] constexpr WriteResult encode_frame(const M& message,
                                                 std::span<std::uint8_t> out) noexcept {
  using Coded = detail::CodedAs<M>;
  const Coded& coded = message;
  std::size_t body_size = detail::fixed_size<Coded>;
  if constexpr (detail::is_of_fixed_size<Coded>) {
    if (out.size() < frame_size<framing>(body_size)) return {0, {Code::buffer_too_small}};
    if constexpr (detail::HasFixedMembers<Coded>) {
      detail::Fixed::put(frame_body(out.data()), coded);
    }
  } else {
    constexpr std::size_t overhead = frame_size<framing>(0);
    if (out.size() < overhead) return {0, {Code::buffer_too_small}};
    const WriteResult body = encode_body(message, {frame_body(out.data()), out.size() - overhead});
    if (!body) return body;
    body_size = body.size;
  }
  constexpr auto id = static_cast<std::uint8_t>(M::command);
  return {detail::finish_frame_of<framing, table>(coded, out.data(), id, body_size), {}};
}

/// The same for a framing selected at run time.
template <Message M>
[[nodiscard]] constexpr WriteResult encode_frame(Framing framing, const M& message,
                                                 std::span<std::uint8_t> out) noexcept {
  return with_framing(framing, [&](auto f) { return encode_frame<f()>(message, out); });
}

}  // namespace sbgc
