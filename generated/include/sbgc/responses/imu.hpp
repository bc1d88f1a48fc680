// Generated from spec/ by generator/: edit those, then run ./dev generate.

/// Response policies of the requests in <sbgc/messages/imu.hpp>.
#pragma once

#include <cstdint>

#include <sbgc/response_policy.hpp>
#include <sbgc/messages/imu.hpp>

namespace sbgc::msg {

constexpr ResponsePolicy response_policy(const SelectImu3&) noexcept {
  return {.responses = {.command = 24,
              .confirmed = Confirmed::possible},
      .confirmations = 1,
      .retry_is_safe = true,
      .has_effect = true,
      .timeout_ms = 500};
}

constexpr ResponsePolicy response_policy(const SelectImu3Ext&) noexcept {
  return {.responses = {.command = 24,
              .confirmed = Confirmed::possible},
      .confirmations = 1,
      .retry_is_safe = true,
      .has_effect = true,
      .timeout_ms = 500};
}

constexpr ResponsePolicy response_policy(const SelectImu3CalibrateShort& request) noexcept {
  if (request.action == CalibAction::reset || request.action == CalibAction::enable_temperature || request.action == CalibAction::disable_temperature) {
    return {.responses = {.command = 24,
              .confirmed = Confirmed::possible},
      .confirmations = 1,
      .restarts_board = true,
      .has_effect = true,
      .moves = request.action == CalibAction::reset ||
          request.action == CalibAction::enable_temperature ||
          request.action == CalibAction::disable_temperature,
      .timeout_ms = 500};
  }
  if (request.action == CalibAction::temperature) {
    return {.responses = {.command = 24,
              .confirmed = Confirmed::possible},
      .confirmations = 2,
      .has_effect = true,
      .moves = request.action == CalibAction::reset ||
          request.action == CalibAction::enable_temperature ||
          request.action == CalibAction::disable_temperature,
      .timeout_ms = 500,
      .finish_ms = 3600000};
  }
  return {.responses = {.command = 24,
              .confirmed = Confirmed::possible},
      .confirmations = 2,
      .has_effect = true,
      .moves = request.action == CalibAction::reset ||
          request.action == CalibAction::enable_temperature ||
          request.action == CalibAction::disable_temperature,
      .timeout_ms = 500,
      .finish_ms = 30000};
}

constexpr ResponsePolicy response_policy(const SelectImu3Calibrate& request) noexcept {
  if (request.action == CalibAction::reset || request.action == CalibAction::enable_temperature || request.action == CalibAction::disable_temperature) {
    return {.responses = {.command = 24,
              .confirmed = Confirmed::possible},
      .confirmations = 1,
      .restarts_board = true,
      .has_effect = true,
      .moves = request.action == CalibAction::reset ||
          request.action == CalibAction::enable_temperature ||
          request.action == CalibAction::disable_temperature,
      .timeout_ms = 500};
  }
  if (request.action == CalibAction::temperature) {
    return {.responses = {.command = 24,
              .confirmed = Confirmed::possible},
      .confirmations = 2,
      .has_effect = true,
      .moves = request.action == CalibAction::reset ||
          request.action == CalibAction::enable_temperature ||
          request.action == CalibAction::disable_temperature,
      .timeout_ms = 500,
      .finish_ms = 3600000};
  }
  return {.responses = {.command = 24,
              .confirmed = Confirmed::possible},
      .confirmations = 2,
      .has_effect = true,
      .moves = request.action == CalibAction::reset ||
          request.action == CalibAction::enable_temperature ||
          request.action == CalibAction::disable_temperature,
      .timeout_ms = 500,
      .finish_ms = 30000};
}

constexpr ResponsePolicy response_policy(const AhrsHelperRequest&) noexcept {
  return {.responses = {.command = 56,
              .form_count = 1,
              .forms = {{{.id = 56,
               .min_size = 24,
               .max_size = max_body_size,
               .size = 24}}}},
      .response_required = true,
      .retry_is_safe = true,
      .timeout_ms = 500};
}

constexpr ResponsePolicy response_policy(const AhrsHelperRequestWide&) noexcept {
  return {.responses = {.command = 56,
              .form_count = 1,
              .forms = {{{.id = 56,
               .min_size = 24,
               .max_size = max_body_size,
               .size = 24}}}},
      .response_required = true,
      .retry_is_safe = true,
      .timeout_ms = 500};
}

constexpr ResponsePolicy response_policy(const AhrsHelperRequestExt& request) noexcept {
  if (request.mode.has(AhrsHelperModeBit::set)) {
    return {.responses = {.command = 56,
              .confirmed = Confirmed::unlikely},
      .confirmations = 1,
      .retry_is_safe = true,
      .has_effect = request.mode.has(AhrsHelperModeBit::set),
      .moves = request.mode.has(AhrsHelperModeBit::set),
      .timeout_ms = 500};
  }
  return {.responses = {.command = 56,
              .form_count = 1,
              .forms = {{{.id = 56,
               .min_size = 24,
               .max_size = max_body_size,
               .size = 24}}}},
      .response_required = true,
      .retry_is_safe = true,
      .has_effect = request.mode.has(AhrsHelperModeBit::set),
      .moves = request.mode.has(AhrsHelperModeBit::set),
      .timeout_ms = 500};
}

constexpr ResponsePolicy response_policy(const AhrsHelperRequestExtWide& request) noexcept {
  if (request.mode.has(AhrsHelperWideModeBit::set)) {
    return {.responses = {.command = 56,
              .confirmed = Confirmed::unlikely},
      .confirmations = 1,
      .retry_is_safe = true,
      .has_effect = request.mode.has(AhrsHelperWideModeBit::set),
      .moves = request.mode.has(AhrsHelperWideModeBit::set),
      .timeout_ms = 500};
  }
  return {.responses = {.command = 56,
              .form_count = 1,
              .forms = {{{.id = 56,
               .min_size = 24,
               .max_size = max_body_size,
               .size = 24}}}},
      .response_required = true,
      .retry_is_safe = true,
      .has_effect = request.mode.has(AhrsHelperWideModeBit::set),
      .moves = request.mode.has(AhrsHelperWideModeBit::set),
      .timeout_ms = 500};
}

constexpr ResponsePolicy response_policy(const GyroCorrection&) noexcept {
  return {.responses = {.command = 75,
              .confirmed = Confirmed::possible},
      .confirmations = 1,
      .has_effect = true,
      .moves = true,
      .timeout_ms = 500};
}

constexpr ResponsePolicy response_policy(const ExtImuDebugInfoRequest&) noexcept {
  return {.responses = {.command = 106,
              .form_count = 1,
              .forms = {{{.id = 106,
               .min_size = 74,
               .max_size = max_body_size,
               .size = 74}}}},
      .response_required = true,
      .retry_is_safe = true,
      .timeout_ms = 500};
}

constexpr ResponsePolicy response_policy(const ExtImuCmd&) noexcept {
  return {.responses = {.command = 110,
              .confirmed = Confirmed::possible},
      .confirmations = 1,
      .has_effect = true,
      .moves = true,
      .timeout_ms = 500};
}

constexpr ResponsePolicy response_policy(const ExtSensCmdRequest& request) noexcept {
  return {.responses = {.command = 150,
              .confirmed = Confirmed::possible},
      .confirmations = 1,
      .has_effect = !(request.cmd_id == ExtSensCommand::get_device_info || request.cmd_id == ExtSensCommand::get_data || request.cmd_id == ExtSensCommand::get_user_conf_log),
      .moves = !(request.cmd_id == ExtSensCommand::get_device_info ||
          request.cmd_id == ExtSensCommand::get_data ||
          request.cmd_id == ExtSensCommand::get_user_conf_log),
      .timeout_ms = 500};
}

constexpr ResponsePolicy response_policy(const ImuAdvancedCalibRequest&) noexcept {
  return {.responses = {.command = 115,
              .confirmed = Confirmed::possible},
      .confirmations = 1,
      .has_effect = true,
      .timeout_ms = 500};
}

}  // namespace sbgc::msg
