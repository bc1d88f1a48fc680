/// Limits of fields at compile time, from the tables of the specification.
#pragma once

#include <cstddef>

#include <sbgc/meta.hpp>

namespace sbgc::detail {

consteval bool is_same_text(const char* a, const char* b) noexcept {
  for (; *a == *b; ++a, ++b) {
    if (*a == '\0') return true;
  }
  return false;
}

/// Not constexpr: a call in a constant expression is an error with this name.
void no_field_has_this_name();

/// The table of a field of M. Does not compile if there is none.
template <class M>
consteval const FieldInfo& field_info(const char* name) {
  for (const FieldInfo& field : Meta<M>::fields) {
    if (is_same_text(field.name, name)) return field;
  }
  no_field_has_this_name();  // stops the compiler
  return Meta<M>::fields[0];
}

/// The highest value of a field, as a size.
template <class M>
consteval std::size_t highest(const char* name) {
  return static_cast<std::size_t>(field_info<M>(name).range->highest);
}

}  // namespace sbgc::detail
