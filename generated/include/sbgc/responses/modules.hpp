// Generated from spec/ by generator/: edit those, then run ./dev generate.

/// Response policies of the requests in <sbgc/messages/modules.hpp>.
#pragma once

#include <cstdint>

#include <sbgc/response_policy.hpp>
#include <sbgc/messages/modules.hpp>

namespace sbgc::msg {

constexpr ResponsePolicy response_policy(const ModuleListRequest&) noexcept {
  return {.responses = {.command = 76,
              .form_count = 1,
              .forms = {{{.id = 76,
               .min_size = 1,
               .max_size = max_body_size,
               .size = 222}}}},
      .response_required = true,
      .retry_is_safe = true,
      .timeout_ms = 500};
}

constexpr ResponsePolicy response_policy(const CanDeviceScanRequest&) noexcept {
  return {.responses = {.command = 96,
              .form_count = 1,
              .forms = {{{.id = 96,
               .min_size = 0,
               .max_size = max_body_size,
               .size = 252}}}},
      .response_required = true,
      .retry_is_safe = true,
      .timeout_ms = 500};
}

constexpr ResponsePolicy response_policy(const TransparentSapiRequest&) noexcept {
  return {.responses = {.command = 151},
      .has_effect = true,
      .moves = true,
      .timeout_ms = 500};
}

constexpr ResponsePolicy response_policy(const ModuleFlashStart&) noexcept {
  return {.responses = {.command = 78,
              .confirmed = Confirmed::always},
      .confirmations = 1,
      .has_effect = true,
      .moves = true,
      .timeout_ms = 5000};
}

constexpr ResponsePolicy response_policy(const ModuleFlashWrite&) noexcept {
  return {.responses = {.command = 81,
              .confirmed = Confirmed::always},
      .confirmations = 1,
      .has_effect = true,
      .timeout_ms = 5000};
}

constexpr ResponsePolicy response_policy(const ModuleFlashFinish&) noexcept {
  return {.responses = {.command = 83,
              .confirmed = Confirmed::always},
      .confirmations = 1,
      .has_effect = true,
      .timeout_ms = 5000};
}

constexpr ResponsePolicy response_policy(const UdrvDeviceScan&) noexcept {
  return {.responses = {.command = 144,
              .form_count = 1,
              .forms = {{{.id = 96,
               .min_size = 0,
               .max_size = max_body_size,
               .size = 252}}}},
      .response_required = true,
      .has_effect = true,
      .timeout_ms = 5000};
}

constexpr ResponsePolicy response_policy(const SetTranspProxy&) noexcept {
  return {.responses = {.command = 143},
      .has_effect = true,
      .timeout_ms = 500};
}

constexpr ResponsePolicy response_policy(const UartBypassRequest&) noexcept {
  return {.responses = {.command = 60,
              .confirmed = Confirmed::possible},
      .confirmations = 1,
      .has_effect = true,
      .timeout_ms = 500};
}

constexpr ResponsePolicy response_policy(const SetDeviceAddrRequest&) noexcept {
  return {.responses = {.command = 107,
              .confirmed = Confirmed::possible},
      .confirmations = 1,
      .has_effect = true,
      .timeout_ms = 500};
}

constexpr ResponsePolicy response_policy(const SerialProxyRequest&) noexcept {
  return {.responses = {.command = 113,
              .confirmed = Confirmed::possible},
      .confirmations = 1,
      .has_effect = true,
      .timeout_ms = 500};
}

}  // namespace sbgc::msg
