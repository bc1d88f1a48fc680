/// Sets fields of a message from texts such as "axes.pitch.angle=-30deg".
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <sbgc/json_dom.hpp>

#include "values/field_lookup.hpp"
#include "values/message_json.hpp"

namespace sbgc::tools {

struct Assignment {
  std::string name{};
  std::string value{};
};

/// Splits "NAME=VALUE". Throws ValueError.
Assignment parse_assignment(std::string_view text);
std::vector<Assignment> parse_assignments(const std::vector<std::string>& texts);

/// A field and the text of its value.
struct FieldValue {
  FoundField field{};
  std::string text{};
};

/// Returns the value for each of the fields that one name means: numbers for the axes may be
/// separated by commas; otherwise all get the same.
std::vector<FieldValue> values_for(const std::vector<FoundField>& fields, const std::string& text);

/// Returns the fields that the assignments mean. Throws ValueError if one does not exist or is
/// assigned twice.
std::vector<FieldValue> find_values(const MessageType& message,
                                    const std::vector<Assignment>& assignments);

/// Sets the values in the JSON of the message. A quantity is read in the unit that the other values
/// of the message select. Throws ValueError, which names the field.
void set_values(const MessageType& message, const std::vector<FieldValue>& values, Json& fields);

/// find_values() and set_values() in one step.
void assign(const MessageType& message, const std::vector<Assignment>& assignments, Json& fields);

/// Throws ValueError if one of the values is outside of its range, whatever the others are.
void check_ranges(const MessageType& message, const std::vector<FieldValue>& values,
                  const Json& fields);

/// Replaces names of values and lists of flags in the JSON of a message by their numbers. Leaves
/// everything else to the reader of the message. Throws ValueError, which names the field.
void replace_names(const MessageType& message, Json& fields);

/// Adds the fields that are missing although the values of others demand them.
void add_demanded(const MessageType& message, Json& fields);

/// Adds the fields that the JSON of a message lacks, as in a new message.
void add_defaults(const MessageType& message, Json& fields);

}  // namespace sbgc::tools
