/// Fields whose unit depends on a flag in another field, `flags`: a flag set or a packed value.
#pragma once

#include <cstddef>

namespace sbgc::detail {

template <class Flags>
constexpr bool has_bits(const Flags& flags, typename Flags::raw_type mask) noexcept {
  return (flags.raw() & mask) == mask;
}

/// Returns the physical value of a field, which is an `Other` if the flag is set.
template <class Other, class Usual, class Flags>
constexpr double real_in_unit(const Usual& field, const Flags& flags,
                              typename Flags::raw_type mask) noexcept {
  return has_bits(flags, mask) ? Other(field.raw()).real() : field.real();
}

/// Sets a field and the flag that selects its unit.
template <class Usual, class Unit, class Flags>
constexpr void set_in_unit(Usual& field, Unit value, Flags& flags, typename Flags::raw_type mask,
                           bool on) noexcept {
  using Raw = typename Flags::raw_type;
  field = Usual(value.raw());
  flags = Flags(static_cast<Raw>(on ? flags.raw() | mask : flags.raw() & ~mask));
}

/// The same for one of several elements that share a flag; `field_of(element)` is the field.
/// Returns false and changes nothing if another element has a value in the other unit. (A raw value
/// of 0 counts as unset.)
template <class Elements, class FieldOf, class Unit, class Flags>
constexpr bool set_in_common_unit(Elements& elements, std::size_t index, FieldOf field_of,
                                  Unit value, Flags& flags, typename Flags::raw_type mask,
                                  bool on) noexcept {
  for (std::size_t i = 0; i < elements.size() && has_bits(flags, mask) != on; ++i) {
    if (i != index && field_of(elements[i]).raw() != 0) return false;
  }
  set_in_unit(field_of(elements[index]), value, flags, mask, on);
  return true;
}

}  // namespace sbgc::detail
