// Generated from spec/ by generator/: edit those, then run ./dev generate.

/// Response policies of the requests in <sbgc/messages/control.hpp>.
#pragma once

#include <cstdint>

#include <sbgc/response_policy.hpp>
#include <sbgc/messages/control.hpp>

namespace sbgc::msg {

constexpr ResponsePolicy response_policy(const Control&) noexcept {
  return {.responses = {.command = 67,
              .confirmed = Confirmed::possible},
      .confirmations = 1,
      .retry_is_safe = true,
      .timeout_ms = 500};
}

constexpr ResponsePolicy response_policy(const ControlExt&) noexcept {
  return {.responses = {.command = 67,
              .confirmed = Confirmed::possible},
      .confirmations = 1,
      .retry_is_safe = true,
      .timeout_ms = 500};
}

constexpr ResponsePolicy response_policy(const ControlExtCommand&) noexcept {
  return {.responses = {.command = 121,
              .confirmed = Confirmed::possible},
      .confirmations = 1,
      .retry_is_safe = true,
      .timeout_ms = 500};
}

constexpr ResponsePolicy response_policy(const ControlConfig& request) noexcept {
  if (request.flags.has(ControlConfigFlag::no_confirm)) {
    return {.responses = {.command = 90,
              .confirmed = Confirmed::possible},
      .confirmations = 1,
      .retry_is_safe = true,
      .timeout_ms = 500};
  }
  return {.responses = {.command = 90,
              .confirmed = Confirmed::always},
      .confirmations = 1,
      .retry_is_safe = true,
      .timeout_ms = 500};
}

constexpr ResponsePolicy response_policy(const ControlQuatDisabled& request) noexcept {
  if (request.flags.has(ControlQuatFlag::confirm)) {
    return {.responses = {.command = 140,
              .confirmed = Confirmed::always},
      .confirmations = 1,
      .retry_is_safe = true,
      .timeout_ms = 500};
  }
  return {.responses = {.command = 140},
      .timeout_ms = 500};
}

constexpr ResponsePolicy response_policy(const ControlQuatSpeed& request) noexcept {
  if (request.flags.has(ControlQuatFlag::confirm)) {
    return {.responses = {.command = 140,
              .confirmed = Confirmed::always},
      .confirmations = 1,
      .retry_is_safe = true,
      .timeout_ms = 500};
  }
  return {.responses = {.command = 140},
      .timeout_ms = 500};
}

constexpr ResponsePolicy response_policy(const ControlQuatAttitude& request) noexcept {
  if (request.flags.has(ControlQuatFlag::confirm) && request.flags.has(ControlQuatFlag::auto_task)) {
    return {.responses = {.command = 140,
              .confirmed = Confirmed::always},
      .confirmations = 2,
      .timeout_ms = 500,
      .finish_ms = 11000};
  }
  if (request.flags.has(ControlQuatFlag::confirm)) {
    return {.responses = {.command = 140,
              .confirmed = Confirmed::always},
      .confirmations = 1,
      .retry_is_safe = true,
      .timeout_ms = 500};
  }
  if (request.flags.has(ControlQuatFlag::auto_task)) {
    return {.responses = {.command = 140,
              .confirmed = Confirmed::always},
      .confirmations = 1,
      .timeout_ms = 11000};
  }
  return {.responses = {.command = 140},
      .timeout_ms = 500};
}

constexpr ResponsePolicy response_policy(const ControlQuatAttitudePacked& request) noexcept {
  if (request.flags.has(ControlQuatFlag::confirm) && request.flags.has(ControlQuatFlag::auto_task)) {
    return {.responses = {.command = 140,
              .confirmed = Confirmed::always},
      .confirmations = 2,
      .timeout_ms = 500,
      .finish_ms = 11000};
  }
  if (request.flags.has(ControlQuatFlag::confirm)) {
    return {.responses = {.command = 140,
              .confirmed = Confirmed::always},
      .confirmations = 1,
      .retry_is_safe = true,
      .timeout_ms = 500};
  }
  if (request.flags.has(ControlQuatFlag::auto_task)) {
    return {.responses = {.command = 140,
              .confirmed = Confirmed::always},
      .confirmations = 1,
      .timeout_ms = 11000};
  }
  return {.responses = {.command = 140},
      .timeout_ms = 500};
}

constexpr ResponsePolicy response_policy(const ControlQuatSpeedAttitude& request) noexcept {
  if (request.flags.has(ControlQuatFlag::confirm)) {
    return {.responses = {.command = 140,
              .confirmed = Confirmed::always},
      .confirmations = 1,
      .retry_is_safe = true,
      .timeout_ms = 500};
  }
  return {.responses = {.command = 140},
      .timeout_ms = 500};
}

constexpr ResponsePolicy response_policy(const ControlQuatSpeedAttitudePacked& request) noexcept {
  if (request.flags.has(ControlQuatFlag::confirm)) {
    return {.responses = {.command = 140,
              .confirmed = Confirmed::always},
      .confirmations = 1,
      .retry_is_safe = true,
      .timeout_ms = 500};
  }
  return {.responses = {.command = 140},
      .timeout_ms = 500};
}

constexpr ResponsePolicy response_policy(const ControlQuatStatusRequest& request) noexcept {
  return {.responses = {.command = 141,
              .form_count = 1,
              .forms = {{{.id = 141,
               .min_size = 4,
               .max_size = max_body_size,
               .size = 97,
               .correlation = {{{.offset = 0, .size = 4, .value = static_cast<std::uint32_t>(request.data_set.raw())}}}}}}},
      .response_required = true,
      .retry_is_safe = true,
      .timeout_ms = 500};
}

constexpr ResponsePolicy response_policy(const ControlQuatConfig&) noexcept {
  return {.responses = {.command = 142,
              .confirmed = Confirmed::always},
      .confirmations = 1,
      .retry_is_safe = true,
      .timeout_ms = 500};
}

constexpr ResponsePolicy response_policy(const GetAnglesRequest&) noexcept {
  return {.responses = {.command = 73,
              .form_count = 1,
              .forms = {{{.id = 73,
               .min_size = 18,
               .max_size = max_body_size,
               .size = 18}}}},
      .response_required = true,
      .retry_is_safe = true,
      .timeout_ms = 500};
}

constexpr ResponsePolicy response_policy(const GetAnglesExtRequest&) noexcept {
  return {.responses = {.command = 61,
              .form_count = 1,
              .forms = {{{.id = 61,
               .min_size = 54,
               .max_size = max_body_size,
               .size = 54}}}},
      .response_required = true,
      .retry_is_safe = true,
      .timeout_ms = 500};
}

constexpr ResponsePolicy response_policy(const MotorsOn&) noexcept {
  return {.responses = {.command = 77,
              .confirmed = Confirmed::always},
      .confirmations = 1,
      .retry_is_safe = true,
      .timeout_ms = 500};
}

constexpr ResponsePolicy response_policy(const MotorsOff&) noexcept {
  return {.responses = {.command = 109,
              .confirmed = Confirmed::always},
      .confirmations = 1,
      .retry_is_safe = true,
      .timeout_ms = 500};
}

constexpr ResponsePolicy response_policy(const MotorsOffExt&) noexcept {
  return {.responses = {.command = 109,
              .confirmed = Confirmed::always},
      .confirmations = 1,
      .retry_is_safe = true,
      .timeout_ms = 500};
}

constexpr ResponsePolicy response_policy(const SyncMotors&) noexcept {
  return {.responses = {.command = 123,
              .confirmed = Confirmed::always},
      .confirmations = 1,
      .timeout_ms = 500};
}

constexpr ResponsePolicy response_policy(const ExecuteMenu&) noexcept {
  return {.responses = {.command = 69,
              .confirmed = Confirmed::possible},
      .confirmations = 1,
      .timeout_ms = 500};
}

constexpr ResponsePolicy response_policy(const ExecuteMenuExt& request) noexcept {
  if (request.param.has(ExecuteMenuFlag::confirm) && request.param.has(ExecuteMenuFlag::confirm_on_finish)) {
    return {.responses = {.command = 69,
              .confirmed = Confirmed::always},
      .confirmations = 2,
      .timeout_ms = 500,
      .finish_ms = 60000};
  }
  if (request.param.has(ExecuteMenuFlag::confirm)) {
    return {.responses = {.command = 69,
              .confirmed = Confirmed::always},
      .confirmations = 1,
      .timeout_ms = 500};
  }
  if (request.param.has(ExecuteMenuFlag::confirm_on_finish)) {
    return {.responses = {.command = 69,
              .confirmed = Confirmed::always},
      .confirmations = 1,
      .timeout_ms = 60000};
  }
  return {.responses = {.command = 69,
              .confirmed = Confirmed::possible},
      .confirmations = 1,
      .timeout_ms = 500};
}

constexpr ResponsePolicy response_policy(const HelperData&) noexcept {
  return {.responses = {.command = 72,
              .confirmed = Confirmed::unlikely},
      .confirmations = 1,
      .timeout_ms = 500};
}

constexpr ResponsePolicy response_policy(const HelperDataExt&) noexcept {
  return {.responses = {.command = 72,
              .confirmed = Confirmed::unlikely},
      .confirmations = 1,
      .timeout_ms = 500};
}

}  // namespace sbgc::msg
