// Generated from spec/ by generator/: edit those, then run ./dev generate.

/// Response policies of the requests in <sbgc/messages/realtime.hpp>.
#pragma once

#include <cstdint>
#include <span>

#include <sbgc/response_policy.hpp>
#include <sbgc/messages/realtime.hpp>

namespace sbgc::msg {

/// Returns the stream change that the request makes.
constexpr StreamChange stream_change(const DataStreamInterval& request) noexcept {
  StreamChange change;
  change.command = static_cast<std::uint8_t>(request.cmd_id);
  const std::uint32_t interval = request.interval_ms.raw();
  change.interval_us = interval == 0     ? 0
                       : interval == 1 ? 800
                                       : interval * 1000;
  std::uint8_t body[21]{};
  if (encode(request, body)) {
    for (std::size_t i = 0; i < 8; ++i) change.config[i] = body[3 + i];
  }
  switch (change.command) {
    case 23: change.size = 63; break;
    case 25: change.size = 124; break;
    case 88: change.size = static_cast<std::uint8_t>(2 +
              (request.config.flags && request.config.flags->has(RealtimeDataCustomFlag::imu_angles) ? 6 : 0) +
              (request.config.flags && request.config.flags->has(RealtimeDataCustomFlag::target_angles) ? 6 : 0) +
              (request.config.flags && request.config.flags->has(RealtimeDataCustomFlag::target_speed) ? 6 : 0) +
              (request.config.flags && request.config.flags->has(RealtimeDataCustomFlag::stator_rotor_angle) ? 6 : 0) +
              (request.config.flags && request.config.flags->has(RealtimeDataCustomFlag::gyro_data) ? 6 : 0) +
              (request.config.flags && request.config.flags->has(RealtimeDataCustomFlag::rc_data) ? 12 : 0) +
              (request.config.flags && request.config.flags->has(RealtimeDataCustomFlag::z1_h1_vectors) ? 12 : 0) +
              (request.config.flags && request.config.flags->has(RealtimeDataCustomFlag::z1_h1_vectors) ? 12 : 0) +
              (request.config.flags && request.config.flags->has(RealtimeDataCustomFlag::rc_channels) ? 36 : 0) +
              (request.config.flags && request.config.flags->has(RealtimeDataCustomFlag::acc_data) ? 6 : 0)); break;
    case 56: change.size = 24; break;
    default: change.size = max_body_size; break;
  }
  return change;
}

constexpr ResponsePolicy response_policy(const RealtimeData&) noexcept {
  return {.responses = {.command = 68,
              .form_count = 1,
              .forms = {{{.id = 23,
               .min_size = 63,
               .max_size = max_body_size,
               .size = 63}}}},
      .response_required = true,
      .retry_is_safe = true,
      .timeout_ms = 500};
}

constexpr ResponsePolicy response_policy(const RealtimeData3Request&) noexcept {
  return {.responses = {.command = 23,
              .form_count = 1,
              .forms = {{{.id = 23,
               .min_size = 63,
               .max_size = max_body_size,
               .size = 63}}}},
      .response_required = true,
      .retry_is_safe = true,
      .timeout_ms = 500};
}

constexpr ResponsePolicy response_policy(const RealtimeData4Request&) noexcept {
  return {.responses = {.command = 25,
              .form_count = 1,
              .forms = {{{.id = 25,
               .min_size = 124,
               .max_size = max_body_size,
               .size = 124}}}},
      .response_required = true,
      .retry_is_safe = true,
      .timeout_ms = 500};
}

constexpr ResponsePolicy response_policy(const RealtimeDataCustomRequest& request) noexcept {
  return {.responses = {.command = 88,
              .form_count = 1,
              .forms = {{{.id = 88,
               .min_size = static_cast<std::uint8_t>(2 +
              (request.flags.has(RealtimeDataCustomFlag::imu_angles) ? 6 : 0) +
              (request.flags.has(RealtimeDataCustomFlag::target_angles) ? 6 : 0) +
              (request.flags.has(RealtimeDataCustomFlag::target_speed) ? 6 : 0) +
              (request.flags.has(RealtimeDataCustomFlag::stator_rotor_angle) ? 6 : 0) +
              (request.flags.has(RealtimeDataCustomFlag::gyro_data) ? 6 : 0) +
              (request.flags.has(RealtimeDataCustomFlag::rc_data) ? 12 : 0) +
              (request.flags.has(RealtimeDataCustomFlag::z1_h1_vectors) ? 12 : 0) +
              (request.flags.has(RealtimeDataCustomFlag::z1_h1_vectors) ? 12 : 0) +
              (request.flags.has(RealtimeDataCustomFlag::rc_channels) ? 36 : 0) +
              (request.flags.has(RealtimeDataCustomFlag::acc_data) ? 6 : 0)),
               .max_size = max_body_size,
               .size = static_cast<std::uint8_t>(2 +
              (request.flags.has(RealtimeDataCustomFlag::imu_angles) ? 6 : 0) +
              (request.flags.has(RealtimeDataCustomFlag::target_angles) ? 6 : 0) +
              (request.flags.has(RealtimeDataCustomFlag::target_speed) ? 6 : 0) +
              (request.flags.has(RealtimeDataCustomFlag::stator_rotor_angle) ? 6 : 0) +
              (request.flags.has(RealtimeDataCustomFlag::gyro_data) ? 6 : 0) +
              (request.flags.has(RealtimeDataCustomFlag::rc_data) ? 12 : 0) +
              (request.flags.has(RealtimeDataCustomFlag::z1_h1_vectors) ? 12 : 0) +
              (request.flags.has(RealtimeDataCustomFlag::z1_h1_vectors) ? 12 : 0) +
              (request.flags.has(RealtimeDataCustomFlag::rc_channels) ? 36 : 0) +
              (request.flags.has(RealtimeDataCustomFlag::acc_data) ? 6 : 0))}}}},
      .response_required = true,
      .retry_is_safe = true,
      .timeout_ms = 500};
}

constexpr ResponsePolicy response_policy(const DataStreamInterval& request) noexcept {
  return {.responses = {.command = 85,
              .confirmed = Confirmed::always},
      .confirmations = 1,
      .retry_is_safe = true,
      .timeout_ms = 500,
      .stream = stream_change(request)};
}

}  // namespace sbgc::msg
