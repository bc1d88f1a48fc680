// Generated from spec/ by generator/: edit those, then run ./dev generate.

/// peripherals: what comes back for each request.
#pragma once

#include <cstdint>

#include <sbgc/exchange.hpp>
#include <sbgc/messages/peripherals.hpp>

namespace sbgc::msg {

struct I2cReadRegBuf;

constexpr Exchange exchange_of(const BeepSound&) noexcept {
  return {.replies = {.command = 89,
              .confirmed = Confirmed::possible},
      .confirmations = 1,
      .timeout_ms = 500};
}

constexpr Exchange exchange_of(const TriggerPin&) noexcept {
  return {.replies = {.command = 84,
              .confirmed = Confirmed::possible},
      .confirmations = 1,
      .retry_is_safe = true,
      .timeout_ms = 500};
}

constexpr Exchange exchange_of(const ServoOut&) noexcept {
  return {.replies = {.command = 36,
              .confirmed = Confirmed::possible},
      .confirmations = 1,
      .retry_is_safe = true,
      .timeout_ms = 500};
}

constexpr Exchange exchange_of(const I2cWriteRegBuf&) noexcept {
  return {.replies = {.command = 39,
              .confirmed = Confirmed::always},
      .confirmations = 1,
      .timeout_ms = 500};
}

constexpr Exchange exchange_of(const I2cReadRegBufRequest&) noexcept {
  return {.replies = {.command = 40,
              .answer_count = 1,
              .answers = {{{.id = 40,
               .min_size = 0,
               .max_size = max_body_size,
               .size = 255}}}},
      .answer_required = true,
      .timeout_ms = 500};
}

constexpr Exchange exchange_of(const ApiVirtChControl&) noexcept {
  return {.replies = {.command = 45,
              .confirmed = Confirmed::unlikely},
      .confirmations = 1,
      .retry_is_safe = true,
      .timeout_ms = 500};
}

}  // namespace sbgc::msg
