// Generated from spec/ by generator/: edit those, then run ./dev generate.

/// Response policies of the requests in <sbgc/messages/adjustable_variables.hpp>.
#pragma once

#include <cstdint>

#include <sbgc/response_policy.hpp>
#include <sbgc/messages/adjustable_variables.hpp>

namespace sbgc::msg {

constexpr ResponsePolicy response_policy(const SetAdjVarsVal&) noexcept {
  return {.responses = {.command = 31,
              .confirmed = Confirmed::always},
      .confirmations = 1,
      .retry_is_safe = true,
      .has_effect = true,
      .moves = true,
      .timeout_ms = 500};
}

constexpr ResponsePolicy response_policy(const GetAdjVarsVal& request) noexcept {
  return {.responses = {.command = 64,
              .form_count = 1,
              .forms = {{{.id = 31,
               .min_size = 1,
               .max_size = max_body_size,
               .size = 201,
               .correlation = {{{.offset = 1, .size = request.param_id.empty() ? std::uint8_t{0} : std::uint8_t{1}, .value = request.param_id.empty() ? 0 : static_cast<std::uint32_t>(static_cast<std::uint8_t>(request.param_id[0]))}}}}}}},
      .response_required = true,
      .retry_is_safe = true,
      .timeout_ms = 500};
}

constexpr ResponsePolicy response_policy(const ReadAdjVarsCfgRequest&) noexcept {
  return {.responses = {.command = 43,
              .form_count = 1,
              .forms = {{{.id = 43,
               .min_size = 128,
               .max_size = max_body_size,
               .size = 128}}}},
      .response_required = true,
      .retry_is_safe = true,
      .timeout_ms = 500};
}

constexpr ResponsePolicy response_policy(const WriteAdjVarsCfg&) noexcept {
  return {.responses = {.command = 44,
              .confirmed = Confirmed::always},
      .confirmations = 1,
      .retry_is_safe = true,
      .has_effect = true,
      .moves = true,
      .timeout_ms = 2000};
}

constexpr ResponsePolicy response_policy(const AdjVarsStateRequest&) noexcept {
  return {.responses = {.command = 46,
              .form_count = 1,
              .forms = {{{.id = 46,
               .min_size = 15,
               .max_size = max_body_size,
               .size = 15}}}},
      .response_required = true,
      .retry_is_safe = true,
      .timeout_ms = 500};
}

constexpr ResponsePolicy response_policy(const AdjVarsStateRequestExt&) noexcept {
  return {.responses = {.command = 46,
              .form_count = 1,
              .forms = {{{.id = 46,
               .min_size = 15,
               .max_size = max_body_size,
               .size = 15}}}},
      .response_required = true,
      .retry_is_safe = true,
      .timeout_ms = 500};
}

constexpr ResponsePolicy response_policy(const AdjVarsInfoRequest&) noexcept {
  return {.responses = {.command = 132,
              .form_count = 1,
              .forms = {{{.id = 132,
               .min_size = 1,
               .max_size = max_body_size,
               .size = 255}}}},
      .response_required = true,
      .retry_is_safe = true,
      .timeout_ms = 500};
}

constexpr ResponsePolicy response_policy(const AdjVarsInfoRequestAll&) noexcept {
  return {.responses = {.command = 132,
              .form_count = 1,
              .forms = {{{.id = 132,
               .min_size = 1,
               .max_size = max_body_size,
               .size = 255}}}},
      .response_required = true,
      .retry_is_safe = true,
      .timeout_ms = 500};
}

constexpr ResponsePolicy response_policy(const SetAdjVarsValF&) noexcept {
  return {.responses = {.command = 134,
              .confirmed = Confirmed::always},
      .confirmations = 1,
      .retry_is_safe = true,
      .has_effect = true,
      .moves = true,
      .timeout_ms = 500};
}

constexpr ResponsePolicy response_policy(const GetAdjVarsValF& request) noexcept {
  return {.responses = {.command = 135,
              .form_count = 1,
              .forms = {{{.id = 134,
               .min_size = 1,
               .max_size = max_body_size,
               .size = 201,
               .correlation = {{{.offset = 1, .size = request.id.empty() ? std::uint8_t{0} : std::uint8_t{1}, .value = request.id.empty() ? 0 : static_cast<std::uint32_t>(static_cast<std::uint8_t>(request.id[0]))}}}}}}},
      .response_required = true,
      .retry_is_safe = true,
      .timeout_ms = 500};
}

}  // namespace sbgc::msg
