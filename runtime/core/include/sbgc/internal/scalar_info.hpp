/// The tables that give the number of a scalar its meaning. Includes those of all units and enums.
#pragma once

#include <sbgc/detail/kind.hpp>
#include <sbgc/meta.hpp>
#include <sbgc/meta/enums.hpp>
#include <sbgc/meta/units.hpp>

namespace sbgc::detail {

/// At most one of these is set.
struct ScalarInfo {
  const UnitInfo* unit{};
  const EnumInfo* names{};
  const PackedInfo* packed{};
};

template <Scalar T>
constexpr ScalarInfo scalar_info() noexcept {
  if constexpr (std::is_enum_v<T>) {
    return {.names = &EnumMeta<T>::info};
  } else if constexpr (requires { typename T::flag_type; }) {
    return {.names = &EnumMeta<typename T::flag_type>::info};
  } else if constexpr (requires { PackedMeta<T>::info; }) {
    return {.packed = &PackedMeta<T>::info};
  } else if constexpr (requires { UnitMeta<T>::info; }) {
    return {.unit = &UnitMeta<T>::info};
  } else {
    return {};
  }
}

}  // namespace sbgc::detail
