// Generated from spec/ by generator/: edit those, then run ./dev generate.

/// Response policies of the requests in <sbgc/messages/debug.hpp>.
#pragma once

#include <cstdint>

#include <sbgc/response_policy.hpp>
#include <sbgc/messages/debug.hpp>

namespace sbgc::msg {

constexpr ResponsePolicy response_policy(const DebugVarsInfo3Request&) noexcept {
  return {.responses = {.command = 253,
              .form_count = 1,
              .forms = {{{.id = 253,
               .min_size = 1,
               .max_size = max_body_size,
               .size = 255}}}},
      .response_required = true,
      .retry_is_safe = true,
      .timeout_ms = 500};
}

constexpr ResponsePolicy response_policy(const DebugVars3Request&) noexcept {
  return {.responses = {.command = 254,
              .form_count = 1,
              .forms = {{{.id = 254,
               .min_size = 0,
               .max_size = max_body_size,
               .size = 255}}}},
      .response_required = true,
      .retry_is_safe = true,
      .timeout_ms = 500};
}

constexpr ResponsePolicy response_policy(const DebugVars3RequestSelected&) noexcept {
  return {.responses = {.command = 254},
      .retry_is_safe = true,
      .timeout_ms = 500};
}

constexpr ResponsePolicy response_policy(const SetDebugPortRequest&) noexcept {
  return {.responses = {.command = 249,
              .confirmed = Confirmed::always},
      .confirmations = 1,
      .retry_is_safe = true,
      .has_effect = true,
      .timeout_ms = 500};
}

}  // namespace sbgc::msg
