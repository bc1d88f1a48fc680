/// Finds the fields that a name on the command line denotes.
#pragma once

#include <cstddef>
#include <functional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include <sbgc/field_type.hpp>

namespace sbgc::tools {

/// An invalid name or value on the command line; what() is a sentence without a final period.
class ValueError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A member, an axis, or the index of an element.
using PathStep = std::variant<std::string, std::size_t>;
using FieldSteps = std::vector<PathStep>;

/// For example "params[3].param_id".
std::string steps_text(const FieldSteps& steps);

/// One value, list or group in a message.
struct FoundField {
  FieldSteps steps{};
  const FieldType* type = nullptr;
};

/// A step on the path to a field: a member, or any element of axes or of a list.
struct WayStep {
  const FieldType* member = nullptr;    ///< null for an element
  const FieldType* elements = nullptr;  ///< the axes or the list that the element is of
};

/// Calls `use(way, type)` for all values, lists and groups in a message, with the path from the
/// outside in. An element of axes or of a list is reported once.
void for_each_field(const std::vector<FieldType>& members,
                    const std::function<void(const std::vector<WayStep>&, const FieldType&)>& use);

/// Returns the path as text: "axes.roll|pitch|yaw.p", "params[].param_id".
std::string way_text(const std::vector<WayStep>& way);

/// Returns the fields of one message that `name` denotes; several if it leaves the axis open.
///
/// `name` is a path as in `sbgc decode`, or the end of one, such as "pitch.p" for "axes.pitch.p",
/// or the name in the specification, with or without an axis, such as "SPEED_PITCH". An axis may
/// have another name, such as "tilt". A path takes precedence. Returns nothing if there is no such
/// field. Throws ValueError if the name fits different fields, or a list without an index.
std::vector<FoundField> find_fields(const std::vector<FieldType>& members, std::string_view name);

/// The same in several groups, such as the messages with parameters.
struct FieldSource {
  std::string name{};
  const std::vector<FieldType>* members = nullptr;
};
struct SourcedFields {
  std::size_t source = 0;  ///< the index of the source
  std::vector<FoundField> fields{};
};
SourcedFields find_fields(const std::vector<FieldSource>& sources, std::string_view name);

/// Returns the nearest names to `name` among the paths of the sources and their ends.
std::vector<std::string> similar_fields(const std::vector<FieldSource>& sources,
                                        std::string_view name);

/// Returns the paths of all values; axes are spelled out, list elements have the index 0.
std::vector<std::string> field_paths(const std::vector<FieldType>& members);

}  // namespace sbgc::tools
