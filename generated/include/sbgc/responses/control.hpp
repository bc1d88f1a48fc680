// Generated from spec/ by generator/: edit those, then run ./dev generate.

/// Response policies of the requests in <sbgc/messages/control.hpp>.
#pragma once

#include <cstdint>

#include <sbgc/response_policy.hpp>
#include <sbgc/messages/control.hpp>

namespace sbgc::msg {

constexpr ResponsePolicy response_policy(const Control& request) noexcept {
  if ((request.control_mode.flags().has(ControlFlag::auto_task)) && (request.control_mode.mode() == ControlModeKind::angle || request.control_mode.mode() == ControlModeKind::angle_rel_frame)) {
    return {.responses = {.command = 67,
              .confirmed = Confirmed::possible},
      .confirmations = 2,
      .retry_is_safe = true,
      .has_effect = true,
      .moves = true,
      .stops = (request.control_mode.raw() & 0x0F) == 0x01 &&
          request.axes.roll.speed.raw() == 0 &&
          request.axes.pitch.speed.raw() == 0 &&
          request.axes.yaw.speed.raw() == 0,
      .timeout_ms = 500,
      .finish_ms = 12000};
  }
  return {.responses = {.command = 67,
              .confirmed = Confirmed::possible},
      .confirmations = 1,
      .retry_is_safe = true,
      .has_effect = true,
      .moves = true,
      .stops = (request.control_mode.raw() & 0x0F) == 0x01 &&
          request.axes.roll.speed.raw() == 0 &&
          request.axes.pitch.speed.raw() == 0 &&
          request.axes.yaw.speed.raw() == 0,
      .timeout_ms = 500};
}

constexpr ResponsePolicy response_policy(const ControlExt& request) noexcept {
  if (((request.control_mode.roll.flags().has(ControlFlag::auto_task)) && (request.control_mode.roll.mode() == ControlModeKind::angle || request.control_mode.roll.mode() == ControlModeKind::angle_rel_frame)) || ((request.control_mode.pitch.flags().has(ControlFlag::auto_task)) && (request.control_mode.pitch.mode() == ControlModeKind::angle || request.control_mode.pitch.mode() == ControlModeKind::angle_rel_frame)) || ((request.control_mode.yaw.flags().has(ControlFlag::auto_task)) && (request.control_mode.yaw.mode() == ControlModeKind::angle || request.control_mode.yaw.mode() == ControlModeKind::angle_rel_frame))) {
    return {.responses = {.command = 67,
              .confirmed = Confirmed::possible},
      .confirmations = 2,
      .retry_is_safe = true,
      .has_effect = true,
      .moves = true,
      .stops = (request.control_mode.roll.raw() & 0x0F) == 0x01 &&
          (request.control_mode.pitch.raw() & 0x0F) == 0x01 &&
          (request.control_mode.yaw.raw() & 0x0F) == 0x01 &&
          request.axes.roll.speed.raw() == 0 &&
          request.axes.pitch.speed.raw() == 0 &&
          request.axes.yaw.speed.raw() == 0,
      .timeout_ms = 500,
      .finish_ms = 12000};
  }
  return {.responses = {.command = 67,
              .confirmed = Confirmed::possible},
      .confirmations = 1,
      .retry_is_safe = true,
      .has_effect = true,
      .moves = true,
      .stops = (request.control_mode.roll.raw() & 0x0F) == 0x01 &&
          (request.control_mode.pitch.raw() & 0x0F) == 0x01 &&
          (request.control_mode.yaw.raw() & 0x0F) == 0x01 &&
          request.axes.roll.speed.raw() == 0 &&
          request.axes.pitch.speed.raw() == 0 &&
          request.axes.yaw.speed.raw() == 0,
      .timeout_ms = 500};
}

constexpr ResponsePolicy response_policy(const ControlExtCommand& request) noexcept {
  if (((request.axes.roll.mode && request.axes.roll.mode->flags().has(ControlFlag::auto_task)) && (request.axes.roll.mode && (request.axes.roll.mode->mode() == ControlModeKind::angle || request.axes.roll.mode->mode() == ControlModeKind::angle_rel_frame))) || ((request.axes.pitch.mode && request.axes.pitch.mode->flags().has(ControlFlag::auto_task)) && (request.axes.pitch.mode && (request.axes.pitch.mode->mode() == ControlModeKind::angle || request.axes.pitch.mode->mode() == ControlModeKind::angle_rel_frame))) || ((request.axes.yaw.mode && request.axes.yaw.mode->flags().has(ControlFlag::auto_task)) && (request.axes.yaw.mode && (request.axes.yaw.mode->mode() == ControlModeKind::angle || request.axes.yaw.mode->mode() == ControlModeKind::angle_rel_frame)))) {
    return {.responses = {.command = 121,
              .confirmed = Confirmed::possible},
      .confirmations = 2,
      .retry_is_safe = true,
      .has_effect = true,
      .moves = true,
      .stops = (request.axes.roll.mode && (request.axes.roll.mode->raw() & 0x0F) == 0x01 &&
          request.axes.pitch.mode && (request.axes.pitch.mode->raw() & 0x0F) == 0x01 &&
          request.axes.yaw.mode && (request.axes.yaw.mode->raw() & 0x0F) == 0x01 &&
          request.axes.roll.speed && request.axes.roll.speed->raw() == 0 &&
          request.axes.pitch.speed && request.axes.pitch.speed->raw() == 0 &&
          request.axes.yaw.speed && request.axes.yaw.speed->raw() == 0) ||
          (request.axes.roll.mode && (request.axes.roll.mode->raw() & 0x0F) == 0x01 &&
          request.axes.pitch.mode && (request.axes.pitch.mode->raw() & 0x0F) == 0x01 &&
          request.axes.yaw.mode && (request.axes.yaw.mode->raw() & 0x0F) == 0x01 &&
          request.axes.roll.speed_32 && request.axes.roll.speed_32->raw() == 0 &&
          request.axes.pitch.speed_32 && request.axes.pitch.speed_32->raw() == 0 &&
          request.axes.yaw.speed_32 && request.axes.yaw.speed_32->raw() == 0),
      .timeout_ms = 500,
      .finish_ms = 12000};
  }
  return {.responses = {.command = 121,
              .confirmed = Confirmed::possible},
      .confirmations = 1,
      .retry_is_safe = true,
      .has_effect = true,
      .moves = true,
      .stops = (request.axes.roll.mode && (request.axes.roll.mode->raw() & 0x0F) == 0x01 &&
          request.axes.pitch.mode && (request.axes.pitch.mode->raw() & 0x0F) == 0x01 &&
          request.axes.yaw.mode && (request.axes.yaw.mode->raw() & 0x0F) == 0x01 &&
          request.axes.roll.speed && request.axes.roll.speed->raw() == 0 &&
          request.axes.pitch.speed && request.axes.pitch.speed->raw() == 0 &&
          request.axes.yaw.speed && request.axes.yaw.speed->raw() == 0) ||
          (request.axes.roll.mode && (request.axes.roll.mode->raw() & 0x0F) == 0x01 &&
          request.axes.pitch.mode && (request.axes.pitch.mode->raw() & 0x0F) == 0x01 &&
          request.axes.yaw.mode && (request.axes.yaw.mode->raw() & 0x0F) == 0x01 &&
          request.axes.roll.speed_32 && request.axes.roll.speed_32->raw() == 0 &&
          request.axes.pitch.speed_32 && request.axes.pitch.speed_32->raw() == 0 &&
          request.axes.yaw.speed_32 && request.axes.yaw.speed_32->raw() == 0),
      .timeout_ms = 500};
}

constexpr ResponsePolicy response_policy(const ControlConfig& request) noexcept {
  if (request.flags.has(ControlConfigFlag::no_confirm)) {
    return {.responses = {.command = 90,
              .confirmed = Confirmed::possible},
      .confirmations = 1,
      .retry_is_safe = true,
      .has_effect = true,
      .moves = true,
      .timeout_ms = 500};
  }
  return {.responses = {.command = 90,
              .confirmed = Confirmed::always},
      .confirmations = 1,
      .retry_is_safe = true,
      .has_effect = true,
      .moves = true,
      .timeout_ms = 500};
}

constexpr ResponsePolicy response_policy(const ControlQuatDisabled& request) noexcept {
  if (request.flags.has(ControlQuatFlag::confirm)) {
    return {.responses = {.command = 140,
              .confirmed = Confirmed::always},
      .confirmations = 1,
      .retry_is_safe = true,
      .has_effect = true,
      .moves = true,
      .timeout_ms = 500};
  }
  return {.responses = {.command = 140},
      .has_effect = true,
      .moves = true,
      .timeout_ms = 500};
}

constexpr ResponsePolicy response_policy(const ControlQuatSpeed& request) noexcept {
  if (request.flags.has(ControlQuatFlag::confirm)) {
    return {.responses = {.command = 140,
              .confirmed = Confirmed::always},
      .confirmations = 1,
      .retry_is_safe = true,
      .has_effect = true,
      .moves = true,
      .stops = request.target_speed.x.raw() == 0.0F &&
          request.target_speed.y.raw() == 0.0F &&
          request.target_speed.z.raw() == 0.0F,
      .timeout_ms = 500};
  }
  return {.responses = {.command = 140},
      .has_effect = true,
      .moves = true,
      .stops = request.target_speed.x.raw() == 0.0F &&
          request.target_speed.y.raw() == 0.0F &&
          request.target_speed.z.raw() == 0.0F,
      .timeout_ms = 500};
}

constexpr ResponsePolicy response_policy(const ControlQuatAttitude& request) noexcept {
  if (request.flags.has(ControlQuatFlag::confirm) && request.flags.has(ControlQuatFlag::auto_task)) {
    return {.responses = {.command = 140,
              .confirmed = Confirmed::always},
      .confirmations = 2,
      .has_effect = true,
      .moves = true,
      .timeout_ms = 500,
      .finish_ms = 11000};
  }
  if (request.flags.has(ControlQuatFlag::confirm)) {
    return {.responses = {.command = 140,
              .confirmed = Confirmed::always},
      .confirmations = 1,
      .retry_is_safe = true,
      .has_effect = true,
      .moves = true,
      .timeout_ms = 500};
  }
  if (request.flags.has(ControlQuatFlag::auto_task)) {
    return {.responses = {.command = 140,
              .confirmed = Confirmed::always},
      .confirmations = 1,
      .has_effect = true,
      .moves = true,
      .timeout_ms = 11000};
  }
  return {.responses = {.command = 140},
      .has_effect = true,
      .moves = true,
      .timeout_ms = 500};
}

constexpr ResponsePolicy response_policy(const ControlQuatAttitudePacked& request) noexcept {
  if (request.flags.has(ControlQuatFlag::confirm) && request.flags.has(ControlQuatFlag::auto_task)) {
    return {.responses = {.command = 140,
              .confirmed = Confirmed::always},
      .confirmations = 2,
      .has_effect = true,
      .moves = true,
      .timeout_ms = 500,
      .finish_ms = 11000};
  }
  if (request.flags.has(ControlQuatFlag::confirm)) {
    return {.responses = {.command = 140,
              .confirmed = Confirmed::always},
      .confirmations = 1,
      .retry_is_safe = true,
      .has_effect = true,
      .moves = true,
      .timeout_ms = 500};
  }
  if (request.flags.has(ControlQuatFlag::auto_task)) {
    return {.responses = {.command = 140,
              .confirmed = Confirmed::always},
      .confirmations = 1,
      .has_effect = true,
      .moves = true,
      .timeout_ms = 11000};
  }
  return {.responses = {.command = 140},
      .has_effect = true,
      .moves = true,
      .timeout_ms = 500};
}

constexpr ResponsePolicy response_policy(const ControlQuatSpeedAttitude& request) noexcept {
  if (request.flags.has(ControlQuatFlag::confirm)) {
    return {.responses = {.command = 140,
              .confirmed = Confirmed::always},
      .confirmations = 1,
      .retry_is_safe = true,
      .has_effect = true,
      .moves = true,
      .timeout_ms = 500};
  }
  return {.responses = {.command = 140},
      .has_effect = true,
      .moves = true,
      .timeout_ms = 500};
}

constexpr ResponsePolicy response_policy(const ControlQuatSpeedAttitudePacked& request) noexcept {
  if (request.flags.has(ControlQuatFlag::confirm)) {
    return {.responses = {.command = 140,
              .confirmed = Confirmed::always},
      .confirmations = 1,
      .retry_is_safe = true,
      .has_effect = true,
      .moves = true,
      .timeout_ms = 500};
  }
  return {.responses = {.command = 140},
      .has_effect = true,
      .moves = true,
      .timeout_ms = 500};
}

constexpr ResponsePolicy response_policy(const ControlQuatStatusRequest& request) noexcept {
  return {.responses = {.command = 141,
              .form_count = 1,
              .forms = {{{.id = 141,
               .min_size = 2,
               .max_size = max_body_size,
               .size = 97,
               .correlation = {{{.offset = 0, .size = 2, .value = static_cast<std::uint32_t>(request.data_set.raw())}}}}}}},
      .response_required = true,
      .retry_is_safe = true,
      .timeout_ms = 500};
}

constexpr ResponsePolicy response_policy(const ControlQuatConfig&) noexcept {
  return {.responses = {.command = 142,
              .confirmed = Confirmed::always},
      .confirmations = 1,
      .retry_is_safe = true,
      .has_effect = true,
      .timeout_ms = 500};
}

constexpr ResponsePolicy response_policy(const GetAnglesRequest&) noexcept {
  return {.responses = {.command = 73,
              .form_count = 1,
              .forms = {{{.id = 73,
               .min_size = 18,
               .max_size = max_body_size,
               .size = 18}}}},
      .response_required = true,
      .retry_is_safe = true,
      .timeout_ms = 500};
}

constexpr ResponsePolicy response_policy(const GetAnglesExtRequest&) noexcept {
  return {.responses = {.command = 61,
              .form_count = 1,
              .forms = {{{.id = 61,
               .min_size = 54,
               .max_size = max_body_size,
               .size = 54}}}},
      .response_required = true,
      .retry_is_safe = true,
      .timeout_ms = 500};
}

constexpr ResponsePolicy response_policy(const MotorsOn&) noexcept {
  return {.responses = {.command = 77,
              .confirmed = Confirmed::always},
      .confirmations = 1,
      .retry_is_safe = true,
      .has_effect = true,
      .moves = true,
      .timeout_ms = 500};
}

constexpr ResponsePolicy response_policy(const MotorsOff&) noexcept {
  return {.responses = {.command = 109,
              .confirmed = Confirmed::always},
      .confirmations = 1,
      .retry_is_safe = true,
      .has_effect = true,
      .moves = true,
      .stops = true,
      .timeout_ms = 500};
}

constexpr ResponsePolicy response_policy(const MotorsOffExt&) noexcept {
  return {.responses = {.command = 109,
              .confirmed = Confirmed::always},
      .confirmations = 1,
      .retry_is_safe = true,
      .has_effect = true,
      .moves = true,
      .stops = true,
      .timeout_ms = 500};
}

constexpr ResponsePolicy response_policy(const SyncMotors&) noexcept {
  return {.responses = {.command = 123,
              .confirmed = Confirmed::always},
      .confirmations = 1,
      .has_effect = true,
      .moves = true,
      .timeout_ms = 500};
}

constexpr ResponsePolicy response_policy(const ExecuteMenu& request) noexcept {
  if (request.cmd_id == MenuCommand::none || request.cmd_id == MenuCommand::profile1 || request.cmd_id == MenuCommand::profile2 || request.cmd_id == MenuCommand::profile3 || request.cmd_id == MenuCommand::profile4 || request.cmd_id == MenuCommand::profile5 || request.cmd_id == MenuCommand::set_angle || request.cmd_id == MenuCommand::set_angle_no_save || request.cmd_id == MenuCommand::motor_on || request.cmd_id == MenuCommand::motor_off || request.cmd_id == MenuCommand::look_down || request.cmd_id == MenuCommand::home_position || request.cmd_id == MenuCommand::home_position_shortest || request.cmd_id == MenuCommand::home_position_motors || request.cmd_id == MenuCommand::level_roll_pitch || request.cmd_id == MenuCommand::level_roll || request.cmd_id == MenuCommand::level_pitch || request.cmd_id == MenuCommand::center_yaw || request.cmd_id == MenuCommand::center_yaw_shortest || request.cmd_id == MenuCommand::untwist_cables || request.cmd_id == MenuCommand::snap_to_fixed_position || request.cmd_id == MenuCommand::retracted_position || request.cmd_id == MenuCommand::motors_safe_stop || request.cmd_id == MenuCommand::set_cur_pos_as_home || request.cmd_id == MenuCommand::stop_script || request.cmd_id == MenuCommand::tripod_mode_off || request.cmd_id == MenuCommand::tripod_mode_on || request.cmd_id == MenuCommand::shake_generator_off || request.cmd_id == MenuCommand::shake_generator_on || request.cmd_id == MenuCommand::servo_mode_on || request.cmd_id == MenuCommand::servo_mode_off) {
    return {.responses = {.command = 69,
              .confirmed = Confirmed::possible},
      .confirmations = 1,
      .retry_is_safe = true,
      .has_effect = !(request.cmd_id == MenuCommand::none),
      .moves = !(request.cmd_id == MenuCommand::none ||
          request.cmd_id == MenuCommand::camera_rec_photo_event ||
          request.cmd_id == MenuCommand::camera_photo_event ||
          request.cmd_id == MenuCommand::calib_acc ||
          request.cmd_id == MenuCommand::calib_gyro ||
          request.cmd_id == MenuCommand::calib_gyro_temp ||
          request.cmd_id == MenuCommand::calib_acc_temp ||
          request.cmd_id == MenuCommand::calib_mag ||
          request.cmd_id == MenuCommand::rc_bind ||
          request.cmd_id == MenuCommand::calib_acc_auto ||
          request.cmd_id == MenuCommand::ext_gyro_online_calib),
      .stops = request.cmd_id == MenuCommand::motor_off ||
          request.cmd_id == MenuCommand::motors_safe_stop,
      .timeout_ms = 500};
  }
  return {.responses = {.command = 69,
              .confirmed = Confirmed::possible},
      .confirmations = 1,
      .has_effect = !(request.cmd_id == MenuCommand::none),
      .moves = !(request.cmd_id == MenuCommand::none ||
          request.cmd_id == MenuCommand::camera_rec_photo_event ||
          request.cmd_id == MenuCommand::camera_photo_event ||
          request.cmd_id == MenuCommand::calib_acc ||
          request.cmd_id == MenuCommand::calib_gyro ||
          request.cmd_id == MenuCommand::calib_gyro_temp ||
          request.cmd_id == MenuCommand::calib_acc_temp ||
          request.cmd_id == MenuCommand::calib_mag ||
          request.cmd_id == MenuCommand::rc_bind ||
          request.cmd_id == MenuCommand::calib_acc_auto ||
          request.cmd_id == MenuCommand::ext_gyro_online_calib),
      .stops = request.cmd_id == MenuCommand::motor_off ||
          request.cmd_id == MenuCommand::motors_safe_stop,
      .timeout_ms = 500};
}

constexpr ResponsePolicy response_policy(const ExecuteMenuExt& request) noexcept {
  if (request.param.has(ExecuteMenuFlag::confirm) && request.param.has(ExecuteMenuFlag::confirm_on_finish)) {
    return {.responses = {.command = 69,
              .confirmed = Confirmed::always},
      .confirmations = 2,
      .has_effect = !(request.cmd_id == MenuCommand::none),
      .moves = !(request.cmd_id == MenuCommand::none ||
          request.cmd_id == MenuCommand::camera_rec_photo_event ||
          request.cmd_id == MenuCommand::camera_photo_event ||
          request.cmd_id == MenuCommand::calib_acc ||
          request.cmd_id == MenuCommand::calib_gyro ||
          request.cmd_id == MenuCommand::calib_gyro_temp ||
          request.cmd_id == MenuCommand::calib_acc_temp ||
          request.cmd_id == MenuCommand::calib_mag ||
          request.cmd_id == MenuCommand::rc_bind ||
          request.cmd_id == MenuCommand::calib_acc_auto ||
          request.cmd_id == MenuCommand::ext_gyro_online_calib),
      .stops = request.cmd_id == MenuCommand::motor_off ||
          request.cmd_id == MenuCommand::motors_safe_stop,
      .timeout_ms = 500,
      .finish_ms = 60000};
  }
  if ((request.param.has(ExecuteMenuFlag::confirm)) && (request.cmd_id == MenuCommand::none || request.cmd_id == MenuCommand::profile1 || request.cmd_id == MenuCommand::profile2 || request.cmd_id == MenuCommand::profile3 || request.cmd_id == MenuCommand::profile4 || request.cmd_id == MenuCommand::profile5 || request.cmd_id == MenuCommand::set_angle || request.cmd_id == MenuCommand::set_angle_no_save || request.cmd_id == MenuCommand::motor_on || request.cmd_id == MenuCommand::motor_off || request.cmd_id == MenuCommand::look_down || request.cmd_id == MenuCommand::home_position || request.cmd_id == MenuCommand::home_position_shortest || request.cmd_id == MenuCommand::home_position_motors || request.cmd_id == MenuCommand::level_roll_pitch || request.cmd_id == MenuCommand::level_roll || request.cmd_id == MenuCommand::level_pitch || request.cmd_id == MenuCommand::center_yaw || request.cmd_id == MenuCommand::center_yaw_shortest || request.cmd_id == MenuCommand::untwist_cables || request.cmd_id == MenuCommand::snap_to_fixed_position || request.cmd_id == MenuCommand::retracted_position || request.cmd_id == MenuCommand::motors_safe_stop || request.cmd_id == MenuCommand::set_cur_pos_as_home || request.cmd_id == MenuCommand::stop_script || request.cmd_id == MenuCommand::tripod_mode_off || request.cmd_id == MenuCommand::tripod_mode_on || request.cmd_id == MenuCommand::shake_generator_off || request.cmd_id == MenuCommand::shake_generator_on || request.cmd_id == MenuCommand::servo_mode_on || request.cmd_id == MenuCommand::servo_mode_off)) {
    return {.responses = {.command = 69,
              .confirmed = Confirmed::always},
      .confirmations = 1,
      .retry_is_safe = true,
      .has_effect = !(request.cmd_id == MenuCommand::none),
      .moves = !(request.cmd_id == MenuCommand::none ||
          request.cmd_id == MenuCommand::camera_rec_photo_event ||
          request.cmd_id == MenuCommand::camera_photo_event ||
          request.cmd_id == MenuCommand::calib_acc ||
          request.cmd_id == MenuCommand::calib_gyro ||
          request.cmd_id == MenuCommand::calib_gyro_temp ||
          request.cmd_id == MenuCommand::calib_acc_temp ||
          request.cmd_id == MenuCommand::calib_mag ||
          request.cmd_id == MenuCommand::rc_bind ||
          request.cmd_id == MenuCommand::calib_acc_auto ||
          request.cmd_id == MenuCommand::ext_gyro_online_calib),
      .stops = request.cmd_id == MenuCommand::motor_off ||
          request.cmd_id == MenuCommand::motors_safe_stop,
      .timeout_ms = 500};
  }
  if (request.param.has(ExecuteMenuFlag::confirm)) {
    return {.responses = {.command = 69,
              .confirmed = Confirmed::always},
      .confirmations = 1,
      .has_effect = !(request.cmd_id == MenuCommand::none),
      .moves = !(request.cmd_id == MenuCommand::none ||
          request.cmd_id == MenuCommand::camera_rec_photo_event ||
          request.cmd_id == MenuCommand::camera_photo_event ||
          request.cmd_id == MenuCommand::calib_acc ||
          request.cmd_id == MenuCommand::calib_gyro ||
          request.cmd_id == MenuCommand::calib_gyro_temp ||
          request.cmd_id == MenuCommand::calib_acc_temp ||
          request.cmd_id == MenuCommand::calib_mag ||
          request.cmd_id == MenuCommand::rc_bind ||
          request.cmd_id == MenuCommand::calib_acc_auto ||
          request.cmd_id == MenuCommand::ext_gyro_online_calib),
      .stops = request.cmd_id == MenuCommand::motor_off ||
          request.cmd_id == MenuCommand::motors_safe_stop,
      .timeout_ms = 500};
  }
  if (request.param.has(ExecuteMenuFlag::confirm_on_finish)) {
    return {.responses = {.command = 69,
              .confirmed = Confirmed::always},
      .confirmations = 1,
      .has_effect = !(request.cmd_id == MenuCommand::none),
      .moves = !(request.cmd_id == MenuCommand::none ||
          request.cmd_id == MenuCommand::camera_rec_photo_event ||
          request.cmd_id == MenuCommand::camera_photo_event ||
          request.cmd_id == MenuCommand::calib_acc ||
          request.cmd_id == MenuCommand::calib_gyro ||
          request.cmd_id == MenuCommand::calib_gyro_temp ||
          request.cmd_id == MenuCommand::calib_acc_temp ||
          request.cmd_id == MenuCommand::calib_mag ||
          request.cmd_id == MenuCommand::rc_bind ||
          request.cmd_id == MenuCommand::calib_acc_auto ||
          request.cmd_id == MenuCommand::ext_gyro_online_calib),
      .stops = request.cmd_id == MenuCommand::motor_off ||
          request.cmd_id == MenuCommand::motors_safe_stop,
      .timeout_ms = 60000};
  }
  return {.responses = {.command = 69,
              .confirmed = Confirmed::possible},
      .confirmations = 1,
      .has_effect = !(request.cmd_id == MenuCommand::none),
      .moves = !(request.cmd_id == MenuCommand::none ||
          request.cmd_id == MenuCommand::camera_rec_photo_event ||
          request.cmd_id == MenuCommand::camera_photo_event ||
          request.cmd_id == MenuCommand::calib_acc ||
          request.cmd_id == MenuCommand::calib_gyro ||
          request.cmd_id == MenuCommand::calib_gyro_temp ||
          request.cmd_id == MenuCommand::calib_acc_temp ||
          request.cmd_id == MenuCommand::calib_mag ||
          request.cmd_id == MenuCommand::rc_bind ||
          request.cmd_id == MenuCommand::calib_acc_auto ||
          request.cmd_id == MenuCommand::ext_gyro_online_calib),
      .stops = request.cmd_id == MenuCommand::motor_off ||
          request.cmd_id == MenuCommand::motors_safe_stop,
      .timeout_ms = 500};
}

constexpr ResponsePolicy response_policy(const HelperData&) noexcept {
  return {.responses = {.command = 72,
              .confirmed = Confirmed::unlikely},
      .confirmations = 1,
      .has_effect = true,
      .moves = true,
      .timeout_ms = 500};
}

constexpr ResponsePolicy response_policy(const HelperDataExt&) noexcept {
  return {.responses = {.command = 72,
              .confirmed = Confirmed::unlikely},
      .confirmations = 1,
      .has_effect = true,
      .moves = true,
      .timeout_ms = 500};
}

}  // namespace sbgc::msg
