/// Compile-time field limits from the metadata tables.
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

/// Deliberately not constexpr: calling it in a constant expression is a compile error that names
/// the problem.
void no_field_has_this_name();

/// Returns the metadata of the field `name` of M. Does not compile if M has no such field.
template <class M>
consteval const FieldInfo& field_info(const char* name) {
  for (const FieldInfo& field : Meta<M>::fields) {
    if (is_same_text(field.name, name)) return field;
  }
  no_field_has_this_name();  // a compile error
  return Meta<M>::fields[0];
}

/// Returns the highest raw value of a field.
template <class M>
consteval std::size_t highest(const char* name) {
  return static_cast<std::size_t>(field_info<M>(name).range->highest);
}

}  // namespace sbgc::detail
