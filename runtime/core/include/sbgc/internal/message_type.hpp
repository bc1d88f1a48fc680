/// Access to the type of a message without its definition.
#pragma once

#include <sbgc/message.hpp>

namespace sbgc {

struct MessageType;

namespace detail {

/// Returns the type of M. The compiled library sbgc::any defines it for every message.
template <Message M>
const MessageType& message_type() noexcept;

}  // namespace detail
}  // namespace sbgc
