/// The requests of data streams, for all clients.
#pragma once

#include <functional>
#include <span>
#include <utility>

#include <sbgc/client/link.hpp>
#include <sbgc/client/typed.hpp>

namespace sbgc {

/// Returns the types of the messages that boards send as data streams, those of
/// sbgc::roles::StreamMessages.
std::span<const MessageType* const> stream_types();

namespace detail {

/// The data stream of messages of this type that `request` starts, or its error. If the firmware
/// has no streams, the message is polled, provided that a request without content asks for it.
Link::Stream stream_of(const MessageType& type, const Result<roles::StreamRequest>& request,
                       Link::MessageHandler handler, const CallOptions& options);

/// The raw data stream that `request` selects.
Link::Stream raw_stream_of(const roles::StreamRequest& request,
                           std::function<void(const Frame&)> handler, const CallOptions& options);

/// Returns the key of the frames with a message of this type.
MessageKey key_of_type(const MessageType& type);
/// Wraps a handler of messages of this type.
Link::MessageHandler any_handler(const MessageType& type,
                                 std::function<void(const AnyMessage&)> handler);

template <Message M>
Link::Stream stream_of(const Result<roles::StreamRequest>& request,
                       std::function<void(const M&)> handler, const CallOptions& options) {
  static_assert(roles::StreamMessages::contains<M>,
                "the board has no data stream of this message; see sbgc::roles::StreamMessages");
  return stream_of(message_type<M>(), request, typed_handler<M>(std::move(handler)), options);
}

}  // namespace detail
}  // namespace sbgc
