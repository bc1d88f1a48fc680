// Generated from spec/ by generator/: edit those, then run ./dev generate.

/// Response policies of the requests in <sbgc/messages/calibration.hpp>.
#pragma once

#include <cstdint>

#include <sbgc/response_policy.hpp>
#include <sbgc/messages/calibration.hpp>

namespace sbgc::msg {

constexpr ResponsePolicy response_policy(const CalibAcc&) noexcept {
  return {.responses = {.command = 65,
              .confirmed = Confirmed::always},
      .confirmations = 2,
      .has_effect = true,
      .timeout_ms = 500,
      .finish_ms = 30000};
}

constexpr ResponsePolicy response_policy(const CalibAccExt& request) noexcept {
  if (request.action == CalibAction::reset || request.action == CalibAction::enable_temperature || request.action == CalibAction::disable_temperature) {
    return {.responses = {.command = 65,
              .confirmed = Confirmed::always},
      .confirmations = 1,
      .restarts_board = true,
      .has_effect = true,
      .moves = request.action == CalibAction::reset ||
          request.action == CalibAction::enable_temperature ||
          request.action == CalibAction::disable_temperature,
      .timeout_ms = 500};
  }
  if (request.action == CalibAction::temperature) {
    return {.responses = {.command = 65,
              .confirmed = Confirmed::always},
      .confirmations = 2,
      .has_effect = true,
      .moves = request.action == CalibAction::reset ||
          request.action == CalibAction::enable_temperature ||
          request.action == CalibAction::disable_temperature,
      .timeout_ms = 500,
      .finish_ms = 3600000};
  }
  return {.responses = {.command = 65,
              .confirmed = Confirmed::always},
      .confirmations = 2,
      .has_effect = true,
      .moves = request.action == CalibAction::reset ||
          request.action == CalibAction::enable_temperature ||
          request.action == CalibAction::disable_temperature,
      .timeout_ms = 500,
      .finish_ms = 30000};
}

constexpr ResponsePolicy response_policy(const CalibGyro&) noexcept {
  return {.responses = {.command = 103,
              .confirmed = Confirmed::always},
      .confirmations = 2,
      .has_effect = true,
      .timeout_ms = 500,
      .finish_ms = 30000};
}

constexpr ResponsePolicy response_policy(const CalibGyroExt& request) noexcept {
  if (request.action == CalibAction::reset || request.action == CalibAction::enable_temperature || request.action == CalibAction::disable_temperature) {
    return {.responses = {.command = 103,
              .confirmed = Confirmed::always},
      .confirmations = 1,
      .restarts_board = true,
      .has_effect = true,
      .moves = request.action == CalibAction::reset ||
          request.action == CalibAction::enable_temperature ||
          request.action == CalibAction::disable_temperature,
      .timeout_ms = 500};
  }
  if (request.action == CalibAction::temperature) {
    return {.responses = {.command = 103,
              .confirmed = Confirmed::always},
      .confirmations = 2,
      .has_effect = true,
      .moves = request.action == CalibAction::reset ||
          request.action == CalibAction::enable_temperature ||
          request.action == CalibAction::disable_temperature,
      .timeout_ms = 500,
      .finish_ms = 3600000};
  }
  return {.responses = {.command = 103,
              .confirmed = Confirmed::always},
      .confirmations = 2,
      .has_effect = true,
      .moves = request.action == CalibAction::reset ||
          request.action == CalibAction::enable_temperature ||
          request.action == CalibAction::disable_temperature,
      .timeout_ms = 500,
      .finish_ms = 30000};
}

constexpr ResponsePolicy response_policy(const CalibMag&) noexcept {
  return {.responses = {.command = 59,
              .confirmed = Confirmed::possible},
      .confirmations = 1,
      .has_effect = true,
      .timeout_ms = 500};
}

constexpr ResponsePolicy response_policy(const CalibMagExt& request) noexcept {
  if (request.action == CalibAction::reset || request.action == CalibAction::enable_temperature || request.action == CalibAction::disable_temperature) {
    return {.responses = {.command = 59,
              .confirmed = Confirmed::possible},
      .confirmations = 1,
      .restarts_board = true,
      .has_effect = true,
      .moves = request.action == CalibAction::reset ||
          request.action == CalibAction::enable_temperature ||
          request.action == CalibAction::disable_temperature,
      .timeout_ms = 500};
  }
  return {.responses = {.command = 59,
              .confirmed = Confirmed::possible},
      .confirmations = 1,
      .has_effect = true,
      .moves = request.action == CalibAction::reset ||
          request.action == CalibAction::enable_temperature ||
          request.action == CalibAction::disable_temperature,
      .timeout_ms = 500};
}

constexpr ResponsePolicy response_policy(const CalibExtGain&) noexcept {
  return {.responses = {.command = 71,
              .confirmed = Confirmed::always},
      .confirmations = 1,
      .has_effect = true,
      .moves = true,
      .timeout_ms = 30000};
}

constexpr ResponsePolicy response_policy(const CalibPoles&) noexcept {
  return {.responses = {.command = 80,
              .confirmed = Confirmed::always},
      .confirmations = 1,
      .has_effect = true,
      .moves = true,
      .timeout_ms = 30000};
}

constexpr ResponsePolicy response_policy(const CalibOffset&) noexcept {
  return {.responses = {.command = 79,
              .confirmed = Confirmed::possible},
      .confirmations = 1,
      .has_effect = true,
      .moves = true,
      .timeout_ms = 500};
}

constexpr ResponsePolicy response_policy(const CalibBat&) noexcept {
  return {.responses = {.command = 66,
              .confirmed = Confirmed::possible},
      .confirmations = 1,
      .has_effect = true,
      .timeout_ms = 500};
}

constexpr ResponsePolicy response_policy(const CalibInfoRequest& request) noexcept {
  return {.responses = {.command = 49,
              .form_count = 1,
              .forms = {{{.id = 49,
               .min_size = 33,
               .max_size = max_body_size,
               .size = 33,
               .correlation = {{{.offset = 1, .size = 1, .value = static_cast<std::uint32_t>(static_cast<std::uint8_t>(request.imu_type))}}}}}}},
      .response_required = true,
      .retry_is_safe = true,
      .timeout_ms = 500};
}

constexpr ResponsePolicy response_policy(const CalibMotorMagLinkRequest&) noexcept {
  return {.responses = {.command = 74,
              .confirmed = Confirmed::possible},
      .confirmations = 1,
      .has_effect = true,
      .timeout_ms = 500};
}

constexpr ResponsePolicy response_policy(const EncodersCalibOffset4&) noexcept {
  return {.responses = {.command = 26,
              .confirmed = Confirmed::possible},
      .confirmations = 1,
      .has_effect = true,
      .timeout_ms = 500};
}

constexpr ResponsePolicy response_policy(const EncodersCalibFldOffset4&) noexcept {
  return {.responses = {.command = 27,
              .confirmed = Confirmed::possible},
      .confirmations = 1,
      .has_effect = true,
      .moves = true,
      .timeout_ms = 500};
}

constexpr ResponsePolicy response_policy(const AutoPidRequest&) noexcept {
  return {.responses = {.command = 35,
              .confirmed = Confirmed::possible},
      .confirmations = 1,
      .has_effect = true,
      .moves = true,
      .timeout_ms = 500};
}

constexpr ResponsePolicy response_policy(const AutoPid2& request) noexcept {
  return {.responses = {.command = 108,
              .confirmed = Confirmed::always},
      .confirmations = 1,
      .has_effect = !(request.action == AutoPid2Action::read),
      .moves = !(request.action == AutoPid2Action::save ||
          request.action == AutoPid2Action::read),
      .timeout_ms = 2000};
}

constexpr ResponsePolicy response_policy(const CalibOrientCorr&) noexcept {
  return {.responses = {.command = 91,
              .confirmed = Confirmed::always},
      .confirmations = 1,
      .has_effect = true,
      .moves = true,
      .timeout_ms = 30000};
}

constexpr ResponsePolicy response_policy(const CalibCogging& request) noexcept {
  return {.responses = {.command = 93,
              .confirmed = Confirmed::always},
      .confirmations = 1,
      .has_effect = true,
      .moves = !(request.action == CoggingAction::erase),
      .timeout_ms = 30000};
}

constexpr ResponsePolicy response_policy(const CalibAccExtRef&) noexcept {
  return {.responses = {.command = 94,
              .confirmed = Confirmed::always},
      .confirmations = 1,
      .has_effect = true,
      .timeout_ms = 30000};
}

constexpr ResponsePolicy response_policy(const BodeTestStartStopRequest&) noexcept {
  return {.responses = {.command = 37,
              .confirmed = Confirmed::possible,
              .form_count = 1,
              .forms = {{{.id = 37,
               .min_size = 22,
               .max_size = max_body_size,
               .size = 22}}}},
      .confirmations = 1,
      .response_required = true,
      .has_effect = true,
      .moves = true,
      .series = 38,
      .timeout_ms = 2000,
      .finish_ms = 3600000};
}

constexpr ResponsePolicy response_policy(const CoggingCalibInfoRequest&) noexcept {
  return {.responses = {.command = 92,
              .confirmed = Confirmed::possible},
      .confirmations = 1,
      .has_effect = true,
      .timeout_ms = 500};
}

constexpr ResponsePolicy response_policy(const CanDrvHardParamsRequest&) noexcept {
  return {.responses = {.command = 97,
              .confirmed = Confirmed::possible},
      .confirmations = 1,
      .has_effect = true,
      .timeout_ms = 500};
}

constexpr ResponsePolicy response_policy(const CanDrvCalibrateRequest&) noexcept {
  return {.responses = {.command = 99,
              .confirmed = Confirmed::possible},
      .confirmations = 1,
      .has_effect = true,
      .timeout_ms = 500};
}

constexpr ResponsePolicy response_policy(const CalibEncoderLutRequest&) noexcept {
  return {.responses = {.command = 117,
              .confirmed = Confirmed::possible},
      .confirmations = 1,
      .has_effect = true,
      .timeout_ms = 500};
}

constexpr ResponsePolicy response_policy(const CalibEncoderLutResRequest&) noexcept {
  return {.responses = {.command = 118,
              .confirmed = Confirmed::possible},
      .confirmations = 1,
      .has_effect = true,
      .timeout_ms = 500};
}

constexpr ResponsePolicy response_policy(const CalibCurSensRequest&) noexcept {
  return {.responses = {.command = 120,
              .confirmed = Confirmed::possible},
      .confirmations = 1,
      .has_effect = true,
      .timeout_ms = 500};
}

constexpr ResponsePolicy response_policy(const EncIntCalibRequest&) noexcept {
  return {.responses = {.command = 122,
              .confirmed = Confirmed::possible},
      .confirmations = 1,
      .has_effect = true,
      .timeout_ms = 500};
}

constexpr ResponsePolicy response_policy(const VibrationTestStartStopRequest&) noexcept {
  return {.responses = {.command = 125,
              .confirmed = Confirmed::possible},
      .confirmations = 1,
      .has_effect = true,
      .timeout_ms = 500};
}

constexpr ResponsePolicy response_policy(const VibrationTestDataRequest&) noexcept {
  return {.responses = {.command = 126,
              .confirmed = Confirmed::possible},
      .confirmations = 1,
      .has_effect = true,
      .timeout_ms = 500};
}

}  // namespace sbgc::msg
