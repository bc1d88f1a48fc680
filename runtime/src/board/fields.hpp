/// Facts about single fields, by name.
#pragma once

#include <string_view>

#include <sbgc/availability.hpp>
#include <sbgc/meta.hpp>

namespace sbgc::board {

/// What the model says of a field of a message. A name that is none does not compile.
template <class M>
consteval const FieldInfo& field_of(std::string_view name) {
  for (const FieldInfo& field : Meta<M>::fields) {
    if (name == field.name) return field;
  }
  throw "no such field";  // NOLINT(hicpp-exception-baseclass): at compile time only
}

/// Whether boards with these versions know a value of an enum or flag set.
template <class E>
constexpr bool knows(const Availability& versions, E value) {
  for (const ValueInfo& info : EnumMeta<E>::values) {
    if (info.value == static_cast<std::int64_t>(value)) return is_available(info.since, versions);
  }
  return false;
}

}  // namespace sbgc::board
