// Generated from spec/ by generator/: edit those, then run ./dev generate.

/// imu: what comes back for each request.
#pragma once

#include <cstdint>

#include <sbgc/exchange.hpp>
#include <sbgc/messages/imu.hpp>

namespace sbgc::msg {

struct AhrsHelper;

constexpr Exchange exchange_of(const SelectImu3&) noexcept {
  return {.replies = {.command = 24,
              .confirmed = Confirmed::possible},
      .confirmations = 1,
      .retry_is_safe = true,
      .timeout_ms = 500};
}

constexpr Exchange exchange_of(const SelectImu3Ext&) noexcept {
  return {.replies = {.command = 24,
              .confirmed = Confirmed::possible},
      .confirmations = 1,
      .retry_is_safe = true,
      .timeout_ms = 500};
}

constexpr Exchange exchange_of(const AhrsHelperRequest&) noexcept {
  return {.replies = {.command = 56,
              .answer_count = 1,
              .answers = {{{.id = 56,
               .min_size = 24,
               .max_size = max_body_size,
               .size = 24}}}},
      .answer_required = true,
      .retry_is_safe = true,
      .timeout_ms = 500};
}

constexpr Exchange exchange_of(const AhrsHelperRequestWide&) noexcept {
  return {.replies = {.command = 56,
              .answer_count = 1,
              .answers = {{{.id = 56,
               .min_size = 24,
               .max_size = max_body_size,
               .size = 24}}}},
      .answer_required = true,
      .retry_is_safe = true,
      .timeout_ms = 500};
}

constexpr Exchange exchange_of(const AhrsHelperRequestExt& request) noexcept {
  if (request.mode.has(AhrsHelperModeBit::set)) {
    return {.replies = {.command = 56,
              .confirmed = Confirmed::unlikely},
      .confirmations = 1,
      .retry_is_safe = true,
      .timeout_ms = 500};
  }
  return {.replies = {.command = 56,
              .answer_count = 1,
              .answers = {{{.id = 56,
               .min_size = 24,
               .max_size = max_body_size,
               .size = 24}}}},
      .answer_required = true,
      .retry_is_safe = true,
      .timeout_ms = 500};
}

constexpr Exchange exchange_of(const AhrsHelperRequestExtWide& request) noexcept {
  if (request.mode.has(AhrsHelperWideModeBit::set)) {
    return {.replies = {.command = 56,
              .confirmed = Confirmed::unlikely},
      .confirmations = 1,
      .retry_is_safe = true,
      .timeout_ms = 500};
  }
  return {.replies = {.command = 56,
              .answer_count = 1,
              .answers = {{{.id = 56,
               .min_size = 24,
               .max_size = max_body_size,
               .size = 24}}}},
      .answer_required = true,
      .retry_is_safe = true,
      .timeout_ms = 500};
}

constexpr Exchange exchange_of(const GyroCorrection&) noexcept {
  return {.replies = {.command = 75,
              .confirmed = Confirmed::possible},
      .confirmations = 1,
      .timeout_ms = 500};
}

}  // namespace sbgc::msg
