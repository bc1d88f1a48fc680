/// Calls with a message that is known only at run time.
#pragma once

#include <sbgc/client/client.hpp>
#include <sbgc/client/reply.hpp>

#include "values/message_type.hpp"

namespace sbgc::tools {

/// As require_possible(). Precondition: the message goes to the board.
void require_any_possible(const Client& client, const MessageType& message, const Json& fields,
                          bool validate = true);

/// Sends a message and waits for the response that the protocol specifies. Throws JsonError if
/// `fields` do not describe it. Precondition: the message goes to the board.
Result<Reply> call_any(Client& client, const MessageType& message, const Json& fields,
                       const CallOptions& options);

}  // namespace sbgc::tools
