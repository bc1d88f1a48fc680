// Generated from spec/ by generator/: edit those, then run ./dev generate.

/// parameters: what comes back for each request.
#pragma once

#include <cstdint>

#include <sbgc/exchange.hpp>
#include <sbgc/messages/parameters.hpp>

namespace sbgc::msg {

struct ReadParams3;
struct ReadParamsExt;
struct ReadParamsExt2;
struct ReadProfileNames;

constexpr Exchange exchange_of(const ReadParams3Request& request) noexcept {
  return {.replies = {.command = 21,
              .answer_count = 1,
              .answers = {{{.id = 21,
               .min_size = 134,
               .max_size = max_body_size,
               .size = 134,
               .echoes = {{{0, request.profile_id == 255 ? std::uint8_t{0} : std::uint8_t{1}, static_cast<std::uint32_t>(request.profile_id)}}}}}}},
      .answer_required = true,
      .retry_is_safe = true,
      .timeout_ms = 500};
}

constexpr Exchange exchange_of(const WriteParams3&) noexcept {
  return {.replies = {.command = 22,
              .confirmed = Confirmed::always},
      .confirmations = 1,
      .retry_is_safe = true,
      .timeout_ms = 2000};
}

constexpr Exchange exchange_of(const ReadParams& request) noexcept {
  return {.replies = {.command = 82,
              .answer_count = 1,
              .answers = {{{.id = 21,
               .min_size = 134,
               .max_size = max_body_size,
               .size = 134,
               .echoes = {{{0, request.profile_id == 255 ? std::uint8_t{0} : std::uint8_t{1}, static_cast<std::uint32_t>(request.profile_id)}}}}}}},
      .answer_required = true,
      .retry_is_safe = true,
      .timeout_ms = 500};
}

constexpr Exchange exchange_of(const WriteParams&) noexcept {
  return {.replies = {.command = 87,
              .confirmed = Confirmed::always},
      .confirmations = 1,
      .retry_is_safe = true,
      .timeout_ms = 2000};
}

constexpr Exchange exchange_of(const ReadParamsExtRequest& request) noexcept {
  return {.replies = {.command = 33,
              .answer_count = 1,
              .answers = {{{.id = 33,
               .min_size = 104,
               .max_size = max_body_size,
               .size = 104,
               .echoes = {{{0, request.profile_id == 255 ? std::uint8_t{0} : std::uint8_t{1}, static_cast<std::uint32_t>(request.profile_id)}}}}}}},
      .answer_required = true,
      .retry_is_safe = true,
      .timeout_ms = 500};
}

constexpr Exchange exchange_of(const WriteParamsExt&) noexcept {
  return {.replies = {.command = 34,
              .confirmed = Confirmed::always},
      .confirmations = 1,
      .retry_is_safe = true,
      .timeout_ms = 2000};
}

constexpr Exchange exchange_of(const ReadParamsExt2Request& request) noexcept {
  return {.replies = {.command = 62,
              .answer_count = 1,
              .answers = {{{.id = 62,
               .min_size = 151,
               .max_size = max_body_size,
               .size = 151,
               .echoes = {{{0, request.profile_id == 255 ? std::uint8_t{0} : std::uint8_t{1}, static_cast<std::uint32_t>(request.profile_id)}}}}}}},
      .answer_required = true,
      .retry_is_safe = true,
      .timeout_ms = 500};
}

constexpr Exchange exchange_of(const WriteParamsExt2&) noexcept {
  return {.replies = {.command = 63,
              .confirmed = Confirmed::always},
      .confirmations = 1,
      .retry_is_safe = true,
      .timeout_ms = 2000};
}

constexpr Exchange exchange_of(const ReadProfileNamesRequest&) noexcept {
  return {.replies = {.command = 28,
              .answer_count = 1,
              .answers = {{{.id = 28,
               .min_size = 240,
               .max_size = max_body_size,
               .size = 240}}}},
      .answer_required = true,
      .retry_is_safe = true,
      .timeout_ms = 500};
}

constexpr Exchange exchange_of(const WriteProfileNames&) noexcept {
  return {.replies = {.command = 29,
              .confirmed = Confirmed::possible},
      .confirmations = 1,
      .retry_is_safe = true,
      .timeout_ms = 2000};
}

constexpr Exchange exchange_of(const SaveParams3&) noexcept {
  return {.replies = {.command = 32,
              .confirmed = Confirmed::possible},
      .confirmations = 1,
      .retry_is_safe = true,
      .timeout_ms = 2000};
}

constexpr Exchange exchange_of(const UseDefaults&) noexcept {
  return {.replies = {.command = 70,
              .confirmed = Confirmed::possible},
      .confirmations = 1,
      .timeout_ms = 5000};
}

}  // namespace sbgc::msg
