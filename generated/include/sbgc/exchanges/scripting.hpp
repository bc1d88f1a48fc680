// Generated from spec/ by generator/: edit those, then run ./dev generate.

/// scripting: what comes back for each request.
#pragma once

#include <cstdint>

#include <sbgc/exchange.hpp>
#include <sbgc/messages/scripting.hpp>

namespace sbgc::msg {

constexpr Exchange exchange_of(const RunScript&) noexcept {
  return {.replies = {.command = 57,
              .confirmed = Confirmed::possible},
      .confirmations = 1,
      .timeout_ms = 500};
}

}  // namespace sbgc::msg
