/// How an adjustable variable's value becomes that of the setting it stands for, and back.
#pragma once

#include <cstdint>
#include <initializer_list>

#include <sbgc/codec.hpp>

namespace sbgc::detail {

/// The setting's count is (the variable's * numerator + addend) / denominator. Nothing overflows,
/// and every result fits: the generator has checked it for each variable.
struct VariableScale {
  std::int64_t numerator;
  std::int64_t addend;
  std::int64_t denominator;
};

/// The nearest integer to a fraction; a half goes away from 0. Precondition: denominator > 0.
constexpr std::int64_t nearest(std::int64_t numerator, std::int64_t denominator) noexcept {
  const std::int64_t whole = numerator / denominator;
  const std::int64_t rest = numerator % denominator;
  if (rest >= 0) return rest >= denominator - rest ? whole + 1 : whole;
  return -rest >= denominator + rest ? whole - 1 : whole;
}

template <class T>
constexpr std::int64_t count_of(const T& setting) noexcept {
  if constexpr (RawValue<T>) {
    return setting.raw();
  } else {
    return static_cast<std::int64_t>(setting);
  }
}

template <class T>
constexpr void set_count(T& setting, std::int64_t count) noexcept {
  if constexpr (RawValue<T>) {
    setting = T(static_cast<typename T::raw_type>(count));
  } else {
    setting = static_cast<T>(count);
  }
}

template <class T>
constexpr std::int32_t variable_value(const VariableScale& scale, const T& setting) noexcept {
  return static_cast<std::int32_t>(
      nearest(count_of(setting) * scale.denominator - scale.addend, scale.numerator));
}

/// Counts in `special` have a meaning of their own, such as "disabled". One is only that of a value
/// that is it exactly: others get the step beside it.
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
  set_count(setting, count);
}

/// A switch is on if its setting is not 0.
template <class T>
constexpr std::int32_t switch_value(const T& setting) noexcept {
  return count_of(setting) != 0 ? 1 : 0;
}

/// What is on already stays as it is when it is switched on.
template <class T>
constexpr void set_switch(T& setting, std::int32_t value) noexcept {
  if (switch_value(setting) != value) set_count(setting, value);
}

}  // namespace sbgc::detail
