/// Makes messages complete according to the specification.
#pragma once

#include <sbgc/any.hpp>

namespace sbgc::tools {

/// Returns a message whose lists have the required number of elements.
AnyMessage new_message(const MessageType& type);

/// Adds missing fields that the values of others require.
void add_demanded(AnyMessage& message);

}  // namespace sbgc::tools
