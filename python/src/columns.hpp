/// The numbers of messages with a fixed layout, as columns.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include <sbgc/field_type.hpp>

namespace sbgc::python {

/// Contiguous messages.
struct Rows {
  const std::uint8_t* first;
  std::size_t count;
  std::size_t stride;
};

/// A number of all rows, and its destination: as f64 if it has a unit, otherwise as the type on the
/// wire, or with 32 bits if that has 24.
struct NumberColumn {
  const FieldType* type;
  std::size_t offset;  ///< in a row
  std::uint8_t* to;
};

/// The size of each number of such a column.
std::size_t number_size(const FieldType& type);

/// Writes the numbers of the rows, in their units.
void fill(const Rows& rows, std::span<const NumberColumn> columns);

}  // namespace sbgc::python
