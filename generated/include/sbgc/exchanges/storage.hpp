// Generated from spec/ by generator/: edit those, then run ./dev generate.

/// storage: what comes back for each request.
#pragma once

#include <cstdint>

#include <sbgc/exchange.hpp>
#include <sbgc/messages/storage.hpp>

namespace sbgc::msg {

struct EepromRead;
struct ReadExternalData;
struct ReadFile;
struct ReadFileError;

constexpr Exchange exchange_of(const EepromWrite& request) noexcept {
  return {.replies = {.command = 47,
              .confirmed = Confirmed::always,
              .confirmation = {1, 4, static_cast<std::uint32_t>(request.addr)}},
      .confirmations = 1,
      .retry_is_safe = true,
      .timeout_ms = 500};
}

constexpr Exchange exchange_of(const ReadFileRequest& request) noexcept {
  return {.replies = {.command = 53,
              .answer_count = 2,
              .answers = {{{.id = 53,
               .min_size = 4,
               .max_size = max_body_size,
               .size = 255,
               .echoes = {{{2, 2, static_cast<std::uint32_t>(request.page_offset.raw())}}}},
                           {.id = 53,
               .min_size = 1,
               .max_size = 1,
               .size = 1,
               .is_error = true}}}},
      .answer_required = true,
      .retry_is_safe = true,
      .timeout_ms = 500};
}

constexpr Exchange exchange_of(const WriteFile&) noexcept {
  return {.replies = {.command = 54,
              .confirmed = Confirmed::always},
      .confirmations = 1,
      .retry_is_safe = true,
      .timeout_ms = 2000,
      .result = {1, 1, 0}};
}

constexpr Exchange exchange_of(const FsClearAll&) noexcept {
  return {.replies = {.command = 55,
              .confirmed = Confirmed::always},
      .confirmations = 1,
      .retry_is_safe = true,
      .timeout_ms = 2000,
      .result = {1, 1, 0}};
}

constexpr Exchange exchange_of(const EepromReadRequest& request) noexcept {
  return {.replies = {.command = 48,
              .answer_count = 1,
              .answers = {{{.id = 48,
               .min_size = 4,
               .max_size = max_body_size,
               .size = 196,
               .echoes = {{{0, 4, static_cast<std::uint32_t>(request.addr)}}}}}}},
      .answer_required = true,
      .retry_is_safe = true,
      .timeout_ms = 500};
}

constexpr Exchange exchange_of(const ReadExternalDataRequest&) noexcept {
  return {.replies = {.command = 42,
              .answer_count = 1,
              .answers = {{{.id = 42,
               .min_size = 128,
               .max_size = max_body_size,
               .size = 128}}}},
      .answer_required = true,
      .retry_is_safe = true,
      .timeout_ms = 500};
}

constexpr Exchange exchange_of(const WriteExternalData&) noexcept {
  return {.replies = {.command = 41,
              .confirmed = Confirmed::possible},
      .confirmations = 1,
      .retry_is_safe = true,
      .timeout_ms = 2000};
}

}  // namespace sbgc::msg
