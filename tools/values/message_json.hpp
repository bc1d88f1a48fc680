/// The values of messages as JSON, as in `sbgc decode`, for programs that build them step by step.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <sbgc/any.hpp>
#include <sbgc/availability.hpp>
#include <sbgc/framing.hpp>
#include <sbgc/json_dom.hpp>

namespace sbgc::tools {

/// Returns the message with these fields. Throws JsonError if they do not describe it.
AnyMessage message_of(const MessageType& type, const Json& fields);
/// The same; missing fields are as in a new message.
AnyMessage message_with_defaults(const MessageType& type, Json fields);

/// Replaces names of values and lists of flags in the JSON of a message by their numbers. Leaves
/// everything else to the reader of the message. Throws ValueError, which names the field.
void replace_names(const MessageType& type, Json& fields);

/// Returns a frame. Throws std::runtime_error if the message does not fit into one.
std::vector<std::uint8_t> encoded(const AnyMessage& message, Framing framing);

/// Returns the violations of the specification, joined by "; "; "" if there are none.
std::string violations_of(const AnyMessage& message, const Availability& versions);

}  // namespace sbgc::tools
