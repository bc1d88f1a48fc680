/// The result type of a call.
#pragma once

#include <concepts>
#include <optional>
#include <type_traits>
#include <variant>

#include <sbgc/message.hpp>
#include <sbgc/protocol.hpp>
#include <sbgc/response.hpp>
#include <sbgc/result.hpp>
#include <sbgc/type_list.hpp>

namespace sbgc {

class AnyMessage;

namespace detail {

/// The messages that may be the result. Error messages are left out: they make the call fail.
template <class Kept, class... Messages>
struct OneOf;
template <class Only>
struct OneOf<TypeList<Only>> {
  using type = Only;
};
template <class... Kept>
struct OneOf<TypeList<Kept...>> {
  using type = std::variant<Kept...>;
};
template <class... Kept, class Next, class... Others>
struct OneOf<TypeList<Kept...>, Next, Others...>
    : OneOf<
          std::conditional_t<Next::form == Form::error, TypeList<Kept...>, TypeList<Kept..., Next>>,
          Others...> {};

template <class Response>
struct Delivered {
  using type = Response;
};
template <class... Messages>
struct Delivered<TypeList<Messages...>> : OneOf<TypeList<>, Messages...> {};
template <class Response>
struct Delivered<Maybe<Response>> {
  using type = std::optional<typename Delivered<Response>::type>;
};

template <class M>
struct ResponseTo : Delivered<typename M::Response> {};
/// A misuse, which Conversation::prepare() reports.
template <Message M>
  requires(M::direction == Direction::from_board)
struct ResponseTo<M> {
  using type = void;
};
template <>
struct ResponseTo<AnyMessage> {
  using type = std::optional<AnyMessage>;
};

/// The result of a successful call with the request M.
template <class M>
using CallResponse = typename ResponseTo<M>::type;

}  // namespace detail

/// A message that can be sent as a request, including one whose type is known only at run time.
template <class M>
concept Callable = Message<M> || std::same_as<M, AnyMessage>;

/// The result of a call with the request M: the response; void if the protocol has none; an
/// optional response if it depends on the values of the request.
template <class M>
using CallResult = Result<detail::CallResponse<M>>;

}  // namespace sbgc
