// Generated from spec/ by generator/: edit those, then run ./dev generate.

/// calibration: what comes back for each request.
#pragma once

#include <cstdint>

#include <sbgc/exchange.hpp>
#include <sbgc/messages/calibration.hpp>

namespace sbgc::msg {

struct CalibInfo;

constexpr Exchange exchange_of(const CalibAcc&) noexcept {
  return {.replies = {.command = 65,
              .confirmed = Confirmed::always},
      .confirmations = 2,
      .timeout_ms = 500,
      .finish_ms = 30000};
}

constexpr Exchange exchange_of(const CalibAccExt& request) noexcept {
  if (request.action == CalibAction::reset || request.action == CalibAction::enable_temperature || request.action == CalibAction::disable_temperature) {
    return {.replies = {.command = 65,
              .confirmed = Confirmed::always},
      .confirmations = 1,
      .restarts_board = true,
      .timeout_ms = 500};
  }
  if (request.action == CalibAction::temperature) {
    return {.replies = {.command = 65,
              .confirmed = Confirmed::always},
      .confirmations = 2,
      .timeout_ms = 500,
      .finish_ms = 3600000};
  }
  return {.replies = {.command = 65,
              .confirmed = Confirmed::always},
      .confirmations = 2,
      .timeout_ms = 500,
      .finish_ms = 30000};
}

constexpr Exchange exchange_of(const CalibGyro&) noexcept {
  return {.replies = {.command = 103,
              .confirmed = Confirmed::always},
      .confirmations = 2,
      .timeout_ms = 500,
      .finish_ms = 30000};
}

constexpr Exchange exchange_of(const CalibGyroExt& request) noexcept {
  if (request.action == CalibAction::reset || request.action == CalibAction::enable_temperature || request.action == CalibAction::disable_temperature) {
    return {.replies = {.command = 103,
              .confirmed = Confirmed::always},
      .confirmations = 1,
      .restarts_board = true,
      .timeout_ms = 500};
  }
  if (request.action == CalibAction::temperature) {
    return {.replies = {.command = 103,
              .confirmed = Confirmed::always},
      .confirmations = 2,
      .timeout_ms = 500,
      .finish_ms = 3600000};
  }
  return {.replies = {.command = 103,
              .confirmed = Confirmed::always},
      .confirmations = 2,
      .timeout_ms = 500,
      .finish_ms = 30000};
}

constexpr Exchange exchange_of(const CalibMag&) noexcept {
  return {.replies = {.command = 59,
              .confirmed = Confirmed::possible},
      .confirmations = 1,
      .timeout_ms = 500};
}

constexpr Exchange exchange_of(const CalibExtGain&) noexcept {
  return {.replies = {.command = 71,
              .confirmed = Confirmed::always},
      .confirmations = 1,
      .timeout_ms = 30000};
}

constexpr Exchange exchange_of(const CalibPoles&) noexcept {
  return {.replies = {.command = 80,
              .confirmed = Confirmed::always},
      .confirmations = 1,
      .timeout_ms = 30000};
}

constexpr Exchange exchange_of(const CalibOffset&) noexcept {
  return {.replies = {.command = 79,
              .confirmed = Confirmed::possible},
      .confirmations = 1,
      .timeout_ms = 500};
}

constexpr Exchange exchange_of(const CalibBat&) noexcept {
  return {.replies = {.command = 66,
              .confirmed = Confirmed::possible},
      .confirmations = 1,
      .timeout_ms = 500};
}

constexpr Exchange exchange_of(const CalibInfoRequest& request) noexcept {
  return {.replies = {.command = 49,
              .answer_count = 1,
              .answers = {{{.id = 49,
               .min_size = 33,
               .max_size = max_body_size,
               .size = 33,
               .echoes = {{{1, 1, static_cast<std::uint32_t>(static_cast<std::uint8_t>(request.imu_type))}}}}}}},
      .answer_required = true,
      .retry_is_safe = true,
      .timeout_ms = 500};
}

constexpr Exchange exchange_of(const CalibMotorMagLinkRequest&) noexcept {
  return {.replies = {.command = 74,
              .confirmed = Confirmed::possible},
      .confirmations = 1,
      .timeout_ms = 500};
}

constexpr Exchange exchange_of(const EncodersCalibOffset4&) noexcept {
  return {.replies = {.command = 26,
              .confirmed = Confirmed::possible},
      .confirmations = 1,
      .timeout_ms = 500};
}

constexpr Exchange exchange_of(const EncodersCalibFldOffset4&) noexcept {
  return {.replies = {.command = 27,
              .confirmed = Confirmed::possible},
      .confirmations = 1,
      .timeout_ms = 500};
}

constexpr Exchange exchange_of(const AutoPidRequest&) noexcept {
  return {.replies = {.command = 35,
              .confirmed = Confirmed::possible},
      .confirmations = 1,
      .timeout_ms = 500};
}

}  // namespace sbgc::msg
