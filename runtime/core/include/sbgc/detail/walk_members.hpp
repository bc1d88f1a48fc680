/// Iterates over the members of a message, and knows the adjustable variables.
#pragma once

#include <cstddef>
#include <type_traits>

#include <sbgc/internal/walk.hpp>
#include <sbgc/meta/variables.hpp>

namespace sbgc::detail {

/// Walks the members of one struct. Not a lambda: that would be a distinct type for each.
template <class Visitor>
struct MemberWalk {
  using Place = typename Visitor::Place;

  Visitor& visitor;
  typename Place::Parent parent{};
  const VariableInfo* variable = nullptr;  ///< the one that the last VariableId names, or null

  template <class Member>
  SBGC_ALWAYS_INLINE constexpr void operator()(const FieldInfo& field, Member&& member) {
    if constexpr (Visitor::is_inlined) {
      step(field, member);
    } else {
      step_apart(field, member);
    }
  }
  /// One element of a member with an index.
  template <class Axes>
  SBGC_ALWAYS_INLINE constexpr void element(const FieldInfo& field, Axes& axes, std::size_t i) {
    const Place whole(field, parent);
    const char* const name = Meta<std::remove_const_t<Axes>>::fields[i].name;
    walk(axes[i], Place(whole, name, i), visitor);
  }

 private:
  template <class Member>
  SBGC_NOINLINE constexpr void step_apart(const FieldInfo& field, Member& member) {
    step(field, member);
  }
  template <class Member>
  SBGC_ALWAYS_INLINE constexpr void step(const FieldInfo& field, Member& member) {
    using Value = std::remove_cvref_t<Member>;
    const Place place(field, parent);
    if constexpr (std::is_same_v<Value, msg::VariableId>) variable = find_variable(member);
    if constexpr (std::is_integral_v<Value>) {
      if (field.is_variable_value && variable != nullptr) {
        return visitor.variable(member, *variable, place);
      }
    }
    walk(member, place, visitor);
  }
};

/// Walks the members of a message or struct. If the visitor `is_inlined`, everything is compiled
/// for each member; else once for each type of member, which is smaller. The value of an adjustable
/// variable goes to the handler `variable(value, info, place)`.
template <class T, class Visitor>
SBGC_ALWAYS_INLINE constexpr void walk_members(T& value, typename Visitor::Place::Parent parent,
                                               Visitor& visitor) {
  Meta<std::remove_const_t<T>>::visit(value, MemberWalk<Visitor>{visitor, parent});
}

}  // namespace sbgc::detail
