/// The messages of the protocol at run time: their fields, and the operations on them. The values
/// of a message are exchanged as JSON, as in `sbgc decode`.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <sbgc/availability.hpp>
#include <sbgc/framing.hpp>
#include <sbgc/json_dom.hpp>
#include <sbgc/message.hpp>
#include <sbgc/text/leaves.hpp>
#include <sbgc/validate.hpp>

#include "values/field_type.hpp"

namespace sbgc::tools {

/// A message. The functions that take `fields` throw JsonError if these do not describe it.
struct MessageType {
  const MessageInfo* info = nullptr;

  /// Returns the fields in wire order.
  const std::vector<FieldType>& (*fields)() = nullptr;
  /// Calls `report` for every value that a board with these versions does not allow.
  void (*validate)(const Json& fields, const Availability& versions,
                   const std::function<void(const Violation&)>& report) = nullptr;
  /// Calls `use` for every value.
  void (*for_each_value)(const Json& fields, const std::function<void(const Leaf&)>& use) = nullptr;
  /// Writes a frame to `out`, which has room for any.
  WriteResult (*encode)(const Json& fields, Framing framing, std::span<std::uint8_t> out) = nullptr;

  bool is_sent_to_board() const noexcept { return info->direction != Direction::from_board; }
};

/// All messages, in the order of the specification's families.
const std::vector<MessageType>& message_types();

/// Returns the message with this name of ours; null if there is none.
const MessageType* find_message(std::string_view name);

/// Returns the fields of a new message: 0, empty or absent, unless the specification has a default.
Json initial_fields(const std::vector<FieldType>& members);
/// Returns the value of a field in a new message.
Json initial_value(const FieldType& type);

/// Returns a frame. Throws std::runtime_error if the message does not fit into one, and JsonError.
std::vector<std::uint8_t> encoded(const MessageType& message, const Json& fields, Framing framing);

/// Returns the violations of the specification, joined by "; "; "" if there are none.
std::string violations_of(const MessageType& message, const Json& fields,
                          const Availability& versions);

}  // namespace sbgc::tools
