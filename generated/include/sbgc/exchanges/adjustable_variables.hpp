// Generated from spec/ by generator/: edit those, then run ./dev generate.

/// adjustable_variables: what comes back for each request.
#pragma once

#include <cstdint>

#include <sbgc/exchange.hpp>
#include <sbgc/messages/adjustable_variables.hpp>

namespace sbgc::msg {

struct AdjVarsState;
struct ReadAdjVarsCfg;
struct SetAdjVarsVal;

constexpr Exchange exchange_of(const SetAdjVarsVal&) noexcept {
  return {.replies = {.command = 31,
              .confirmed = Confirmed::always},
      .confirmations = 1,
      .retry_is_safe = true,
      .timeout_ms = 500};
}

constexpr Exchange exchange_of(const GetAdjVarsVal&) noexcept {
  return {.replies = {.command = 64,
              .answer_count = 1,
              .answers = {{{.id = 31,
               .min_size = 1,
               .max_size = max_body_size,
               .size = 201}}}},
      .answer_required = true,
      .retry_is_safe = true,
      .timeout_ms = 500};
}

constexpr Exchange exchange_of(const ReadAdjVarsCfgRequest&) noexcept {
  return {.replies = {.command = 43,
              .answer_count = 1,
              .answers = {{{.id = 43,
               .min_size = 128,
               .max_size = max_body_size,
               .size = 128}}}},
      .answer_required = true,
      .retry_is_safe = true,
      .timeout_ms = 500};
}

constexpr Exchange exchange_of(const WriteAdjVarsCfg&) noexcept {
  return {.replies = {.command = 44,
              .confirmed = Confirmed::always},
      .confirmations = 1,
      .retry_is_safe = true,
      .timeout_ms = 2000};
}

constexpr Exchange exchange_of(const AdjVarsStateRequest&) noexcept {
  return {.replies = {.command = 46,
              .answer_count = 1,
              .answers = {{{.id = 46,
               .min_size = 15,
               .max_size = max_body_size,
               .size = 15}}}},
      .answer_required = true,
      .retry_is_safe = true,
      .timeout_ms = 500};
}

constexpr Exchange exchange_of(const AdjVarsStateRequestExt&) noexcept {
  return {.replies = {.command = 46,
              .answer_count = 1,
              .answers = {{{.id = 46,
               .min_size = 15,
               .max_size = max_body_size,
               .size = 15}}}},
      .answer_required = true,
      .retry_is_safe = true,
      .timeout_ms = 500};
}

}  // namespace sbgc::msg
