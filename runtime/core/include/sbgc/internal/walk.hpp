/// Iterates over the values of a message with their metadata.
#pragma once

#include <cstddef>
#include <type_traits>

#include <sbgc/detail/kind.hpp>
#include <sbgc/field_path.hpp>
#include <sbgc/internal/compiler.hpp>
#include <sbgc/meta.hpp>

namespace sbgc::detail {

/// Where a value is: its field, and the path to it.
struct PathPlace {
  using Parent = const FieldPath*;

  const FieldInfo& field;
  FieldPath path;

  constexpr PathPlace(const FieldInfo& of, Parent parent) : field(of), path{parent, of.name} {}
  constexpr PathPlace(const PathPlace& list, const char* name, std::size_t index)
      : field(list.field), path{&list.path, name, index} {}
  /// For the members of this value.
  constexpr Parent parent() const { return &path; }
};

/// The same for a visitor that needs no path.
struct FieldPlace {
  struct Parent {};

  const FieldInfo& field;

  constexpr FieldPlace(const FieldInfo& of, Parent) : field(of) {}
  constexpr FieldPlace(const FieldPlace& list, const char*, std::size_t) : field(list.field) {}
  constexpr Parent parent() const { return {}; }
};

/// Passes a value to the handler of its kind and returns its result. A visitor has a `Place` and
/// one handler for each Kind, `scalar(value, place)` and so on; walk_axes(), walk_list() and
/// walk_members() go on to the values inside.
template <class T, class Visitor>
SBGC_ALWAYS_INLINE constexpr decltype(auto) walk(T& value, const typename Visitor::Place& place,
                                                 Visitor& visitor) {
  constexpr Kind kind = kind_of<std::remove_const_t<T>>;
  if constexpr (kind == Kind::scalar) {
    return visitor.scalar(value, place);
  } else if constexpr (kind == Kind::axes) {
    return visitor.axes(value, place);
  } else if constexpr (kind == Kind::array) {
    return visitor.array(value, place);
  } else if constexpr (kind == Kind::bytes) {
    return visitor.bytes(value, place);
  } else if constexpr (kind == Kind::text) {
    return visitor.text(value, place);
  } else if constexpr (kind == Kind::list) {
    return visitor.list(value, place);
  } else if constexpr (kind == Kind::optional) {
    return visitor.optional(value, place);
  } else if constexpr (kind == Kind::counter) {
    return visitor.counter(value, place);
  } else if constexpr (kind == Kind::number) {
    return visitor.number(value, place);
  } else {
    return visitor.group(value, place);
  }
}

template <class T, class Visitor>
SBGC_ALWAYS_INLINE constexpr void walk_axes(T& value, const typename Visitor::Place& place,
                                            Visitor& visitor) {
  using Place = typename Visitor::Place;
  constexpr auto& names = Meta<std::remove_const_t<T>>::fields;
  walk(value[0], Place(place, names[0].name, 0), visitor);
  walk(value[1], Place(place, names[1].name, 1), visitor);
  walk(value[2], Place(place, names[2].name, 2), visitor);
}

/// Walks the elements of a list or an array.
template <class T, class Visitor>
SBGC_ALWAYS_INLINE constexpr void walk_list(T& value, const typename Visitor::Place& place,
                                            Visitor& visitor) {
  using Place = typename Visitor::Place;
  for (std::size_t i = 0; i < value.size(); ++i) walk(value[i], Place(place, "", i), visitor);
}

}  // namespace sbgc::detail
