/// Types handed around as values.
#pragma once

namespace sbgc {

/// A type handed over as a value.
template <class T>
struct Type {
  using type = T;
};

/// A list of types.
template <class... T>
struct TypeList {
  /// Calls `use(Type<T>{})` for each, in order.
  template <class Use>
  static constexpr void for_each(Use&& use) {
    (use(Type<T>{}), ...);
  }
};

}  // namespace sbgc
