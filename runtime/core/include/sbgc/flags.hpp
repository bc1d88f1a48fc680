/// Type-safe flag sets.
#pragma once

#include <concepts>
#include <type_traits>

#include <sbgc/internal/compiler.hpp>

namespace sbgc {

/// True for enums whose values are flags of a set. Generated code specializes it.
template <class E>
inline constexpr bool is_flag = false;

/// A set of the flags in `Flag`. Unnamed bits are preserved.
template <class Flag>
class Flags {
 public:
  /// The enum of the single bits.
  using flag_type = Flag;
  /// The integer on the wire.
  using raw_type = std::underlying_type_t<Flag>;

  constexpr Flags() = default;
  /// Implicit, so that a single flag can be used as a set.
  // NOLINTNEXTLINE(google-explicit-constructor): a flag is a set of one
  constexpr Flags(Flag flag) noexcept : raw_(static_cast<raw_type>(flag)) {}
  constexpr explicit Flags(raw_type raw) noexcept : raw_(raw) {}

  /// Returns the integer on the wire.
  constexpr raw_type raw() const noexcept { return raw_; }
  /// True if all bits of `flag` are set.
  constexpr bool has(Flag flag) const noexcept {
    const auto bits = static_cast<raw_type>(flag);
    return (raw_ & bits) == bits;
  }
  /// Sets or clears the bits of `flag`.
  constexpr Flags& set(Flag flag, bool on = true) noexcept {
    const auto bits = static_cast<raw_type>(flag);
    raw_ = static_cast<raw_type>(on ? raw_ | bits : raw_ & ~bits);
    return *this;
  }

  friend constexpr Flags operator|(Flags a, Flags b) noexcept {
    return Flags(static_cast<raw_type>(a.raw_ | b.raw_));
  }
  friend constexpr bool operator==(const Flags&, const Flags&) = default;

 private:
  raw_type raw_{};
};

/// Returns the set of two flags.
template <class Flag>
  requires is_flag<Flag>
constexpr Flags<Flag> operator|(Flag a, Flag b) noexcept { return Flags<Flag>(a) | Flags<Flag>(b); }

}  // namespace sbgc
