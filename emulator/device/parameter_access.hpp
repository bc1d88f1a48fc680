/// Reading and writing of settings, for all messages that hold some.
#pragma once

#include <cstdint>
#include <optional>
#include <type_traits>

#include <sbgc/settings.hpp>

#include "device/device.hpp"
#include "device/request_context.hpp"

namespace sbgc::board {

namespace detail {

template <class M, class List>
inline constexpr bool is_one_of = false;
template <class M, class... Others>
inline constexpr bool is_one_of<M, TypeList<Others...>> = (std::is_same_v<M, Others> || ...);

template <class Request, class Settings>
inline constexpr bool reads = is_one_of<Request, typename SettingsOf<Settings>::Readers>;
template <class Request, class Settings>
inline constexpr bool writes = is_one_of<Request, typename SettingsOf<Settings>::Writers>;

template <class Request, class List>
inline constexpr bool accesses_one = false;
template <class Request, class... Settings>
inline constexpr bool accesses_one<Request, TypeList<Settings...>> =
    ((reads<Request, Settings> || writes<Request, Settings>) || ...);

/// The copy that a request is about; nothing if there is none.
template <class S, class Request>
std::optional<std::uint8_t> copy_of(const Machine& machine, const Request& request) {
  if constexpr (SettingsOf<S>::copies == 1) {
    return std::uint8_t{0};
  } else {
    const std::uint8_t copy = SettingsOf<S>::copy(request);
    if (copy == Request::active_profile) return machine.settings.profile();
    if (copy < SettingsOf<S>::copies) return copy;
    return {};
  }
}

/// The fields that tell the state of the board.
template <class S>
void fill_state(const Machine& machine, S& settings) {
  if constexpr (requires { settings.cur_imu; }) settings.cur_imu = machine.cur_imu;
  if constexpr (requires { settings.cur_profile_id; }) {
    settings.cur_profile_id = machine.settings.profile();
  }
}

}  // namespace detail

/// Whether a request reads or writes settings.
template <class Request>
inline constexpr bool accesses_settings = detail::accesses_one<Request, StoredMessages>;

/// Carries it out. Any values are stored: the specification does not say that the board looks at
/// them, and what it does not understand it must keep.
template <class Request>
Outcome access_settings(Turn& turn, const Request& request) {
  Outcome outcome = Outcome::refused;
  StoredMessages::for_each([&]<class S>(Type<S>) {
    if constexpr (detail::reads<Request, S> || detail::writes<Request, S>) {
      Machine& machine = turn.machine;
      const auto copy = detail::copy_of<S>(machine, request);
      if (!copy) {
        outcome = turn.refuse(msg::BoardErrorCode::wrong_params);
      } else if constexpr (detail::reads<Request, S>) {
        S answer = machine.settings.read<S>(*copy);
        detail::fill_state(machine, answer);
        outcome = turn.answer_anyway(answer);
      } else if (machine.settings.write<S>(*copy, request)) {
        machine.apply_settings(turn.now);
        outcome = turn.confirm();
      } else {
        outcome = turn.refuse(msg::BoardErrorCode::operation_failed);
      }
    }
  });
  return outcome;
}

}  // namespace sbgc::board
