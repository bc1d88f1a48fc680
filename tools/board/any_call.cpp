#include "board/any_call.hpp"

#include <future>

#include <sbgc/client/raw_request.hpp>
#include <sbgc/client/request.hpp>
#include <sbgc/dispatch.hpp>
#include <sbgc/meta/all.hpp>
#include <sbgc/surplus.hpp>

#include "board/connection.hpp"

namespace sbgc::tools {

namespace {

/// Calls `use` with the message, and its surplus if it may have any.
template <class Use>
void with_request(const MessageType& message, const Json& fields, const Use& use) {
  AllMessages::for_each([&]<class M>(Type<M>) {
    if constexpr (M::direction != Direction::from_board) {
      if (message.info != &Meta<M>::info) return;
      Received<M> request{};
      from_dom(fields, request);
      use(request);
    }
  });
}

template <Message M>
Result<Reply> call(Client& client, const M& request, const CallOptions& options) {
  return client.transact(request, options);
}

/// Sends a request that the client knows without its surplus.
template <Message M>
Result<Reply> call(Client& client, const WithSurplus<M>& request, const CallOptions& options) {
  if (request.tail.empty()) return client.transact(without_surplus(request), options);
  const auto prepared = sbgc::detail::prepare(without_surplus(request),
                                              client.identity().versions(), options.validate);
  if (!prepared) return prepared.error();
  RawRequest raw{.id = prepared->id, .body = prepared->body, .policy = prepared->policy};
  for (const std::uint8_t byte : request.tail) {
    if (!raw.body.push_back(byte)) return ClientError{ErrorCode::invalid, "the tail is too long"};
  }
  std::promise<Result<Reply>> reply;
  client.start_raw(raw, options, [&](const Result<Reply>& came) { reply.set_value(came); });
  return reply.get_future().get();
}

}  // namespace

void require_any_possible(const Client& client, const MessageType& message, const Json& fields,
                          bool validate) {
  with_request(message, fields, [&](const auto& request) {
    require_possible(client, without_surplus(request), validate);
  });
}

Result<Reply> call_any(Client& client, const MessageType& message, const Json& fields,
                       const CallOptions& options) {
  Result<Reply> reply = ClientError{ErrorCode::invalid, "only the board sends this message"};
  with_request(message, fields,
               [&](const auto& request) { reply = call(client, request, options); });
  return reply;
}

}  // namespace sbgc::tools
