// Generated from spec/ by generator/: edit those, then run ./dev generate.

/// Response policies of the requests in <sbgc/messages/system.hpp>.
#pragma once

#include <cstdint>

#include <sbgc/response_policy.hpp>
#include <sbgc/messages/system.hpp>

namespace sbgc::msg {

constexpr ResponsePolicy response_policy(const BoardInfoRequest&) noexcept {
  return {.responses = {.command = 86,
              .form_count = 1,
              .forms = {{{.id = 86,
               .min_size = 18,
               .max_size = max_body_size,
               .size = 18}}}},
      .response_required = true,
      .retry_is_safe = true,
      .timeout_ms = 500};
}

constexpr ResponsePolicy response_policy(const BoardInfoRequestOneByte&) noexcept {
  return {.responses = {.command = 86,
              .form_count = 1,
              .forms = {{{.id = 86,
               .min_size = 18,
               .max_size = max_body_size,
               .size = 18}}}},
      .response_required = true,
      .retry_is_safe = true,
      .timeout_ms = 500};
}

constexpr ResponsePolicy response_policy(const BoardInfoRequestExt&) noexcept {
  return {.responses = {.command = 86,
              .form_count = 1,
              .forms = {{{.id = 86,
               .min_size = 18,
               .max_size = max_body_size,
               .size = 18}}}},
      .response_required = true,
      .retry_is_safe = true,
      .has_effect = true,
      .timeout_ms = 500};
}

constexpr ResponsePolicy response_policy(const BoardInfo3Request&) noexcept {
  return {.responses = {.command = 20,
              .form_count = 1,
              .forms = {{{.id = 20,
               .min_size = 69,
               .max_size = max_body_size,
               .size = 69}}}},
      .response_required = true,
      .retry_is_safe = true,
      .timeout_ms = 500};
}

constexpr ResponsePolicy response_policy(const ResetRequest&) noexcept {
  return {.responses = {.command = 114},
      .restarts_board = true,
      .has_effect = true,
      .moves = true,
      .timeout_ms = 500};
}

constexpr ResponsePolicy response_policy(const ResetRequestExt& request) noexcept {
  if (request.confirm.has(ResetOption::notify)) {
    return {.responses = {.command = 114,
              .form_count = 1,
              .forms = {{{.id = 114,
               .min_size = 0,
               .max_size = max_body_size,
               .size = 0}}}},
      .response_required = true,
      .restarts_board = true,
      .has_effect = true,
      .moves = true,
      .timeout_ms = 500};
  }
  return {.responses = {.command = 114},
      .restarts_board = true,
      .has_effect = true,
      .moves = true,
      .timeout_ms = 500};
}

constexpr ResponsePolicy response_policy(const BootMode3&) noexcept {
  return {.responses = {.command = 51},
      .restarts_board = true,
      .has_effect = true,
      .moves = true,
      .timeout_ms = 500};
}

constexpr ResponsePolicy response_policy(const BootMode3Ext& request) noexcept {
  if (request.confirm.has(ResetOption::notify)) {
    return {.responses = {.command = 51,
              .form_count = 1,
              .forms = {{{.id = 114,
               .min_size = 0,
               .max_size = max_body_size,
               .size = 0}}}},
      .response_required = true,
      .restarts_board = true,
      .has_effect = true,
      .moves = true,
      .timeout_ms = 500};
  }
  return {.responses = {.command = 51},
      .restarts_board = true,
      .has_effect = true,
      .moves = true,
      .timeout_ms = 500};
}

constexpr ResponsePolicy response_policy(const ReadStateVarsRequest&) noexcept {
  return {.responses = {.command = 111,
              .form_count = 1,
              .forms = {{{.id = 111,
               .min_size = 192,
               .max_size = max_body_size,
               .size = 192}}}},
      .response_required = true,
      .retry_is_safe = true,
      .timeout_ms = 500};
}

constexpr ResponsePolicy response_policy(const WriteStateVars&) noexcept {
  return {.responses = {.command = 112,
              .confirmed = Confirmed::always},
      .confirmations = 1,
      .retry_is_safe = true,
      .has_effect = true,
      .timeout_ms = 2000};
}

constexpr ResponsePolicy response_policy(const SignMessageRequest&) noexcept {
  return {.responses = {.command = 50,
              .form_count = 1,
              .forms = {{{.id = 50,
               .min_size = 32,
               .max_size = max_body_size,
               .size = 32}}}},
      .response_required = true,
      .retry_is_safe = true,
      .timeout_ms = 500};
}

constexpr ResponsePolicy response_policy(const PassProtectReadRequest&) noexcept {
  return {.responses = {.command = 136,
              .form_count = 1,
              .forms = {{{.id = 136,
               .min_size = 8,
               .max_size = max_body_size,
               .size = 8}}}},
      .response_required = true,
      .retry_is_safe = true,
      .timeout_ms = 500};
}

constexpr ResponsePolicy response_policy(const PassProtectWrite&) noexcept {
  return {.responses = {.command = 137,
              .confirmed = Confirmed::always},
      .confirmations = 1,
      .retry_is_safe = true,
      .has_effect = true,
      .timeout_ms = 2000};
}

constexpr ResponsePolicy response_policy(const QueueParamsInfo3Request&) noexcept {
  return {.responses = {.command = 30,
              .confirmed = Confirmed::possible},
      .confirmations = 1,
      .has_effect = true,
      .timeout_ms = 500};
}

constexpr ResponsePolicy response_policy(const SystemStateRequest&) noexcept {
  return {.responses = {.command = 52,
              .confirmed = Confirmed::possible},
      .confirmations = 1,
      .has_effect = true,
      .timeout_ms = 500};
}

constexpr ResponsePolicy response_policy(const MavlinkInfoRequest&) noexcept {
  return {.responses = {.command = 250,
              .confirmed = Confirmed::possible},
      .confirmations = 1,
      .has_effect = true,
      .timeout_ms = 500};
}

constexpr ResponsePolicy response_policy(const MavlinkDebugRequest&) noexcept {
  return {.responses = {.command = 251,
              .confirmed = Confirmed::possible},
      .confirmations = 1,
      .has_effect = true,
      .timeout_ms = 500};
}

constexpr ResponsePolicy response_policy(const ExtLicenseInfoRequest&) noexcept {
  return {.responses = {.command = 124,
              .confirmed = Confirmed::possible},
      .confirmations = 1,
      .has_effect = true,
      .timeout_ms = 500};
}

}  // namespace sbgc::msg
