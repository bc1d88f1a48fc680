/// The type of a message, for those who need not see what is in it.
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
