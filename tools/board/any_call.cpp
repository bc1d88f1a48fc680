#include "board/any_call.hpp"

#include <sbgc/dispatch.hpp>
#include <sbgc/meta/all.hpp>

#include "board/connection.hpp"

namespace sbgc::tools {

namespace {

/// Calls `use` with the message.
template <class Use>
void with_request(const MessageType& message, const Json& fields, const Use& use) {
  AllMessages::for_each([&]<class M>(Type<M>) {
    if constexpr (M::direction != Direction::from_board) {
      if (message.info != &Meta<M>::info) return;
      M request{};
      from_dom(fields, request);
      use(request);
    }
  });
}

}  // namespace

void require_any_possible(const Client& client, const MessageType& message, const Json& fields,
                          bool validate) {
  with_request(message, fields,
               [&](const auto& request) { require_possible(client, request, validate); });
}

Result<Reply> call_any(Client& client, const MessageType& message, const Json& fields,
                       const CallOptions& options) {
  Result<Reply> reply = ClientError{ErrorCode::invalid, "only the board sends this message"};
  with_request(message, fields,
               [&](const auto& request) { reply = client.transact(request, options); });
  return reply;
}

}  // namespace sbgc::tools
