// Generated from spec/ by generator/: edit those, then run ./dev generate.

/// Response policies of the requests in <sbgc/messages/storage.hpp>.
#pragma once

#include <cstdint>

#include <sbgc/response_policy.hpp>
#include <sbgc/messages/storage.hpp>

namespace sbgc::msg {

constexpr ResponsePolicy response_policy(const EepromWrite& request) noexcept {
  return {.responses = {.command = 47,
              .confirmed = Confirmed::always,
              .confirmation = {.offset = 1, .size = 4, .value = static_cast<std::uint32_t>(request.addr)}},
      .confirmations = 1,
      .retry_is_safe = true,
      .has_effect = true,
      .moves = true,
      .timeout_ms = 500};
}

constexpr ResponsePolicy response_policy(const ReadFileRequest& request) noexcept {
  return {.responses = {.command = 53,
              .form_count = 2,
              .forms = {{{.id = 53,
               .min_size = 4,
               .max_size = max_body_size,
               .size = 255,
               .correlation = {{{.offset = 2, .size = 2, .value = static_cast<std::uint32_t>(request.page_offset.raw())}}}},
                           {.id = 53,
               .min_size = 1,
               .max_size = 1,
               .size = 1,
               .is_error = true}}}},
      .response_required = true,
      .retry_is_safe = true,
      .timeout_ms = 500};
}

constexpr ResponsePolicy response_policy(const WriteFile&) noexcept {
  return {.responses = {.command = 54,
              .confirmed = Confirmed::always},
      .confirmations = 1,
      .retry_is_safe = true,
      .has_effect = true,
      .timeout_ms = 2000,
      .result = {1, 1, 0}};
}

constexpr ResponsePolicy response_policy(const FsClearAll&) noexcept {
  return {.responses = {.command = 55,
              .confirmed = Confirmed::always},
      .confirmations = 1,
      .retry_is_safe = true,
      .has_effect = true,
      .timeout_ms = 2000,
      .result = {1, 1, 0}};
}

constexpr ResponsePolicy response_policy(const EepromReadRequest& request) noexcept {
  return {.responses = {.command = 48,
              .form_count = 1,
              .forms = {{{.id = 48,
               .min_size = 4,
               .max_size = max_body_size,
               .size = 196,
               .correlation = {{{.offset = 0, .size = 4, .value = static_cast<std::uint32_t>(request.addr)}}}}}}},
      .response_required = true,
      .retry_is_safe = true,
      .timeout_ms = 500};
}

constexpr ResponsePolicy response_policy(const ReadExternalDataRequest&) noexcept {
  return {.responses = {.command = 42,
              .form_count = 1,
              .forms = {{{.id = 42,
               .min_size = 128,
               .max_size = max_body_size,
               .size = 128}}}},
      .response_required = true,
      .retry_is_safe = true,
      .timeout_ms = 500};
}

constexpr ResponsePolicy response_policy(const WriteExternalData&) noexcept {
  return {.responses = {.command = 41,
              .confirmed = Confirmed::possible},
      .confirmations = 1,
      .retry_is_safe = true,
      .has_effect = true,
      .timeout_ms = 2000};
}

}  // namespace sbgc::msg
