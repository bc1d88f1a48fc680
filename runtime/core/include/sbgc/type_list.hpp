/// Types as values, and lists of types.
#pragma once

#include <type_traits>

namespace sbgc {

/// A type as a value.
template <class T>
struct Type {
  using type = T;
};

/// A list of types.
template <class... T>
struct TypeList {
  /// True if U is in the list.
  template <class U>
  static constexpr bool contains = (std::is_same_v<U, T> || ...);

  /// Calls `use(Type<T>{})` for each type, in order.
  template <class Use>
  static constexpr void for_each(Use&& use) {
    (use(Type<T>{}), ...);
  }
};

}  // namespace sbgc
