/// The named values in an enum, flag set or packed value.
#pragma once

#include <cstdint>
#include <type_traits>

#include <sbgc/meta.hpp>
#include <sbgc/meta/enums.hpp>

namespace sbgc::detail {

constexpr void be_at_least(Availability& versions, const EnumInfo& info) noexcept {
  for (const ValueInfo& value : info.values) {
    if (value.since.firmware > versions.firmware) versions.firmware = value.since.firmware;
    if (value.since.board > versions.board) versions.board = value.since.board;
    versions.features |= value.since.features;
  }
}

/// True for enums, flag sets and packed values.
template <class T>
inline constexpr bool has_named_values = std::is_enum_v<T> || requires {
  typename T::flag_type;
}
|| requires { PackedMeta<T>::info; };

/// The first versions, and the features of boards, that have every named value of an enum, flag set
/// or packed value.
template <class T>
inline constexpr Availability has_all_values_of = [] {
  Availability versions{};
  if constexpr (std::is_enum_v<T>) {
    be_at_least(versions, EnumMeta<T>::info);
  } else if constexpr (requires { typename T::flag_type; }) {
    be_at_least(versions, EnumMeta<typename T::flag_type>::info);
  } else {
    for (const PartInfo& part : PackedMeta<T>::parts) {
      if (part.values != nullptr) be_at_least(versions, *part.values);
    }
  }
  return versions;
}();

/// Calls `visitor(known, raw)` for each named value in `raw`: the value of an enum, or the flags.
template <class Visitor>
constexpr void for_each_name(const EnumInfo& info, std::uint64_t raw, Visitor&& visitor) {
  for (const ValueInfo& known : info.values) {
    const auto value = static_cast<std::uint64_t>(known.value);
    const bool has_flag = value != 0 && (raw & value) == value;
    if (info.is_flags ? has_flag : value == raw) visitor(known, static_cast<std::int64_t>(raw));
  }
}

template <class Visitor>
constexpr void for_each_name(const PackedInfo& info, std::uint64_t raw, Visitor&& visitor) {
  for (const PartInfo& part : info.parts) {
    if (part.values == nullptr) continue;
    const std::uint64_t bits = raw & part.mask;
    for_each_name(*part.values, part.values->is_flags ? bits : bits >> part.shift, visitor);
  }
}

/// The same for a value; in a packed one, for each part.
template <class T, class Visitor>
constexpr void for_each_name(const T& value, Visitor&& visitor) {
  if constexpr (std::is_enum_v<T>) {
    for_each_name(EnumMeta<T>::info, static_cast<std::uint64_t>(value), visitor);
  } else if constexpr (requires { typename T::flag_type; }) {
    for_each_name(EnumMeta<typename T::flag_type>::info, value.raw(), visitor);
  } else {
    for (const PartInfo& part : PackedMeta<T>::parts) {
      if (part.values == nullptr) continue;
      const auto bits = static_cast<std::uint64_t>(value.raw()) & part.mask;
      for_each_name(*part.values, part.values->is_flags ? bits : bits >> part.shift, visitor);
    }
  }
}

}  // namespace sbgc::detail
