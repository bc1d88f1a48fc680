/// Iterates over the members of a message, and resolves adjustable variables.
#pragma once

#include <cstddef>
#include <type_traits>

#include <sbgc/internal/walk.hpp>
#include <sbgc/meta/variables.hpp>

namespace sbgc::detail {

/// Walks the members of one struct; compiled for each struct. The value of an adjustable variable
/// goes to the handler `variable(value, info, field)`. Not a lambda: that would be a distinct type
/// for each struct.
template <class Visitor>
struct MemberWalk {
  Visitor& visitor;
  const VariableInfo* variable = nullptr;  ///< the one that the last VariableId names, or null

  template <class Member>
  SBGC_ALWAYS_INLINE constexpr void operator()(const FieldInfo& field, Member&& member) {
    using Value = std::remove_cvref_t<Member>;
    if constexpr (std::is_same_v<Value, msg::VariableId>) variable = find_variable(member);
    if constexpr (std::is_integral_v<Value>) {
      if (field.is_variable_value && variable != nullptr) {
        return visitor.variable(member, *variable, field);
      }
    }
    walk(member, field, visitor);
  }
  /// One element of a member with an index.
  template <class Axes>
  SBGC_ALWAYS_INLINE constexpr void element(const FieldInfo& field, Axes& axes, std::size_t i) {
    walk(axes[i], field, visitor);
  }
};

}  // namespace sbgc::detail
