/// The default handler of requests. It executes an equivalent request, or sends a response derived
/// from the model alone: new commands of the specification need no code here.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

#include <sbgc/framing.hpp>
#include <sbgc/messages.hpp>
#include <sbgc/response.hpp>
#include <sbgc/response_policy.hpp>

#include "device/request_context.hpp"

namespace sbgc::emulator {

namespace detail {

template <class Answer>
struct FirstOf {
  using type = Answer;
};
template <class First, class... Others>
struct FirstOf<TypeList<First, Others...>> {
  using type = First;
};

using Body = std::array<std::uint8_t, max_body_size>;

/// Sends an answer, whose `body` has `size` bytes, with the correlation fields of the request.
void answer_in(RequestContext& context, const ResponseForm& form, Body& body, std::size_t size);
/// Sends the confirmations that the policy allows. They also contain the bytes of `body`.
void confirm_by(RequestContext& context, const ResponsePolicy& policy, Body& body);

}  // namespace detail

/// True if the model documents the request: undocumented bodies have any size.
template <class Request>
inline constexpr bool is_documented = Request::min_size != 0 || Request::max_size != max_body_size;

/// Sends an empty response with the correlation fields of the request, a confirmation if the policy
/// allows one, or nothing.
template <class Request>
Reaction default_response(RequestContext& context, const Request& request) {
  if constexpr (!is_documented<Request>) {
    // Assumption: a real board does something undocumented here; the emulator does nothing.
    return Reaction::executed;
  } else {
    const ResponsePolicy policy = response_policy(request);
    detail::Body body{};
    if constexpr (requires { detail::FirstOf<ResponseMessages<Request>>::type::command; }) {
      using Answer = typename detail::FirstOf<ResponseMessages<Request>>::type;
      if (policy.responses.form_count != 0) {
        if (!is_supported<Answer>(context.versions())) return Reaction::executed;
        const WriteResult written = encode(Answer{}, body);
        detail::answer_in(context, policy.responses.forms[0], body, written.size);
      }
    }
    detail::confirm_by(context, policy, body);
    return Reaction::executed;
  }
}

// Equivalent requests, which the board executes instead.

inline msg::AdjVarsInfoRequest equivalent(const msg::AdjVarsInfoRequestAll&) { return {}; }
inline msg::BoardInfoRequest equivalent(const msg::BoardInfoRequestOneByte&) { return {}; }
/// The configuration is for Bluetooth LE modules between board and host, which are not emulated.
inline msg::BoardInfoRequest equivalent(const msg::BoardInfoRequestExt&) { return {}; }
inline msg::BootMode3Ext equivalent(const msg::BootMode3&) { return {}; }
inline msg::CalibAccExt equivalent(const msg::CalibAcc&) {
  return {.imu_idx = msg::CalibImu::active, .action = msg::CalibAction::regular};
}
inline msg::CalibGyroExt equivalent(const msg::CalibGyro&) {
  return {.imu_idx = msg::CalibImu::active, .action = msg::CalibAction::regular};
}
inline msg::CalibMagExt equivalent(const msg::CalibMag&) {
  return {.imu_idx = msg::CalibImu::main, .action = msg::CalibAction::regular};
}
inline msg::ControlExt equivalent(const msg::Control& request) {
  const msg::ControlMode mode = request.control_mode;
  return {.control_mode = {mode, mode, mode}, .axes = request.axes};
}
inline msg::ExecuteMenuExt equivalent(const msg::ExecuteMenu& request) {
  return {.cmd_id = request.cmd_id};
}
inline msg::HelperDataExt equivalent(const msg::HelperData& request) {
  return {request.frame_acc, request.frame_angle_roll, request.frame_angle_pitch};
}
/// Assumption: the first register, as the emulated chips have no register pointer.
inline msg::I2cReadRegBufRequest equivalent(const msg::I2cReadRegBufRequestNoRegister& request) {
  return {.device_addr = request.device_addr, .data_len = request.data_len};
}
/// Assumption: the emulated chips use the lower byte of the address.
inline msg::I2cReadRegBufRequest equivalent(const msg::I2cReadRegBufRequestWideRegister& request) {
  return {request.device_addr, static_cast<std::uint8_t>(request.reg_addr), request.data_len};
}
inline msg::MotorsOffExt equivalent(const msg::MotorsOff&) {
  return {.mode = msg::MotorsOffMode::normal};
}
inline msg::ResetRequestExt equivalent(const msg::ResetRequest&) { return {}; }
/// The other parameters are undocumented.
inline msg::SelectImu3 equivalent(const msg::SelectImu3Ext& request) {
  return {.imu_type = request.imu_type};
}
inline msg::SelectImu3Calibrate equivalent(const msg::SelectImu3CalibrateShort& request) {
  return {.imu_type = request.imu_type, .action = request.action, .time_ms = request.time_ms};
}
inline msg::ServoOut equivalent(const msg::ServoOutFour& request) {
  msg::ServoOut all;
  all.servo_time.fill(msg::ServoPulse(msg::ServoOut::floating));
  std::copy(request.servo_time.begin(), request.servo_time.end(), all.servo_time.begin());
  return all;
}

}  // namespace sbgc::emulator
