/// Determines the messages that a visitor accepts.
#pragma once

#include <concepts>
#include <type_traits>

#include <sbgc/type_list.hpp>

namespace sbgc {

/// Combines several functions into one; overload resolution selects the one that runs.
template <class... Functions>
struct overloaded : Functions... {  // NOLINT(readability-identifier-naming): its usual name
  using Functions::operator()...;
};
template <class... Functions>
overloaded(Functions...) -> overloaded<Functions...>;

namespace detail {

template <class R, class M, bool never_throws>
Type<std::remove_cvref_t<M>> parameter(R (*)(M) noexcept(never_throws));
template <class F, class R, class M, bool never_throws>
Type<std::remove_cvref_t<M>> parameter(R (F::*)(M) noexcept(never_throws));
template <class F, class R, class M, bool never_throws>
Type<std::remove_cvref_t<M>> parameter(R (F::*)(M) const noexcept(never_throws));

/// Returns the parameter type of a function or lambda that has one.
template <class Function>
  requires std::is_function_v<std::remove_pointer_t<Function>>
auto parameter_of() -> decltype(parameter(static_cast<std::decay_t<Function>>(nullptr)));
template <class Function>
auto parameter_of() -> decltype(parameter(&Function::operator()));

template <class Function>
concept HasOneParameter = requires {
  parameter_of<Function>();
};

/// The messages accepted by a function that may have several parameter types, such as a generic
/// lambda. A class with several operator() also accepts messages that derive from its parameters.
template <class Function>
struct Accepted {
  template <class M>
  static constexpr bool has = requires(Function& function, const M& message) {
    function(message);
  };

  template <class... M>
  static constexpr bool has_one_of(TypeList<M...>) noexcept {
    return (has<M> || ...);
  }
};

/// A function or plain lambda accepts exactly its parameter type. (Some messages derive from
/// another one with the same body and would otherwise convert to it.)
template <class Function>
  requires HasOneParameter<std::remove_const_t<Function>>
struct Accepted<Function> {
  using Parameter = typename decltype(parameter_of<std::remove_const_t<Function>>())::type;

  template <class M>
  static constexpr bool has = std::same_as<M, Parameter>&& std::invocable<Function&, const M&>;

  template <class... M>
  static constexpr bool has_one_of(TypeList<M...>) noexcept {
    return (has<M> || ...);
  }
};

/// Each function must accept at least one message.
template <class... Functions>
struct Accepted<overloaded<Functions...>> {
  template <class M>
  static constexpr bool has = (Accepted<Functions>::template has<M> || ...);

  template <class... M>
  static constexpr bool has_one_of(TypeList<M...> messages) noexcept {
    return (Accepted<Functions>::has_one_of(messages) && ...);
  }
};
template <class... Functions>
struct Accepted<const overloaded<Functions...>> : Accepted<overloaded<const Functions...>> {};

}  // namespace detail
}  // namespace sbgc
