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

constexpr ResponsePolicy response_policy(const ExecuteMenu&) noexcept {
  return {.responses = {.command = 69,
              .confirmed = Confirmed::possible},
      .confirmations = 1,
      .timeout_ms = 500};
}

constexpr ResponsePolicy response_policy(const ExecuteMenuExt&) noexcept {
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
