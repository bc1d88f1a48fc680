/// Messages that have what the specification demands.
#pragma once

#include <sbgc/any.hpp>

namespace sbgc::tools {

/// Returns a message whose lists have as many elements as the specification wants.
AnyMessage new_message(const MessageType& type);

/// Adds the fields that are missing although the values of others demand them.
void add_demanded(AnyMessage& message);

}  // namespace sbgc::tools
