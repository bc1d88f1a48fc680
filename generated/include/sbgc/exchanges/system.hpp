// Generated from spec/ by generator/: edit those, then run ./dev generate.

/// system: what comes back for each request.
#pragma once

#include <cstdint>

#include <sbgc/exchange.hpp>
#include <sbgc/messages/system.hpp>

namespace sbgc::msg {

struct BoardInfo;
struct BoardInfo3;
struct Reset;

constexpr Exchange exchange_of(const BoardInfoRequest&) noexcept {
  return {.replies = {.command = 86,
              .answer_count = 1,
              .answers = {{{.id = 86,
               .min_size = 18,
               .max_size = max_body_size,
               .size = 18}}}},
      .answer_required = true,
      .retry_is_safe = true,
      .timeout_ms = 500};
}

constexpr Exchange exchange_of(const BoardInfoRequestOneByte&) noexcept {
  return {.replies = {.command = 86,
              .answer_count = 1,
              .answers = {{{.id = 86,
               .min_size = 18,
               .max_size = max_body_size,
               .size = 18}}}},
      .answer_required = true,
      .retry_is_safe = true,
      .timeout_ms = 500};
}

constexpr Exchange exchange_of(const BoardInfoRequestExt&) noexcept {
  return {.replies = {.command = 86,
              .answer_count = 1,
              .answers = {{{.id = 86,
               .min_size = 18,
               .max_size = max_body_size,
               .size = 18}}}},
      .answer_required = true,
      .retry_is_safe = true,
      .timeout_ms = 500};
}

constexpr Exchange exchange_of(const BoardInfo3Request&) noexcept {
  return {.replies = {.command = 20,
              .answer_count = 1,
              .answers = {{{.id = 20,
               .min_size = 69,
               .max_size = max_body_size,
               .size = 69}}}},
      .answer_required = true,
      .retry_is_safe = true,
      .timeout_ms = 500};
}

constexpr Exchange exchange_of(const ResetRequest&) noexcept {
  return {.replies = {.command = 114},
      .restarts_board = true,
      .timeout_ms = 500};
}

constexpr Exchange exchange_of(const ResetRequestExt& request) noexcept {
  if (request.confirm.has(ResetOption::notify)) {
    return {.replies = {.command = 114,
              .answer_count = 1,
              .answers = {{{.id = 114,
               .min_size = 0,
               .max_size = max_body_size,
               .size = 0}}}},
      .answer_required = true,
      .restarts_board = true,
      .timeout_ms = 500};
  }
  return {.replies = {.command = 114},
      .restarts_board = true,
      .timeout_ms = 500};
}

constexpr Exchange exchange_of(const BootMode3&) noexcept {
  return {.replies = {.command = 51},
      .restarts_board = true,
      .timeout_ms = 500};
}

constexpr Exchange exchange_of(const BootMode3Ext& request) noexcept {
  if (request.confirm.has(ResetOption::notify)) {
    return {.replies = {.command = 51,
              .answer_count = 1,
              .answers = {{{.id = 114,
               .min_size = 0,
               .max_size = max_body_size,
               .size = 0}}}},
      .answer_required = true,
      .restarts_board = true,
      .timeout_ms = 500};
  }
  return {.replies = {.command = 51},
      .restarts_board = true,
      .timeout_ms = 500};
}

constexpr Exchange exchange_of(const QueueParamsInfo3Request&) noexcept {
  return {.replies = {.command = 30,
              .confirmed = Confirmed::possible},
      .confirmations = 1,
      .timeout_ms = 500};
}

constexpr Exchange exchange_of(const SystemStateRequest&) noexcept {
  return {.replies = {.command = 52,
              .confirmed = Confirmed::possible},
      .confirmations = 1,
      .timeout_ms = 500};
}

constexpr Exchange exchange_of(const MavlinkInfoRequest&) noexcept {
  return {.replies = {.command = 250,
              .confirmed = Confirmed::possible},
      .confirmations = 1,
      .timeout_ms = 500};
}

constexpr Exchange exchange_of(const MavlinkDebugRequest&) noexcept {
  return {.replies = {.command = 251,
              .confirmed = Confirmed::possible},
      .confirmations = 1,
      .timeout_ms = 500};
}

}  // namespace sbgc::msg
