/// Converts between messages and bodies: decode(body, message), encode(message, out).
///
/// Generated messages only list their members (see wire_size.hpp); everything else is here.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <type_traits>
#include <utility>

#include <sbgc/detail/reader.hpp>
#include <sbgc/detail/writer.hpp>
#include <sbgc/flags.hpp>
#include <sbgc/internal/fixed.hpp>
#include <sbgc/number.hpp>
#include <sbgc/protocol.hpp>
#include <sbgc/quantity.hpp>
#include <sbgc/status.hpp>
#include <sbgc/types.hpp>
#include <sbgc/wire.hpp>
#include <sbgc/wire_size.hpp>

namespace sbgc {

/// Generated headers check this number, because they must match the runtime.
inline constexpr int codec_version = 3;

/// The direction of a message. `both` is for messages that are sent in either direction, never for
/// a frame.
enum class Direction : std::uint8_t { to_board, from_board, both };

/// The first firmware and board versions that have something, encoded as in VersionTypes (0: all),
/// and the features that it needs. For a board: its versions, and the features that it lacks; so a
/// board of which only the versions are known lacks nothing.
struct Availability {
  std::uint16_t firmware{};  ///< as on the wire: 2590 is 2.59b0; 0: any
  std::uint8_t board{};      ///< as on the wire: 30 is 3.0; 0: any
  std::uint64_t features{};  ///< masks of `features` in <sbgc/meta/enums.hpp>
};

/// Returns true if a board with these versions has something available since `since`.
constexpr bool is_available(const Availability& since, const Availability& versions) noexcept {
  return since.firmware <= versions.firmware && since.board <= versions.board &&
         (since.features & versions.features) == 0;
}

/// A generated message.
template <class M>
concept Message = requires {
  M::command;
  M::direction;
  M::form;
  M::min_size;
  M::max_size;
};

namespace detail {

/// A message that keeps the bytes that later firmware appends.
template <class M>
concept HasTail = requires(M& message) {
  message.tail;
};

template <class M>
concept HasTaggedUnions = requires {
  &M::template tagged_unions<M, int>;
};

/// A message whose body cannot be decoded without facts from earlier messages.
template <class M>
concept HasContext = requires {
  typename M::Context;
};

template <class M>
struct BodyOf {
  using Type = M;
};
template <class M>
  requires requires { typename M::Body; }
struct BodyOf<M> {
  using Type = typename M::Body;
};
/// The message that defines the members of `M`: a base class, or `M` itself.
template <class M>
using CodedAs = typename BodyOf<M>::Type;

/// A message whose body may repeat a fact of its context.
template <class M>
concept RepeatsContext = HasContext<M> && requires {
  M::Context::repeated;
};

/// Returns the error for a body of the wrong size.
constexpr Status wrong_size(std::size_t size, std::size_t wanted) noexcept {
  return {size < wanted ? Code::too_short : Code::too_long,
          static_cast<std::uint16_t>(size < wanted ? size : wanted)};
}

/// Stores the bytes after the first `size` bytes in `tail`.
template <std::size_t n>
constexpr Status get_tail(std::span<const std::uint8_t> body, std::size_t size,
                          BoundedBytes<n>& tail) noexcept {
  tail.clear();
  if (body.size() == size) return {};
  if (!tail.resize_for_overwrite(body.size() - size)) return {Code::too_long, max_body_size};
  copy(body.data() + size, tail.data(), tail.size());
  return {};
}

template <class M, class... Context>
constexpr Status decode_body(std::span<const std::uint8_t> body, [[maybe_unused]] M& out,
                             const Context&... context) noexcept {
  constexpr std::size_t size = fixed_size<M>;
  static_assert(HasVaryingMembers<M> ? size <= M::min_size : size == M::min_size);
  constexpr bool may_be_longer = HasVaryingMembers<M> || HasTail<M>;
  if (may_be_longer ? body.size() < size : body.size() != size) {
    return wrong_size(body.size(), size);
  }
  if constexpr (HasFixedMembers<M>) Fixed::get(body.data(), out);
  if constexpr (HasTaggedUnions<M>) {
    Reader reader(body, 0);
    M::tagged_unions(out, reader);
  }
  if constexpr (HasVaryingMembers<M>) {
    const auto read = [&](bool takes_fitting) {
      Reader reader(body, size, takes_fitting);
      M::varying_members(out, reader, context...);
      if constexpr (HasTail<M>) {
        return reader.end(out.tail);
      } else {
        return reader.end();
      }
    };
    if constexpr (requires { M::has_fitting_member; }) {
      // First without the member, then with it if only that fits exactly.
      if (read(false) && out.tail.empty()) return {};
      if (read(true) && out.tail.empty()) return {};
    }
    return read(false);
  } else if constexpr (HasTail<M>) {
    return get_tail(body, size, out.tail);
  } else {
    return {};
  }
}

/// Returns the flags that a body repeats after its fixed members; none if it does not.
template <class M>
constexpr auto repeated_flags(std::span<const std::uint8_t> body) noexcept {
  using Context = typename M::Context;
  std::remove_cvref_t<decltype(Context{}.*Context::repeated)> flags{};
  if (body.size() < fixed_size<M> + sizeof(flags.raw())) return flags;
  const decltype(flags) found(wire::load<decltype(flags.raw())>(body.data() + fixed_size<M>));
  return found.has(Context::repeats) ? found : flags;
}

/// Decodes with the flags in the context or those in the body: the first of the two that fits the
/// body exactly. Those in the body come first if the context asks for them.
template <RepeatsContext M>
constexpr Status decode_repeated(std::span<const std::uint8_t> body, M& out,
                                 typename M::Context context) noexcept {
  using Context = typename M::Context;
  auto& flags = context.*Context::repeated;
  auto first = flags;
  first.set(Context::repeats, false);
  const auto own = repeated_flags<M>(body);
  auto second = own.has(Context::repeats) ? own : first;
  if (flags.has(Context::repeats)) std::swap(first, second);
  Status status;
  for (const auto& attempt : {first, second, first}) {
    flags = attempt;
    status = decode_body(body, out, context);
    if (status && out.tail.empty()) break;
  }
  return status;
}

template <class M, class... Context>
constexpr WriteResult encode_body([[maybe_unused]] const M& in, std::span<std::uint8_t> out,
                                  const Context&... context) noexcept {
  constexpr std::size_t fixed = fixed_size<M>;
  std::size_t size = fixed;
  if constexpr (HasTail<M> && !HasVaryingMembers<M>) size += in.tail.size();
  if (out.size() < size) return {0, {Code::buffer_too_small}};
  if constexpr (HasFixedMembers<M>) Fixed::put(out.data(), in);
  if constexpr (HasTaggedUnions<M>) {
    Writer writer(out, 0);
    M::tagged_unions(in, writer);
    if (const WriteResult written = writer.end(); !written) return written;
  }
  if constexpr (HasVaryingMembers<M>) {
    Writer writer(out, fixed);
    M::varying_members(in, writer, context...);
    if constexpr (HasTail<M>) writer.rest(in.tail, "tail");
    return writer.end();
  } else {
    if constexpr (HasTail<M>) copy(in.tail.data(), out.data() + fixed, in.tail.size());
    return {size, {}};
  }
}

/// Assigns the value of a narrower integer to a wider one. Either may be an enum or RawValue.
template <class From, class To>
constexpr void widen(const From& from, To& to) noexcept {
  to = static_cast<To>(static_cast<RawOf<To>>(raw_of(from)));
}

}  // namespace detail

/// Decodes a message from a body. On failure, `out` holds the members read so far.
template <Message M>
  requires(!detail::HasContext<M>)
[[nodiscard]] constexpr Status decode(std::span<const std::uint8_t> body, M& out) noexcept {
  return detail::decode_body<detail::CodedAs<M>>(body, out);
}

/// The same for a message whose body depends on facts from earlier messages.
template <Message M>
  requires detail::HasContext<M>
[[nodiscard]] constexpr Status decode(std::span<const std::uint8_t> body, M& out,
                                      const typename M::Context& context = {}) noexcept {
  if constexpr (detail::RepeatsContext<M>) {
    return detail::decode_repeated(body, out, context);
  } else {
    return detail::decode_body<detail::CodedAs<M>>(body, out, context);
  }
}

/// Writes the body of a message into `out`; returns its size or the error. max_body_size bytes are
/// always enough.
template <Message M>
[[nodiscard]] constexpr WriteResult encode(const M& message, std::span<std::uint8_t> out) noexcept {
  if constexpr (detail::HasContext<M>) {
    return detail::encode_body<detail::CodedAs<M>>(message, out, typename M::Context{});
  } else {
    return detail::encode_body<detail::CodedAs<M>>(message, out);
  }
}

}  // namespace sbgc
