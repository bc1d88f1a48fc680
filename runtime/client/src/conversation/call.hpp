/// One call of a conversation.
#pragma once

#include <functional>
#include <memory>

#include <sbgc/client/conversation.hpp>
#include <sbgc/session.hpp>

namespace sbgc::detail {

struct Call {
  Conversation::Ticket ticket{};
  Request request{};
  SendOptions send{};
  Instant deadline = Instant::never;
  Duration allowed{};  ///< from its beginning to the deadline
  std::function<void(unsigned)> on_confirmation{};
  Conversation::ReplyHandler handler{};
  Handle handle{};  ///< of the session, once that has the request; only Dialogue uses it
};

using CallPointer = std::shared_ptr<Call>;

/// A call that begins at `now`. `options` come before what was said when connecting.
CallPointer make_call(Request request, const CallOptions& options, const ConnectOptions& defaults,
                      Instant now, Conversation::ReplyHandler handler);

}  // namespace sbgc::detail
