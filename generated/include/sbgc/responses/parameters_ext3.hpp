// Generated from spec/ by generator/: edit those, then run ./dev generate.

/// Response policies of the requests in <sbgc/messages/parameters_ext3.hpp>.
#pragma once

#include <cstdint>

#include <sbgc/response_policy.hpp>
#include <sbgc/messages/parameters_ext3.hpp>

namespace sbgc::msg {

constexpr ResponsePolicy response_policy(const ReadParamsExt3Request& request) noexcept {
  return {.responses = {.command = 104,
              .form_count = 1,
              .forms = {{{.id = 104,
               .min_size = 221,
               .max_size = max_body_size,
               .size = 221,
               .correlation = {{{.offset = 0, .size = request.profile_id == 255 ? std::uint8_t{0} : std::uint8_t{1}, .value = static_cast<std::uint32_t>(request.profile_id)}}}}}}},
      .response_required = true,
      .retry_is_safe = true,
      .timeout_ms = 500};
}

constexpr ResponsePolicy response_policy(const WriteParamsExt3&) noexcept {
  return {.responses = {.command = 105,
              .confirmed = Confirmed::always},
      .confirmations = 1,
      .retry_is_safe = true,
      .has_effect = true,
      .moves = true,
      .timeout_ms = 2000};
}

}  // namespace sbgc::msg
