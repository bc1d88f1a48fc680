/// Limits of fields at compile time, from the tables of the specification.
#pragma once

#include <cstddef>
#include <string_view>

#include <sbgc/meta.hpp>

namespace sbgc::detail {

/// The table of a field of M. Does not compile if there is none.
template <class M>
consteval const FieldInfo& field_info(std::string_view name) {
  for (const FieldInfo& field : Meta<M>::fields) {
    if (field.name == name) return field;
  }
  throw "no field has this name";  // NOLINT(*-exception-*): stops the compiler
}

/// The highest value of a field, as a size.
template <class M>
consteval std::size_t highest(std::string_view name) {
  return static_cast<std::size_t>(field_info<M>(name).range->highest);
}

}  // namespace sbgc::detail
