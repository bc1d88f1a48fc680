/// Fields whose unit changes with later firmware.
#pragma once

#include <cstddef>
#include <cstdint>
#include <type_traits>

#include <sbgc/codec.hpp>
#include <sbgc/detail/kind.hpp>
#include <sbgc/quantity.hpp>

namespace sbgc::detail {

/// The type of a field, starting with a firmware version.
template <std::uint16_t firmware, class T>
struct LaterType {
  using type = T;
  static constexpr std::uint16_t since = firmware;
};

struct NoUnit {
  static constexpr const char* text = "";
};
/// A number without a unit.
template <class Raw>
class PlainNumber : public Quantity<PlainNumber<Raw>, Raw, NoUnit, 1, 1> {
 public:
  using Quantity<PlainNumber<Raw>, Raw, NoUnit, 1, 1>::Quantity;
};

template <class T>
struct WithUnit {
  using type = PlainNumber<std::conditional_t<is_integer24<T>, T, RawOf<T>>>;
};
template <class T>
  requires requires(T value) { value.real(); }
struct WithUnit<T> {
  using type = T;
};

/// Calls `use(Type<Q>)` with the quantity type of a field of type T on a board with these versions.
/// `Laters` are its types in later firmware, the earliest first.
template <class T, class... Laters, class Use>
constexpr void with_type_in(const Availability& versions, Use&& use) noexcept {
  const std::size_t wanted = (0 + ... + std::size_t{Laters::since <= versions.firmware});
  std::size_t index = 0;
  if (wanted == 0) use(Type<typename WithUnit<T>::type>{});
  ((++index == wanted ? use(Type<typename WithUnit<typename Laters::type>::type>{}) : void()), ...);
}

/// Returns the physical value of a field.
template <class... Laters, class T>
constexpr double real_in_firmware(const T& field, const Availability& versions) noexcept {
  double result = 0;
  with_type_in<T, Laters...>(versions, [&]<class Q>(Type<Q>) { result = Q(raw_of(field)).real(); });
  return result;
}

/// Sets a field to the raw value nearest to a physical one. Returns false if it does not fit.
template <class... Laters, class T>
constexpr bool set_in_firmware(T& field, double value, const Availability& versions) noexcept {
  bool fits = false;
  with_type_in<T, Laters...>(versions, [&]<class Q>(Type<Q>) {
    const auto quantity = Q::from_real(value);
    if (!quantity) return;
    fits = true;
    field = static_cast<T>((*quantity).raw());
  });
  return fits;
}

}  // namespace sbgc::detail
