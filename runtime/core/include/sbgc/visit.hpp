/// Decodes a frame into a typed message.
#pragma once

#include <concepts>
#include <type_traits>
#include <utility>

#include <sbgc/dispatch.hpp>
#include <sbgc/frame.hpp>
#include <sbgc/internal/compiler.hpp>
#include <sbgc/visitor.hpp>

namespace sbgc {

namespace detail {

/// The body cannot be part of the message (restrict), so the compiler can omit initial values that
/// decoding replaces. Body and size are values, as reading a span just written would stall.
template <class M, class Visitor>
constexpr Status decode_and_call(const std::uint8_t* SBGC_RESTRICT data, std::size_t size,
                                 Visitor& visitor, const Contexts& contexts) {
  const std::span<const std::uint8_t> body(data, size);
  M message;
  Status status{};
  if constexpr (requires { contexts.of(message); }) {
    status = decode(body, message, contexts.of(message));
  } else {
    status = decode(body, message);
  }
  if (status) {
    // The visitor may overwrite the body: the compiler must not read it after this point.
    if (!detail::is_constant_evaluated()) __atomic_signal_fence(__ATOMIC_SEQ_CST);
    visitor(std::as_const(message));
  }
  return status;
}

}  // namespace detail

/// Decodes a body and calls `visitor(message)` with the typed message, if the visitor accepts it:
///     visit(id, body, direction, [](const msg::Control& control) { ... });
///
/// `direction` is required because some ids have a different meaning in each direction. `contexts`
/// holds facts from earlier messages (see Contexts). Returns the status of decoding, or
/// unknown_command or unknown_form; calls the visitor only if the status is ok. A message that the
/// visitor does not accept is not decoded; its status is ok.
template <class Visitor>
constexpr Status visit(std::uint8_t id, std::span<const std::uint8_t> body, Direction direction,
                       Visitor&& visitor, const Contexts& contexts = {}) {
  using Accepted = detail::Accepted<std::remove_reference_t<Visitor>>;
  constexpr bool accepts_messages = Accepted::has_one_of(AllMessages{});
  static_assert(accepts_messages,
                "this visitor, or a function of it, accepts no message: let it take one as in "
                "[](const sbgc::msg::Control& control) { ... }");
  Status status{};
  const auto use = [&, data = body.data(), size = body.size()]<class M>(Type<M>) {
    if constexpr (Accepted::template has<M>) {
      status = detail::decode_and_call<M>(data, size, visitor, contexts);
    }
  };
  const Code code = select(direction, id, body.size(), use, contexts);
  return code == Code::ok ? status : Status{code};
}

/// The same for a frame found by the parser.
template <class Visitor>
constexpr Status visit(const Frame& frame, Direction direction, Visitor&& visitor,
                       const Contexts& contexts = {}) {
  return visit(frame.id, frame.body, direction, std::forward<Visitor>(visitor), contexts);
}

/// The same as visit(frame, direction, overloaded{first, second, more...}).
template <class First, class Second, class... More>
  requires(!std::same_as<std::remove_cvref_t<Second>, Contexts>)
constexpr Status visit(const Frame& frame, Direction direction, First&& first, Second&& second,
                       More&&... more) {
  return visit(frame, direction,
               overloaded{std::forward<First>(first), std::forward<Second>(second),
                          std::forward<More>(more)...});
}

}  // namespace sbgc
