// Generated from spec/ by generator/: edit those, then run ./dev generate.

/// Response policies of the requests in <sbgc/messages/external_motors.hpp>.
#pragma once

#include <cstdint>

#include <sbgc/response_policy.hpp>
#include <sbgc/messages/external_motors.hpp>

namespace sbgc::msg {

constexpr ResponsePolicy response_policy(const ExtMotorsAction& request) noexcept {
  if (request.for_motors.has(ExtMotorTarget::confirm)) {
    return {.responses = {.command = 128,
              .confirmed = Confirmed::always},
      .confirmations = 1,
      .retry_is_safe = true,
      .has_effect = true,
      .moves = true,
      .timeout_ms = 500};
  }
  return {.responses = {.command = 128},
      .has_effect = true,
      .moves = true,
      .timeout_ms = 500};
}

constexpr ResponsePolicy response_policy(const ExtMotorsControl&) noexcept {
  return {.responses = {.command = 129,
              .confirmed = Confirmed::unlikely},
      .confirmations = 1,
      .retry_is_safe = true,
      .has_effect = true,
      .moves = true,
      .timeout_ms = 500};
}

constexpr ResponsePolicy response_policy(const ExtMotorsControlConfig& request) noexcept {
  if (request.for_motors.has(ExtMotorTarget::confirm)) {
    return {.responses = {.command = 130,
              .confirmed = Confirmed::always},
      .confirmations = 1,
      .retry_is_safe = true,
      .has_effect = true,
      .timeout_ms = 500};
  }
  return {.responses = {.command = 130},
      .has_effect = true,
      .timeout_ms = 500};
}

constexpr ResponsePolicy response_policy(const ExtMotorsStateRequest& request) noexcept {
  return {.responses = {.command = 131,
              .form_count = 1,
              .forms = {{{.id = 131,
               .min_size = 5,
               .max_size = max_body_size,
               .size = 50,
               .correlation = {{{.offset = 1, .size = 4, .value = static_cast<std::uint32_t>(request.data_set.raw())}}}}}}},
      .response_required = true,
      .retry_is_safe = true,
      .timeout_ms = 500};
}

}  // namespace sbgc::msg
