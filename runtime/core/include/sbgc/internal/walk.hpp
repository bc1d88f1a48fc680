/// Iterates over the values of a message with their metadata.
#pragma once

#include <cstddef>
#include <type_traits>

#include <sbgc/detail/kind.hpp>
#include <sbgc/internal/compiler.hpp>
#include <sbgc/meta.hpp>

namespace sbgc::detail {

/// Passes a value to the handler of its kind and returns its result. A visitor has one handler for
/// each Kind, `scalar(value, field)` and so on; walk_axes() and walk_list() descend to the values
/// inside, with the field of the whole.
template <class T, class Visitor>
SBGC_ALWAYS_INLINE constexpr decltype(auto) walk(T& value, const FieldInfo& field,
                                                 Visitor& visitor) {
  constexpr Kind kind = kind_of<std::remove_const_t<T>>;
  if constexpr (kind == Kind::scalar) {
    return visitor.scalar(value, field);
  } else if constexpr (kind == Kind::axes) {
    return visitor.axes(value, field);
  } else if constexpr (kind == Kind::array) {
    return visitor.array(value, field);
  } else if constexpr (kind == Kind::bytes) {
    return visitor.bytes(value, field);
  } else if constexpr (kind == Kind::text) {
    return visitor.text(value, field);
  } else if constexpr (kind == Kind::list) {
    return visitor.list(value, field);
  } else if constexpr (kind == Kind::optional) {
    return visitor.optional(value, field);
  } else if constexpr (kind == Kind::counter) {
    return visitor.counter(value, field);
  } else if constexpr (kind == Kind::number) {
    return visitor.number(value, field);
  } else {
    return visitor.group(value, field);
  }
}

template <class T, class Visitor>
SBGC_ALWAYS_INLINE constexpr void walk_axes(T& value, const FieldInfo& field, Visitor& visitor) {
  walk(value[0], field, visitor);
  walk(value[1], field, visitor);
  walk(value[2], field, visitor);
}

/// Walks the elements of a list or an array.
template <class T, class Visitor>
SBGC_ALWAYS_INLINE constexpr void walk_list(T& value, const FieldInfo& field, Visitor& visitor) {
  for (std::size_t i = 0; i < value.size(); ++i) walk(value[i], field, visitor);
}

}  // namespace sbgc::detail
