/// Handles every request that reads or writes parameters.
#pragma once

#include <cstdint>
#include <optional>

#include <sbgc/parameters.hpp>

#include "device/imu/imus.hpp"
#include "device/parameters/parameters.hpp"
#include "device/request_context.hpp"

namespace sbgc::emulator {

namespace detail {

template <class Request, class Parameters>
inline constexpr bool reads = ParametersOf<Parameters>::Readers::template contains<Request>;
template <class Request, class Parameters>
inline constexpr bool writes = ParametersOf<Parameters>::Writers::template contains<Request>;

template <class Request, class List>
inline constexpr bool accesses_one = false;
template <class Request, class... Parameters>
inline constexpr bool accesses_one<Request, TypeList<Parameters...>> =
    ((reads<Request, Parameters> || writes<Request, Parameters>) || ...);

/// The answer to a request for S, with the body of S: an older request may have another answer id.
template <class Request, class S>
struct AnswerTo {
  using Type = typename Request::Response;
};

/// Returns the copy that a request selects; nothing if there is no such copy.
template <class S, class Request>
std::optional<std::uint8_t> copy_of(const Parameters& parameters, const Request& request) {
  if constexpr (ParametersOf<S>::copies == 1) {
    return std::uint8_t{0};
  } else {
    const std::uint8_t copy = ParametersOf<S>::copy(request);
    if (copy == Request::active_profile) return parameters.profile();
    if (copy < ParametersOf<S>::copies) return copy;
    return {};
  }
}

/// Sets the fields that hold state of the board.
template <class S>
void fill_state(const Parameters& parameters, const Imus& imus, S& answer) {
  if constexpr (requires { answer.cur_imu; }) answer.cur_imu = imus.selected;
  if constexpr (requires { answer.cur_profile_id; }) answer.cur_profile_id = parameters.profile();
}

}  // namespace detail

/// True if a request reads or writes parameters.
template <class Request>
inline constexpr bool accesses_parameters = detail::accesses_one<Request, ParameterMessages>;

/// Handles such a request. Stores any values: the specification does not require the board to check
/// them, and it must keep values that it does not understand.
template <class Request>
Reaction access_parameters(RequestContext& context, const Request& request, Parameters& parameters,
                           const Imus& imus) {
  Reaction reaction = Reaction::refused;
  ParameterMessages::for_each([&]<class S>(Type<S>) {
    if constexpr (detail::reads<Request, S> || detail::writes<Request, S>) {
      const auto copy = detail::copy_of<S>(parameters, request);
      if (!copy) {
        reaction = context.refuse(msg::BoardErrorCode::wrong_params);
      } else if constexpr (detail::reads<Request, S>) {
        typename detail::AnswerTo<Request, S>::Type answer{parameters.read<S>(*copy)};
        detail::fill_state(parameters, imus, answer);
        reaction = context.answer_anyway(answer);
      } else if (parameters.write<S>(*copy, request)) {
        reaction = context.confirm();
      } else {
        reaction = context.refuse(msg::BoardErrorCode::operation_failed);
      }
    }
  });
  return reaction;
}

}  // namespace sbgc::emulator
