/// The `Response` type of a request: the messages with which the board answers.
///
///     using Response = BoardInfo;                           // this one
///     using Response = TypeList<ReadFile, ReadFileError>;   // one of these
///     using Response = Maybe<AhrsHelper>;                   // this one or none
///     using Response = void;                                // none
#pragma once

#include <sbgc/type_list.hpp>

namespace sbgc {

/// The board sends `Response`, a message or a TypeList, only for some contents of the request.
template <class Response>
struct Maybe {};

namespace detail {

template <class Response>
struct ResponseMessagesOf {
  using type = TypeList<Response>;
};
template <>
struct ResponseMessagesOf<void> {
  using type = TypeList<>;
};
template <class... Messages>
struct ResponseMessagesOf<TypeList<Messages...>> {
  using type = TypeList<Messages...>;
};
template <class Response>
struct ResponseMessagesOf<Maybe<Response>> : ResponseMessagesOf<Response> {};

}  // namespace detail

/// A TypeList of all messages that may answer a request.
template <class Request>
using ResponseMessages = typename detail::ResponseMessagesOf<typename Request::Response>::type;

}  // namespace sbgc
