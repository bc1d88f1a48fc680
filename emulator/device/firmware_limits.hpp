/// Limits messages to what the firmware of a board knows, as the model says for each field and
/// value.
#pragma once

#include <cstdint>
#include <type_traits>

#include <sbgc/availability.hpp>
#include <sbgc/internal/walk.hpp>
#include <sbgc/meta/all.hpp>

namespace sbgc::emulator {

namespace detail {

using sbgc::detail::walk;
using sbgc::detail::walk_axes;
using sbgc::detail::walk_list;

/// Removes optional fields that do not exist yet, and clears fields that are still reserved and
/// flags without a meaning. Keeps enum values, but reports them.
class FirmwareLimiter {
 public:
  explicit constexpr FirmwareLimiter(const Availability& versions) : versions_(versions) {}

  template <class T>
  void members(T& value) {
    Meta<T>::visit(value, *this);
  }
  /// Called by members() for each member.
  template <class T>
  void operator()(const FieldInfo& field, T& member) {
    if constexpr (!std::is_const_v<T>) {
      if (is_available(field.since, versions_)) return walk(member, field, *this);
      member = T{};
    }
  }
  /// Counters are not stored.
  void operator()(const FieldInfo&, const Counter&) {}

  bool has_unknown_values() const { return has_unknown_values_; }

  // The handlers of the walk.

  template <class T>
  void scalar(T& value, const FieldInfo&) {
    if constexpr (std::is_enum_v<T>) {
      named(EnumMeta<T>::info, static_cast<std::int64_t>(value));
    } else if constexpr (requires { typename T::flag_type; }) {
      value = T(known_flags(EnumMeta<typename T::flag_type>::info, value.raw()));
    } else if constexpr (requires { PackedMeta<T>::info; }) {
      packed(value);
    }
  }
  void number(Number&, const FieldInfo&) {}
  template <class T>
  void bytes(T&, const FieldInfo&) {}
  template <class T>
  void text(T&, const FieldInfo&) {}
  template <class T>
  void list(T& list, const FieldInfo& field) {
    walk_list(list, field, *this);
  }
  template <class T>
  void array(T& array, const FieldInfo& field) {
    walk_list(array, field, *this);
  }
  template <class T>
  void axes(T& axes, const FieldInfo& field) {
    walk_axes(axes, field, *this);
  }
  template <class T>
  void optional(T& optional, const FieldInfo& field) {
    if (optional) walk(*optional, field, *this);
  }
  template <class T>
  void group(T& value, const FieldInfo&) {
    members(value);
  }

 private:
  template <class Raw>
  Raw known_flags(const EnumInfo& info, Raw raw) const {
    for (const ValueInfo& flag : info.values) {
      const auto mask = static_cast<Raw>(flag.value);
      const bool is_set = mask != 0 && (raw & mask) == mask;
      if (is_set && !is_available(flag.since, versions_)) raw = static_cast<Raw>(raw & ~mask);
    }
    return raw;
  }
  void named(const EnumInfo& info, std::int64_t raw) {
    for (const ValueInfo& known : info.values) {
      if (known.value == raw && !is_available(known.since, versions_)) has_unknown_values_ = true;
    }
  }

  template <class T>
  void packed(T& value) {
    using Raw = typename T::raw_type;
    for (const PartInfo& part : PackedMeta<T>::parts) {
      if (part.values == nullptr) continue;
      const auto mask = static_cast<Raw>(part.mask);
      const auto bits = static_cast<Raw>(value.raw() & mask);
      if (part.values->is_flags) {
        value = T(static_cast<Raw>((value.raw() & ~mask) | known_flags(*part.values, bits)));
      } else {
        named(*part.values, static_cast<std::int64_t>(bits >> part.shift));
      }
    }
  }
  Availability versions_;
  bool has_unknown_values_ = false;
};

}  // namespace detail

/// Limits a message to these versions of board and firmware. Returns true if it has an enum value
/// that does not exist yet.
template <class M>
bool limit_to(const Availability& versions, M& message) {
  detail::FirmwareLimiter limiter(versions);
  limiter.members(message);
  return limiter.has_unknown_values();
}

}  // namespace sbgc::emulator
