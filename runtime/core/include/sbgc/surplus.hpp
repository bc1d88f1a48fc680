/// Requests with surplus: bytes after the largest form of the command. Boards ignore them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <type_traits>
#include <utility>

#include <sbgc/codec.hpp>
#include <sbgc/internal/fixed.hpp>
#include <sbgc/meta.hpp>
#include <sbgc/request_sizes.hpp>
#include <sbgc/types.hpp>
#include <sbgc/validate.hpp>
#include <sbgc/visit.hpp>

namespace sbgc {

/// A request and its surplus. Codec, JSON and text treat it like a message that keeps a tail; plain
/// requests have no tail, so that they stay small.
template <Message M>
struct WithSurplus : M {
  using Body = WithSurplus;

  BoundedBytes<max_body_size - M::min_size>
      tail{};  ///< the bytes after those that the message describes

  bool operator==(const WithSurplus&) const = default;
};

template <class M>
struct Meta<WithSurplus<M>> : Meta<M> {
  template <class T, class Visitor>
  static constexpr void visit(T& value, Visitor&& visitor) {
    Meta<M>::visit(value, visitor);
    visitor(tail_field, value.tail);
  }
};

template <class M>
struct detail::WithoutTail<WithSurplus<M>> {
  using Type = M;
};

/// True if the bytes after M are surplus: it is the largest form of a request, has no open end, and
/// needs no context.
template <Message M>
inline constexpr bool takes_surplus =
    M::direction == Direction::to_board && !detail::HasContext<M> && M::max_size < max_body_size &&
    M::max_size == largest_request(static_cast<std::uint8_t>(M::command), newest);

/// A message as its receiver reads it: with surplus if it may have any.
template <Message M>
using Received = std::conditional_t<takes_surplus<M>, WithSurplus<M>, M>;

/// Returns the message without its surplus.
template <Message M>
constexpr const M& without_surplus(const M& message) noexcept {
  return message;
}
template <Message M>
constexpr const M& without_surplus(const WithSurplus<M>& message) noexcept {
  return message;
}

/// Decodes a request and its surplus, which begins after the largest form: a shorter body has
/// none.
template <Message M>
[[nodiscard]] constexpr Status decode(std::span<const std::uint8_t> body,
                                      WithSurplus<M>& out) noexcept {
  M& request = out;
  out.tail.clear();
  const Status status = decode(body, request);
  if (status.code != Code::too_long || body.size() <= M::max_size) return status;
  out.tail.resize_for_overwrite(body.size() - status.offset);
  detail::copy(body.data() + status.offset, out.tail.data(), out.tail.size());
  return decode(body.first(status.offset), request);
}

/// Writes a request and its surplus. Fails if a board would not read the tail as surplus.
template <Message M>
[[nodiscard]] constexpr WriteResult encode(const WithSurplus<M>& in,
                                           std::span<std::uint8_t> out) noexcept {
  const M& request = in;
  const WriteResult written = encode(request, out);
  if (!written || in.tail.empty()) return written;
  const auto at = static_cast<std::uint16_t>(written.size);
  const std::size_t size = written.size + in.tail.size();
  if (size > out.size()) return {0, {Code::buffer_too_small, at, tail_field.name}};
  detail::copy(in.tail.data(), out.data() + at, in.tail.size());
  WithSurplus<M> read{};
  const bool is_surplus = decode(out.first(size), read) && read.tail.size() == in.tail.size();
  if (!is_surplus) return {0, {Code::presence_mismatch, at, tail_field.name}};
  return {size, {}};
}

/// Like select(), but also selects the message of a request with surplus.
template <class Use>
constexpr Code select_received(Direction direction, std::uint8_t id, std::size_t size, Use&& use,
                               const Contexts& contexts = detail::nothing_known) {
  const bool is_request = direction == Direction::to_board;
  const std::size_t largest = is_request ? largest_request(id, newest) : max_body_size;
  return select(direction, id, size < largest ? size : largest, std::forward<Use>(use), contexts);
}

/// Like visit(), but also decodes requests with surplus. The visitor gets Received<M> and must
/// accept all messages.
template <class Visitor>
constexpr Status visit_received(std::uint8_t id, std::span<const std::uint8_t> body,
                                Direction direction, Visitor&& visitor,
                                const Contexts& contexts = {}) {
  Status status{};
  const auto use = [&]<class M>(Type<M>) {
    status = detail::decode_and_call<Received<M>>(body.data(), body.size(), visitor, contexts);
  };
  const Code code = select_received(direction, id, body.size(), use, contexts);
  return code == Code::ok ? status : Status{code};
}

}  // namespace sbgc
