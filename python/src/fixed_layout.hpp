/// Messages whose values have the same places in every body.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include <sbgc/any.hpp>

namespace sbgc::python {

struct FixedValue {
  std::string path;
  const FieldType* type;
  std::size_t offset;  ///< in the body
};

/// Returns the values of a message; nothing if their places or their units depend on other values,
/// or on earlier messages.
std::optional<std::vector<FixedValue>> fixed_layout(const MessageType& type);

}  // namespace sbgc::python
