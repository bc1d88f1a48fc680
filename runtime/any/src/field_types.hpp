/// Makes the tree of the fields of a message.
#pragma once

#include <vector>

#include <sbgc/field_type.hpp>

namespace sbgc {

struct MessageType;

namespace detail {

/// Returns the members of a message.
std::vector<FieldType> field_types(const MessageType& type);

}  // namespace detail
}  // namespace sbgc
