#include <algorithm>
#include <chrono>
#include <type_traits>
#include <vector>

#include <fmt/format.h>

#include <sbgc/any.hpp>
#include <sbgc/client/polls.hpp>
#include <sbgc/client/stream_requests.hpp>
#include <sbgc/meta/all.hpp>
#include <sbgc/roles.hpp>

namespace sbgc {

namespace {

using detail::Conversation;

struct StreamTypes {
  std::vector<const MessageType*> types;
  std::vector<const MessageType*> polls;  ///< the request without content for each; null if none
};

const StreamTypes& all_streams() {
  static const StreamTypes all = [] {
    StreamTypes result;
    roles::StreamMessages::for_each([&]<class M>(Type<M>) {
      using Poll = typename roles::Poll<M>::type;
      result.types.push_back(&detail::message_type<M>());
      if constexpr (std::is_void_v<Poll>) {
        result.polls.push_back(nullptr);
      } else {
        result.polls.push_back(&detail::message_type<Poll>());
      }
    });
    return result;
  }();
  return all;
}

/// The requests that start and end the data stream that `request` selects.
Conversation::StreamRequests requests_of(const Conversation& conversation,
                                         const roles::StreamRequest& request,
                                         const CallOptions& options) {
  return {conversation.prepare(request, options),
          conversation.prepare(detail::stream_end(request), options)};
}

Conversation::StreamRequests requests_of(const Conversation& conversation, const MessageType& type,
                                         const roles::StreamRequest& request,
                                         const CallOptions& options) {
  const StreamTypes& all = all_streams();
  const auto found = std::ranges::find(all.types, &type);
  if (found == all.types.end()) {
    const ClientError error{ErrorCode::invalid,
                            fmt::format("there is no data stream of {}", type.info->name)};
    return {error, error};
  }
  if (const auto error = conversation.stream_refusal(type)) return {*error, *error};
  Conversation::StreamRequests requests = requests_of(conversation, request, options);
  const MessageType* const poll = all.polls[static_cast<std::size_t>(found - all.types.begin())];
  const bool has_streams = requests.start || requests.start.error().code != ErrorCode::unsupported;
  if (has_streams || poll == nullptr) return requests;
  requests.polling = {detail::stream_interval(request), requests.start.error().message};
  requests.start = conversation.prepare(poll->make(), options);
  return requests;
}

}  // namespace

std::span<const MessageType* const> stream_types() { return all_streams().types; }

namespace detail {

MessageKey key_of_type(const MessageType& type) { return {type.info->id, type.form}; }

Link::MessageHandler any_handler(const MessageType& type,
                                 std::function<void(const AnyMessage&)> handler) {
  return [&type, handler = std::move(handler)](const void* message) {
    handler(AnyMessage(type, message));
  };
}

Link::Stream stream_of(const MessageType& type, const Result<roles::StreamRequest>& request,
                       Link::MessageHandler handler, const CallOptions& options) {
  if (!request) {
    return {[error = request.error()](const Conversation&) {
              return Conversation::StreamRequests{error, error};
            },
            key_of_type(type), std::move(handler), std::chrono::microseconds{}};
  }
  roles::StreamRequest chosen = *request;
  auto& command = roles::stream_command(chosen);
  command = static_cast<std::remove_reference_t<decltype(command)>>(type.info->id);
  return {[&type, chosen, options](const Conversation& conversation) {
            return requests_of(conversation, type, chosen, options);
          },
          key_of_type(type), std::move(handler), stream_interval(chosen)};
}

Link::Stream raw_stream_of(const roles::StreamRequest& request,
                           std::function<void(const Frame&)> handler, const CallOptions& options) {
  return {[request, options](const Conversation& conversation) {
            return requests_of(conversation, request, options);
          },
          raw_key(request), typed_handler<Frame>(std::move(handler)), stream_interval(request)};
}

}  // namespace detail
}  // namespace sbgc
