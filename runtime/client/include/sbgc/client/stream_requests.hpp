/// The requests of data streams, for all clients.
#pragma once

#include <chrono>
#include <functional>
#include <type_traits>
#include <utility>

#include <sbgc/client/link.hpp>
#include <sbgc/client/polls.hpp>
#include <sbgc/client/typed.hpp>

namespace sbgc::detail {

/// Returns the requests that start and end the data stream that `request` selects.
template <Message Request>
Conversation::StreamRequests stream_requests(const Conversation& conversation,
                                             const Request& request, const CallOptions& options) {
  return {conversation.prepare(request, options),
          conversation.prepare(stream_end(request), options)};
}

/// Returns the requests that start and end the data stream of M; `request` starts it. Where the
/// firmware has no streams, M is polled if a request without content asks for it.
template <Message M, Message Request>
Conversation::StreamRequests stream_requests(const Conversation& conversation, Request request,
                                             const CallOptions& options) {
  choose_stream<M>(request);
  if (const auto error = conversation.stream_refusal<M>()) return {*error, *error};
  Conversation::StreamRequests requests = stream_requests(conversation, request, options);
  using Poll = typename roles::Poll<M>::type;
  if constexpr (!std::is_void_v<Poll>) {
    if (!requests.start && requests.start.error().code == ErrorCode::unsupported) {
      requests.polling = {stream_interval(request), requests.start.error().message};
      requests.start = conversation.prepare(Poll{}, options);
    }
  }
  return requests;
}

/// The data stream of M that `request` starts, or its error.
template <Message M, Message Request>
Link::Stream stream_of(const Result<Request>& request, std::function<void(const M&)> handler,
                       const CallOptions& options) {
  return {[request, options](const Conversation& conversation) {
            if (!request) return Conversation::StreamRequests{request.error(), request.error()};
            return stream_requests<M>(conversation, *request, options);
          },
          key_of<M>, typed_handler<M>(std::move(handler)),
          request ? stream_interval(*request) : std::chrono::microseconds{}};
}

/// The bytes of the data stream that `request` selects.
template <Message Request>
Link::Stream raw_stream_of(const Request& request, std::function<void(const Frame&)> handler,
                           const CallOptions& options) {
  return {[request, options](const Conversation& conversation) {
            return stream_requests(conversation, request, options);
          },
          raw_key(request), typed_handler<Frame>(std::move(handler)), stream_interval(request)};
}

}  // namespace sbgc::detail
