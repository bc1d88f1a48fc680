/// Types handed around as values.
#pragma once

#include <type_traits>

namespace sbgc {

/// A type handed over as a value.
template <class T>
struct Type {
  using type = T;
};

/// A list of types.
template <class... T>
struct TypeList {
  /// Whether U is one of them.
  template <class U>
  static constexpr bool contains = (std::is_same_v<U, T> || ...);

  /// Calls `use(Type<T>{})` for each, in order.
  template <class Use>
  static constexpr void for_each(Use&& use) {
    (use(Type<T>{}), ...);
  }
};

}  // namespace sbgc
