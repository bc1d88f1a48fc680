// Generated from spec/ by generator/: edit those, then run ./dev generate.

/// Response policies of the requests in <sbgc/messages/scripting.hpp>.
#pragma once

#include <cstdint>

#include <sbgc/response_policy.hpp>
#include <sbgc/messages/scripting.hpp>

namespace sbgc::msg {

constexpr ResponsePolicy response_policy(const RunScript& request) noexcept {
  if (request.mode == ScriptMode::stop) {
    return {.responses = {.command = 57,
              .confirmed = Confirmed::possible},
      .confirmations = 1,
      .retry_is_safe = true,
      .has_effect = true,
      .moves = true,
      .timeout_ms = 500};
  }
  return {.responses = {.command = 57,
              .confirmed = Confirmed::possible},
      .confirmations = 1,
      .has_effect = true,
      .moves = true,
      .timeout_ms = 500};
}

}  // namespace sbgc::msg
