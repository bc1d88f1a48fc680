#include "board/any_call.hpp"

#include <sbgc/dispatch.hpp>
#include <sbgc/meta/all.hpp>

namespace sbgc::tools {

Result<Reply> call_any(Client& client, const MessageType& message, const Json& fields,
                       const CallOptions& options) {
  Result<Reply> reply = ClientError{ErrorCode::invalid, "only the board sends this message"};
  AllMessages::for_each([&]<class M>(Type<M>) {
    if constexpr (M::direction != Direction::from_board) {
      if (message.info != &Meta<M>::info) return;
      M request{};
      from_dom(fields, request);
      reply = client.transact(request, options);
    }
  });
  return reply;
}

}  // namespace sbgc::tools
