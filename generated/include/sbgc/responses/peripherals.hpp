// Generated from spec/ by generator/: edit those, then run ./dev generate.

/// Response policies of the requests in <sbgc/messages/peripherals.hpp>.
#pragma once

#include <cstdint>

#include <sbgc/response_policy.hpp>
#include <sbgc/messages/peripherals.hpp>

namespace sbgc::msg {

constexpr ResponsePolicy response_policy(const BeepSound&) noexcept {
  return {.responses = {.command = 89,
              .confirmed = Confirmed::possible},
      .confirmations = 1,
      .has_effect = true,
      .timeout_ms = 500};
}

constexpr ResponsePolicy response_policy(const TriggerPin&) noexcept {
  return {.responses = {.command = 84,
              .confirmed = Confirmed::possible},
      .confirmations = 1,
      .retry_is_safe = true,
      .has_effect = true,
      .timeout_ms = 500};
}

constexpr ResponsePolicy response_policy(const ServoOut&) noexcept {
  return {.responses = {.command = 36,
              .confirmed = Confirmed::possible},
      .confirmations = 1,
      .retry_is_safe = true,
      .has_effect = true,
      .moves = true,
      .timeout_ms = 500};
}

constexpr ResponsePolicy response_policy(const ServoOutFour&) noexcept {
  return {.responses = {.command = 36,
              .confirmed = Confirmed::possible},
      .confirmations = 1,
      .retry_is_safe = true,
      .has_effect = true,
      .moves = true,
      .timeout_ms = 500};
}

constexpr ResponsePolicy response_policy(const ServoOutExt&) noexcept {
  return {.responses = {.command = 133},
      .retry_is_safe = true,
      .has_effect = true,
      .moves = true,
      .timeout_ms = 500};
}

constexpr ResponsePolicy response_policy(const I2cWriteRegBuf&) noexcept {
  return {.responses = {.command = 39,
              .confirmed = Confirmed::always},
      .confirmations = 1,
      .has_effect = true,
      .timeout_ms = 500};
}

constexpr ResponsePolicy response_policy(const I2cReadRegBufRequest&) noexcept {
  return {.responses = {.command = 40,
              .form_count = 1,
              .forms = {{{.id = 40,
               .min_size = 0,
               .max_size = max_body_size,
               .size = 255}}}},
      .response_required = true,
      .timeout_ms = 500};
}

constexpr ResponsePolicy response_policy(const I2cReadRegBufRequestNoRegister&) noexcept {
  return {.responses = {.command = 40,
              .form_count = 1,
              .forms = {{{.id = 40,
               .min_size = 0,
               .max_size = max_body_size,
               .size = 255}}}},
      .response_required = true,
      .timeout_ms = 500};
}

constexpr ResponsePolicy response_policy(const I2cReadRegBufRequestWideRegister&) noexcept {
  return {.responses = {.command = 40,
              .form_count = 1,
              .forms = {{{.id = 40,
               .min_size = 0,
               .max_size = max_body_size,
               .size = 255}}}},
      .response_required = true,
      .timeout_ms = 500};
}

constexpr ResponsePolicy response_policy(const ApiVirtChControl&) noexcept {
  return {.responses = {.command = 45,
              .confirmed = Confirmed::unlikely},
      .confirmations = 1,
      .retry_is_safe = true,
      .has_effect = true,
      .moves = true,
      .timeout_ms = 500};
}

constexpr ResponsePolicy response_policy(const ApiVirtChHighRes&) noexcept {
  return {.responses = {.command = 116},
      .retry_is_safe = true,
      .has_effect = true,
      .moves = true,
      .timeout_ms = 500};
}

constexpr ResponsePolicy response_policy(const ReadRcInputsRequest& request) noexcept {
  return {.responses = {.command = 100,
              .form_count = 1,
              .forms = {{{.id = 100,
               .min_size = 0,
               .max_size = max_body_size,
               .size = 254}}}},
      .response_required = true,
      .retry_is_safe = true,
      .has_effect = request.cfg_flags.has(RcInputOption::init_if_needed),
      .timeout_ms = 500};
}

}  // namespace sbgc::msg
