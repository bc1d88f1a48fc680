/// Converts between the value of an adjustable variable and the setting that it controls.
#pragma once

#include <cstdint>
#include <initializer_list>

#include <sbgc/codec.hpp>

namespace sbgc::detail {

/// The setting's raw value is (variable * numerator + addend) / denominator. The generator has
/// checked for each variable that nothing overflows and that every result fits.
struct VariableScale {
  std::int64_t numerator;
  std::int64_t addend;
  std::int64_t denominator;
};

/// Returns the integer nearest to a fraction; rounds halves away from 0. Precondition:
/// denominator > 0.
constexpr std::int64_t nearest(std::int64_t numerator, std::int64_t denominator) noexcept {
  const std::int64_t whole = numerator / denominator;
  const std::int64_t rest = numerator % denominator;
  if (rest >= 0) return rest >= denominator - rest ? whole + 1 : whole;
  return -rest >= denominator + rest ? whole - 1 : whole;
}

template <class T>
constexpr void set_raw(T& setting, std::int64_t count) noexcept {
  setting = static_cast<T>(static_cast<RawOf<T>>(count));
}

template <class T>
constexpr std::int32_t variable_value(const VariableScale& scale, const T& setting) noexcept {
  return static_cast<std::int32_t>(
      nearest(std::int64_t{raw_of(setting)} * scale.denominator - scale.addend, scale.numerator));
}

/// Raw values in `special` have a special meaning, such as "disabled". Only a value that converts
/// to one of them exactly sets it; other values get the adjacent raw value.
template <class T>
constexpr void set_variable(const VariableScale& scale, T& setting, std::int32_t value,
                            std::initializer_list<std::int64_t> special = {}) noexcept {
  const std::int64_t numerator = value * scale.numerator + scale.addend;
  std::int64_t count = nearest(numerator, scale.denominator);
  const std::int64_t rest = numerator - count * scale.denominator;
  for (const std::int64_t one : special) {
    if (count != one || rest == 0) continue;
    count += rest > 0 ? 1 : -1;
    break;
  }
  set_raw(setting, count);
}

/// A switch is on if its setting is not 0.
template <class T>
constexpr std::int32_t switch_value(const T& setting) noexcept {
  return raw_of(setting) != 0 ? 1 : 0;
}

/// Leaves the setting unchanged if the switch already has the value: switching on keeps any setting
/// that is not 0.
template <class T>
constexpr void set_switch(T& setting, std::int32_t value) noexcept {
  if (switch_value(setting) != value) set_raw(setting, value);
}

}  // namespace sbgc::detail
