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
  constexpr std::size_t overhead = frame_size<framing>(0);
  if (out.size() < overhead) return {0, {Code::buffer_too_small}};
  const WriteResult body = encode_body(message, {frame_body(out.data()), out.size() - overhead});
  if (!body) return body;
  constexpr auto id = static_cast<std::uint8_t>(M::command);
  constexpr bool is_sum = FramingFacts<framing>::trailer_checksum == ChecksumKind::sum8;
  if constexpr (is_sum && detail::is_same_in_memory<detail::CodedAs<M>>) {
    if (!std::is_constant_evaluated()) {
      const std::uint8_t sum = detail::sum_in_memory<detail::CodedAs<M>>(message);
      return {FrameFormat<framing>::finish(out.data(), id, body.size, sum), {}};
    }
  }
  return {finish_frame<framing, table>(out.data(), id, body.size), {}};
}

/// The same for a framing selected at run time.
template <Message M>
[[nodiscard]] constexpr WriteResult encode_frame(Framing framing, const M& message,
                                                 std::span<std::uint8_t> out) noexcept {
  return with_framing(framing, [&](auto f) { return encode_frame<f()>(message, out); });
}

}  // namespace sbgc
