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
              (request.config.flags && request.config.flags->has(RealtimeDataCustomFlag::include_flags) ? 4 : 0) +
              (request.config.flags && request.config.flags->has(RealtimeDataCustomFlag::imu_angles) ? 6 : 0) +
              (request.config.flags && request.config.flags->has(RealtimeDataCustomFlag::target_angles) ? 6 : 0) +
              (request.config.flags && request.config.flags->has(RealtimeDataCustomFlag::target_speed) ? 6 : 0) +
              (request.config.flags && request.config.flags->has(RealtimeDataCustomFlag::stator_rotor_angle) ? 6 : 0) +
              (request.config.flags && request.config.flags->has(RealtimeDataCustomFlag::gyro_data) ? 6 : 0) +
              (request.config.flags && request.config.flags->has(RealtimeDataCustomFlag::rc_data) ? 12 : 0) +
              (request.config.flags && request.config.flags->has(RealtimeDataCustomFlag::z1_h1_vectors) ? 12 : 0) +
              (request.config.flags && request.config.flags->has(RealtimeDataCustomFlag::z1_h1_vectors) ? 12 : 0) +
              (request.config.flags && request.config.flags->has(RealtimeDataCustomFlag::rc_channels) ? 36 : 0) +
              (request.config.flags && request.config.flags->has(RealtimeDataCustomFlag::acc_data) ? 6 : 0) +
              (request.config.flags && request.config.flags->has(RealtimeDataCustomFlag::motor4_control) ? 8 : 0) +
              (request.config.flags && request.config.flags->has(RealtimeDataCustomFlag::ahrs_debug_info) ? 26 : 0) +
              (request.config.flags && request.config.flags->has(RealtimeDataCustomFlag::encoder_raw24) ? 9 : 0) +
              (request.config.flags && request.config.flags->has(RealtimeDataCustomFlag::imu_angles_rad) ? 12 : 0) +
              (request.config.flags && request.config.flags->has(RealtimeDataCustomFlag::script_vars_float) ? 40 : 0) +
              (request.config.flags && request.config.flags->has(RealtimeDataCustomFlag::script_vars_int16) ? 20 : 0) +
              (request.config.flags && request.config.flags->has(RealtimeDataCustomFlag::system_power_state) ? 46 : 0) +
              (request.config.flags && request.config.flags->has(RealtimeDataCustomFlag::frame_cam_rate) ? 6 : 0) +
              (request.config.flags && request.config.flags->has(RealtimeDataCustomFlag::imu_angles_20) ? 12 : 0) +
              (request.config.flags && request.config.flags->has(RealtimeDataCustomFlag::target_angles_20) ? 12 : 0) +
              (request.config.flags && request.config.flags->has(RealtimeDataCustomFlag::comm_errors) ? 7 : 0) +
              (request.config.flags && request.config.flags->has(RealtimeDataCustomFlag::system_state) ? 13 : 0) +
              (request.config.flags && request.config.flags->has(RealtimeDataCustomFlag::imu_quat) ? 8 : 0) +
              (request.config.flags && request.config.flags->has(RealtimeDataCustomFlag::target_quat) ? 8 : 0) +
              (request.config.flags && request.config.flags->has(RealtimeDataCustomFlag::imu_to_frame_quat) ? 8 : 0) +
              (request.config.flags && request.config.flags->has(RealtimeDataCustomFlag::adc_ch_raw) ? 8 : 0) +
              (request.config.flags && request.config.flags->has(RealtimeDataCustomFlag::sw_limits_dist) ? 12 : 0) +
              (request.config.flags && request.config.flags->has(RealtimeDataCustomFlag::follow_dist) ? 6 : 0) +
              (request.config.flags && request.config.flags->has(RealtimeDataCustomFlag::ext_target_limit) ? 12 : 0) +
              (request.config.flags && request.config.flags->has(RealtimeDataCustomFlag::ext_target_limit) ? 12 : 0) +
              (request.config.flags && request.config.flags->has(RealtimeDataCustomFlag::frame_cam_angle_20) ? 12 : 0) +
              (request.config.flags && request.config.flags->has(RealtimeDataCustomFlag::main_imu_state) ? 11 : 0)); break;
    case 139: change.size = static_cast<std::uint8_t>(2 +
              (request.config.custom2_flags && request.config.custom2_flags->has(RealtimeDataCustom2Flag::include_flags) ? 4 : 0) +
              (request.config.custom2_flags && request.config.custom2_flags->has(RealtimeDataCustom2Flag::frame_imu_angles) ? 6 : 0) +
              (request.config.custom2_flags && request.config.custom2_flags->has(RealtimeDataCustom2Flag::frame_gyro) ? 6 : 0) +
              (request.config.custom2_flags && request.config.custom2_flags->has(RealtimeDataCustom2Flag::frame_acc) ? 6 : 0) +
              (request.config.custom2_flags && request.config.custom2_flags->has(RealtimeDataCustom2Flag::debug) ? 8 : 0) +
              (request.config.custom2_flags && request.config.custom2_flags->has(RealtimeDataCustom2Flag::mag_sens_data) ? 6 : 0) +
              (request.config.custom2_flags && request.config.custom2_flags->has(RealtimeDataCustom2Flag::pin_state) ? 8 : 0) +
              (request.config.custom2_flags && request.config.custom2_flags->has(RealtimeDataCustom2Flag::stab_err_ampl) ? 6 : 0)); break;
    case 56: change.size = 24; break;
    case 102: change.size = 4; break;
    case 127: change.size = static_cast<std::uint8_t>(3 +
              (request.config.telemetry_flags && request.config.telemetry_flags->has(CanDrvTelemetryFlag::can_bus_flags) ? 1 : 0) +
              (request.config.telemetry_flags && request.config.telemetry_flags->has(CanDrvTelemetryFlag::can_bus_err_cnt) ? 2 : 0) +
              (request.config.telemetry_flags && request.config.telemetry_flags->has(CanDrvTelemetryFlag::temp_board) ? 1 : 0) +
              (request.config.telemetry_flags && request.config.telemetry_flags->has(CanDrvTelemetryFlag::temp_motor) ? 1 : 0) +
              (request.config.telemetry_flags && request.config.telemetry_flags->has(CanDrvTelemetryFlag::avg_current) ? 2 : 0) +
              (request.config.telemetry_flags && request.config.telemetry_flags->has(CanDrvTelemetryFlag::bus_voltage) ? 2 : 0) +
              (request.config.telemetry_flags && request.config.telemetry_flags->has(CanDrvTelemetryFlag::pin_state) ? 1 : 0) +
              (request.config.telemetry_flags && request.config.telemetry_flags->has(CanDrvTelemetryFlag::phase_current) ? 6 : 0) +
              (request.config.telemetry_flags && request.config.telemetry_flags->has(CanDrvTelemetryFlag::encoder_error_cnt) ? 2 : 0) +
              (request.config.telemetry_flags && request.config.telemetry_flags->has(CanDrvTelemetryFlag::iq_id_current) ? 2 : 0) +
              (request.config.telemetry_flags && request.config.telemetry_flags->has(CanDrvTelemetryFlag::iq_id_current) ? 2 : 0) +
              (request.config.telemetry_flags && request.config.telemetry_flags->has(CanDrvTelemetryFlag::motor_speed) ? 2 : 0) +
              (request.config.telemetry_flags && request.config.telemetry_flags->has(CanDrvTelemetryFlag::pid_pos_err) ? 2 : 0) +
              (request.config.telemetry_flags && request.config.telemetry_flags->has(CanDrvTelemetryFlag::pid_speed_err) ? 2 : 0) +
              (request.config.telemetry_flags && request.config.telemetry_flags->has(CanDrvTelemetryFlag::iq_ref) ? 2 : 0) +
              (request.config.telemetry_flags && request.config.telemetry_flags->has(CanDrvTelemetryFlag::pid_current_err) ? 2 : 0)); break;
    case 131: change.size = 50; break;
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
      .timeout_ms = 500,
      .stream = {.command = 23, .size = 0, .interval_us = 0, .config = {}}};
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
      .timeout_ms = 500,
      .stream = {.command = 23, .size = 0, .interval_us = 0, .config = {}}};
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
      .timeout_ms = 500,
      .stream = {.command = 25, .size = 0, .interval_us = 0, .config = {}}};
}

constexpr ResponsePolicy response_policy(const RealtimeDataCustomRequest& request) noexcept {
  return {.responses = {.command = 88,
              .form_count = 1,
              .forms = {{{.id = 88,
               .min_size = static_cast<std::uint8_t>(2 +
              (request.flags.has(RealtimeDataCustomFlag::include_flags) ? 4 : 0) +
              (request.flags.has(RealtimeDataCustomFlag::imu_angles) ? 6 : 0) +
              (request.flags.has(RealtimeDataCustomFlag::target_angles) ? 6 : 0) +
              (request.flags.has(RealtimeDataCustomFlag::target_speed) ? 6 : 0) +
              (request.flags.has(RealtimeDataCustomFlag::stator_rotor_angle) ? 6 : 0) +
              (request.flags.has(RealtimeDataCustomFlag::gyro_data) ? 6 : 0) +
              (request.flags.has(RealtimeDataCustomFlag::rc_data) ? 12 : 0) +
              (request.flags.has(RealtimeDataCustomFlag::z1_h1_vectors) ? 12 : 0) +
              (request.flags.has(RealtimeDataCustomFlag::z1_h1_vectors) ? 12 : 0) +
              (request.flags.has(RealtimeDataCustomFlag::rc_channels) ? 36 : 0) +
              (request.flags.has(RealtimeDataCustomFlag::acc_data) ? 6 : 0) +
              (request.flags.has(RealtimeDataCustomFlag::motor4_control) ? 8 : 0) +
              (request.flags.has(RealtimeDataCustomFlag::ahrs_debug_info) ? 26 : 0) +
              (request.flags.has(RealtimeDataCustomFlag::encoder_raw24) ? 9 : 0) +
              (request.flags.has(RealtimeDataCustomFlag::imu_angles_rad) ? 12 : 0) +
              (request.flags.has(RealtimeDataCustomFlag::script_vars_float) ? 40 : 0) +
              (request.flags.has(RealtimeDataCustomFlag::script_vars_int16) ? 20 : 0) +
              (request.flags.has(RealtimeDataCustomFlag::system_power_state) ? 46 : 0) +
              (request.flags.has(RealtimeDataCustomFlag::frame_cam_rate) ? 6 : 0) +
              (request.flags.has(RealtimeDataCustomFlag::imu_angles_20) ? 12 : 0) +
              (request.flags.has(RealtimeDataCustomFlag::target_angles_20) ? 12 : 0) +
              (request.flags.has(RealtimeDataCustomFlag::comm_errors) ? 7 : 0) +
              (request.flags.has(RealtimeDataCustomFlag::system_state) ? 13 : 0) +
              (request.flags.has(RealtimeDataCustomFlag::imu_quat) ? 8 : 0) +
              (request.flags.has(RealtimeDataCustomFlag::target_quat) ? 8 : 0) +
              (request.flags.has(RealtimeDataCustomFlag::imu_to_frame_quat) ? 8 : 0) +
              (request.flags.has(RealtimeDataCustomFlag::adc_ch_raw) ? 8 : 0) +
              (request.flags.has(RealtimeDataCustomFlag::sw_limits_dist) ? 12 : 0) +
              (request.flags.has(RealtimeDataCustomFlag::follow_dist) ? 6 : 0) +
              (request.flags.has(RealtimeDataCustomFlag::ext_target_limit) ? 12 : 0) +
              (request.flags.has(RealtimeDataCustomFlag::ext_target_limit) ? 12 : 0) +
              (request.flags.has(RealtimeDataCustomFlag::frame_cam_angle_20) ? 12 : 0) +
              (request.flags.has(RealtimeDataCustomFlag::main_imu_state) ? 11 : 0)),
               .max_size = max_body_size,
               .size = static_cast<std::uint8_t>(2 +
              (request.flags.has(RealtimeDataCustomFlag::include_flags) ? 4 : 0) +
              (request.flags.has(RealtimeDataCustomFlag::imu_angles) ? 6 : 0) +
              (request.flags.has(RealtimeDataCustomFlag::target_angles) ? 6 : 0) +
              (request.flags.has(RealtimeDataCustomFlag::target_speed) ? 6 : 0) +
              (request.flags.has(RealtimeDataCustomFlag::stator_rotor_angle) ? 6 : 0) +
              (request.flags.has(RealtimeDataCustomFlag::gyro_data) ? 6 : 0) +
              (request.flags.has(RealtimeDataCustomFlag::rc_data) ? 12 : 0) +
              (request.flags.has(RealtimeDataCustomFlag::z1_h1_vectors) ? 12 : 0) +
              (request.flags.has(RealtimeDataCustomFlag::z1_h1_vectors) ? 12 : 0) +
              (request.flags.has(RealtimeDataCustomFlag::rc_channels) ? 36 : 0) +
              (request.flags.has(RealtimeDataCustomFlag::acc_data) ? 6 : 0) +
              (request.flags.has(RealtimeDataCustomFlag::motor4_control) ? 8 : 0) +
              (request.flags.has(RealtimeDataCustomFlag::ahrs_debug_info) ? 26 : 0) +
              (request.flags.has(RealtimeDataCustomFlag::encoder_raw24) ? 9 : 0) +
              (request.flags.has(RealtimeDataCustomFlag::imu_angles_rad) ? 12 : 0) +
              (request.flags.has(RealtimeDataCustomFlag::script_vars_float) ? 40 : 0) +
              (request.flags.has(RealtimeDataCustomFlag::script_vars_int16) ? 20 : 0) +
              (request.flags.has(RealtimeDataCustomFlag::system_power_state) ? 46 : 0) +
              (request.flags.has(RealtimeDataCustomFlag::frame_cam_rate) ? 6 : 0) +
              (request.flags.has(RealtimeDataCustomFlag::imu_angles_20) ? 12 : 0) +
              (request.flags.has(RealtimeDataCustomFlag::target_angles_20) ? 12 : 0) +
              (request.flags.has(RealtimeDataCustomFlag::comm_errors) ? 7 : 0) +
              (request.flags.has(RealtimeDataCustomFlag::system_state) ? 13 : 0) +
              (request.flags.has(RealtimeDataCustomFlag::imu_quat) ? 8 : 0) +
              (request.flags.has(RealtimeDataCustomFlag::target_quat) ? 8 : 0) +
              (request.flags.has(RealtimeDataCustomFlag::imu_to_frame_quat) ? 8 : 0) +
              (request.flags.has(RealtimeDataCustomFlag::adc_ch_raw) ? 8 : 0) +
              (request.flags.has(RealtimeDataCustomFlag::sw_limits_dist) ? 12 : 0) +
              (request.flags.has(RealtimeDataCustomFlag::follow_dist) ? 6 : 0) +
              (request.flags.has(RealtimeDataCustomFlag::ext_target_limit) ? 12 : 0) +
              (request.flags.has(RealtimeDataCustomFlag::ext_target_limit) ? 12 : 0) +
              (request.flags.has(RealtimeDataCustomFlag::frame_cam_angle_20) ? 12 : 0) +
              (request.flags.has(RealtimeDataCustomFlag::main_imu_state) ? 11 : 0))}}}},
      .response_required = true,
      .retry_is_safe = true,
      .timeout_ms = 500,
      .stream = {.command = 88, .size = 0, .interval_us = 0, .config = {{static_cast<std::uint8_t>(request.flags.raw() >> 0), static_cast<std::uint8_t>(request.flags.raw() >> 8), static_cast<std::uint8_t>(request.flags.raw() >> 16), static_cast<std::uint8_t>(request.flags.raw() >> 24)}}}};
}

constexpr ResponsePolicy response_policy(const RealtimeDataCustom2Request& request) noexcept {
  return {.responses = {.command = 139,
              .form_count = 1,
              .forms = {{{.id = 139,
               .min_size = static_cast<std::uint8_t>(2 +
              (request.flags.has(RealtimeDataCustom2Flag::include_flags) ? 4 : 0) +
              (request.flags.has(RealtimeDataCustom2Flag::frame_imu_angles) ? 6 : 0) +
              (request.flags.has(RealtimeDataCustom2Flag::frame_gyro) ? 6 : 0) +
              (request.flags.has(RealtimeDataCustom2Flag::frame_acc) ? 6 : 0) +
              (request.flags.has(RealtimeDataCustom2Flag::debug) ? 8 : 0) +
              (request.flags.has(RealtimeDataCustom2Flag::mag_sens_data) ? 6 : 0) +
              (request.flags.has(RealtimeDataCustom2Flag::pin_state) ? 8 : 0) +
              (request.flags.has(RealtimeDataCustom2Flag::stab_err_ampl) ? 6 : 0)),
               .max_size = max_body_size,
               .size = static_cast<std::uint8_t>(2 +
              (request.flags.has(RealtimeDataCustom2Flag::include_flags) ? 4 : 0) +
              (request.flags.has(RealtimeDataCustom2Flag::frame_imu_angles) ? 6 : 0) +
              (request.flags.has(RealtimeDataCustom2Flag::frame_gyro) ? 6 : 0) +
              (request.flags.has(RealtimeDataCustom2Flag::frame_acc) ? 6 : 0) +
              (request.flags.has(RealtimeDataCustom2Flag::debug) ? 8 : 0) +
              (request.flags.has(RealtimeDataCustom2Flag::mag_sens_data) ? 6 : 0) +
              (request.flags.has(RealtimeDataCustom2Flag::pin_state) ? 8 : 0) +
              (request.flags.has(RealtimeDataCustom2Flag::stab_err_ampl) ? 6 : 0))}}}},
      .response_required = true,
      .retry_is_safe = true,
      .timeout_ms = 500,
      .stream = {.command = 139, .size = 0, .interval_us = 0, .config = {{static_cast<std::uint8_t>(request.flags.raw() >> 0), static_cast<std::uint8_t>(request.flags.raw() >> 8), static_cast<std::uint8_t>(request.flags.raw() >> 16), static_cast<std::uint8_t>(request.flags.raw() >> 24)}}}};
}

constexpr ResponsePolicy response_policy(const DataStreamInterval& request) noexcept {
  return {.responses = {.command = 85,
              .confirmed = Confirmed::always},
      .confirmations = 1,
      .retry_is_safe = true,
      .has_effect = true,
      .timeout_ms = 500,
      .stream = stream_change(request)};
}

constexpr ResponsePolicy response_policy(const CanDrvStateRequest&) noexcept {
  return {.responses = {.command = 98,
              .confirmed = Confirmed::possible},
      .confirmations = 1,
      .has_effect = true,
      .timeout_ms = 500};
}

constexpr ResponsePolicy response_policy(const RealtimeDataCanDrvRequest&) noexcept {
  return {.responses = {.command = 101,
              .confirmed = Confirmed::possible},
      .confirmations = 1,
      .has_effect = true,
      .timeout_ms = 500};
}

}  // namespace sbgc::msg
