// Generated from spec/ by generator/: edit those, then run ./dev generate.

/// control: what comes back for each request.
#pragma once

#include <cstdint>

#include <sbgc/exchange.hpp>
#include <sbgc/messages/control.hpp>

namespace sbgc::msg {

struct GetAngles;
struct GetAnglesExt;

constexpr Exchange exchange_of(const Control&) noexcept {
  return {.replies = {.command = 67,
              .confirmed = Confirmed::possible},
      .confirmations = 1,
      .retry_is_safe = true,
      .timeout_ms = 500};
}

constexpr Exchange exchange_of(const ControlExt&) noexcept {
  return {.replies = {.command = 67,
              .confirmed = Confirmed::possible},
      .confirmations = 1,
      .retry_is_safe = true,
      .timeout_ms = 500};
}

constexpr Exchange exchange_of(const GetAnglesRequest&) noexcept {
  return {.replies = {.command = 73,
              .answer_count = 1,
              .answers = {{{.id = 73,
               .min_size = 18,
               .max_size = max_body_size,
               .size = 18}}}},
      .answer_required = true,
      .retry_is_safe = true,
      .timeout_ms = 500};
}

constexpr Exchange exchange_of(const GetAnglesExtRequest&) noexcept {
  return {.replies = {.command = 61,
              .answer_count = 1,
              .answers = {{{.id = 61,
               .min_size = 54,
               .max_size = max_body_size,
               .size = 54}}}},
      .answer_required = true,
      .retry_is_safe = true,
      .timeout_ms = 500};
}

constexpr Exchange exchange_of(const MotorsOn&) noexcept {
  return {.replies = {.command = 77,
              .confirmed = Confirmed::always},
      .confirmations = 1,
      .retry_is_safe = true,
      .timeout_ms = 500};
}

constexpr Exchange exchange_of(const MotorsOff&) noexcept {
  return {.replies = {.command = 109,
              .confirmed = Confirmed::always},
      .confirmations = 1,
      .retry_is_safe = true,
      .timeout_ms = 500};
}

constexpr Exchange exchange_of(const MotorsOffExt&) noexcept {
  return {.replies = {.command = 109,
              .confirmed = Confirmed::always},
      .confirmations = 1,
      .retry_is_safe = true,
      .timeout_ms = 500};
}

constexpr Exchange exchange_of(const ExecuteMenu&) noexcept {
  return {.replies = {.command = 69,
              .confirmed = Confirmed::possible},
      .confirmations = 1,
      .timeout_ms = 500};
}

constexpr Exchange exchange_of(const ExecuteMenuExt&) noexcept {
  return {.replies = {.command = 69,
              .confirmed = Confirmed::possible},
      .confirmations = 1,
      .timeout_ms = 500};
}

constexpr Exchange exchange_of(const HelperData&) noexcept {
  return {.replies = {.command = 72,
              .confirmed = Confirmed::unlikely},
      .confirmations = 1,
      .timeout_ms = 500};
}

constexpr Exchange exchange_of(const HelperDataExt&) noexcept {
  return {.replies = {.command = 72,
              .confirmed = Confirmed::unlikely},
      .confirmations = 1,
      .timeout_ms = 500};
}

}  // namespace sbgc::msg
