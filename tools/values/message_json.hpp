/// The values of messages as JSON, as in `sbgc decode`, for programs that build them part by part.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <sbgc/any.hpp>
#include <sbgc/availability.hpp>
#include <sbgc/framing.hpp>
#include <sbgc/json_dom.hpp>

namespace sbgc::tools {

/// Returns the fields of a new message: 0, empty or absent, unless the specification has a default.
Json initial_fields(const std::vector<FieldType>& members);
/// Returns the value of a field in a new message.
Json initial_value(const FieldType& type);

/// Returns the message with these fields. Throws JsonError if they do not describe it.
AnyMessage message_of(const MessageType& type, const Json& fields);
/// Returns the fields of a message.
Json fields_of(const AnyMessage& message);

/// Returns a frame. Throws std::runtime_error if the message does not fit into one.
std::vector<std::uint8_t> encoded(const AnyMessage& message, Framing framing);

/// Returns the violations of the specification, joined by "; "; "" if there are none.
std::string violations_of(const AnyMessage& message, const Availability& versions);

}  // namespace sbgc::tools
