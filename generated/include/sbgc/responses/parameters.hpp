// Generated from spec/ by generator/: edit those, then run ./dev generate.

/// Response policies of the requests in <sbgc/messages/parameters.hpp>.
#pragma once

#include <cstdint>

#include <sbgc/response_policy.hpp>
#include <sbgc/messages/parameters.hpp>

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wdeprecated-declarations"

namespace sbgc::msg {

constexpr ResponsePolicy response_policy(const ReadParams3Request& request) noexcept {
  return {.responses = {.command = 21,
              .form_count = 1,
              .forms = {{{.id = 21,
               .min_size = 134,
               .max_size = max_body_size,
               .size = 134,
               .correlation = {{{.offset = 0, .size = request.profile_id == 255 ? std::uint8_t{0} : std::uint8_t{1}, .value = static_cast<std::uint32_t>(request.profile_id)}}}}}}},
      .response_required = true,
      .retry_is_safe = true,
      .timeout_ms = 500};
}

constexpr ResponsePolicy response_policy(const WriteParams3&) noexcept {
  return {.responses = {.command = 22,
              .confirmed = Confirmed::always},
      .confirmations = 1,
      .retry_is_safe = true,
      .has_effect = true,
      .moves = true,
      .timeout_ms = 2000};
}

constexpr ResponsePolicy response_policy(const ReadParams& request) noexcept {
  return {.responses = {.command = 82,
              .form_count = 1,
              .forms = {{{.id = 82,
               .min_size = 134,
               .max_size = max_body_size,
               .size = 134,
               .correlation = {{{.offset = 0, .size = request.profile_id == 255 ? std::uint8_t{0} : std::uint8_t{1}, .value = static_cast<std::uint32_t>(request.profile_id)}}}}}}},
      .response_required = true,
      .retry_is_safe = true,
      .timeout_ms = 500};
}

constexpr ResponsePolicy response_policy(const WriteParams&) noexcept {
  return {.responses = {.command = 87,
              .confirmed = Confirmed::always},
      .confirmations = 1,
      .retry_is_safe = true,
      .has_effect = true,
      .moves = true,
      .timeout_ms = 2000};
}

constexpr ResponsePolicy response_policy(const ReadParamsExtRequest& request) noexcept {
  return {.responses = {.command = 33,
              .form_count = 1,
              .forms = {{{.id = 33,
               .min_size = 104,
               .max_size = max_body_size,
               .size = 104,
               .correlation = {{{.offset = 0, .size = request.profile_id == 255 ? std::uint8_t{0} : std::uint8_t{1}, .value = static_cast<std::uint32_t>(request.profile_id)}}}}}}},
      .response_required = true,
      .retry_is_safe = true,
      .timeout_ms = 500};
}

constexpr ResponsePolicy response_policy(const WriteParamsExt&) noexcept {
  return {.responses = {.command = 34,
              .confirmed = Confirmed::always},
      .confirmations = 1,
      .retry_is_safe = true,
      .has_effect = true,
      .moves = true,
      .timeout_ms = 2000};
}

constexpr ResponsePolicy response_policy(const ReadParamsExt2Request& request) noexcept {
  return {.responses = {.command = 62,
              .form_count = 1,
              .forms = {{{.id = 62,
               .min_size = 151,
               .max_size = max_body_size,
               .size = 151,
               .correlation = {{{.offset = 0, .size = request.profile_id == 255 ? std::uint8_t{0} : std::uint8_t{1}, .value = static_cast<std::uint32_t>(request.profile_id)}}}}}}},
      .response_required = true,
      .retry_is_safe = true,
      .timeout_ms = 500};
}

constexpr ResponsePolicy response_policy(const WriteParamsExt2&) noexcept {
  return {.responses = {.command = 63,
              .confirmed = Confirmed::always},
      .confirmations = 1,
      .retry_is_safe = true,
      .has_effect = true,
      .moves = true,
      .timeout_ms = 2000};
}

constexpr ResponsePolicy response_policy(const WriteParamsSet&) noexcept {
  return {.responses = {.command = 119,
              .confirmed = Confirmed::always},
      .confirmations = 1,
      .retry_is_safe = true,
      .has_effect = true,
      .moves = true,
      .timeout_ms = 2000};
}

constexpr ResponsePolicy response_policy(const ReadProfileNamesRequest&) noexcept {
  return {.responses = {.command = 28,
              .form_count = 1,
              .forms = {{{.id = 28,
               .min_size = 240,
               .max_size = max_body_size,
               .size = 240}}}},
      .response_required = true,
      .retry_is_safe = true,
      .timeout_ms = 500};
}

constexpr ResponsePolicy response_policy(const WriteProfileNames&) noexcept {
  return {.responses = {.command = 29,
              .confirmed = Confirmed::possible},
      .confirmations = 1,
      .retry_is_safe = true,
      .has_effect = true,
      .timeout_ms = 2000};
}

constexpr ResponsePolicy response_policy(const ProfileSet& request) noexcept {
  return {.responses = {.command = 95,
              .confirmed = Confirmed::always},
      .confirmations = 1,
      .has_effect = true,
      .moves = !(request.action == ProfileSetAction::save ||
          request.action == ProfileSetAction::clear),
      .timeout_ms = 5000};
}

constexpr ResponsePolicy response_policy(const SaveParams3&) noexcept {
  return {.responses = {.command = 32,
              .confirmed = Confirmed::possible},
      .confirmations = 1,
      .retry_is_safe = true,
      .has_effect = true,
      .timeout_ms = 2000};
}

constexpr ResponsePolicy response_policy(const UseDefaults&) noexcept {
  return {.responses = {.command = 70,
              .confirmed = Confirmed::possible},
      .confirmations = 1,
      .retry_is_safe = true,
      .has_effect = true,
      .moves = true,
      .timeout_ms = 5000};
}

}  // namespace sbgc::msg

#pragma GCC diagnostic pop
