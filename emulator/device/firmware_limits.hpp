/// Limits messages to what the firmware of a board knows, as the model says for each field and
/// value.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <type_traits>

#include <sbgc/availability.hpp>
#include <sbgc/meta/all.hpp>
#include <sbgc/types.hpp>

namespace sbgc::emulator {

/// What a message had that the firmware does not know.
struct Unknown {
  bool fields = false;  ///< it was longer than this firmware sends or expects
  bool values = false;  ///< it had an enum value that does not exist yet
};

namespace detail {

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
      if (is_available(field.since, versions_)) return this->value(member);
      if (takes_room(member)) unknown_.fields = true;
      member = T{};
    }
  }
  /// Counters are not stored.
  void operator()(const FieldInfo&, const Counter&) {}

  const Unknown& unknown() const { return unknown_; }

 private:
  template <class T>
  static bool takes_room(const T&) {
    return false;  // the bytes were reserved
  }
  template <class T>
  static bool takes_room(const Optional<T>& member) {
    return member.has_value();
  }
  template <class T, std::size_t n>
  static bool takes_room(const BoundedArray<T, n>& member) {
    return !member.empty();
  }

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
      if (known.value == raw && !is_available(known.since, versions_)) unknown_.values = true;
    }
  }

  template <class T>
  void value(T& value) {
    if constexpr (std::is_enum_v<T>) {
      named(EnumMeta<T>::info, static_cast<std::int64_t>(value));
    } else if constexpr (requires { typename T::flag_type; }) {
      value = T(known_flags(EnumMeta<typename T::flag_type>::info, value.raw()));
    } else if constexpr (requires { PackedMeta<T>::info; }) {
      packed(value);
    } else if constexpr (requires { Meta<T>::fields; }) {
      members(value);
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
  template <class T>
  void value(Optional<T>& optional) {
    if (optional) value(*optional);
  }
  template <class T, std::size_t n>
  void value(std::array<T, n>& array) {
    for (T& element : array) value(element);
  }
  template <class T, std::size_t n>
  void value(BoundedArray<T, n>& array) {
    for (T& element : array) value(element);
  }

  Availability versions_;
  Unknown unknown_{};
};

}  // namespace detail

/// Limits a message to these versions of board and firmware.
template <class M>
Unknown limit_to(const Availability& versions, M& message) {
  detail::FirmwareLimiter limiter(versions);
  limiter.members(message);
  return limiter.unknown();
}

}  // namespace sbgc::emulator
