// Generated from spec/ by generator/: edit those, then run ./dev generate.

/// The stored settings of the board, and the messages that read and store them.
#pragma once

#include <cstdint>

#include <sbgc/messages.hpp>
#include <sbgc/meta.hpp>

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wdeprecated-declarations"

namespace sbgc {

/// How the settings in message M are read and stored: `Readers` and `Writers`, both with deprecated
/// messages last; `name` of M; `copies`, the number of copies of these settings on the board;
/// `copy(message)`, the index of the copy in one of these messages, from 0; `share(from, to)`, which
/// copies the general settings from one copy to another.
template <class M>
struct ParametersOf;

/// Parameters of one profile and general parameters.
template <>
struct ParametersOf<msg::ReadParams3> {
  static constexpr const char* name = "ReadParams3";
  using Readers = TypeList<msg::ReadParams3Request, msg::ReadParams>;
  using Writers = TypeList<msg::WriteParams3, msg::WriteParams>;
  static constexpr std::uint8_t copies = 5;

  static constexpr auto& copy(msg::ReadParams3& message) noexcept { return message.profile_id; }
  static constexpr const auto& copy(const msg::ReadParams3& message) noexcept {
    return message.profile_id;
  }

  static constexpr auto& copy(msg::ReadParams3Request& message) noexcept { return message.profile_id; }
  static constexpr const auto& copy(const msg::ReadParams3Request& message) noexcept {
    return message.profile_id;
  }

  static constexpr auto& copy(msg::ReadParams& message) noexcept { return message.profile_id; }
  static constexpr const auto& copy(const msg::ReadParams& message) noexcept {
    return message.profile_id;
  }

  static constexpr void share(const msg::ReadParams3& from, msg::ReadParams3& to) noexcept {
    to.serial_speed = from.serial_speed;
    to.axis_top = from.axis_top;
    to.axis_right = from.axis_right;
    to.frame_axis_top = from.frame_axis_top;
    to.frame_axis_right = from.frame_axis_right;
    to.frame_imu_pos = from.frame_imu_pos;
    to.general_flags1 = from.general_flags1;
    to.order_of_axes = from.order_of_axes;
  }
};

/// More parameters of one profile: filters, encoders, magnetometer.
template <>
struct ParametersOf<msg::ReadParamsExt> {
  static constexpr const char* name = "ReadParamsExt";
  using Readers = TypeList<msg::ReadParamsExtRequest>;
  using Writers = TypeList<msg::WriteParamsExt>;
  static constexpr std::uint8_t copies = 5;

  static constexpr auto& copy(msg::ReadParamsExt& message) noexcept { return message.profile_id; }
  static constexpr const auto& copy(const msg::ReadParamsExt& message) noexcept {
    return message.profile_id;
  }

  static constexpr auto& copy(msg::ReadParamsExtRequest& message) noexcept { return message.profile_id; }
  static constexpr const auto& copy(const msg::ReadParamsExtRequest& message) noexcept {
    return message.profile_id;
  }

  static constexpr void share(const msg::ReadParamsExt&, msg::ReadParamsExt&) noexcept {}
};

/// The third set of parameters of one profile.
template <>
struct ParametersOf<msg::ReadParamsExt2> {
  static constexpr const char* name = "ReadParamsExt2";
  using Readers = TypeList<msg::ReadParamsExt2Request>;
  using Writers = TypeList<msg::WriteParamsExt2>;
  static constexpr std::uint8_t copies = 5;

  static constexpr auto& copy(msg::ReadParamsExt2& message) noexcept { return message.profile_id; }
  static constexpr const auto& copy(const msg::ReadParamsExt2& message) noexcept {
    return message.profile_id;
  }

  static constexpr auto& copy(msg::ReadParamsExt2Request& message) noexcept { return message.profile_id; }
  static constexpr const auto& copy(const msg::ReadParamsExt2Request& message) noexcept {
    return message.profile_id;
  }

  static constexpr void share(const msg::ReadParamsExt2& from, msg::ReadParamsExt2& to) noexcept {
    to.general_flags2 = from.general_flags2;
    to.outer_mot_tilt_angle = from.outer_mot_tilt_angle;
    to.ext_led_pin_id = from.ext_led_pin_id;
    to.interrupt_cfg = from.interrupt_cfg;
    to.rc_serial_speed = from.rc_serial_speed;
    to.uart2_speed = from.uart2_speed;
    to.middle_mot_tilt_angle = from.middle_mot_tilt_angle;
  }
};

/// Profile names.
template <>
struct ParametersOf<msg::ReadProfileNames> {
  static constexpr const char* name = "ReadProfileNames";
  using Readers = TypeList<msg::ReadProfileNamesRequest>;
  using Writers = TypeList<msg::WriteProfileNames>;
  static constexpr std::uint8_t copies = 1;
};

/// The fourth set of parameters of one profile.
template <>
struct ParametersOf<msg::ReadParamsExt3> {
  static constexpr const char* name = "ReadParamsExt3";
  using Readers = TypeList<msg::ReadParamsExt3Request>;
  using Writers = TypeList<msg::WriteParamsExt3>;
  static constexpr std::uint8_t copies = 5;

  static constexpr auto& copy(msg::ReadParamsExt3& message) noexcept { return message.profile_id; }
  static constexpr const auto& copy(const msg::ReadParamsExt3& message) noexcept {
    return message.profile_id;
  }

  static constexpr auto& copy(msg::ReadParamsExt3Request& message) noexcept { return message.profile_id; }
  static constexpr const auto& copy(const msg::ReadParamsExt3Request& message) noexcept {
    return message.profile_id;
  }

  static constexpr void share(const msg::ReadParamsExt3& from, msg::ReadParamsExt3& to) noexcept {
    to.ext_imu_type = from.ext_imu_type;
    to.ext_imu_port = from.ext_imu_port;
    to.ext_imu_position = from.ext_imu_position;
    to.ext_imu_orientation = from.ext_imu_orientation;
    to.ext_imu_flags = from.ext_imu_flags;
    to.can_imu_ext_sens_type = from.can_imu_ext_sens_type;
    to.general_flags3 = from.general_flags3;
    to.imu_model_main = from.imu_model_main;
    to.imu_model_frame = from.imu_model_frame;
    to.ext_buzzer_pin = from.ext_buzzer_pin;
    to.default_profile = from.default_profile;
    to.ext_pwr_sw_shunt_r = from.ext_pwr_sw_shunt_r;
    to.general_flags4 = from.general_flags4;
  }
};

/// RC signals that trigger actions or change adjustable variables.
template <>
struct ParametersOf<msg::ReadAdjVarsCfg> {
  static constexpr const char* name = "ReadAdjVarsCfg";
  using Readers = TypeList<msg::ReadAdjVarsCfgRequest>;
  using Writers = TypeList<msg::WriteAdjVarsCfg>;
  static constexpr std::uint8_t copies = 1;
};

/// User data in the EEPROM.
template <>
struct ParametersOf<msg::ReadExternalData> {
  static constexpr const char* name = "ReadExternalData";
  using Readers = TypeList<msg::ReadExternalDataRequest>;
  using Writers = TypeList<msg::WriteExternalData>;
  static constexpr std::uint8_t copies = 1;
};

/// The messages that hold settings, in the order of the specification's families.
using ParameterMessages = TypeList<msg::ReadParams3, msg::ReadParamsExt, msg::ReadParamsExt2, msg::ReadProfileNames, msg::ReadParamsExt3, msg::ReadAdjVarsCfg, msg::ReadExternalData>;

}  // namespace sbgc

#pragma GCC diagnostic pop
