/// Sets fields of a message from texts such as "axes.pitch.angle=-30deg".
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <sbgc/any.hpp>

#include "values/field_lookup.hpp"

namespace sbgc::tools {

/// The effect of a value on the present one.
enum class Change : unsigned char { set, add, subtract };

struct Assignment {
  std::string name{};
  std::string value{};
  Change change = Change::set;
};

/// Splits "NAME=VALUE", "NAME+=VALUE" or "NAME-=VALUE"; "NAME=+10%" adds a share of the present
/// value. Throws ValueError.
Assignment parse_assignment(std::string_view text);
std::vector<Assignment> parse_assignments(const std::vector<std::string>& texts);

/// A field and the text of its value.
struct FieldValue {
  FoundField field{};
  std::string text{};
  Change change = Change::set;
};

/// Returns the value for each of the fields that one name denotes: numbers for the axes may be
/// separated by commas; otherwise all get the same.
std::vector<FieldValue> values_for(const std::vector<FoundField>& fields,
                                   const Assignment& assignment);

/// A number, and what is known about others like it.
struct PresentNumber {
  double value{};  ///< in the unit
  UnitInfo unit{};
  bool is_integer{};  ///< on the wire
  // Of an integer on the wire.
  double lowest{};
  double highest{};
};

/// Returns the value after a change other than Change::set, as a text in the unit. Throws
/// ValueError.
std::string changed_value(const PresentNumber& present, Change change, const std::string& text);
/// The same for a field of a message that has a value.
FieldValue changed_value(const AnyMessage& present, const FieldValue& value,
                         const Availability& versions);

/// Adds a value. Throws ValueError if the field already has one.
void add_value(std::vector<FieldValue>& values, FieldValue value);

/// Returns the fields that the assignments denote. Throws ValueError if one does not exist or is
/// assigned twice.
std::vector<FieldValue> find_values(const MessageType& type,
                                    const std::vector<Assignment>& assignments);

/// Sets the values, including those that the specification does not allow. A quantity is parsed in
/// the unit that the other values of the message select, and that it has on a board with these
/// versions. Throws ValueError, which names the field.
void set_values(AnyMessage& message, const std::vector<FieldValue>& values,
                const Availability& versions = {});

/// find_values() and set_values() in one step.
void assign(AnyMessage& message, const std::vector<Assignment>& assignments,
            const Availability& versions = {});

/// Throws ValueError if a value is out of range regardless of the others.
void check_ranges(const AnyMessage& message, const std::vector<FieldValue>& values);

}  // namespace sbgc::tools
