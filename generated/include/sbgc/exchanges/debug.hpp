// Generated from spec/ by generator/: edit those, then run ./dev generate.

/// debug: what comes back for each request.
#pragma once

#include <cstdint>

#include <sbgc/exchange.hpp>
#include <sbgc/messages/debug.hpp>

namespace sbgc::msg {

struct DebugVars3;
struct DebugVarsInfo3;

constexpr Exchange exchange_of(const DebugVarsInfo3Request&) noexcept {
  return {.replies = {.command = 253,
              .answer_count = 1,
              .answers = {{{.id = 253,
               .min_size = 1,
               .max_size = max_body_size,
               .size = 255}}}},
      .answer_required = true,
      .retry_is_safe = true,
      .timeout_ms = 500};
}

constexpr Exchange exchange_of(const DebugVars3Request&) noexcept {
  return {.replies = {.command = 254,
              .answer_count = 1,
              .answers = {{{.id = 254,
               .min_size = 0,
               .max_size = max_body_size,
               .size = 255}}}},
      .answer_required = true,
      .retry_is_safe = true,
      .timeout_ms = 500};
}

}  // namespace sbgc::msg
