// Generated from spec/ by generator/: edit those, then run ./dev generate.

/// Moving the camera and asking where it looks.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <type_traits>

#include <sbgc/codec.hpp>
#include <sbgc/enums.hpp>
#include <sbgc/flag_unit.hpp>
#include <sbgc/units.hpp>

namespace sbgc::msg {

using sbgc::get;
using sbgc::put;

static_assert(codec_version == 1, "generated code and runtime do not belong together");

/// Target of each axis.
struct ControlAxis {
  static constexpr std::size_t wire_size = 4;

  /// Speed to move with; an acceleration limit of the settings may hold it back. Unit: deg/s, one
  /// count is 4000/32767. With CONTROL_FLAG_HIGH_RES_SPEED it is FineSpeed instead. Errata: E071,
  /// E109.
  ControlSpeed speed{};
  /// Angle to reach; in MODE_RC the RC signal, -500 to 500. Unit: deg, one count is 360/16384.
  /// Range: -32768 to 32767.
  Angle14 angle{};

  constexpr bool operator==(const ControlAxis&) const = default;
};

constexpr void get(const std::uint8_t* SBGC_RESTRICT from,
                   ControlAxis& SBGC_RESTRICT out) noexcept {
  get(from, out.speed);
  get(from + 2, out.angle);
}
constexpr void put(std::uint8_t* SBGC_RESTRICT to,
                   const ControlAxis& SBGC_RESTRICT in) noexcept {
  put(to, in.speed);
  put(to + 2, in.angle);
}

/// State of each axis.
struct AxisState {
  static constexpr std::size_t wire_size = 6;

  /// Measured angle; starts again after two full turns. Unit: deg, one count is 360/16384. Range:
  /// -32768 to 32767.
  Angle14 imu_angle{};
  /// Angle that the gimbal should hold, set by RC or by control commands. Unit: deg, one count is
  /// 360/16384. Range: -32768 to 32767.
  Angle14 rc_target_angle{};
  /// Speed that the gimbal should hold; 0 once the target is reached. Unit: deg/s, one count is
  /// 4000/32767. Errata: E071, E105, E109.
  ControlSpeed rc_speed{};

  constexpr bool operator==(const AxisState&) const = default;
};

constexpr void get(const std::uint8_t* SBGC_RESTRICT from,
                   AxisState& SBGC_RESTRICT out) noexcept {
  using M = AxisState;
  if (!std::is_constant_evaluated() &&
      detail::in_parallel(offsetof(M, imu_angle), offsetof(M, rc_speed), 4)) {
    detail::get_block(from, out, offsetof(M, imu_angle), 6);
    return;
  }
  get(from, out.imu_angle);
  get(from + 2, out.rc_target_angle);
  get(from + 4, out.rc_speed);
}
constexpr void put(std::uint8_t* SBGC_RESTRICT to,
                   const AxisState& SBGC_RESTRICT in) noexcept {
  using M = AxisState;
  if (!std::is_constant_evaluated() &&
      detail::in_parallel(offsetof(M, imu_angle), offsetof(M, rc_speed), 4)) {
    detail::put_block(to, in, offsetof(M, imu_angle), 6);
    return;
  }
  put(to, in.imu_angle);
  put(to + 2, in.rc_target_angle);
  put(to + 4, in.rc_speed);
}

/// State of each axis.
struct AxisStateExt {
  static constexpr std::size_t wire_size = 18;

  /// Measured angle; starts again after two full turns. Unit: deg, one count is 360/16384. Range:
  /// -32768 to 32767.
  Angle14 imu_angle{};
  /// Angle that the gimbal should hold. Unit: deg, one count is 360/16384. Range: -32768 to 32767.
  Angle14 rc_target_angle{};
  /// Angle of the joint, from an encoder or the second IMU; 0 in normal position, and it counts on
  /// over full turns. Unit: deg, one count is 360/16384. Errata: E039.
  LongAngle14 stator_rotor_angle{};
  /// Reserved; kept as it is.
  Bytes<10> reserved{};

  constexpr bool operator==(const AxisStateExt&) const = default;
};

constexpr void get(const std::uint8_t* SBGC_RESTRICT from,
                   AxisStateExt& SBGC_RESTRICT out) noexcept {
  using M = AxisStateExt;
  if (!std::is_constant_evaluated() &&
      detail::in_parallel(offsetof(M, imu_angle), offsetof(M, reserved), 8)) {
    detail::get_block(from, out, offsetof(M, imu_angle), 18);
    return;
  }
  get(from, out.imu_angle);
  get(from + 2, out.rc_target_angle);
  get(from + 4, out.stator_rotor_angle);
  get(from + 8, out.reserved);
}
constexpr void put(std::uint8_t* SBGC_RESTRICT to,
                   const AxisStateExt& SBGC_RESTRICT in) noexcept {
  using M = AxisStateExt;
  if (!std::is_constant_evaluated() &&
      detail::in_parallel(offsetof(M, imu_angle), offsetof(M, reserved), 8)) {
    detail::put_block(to, in, offsetof(M, imu_angle), 18);
    return;
  }
  put(to, in.imu_angle);
  put(to + 2, in.rc_target_angle);
  put(to + 4, in.stator_rotor_angle);
  put(to + 8, in.reserved);
}

/// Move the camera, one mode for all axes. Overrides RC until a command with MODE_NO_CONTROL and
/// zeros is sent. At most 50 a second. A board keeps the last speed when the link is lost. It tells
/// a target or a speed, never a step, so the same one may be sent again; the last one counts.
///
/// CMD_CONTROL (67), to the board, simple form; 13 bytes.
/// Effect: moves.
/// Source: Outgoing commands L694-L715; Variables L1147-L1152. Errata: E021, E025, E212.
struct Control {
  static constexpr CommandId command = CommandId::control;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::simple;
  static constexpr std::size_t min_size = 13;
  static constexpr std::size_t max_size = 13;
  static constexpr Availability since{};

  /// Mode of all three axes.
  ControlMode control_mode{};
  /// Target of each axis.
  Axes<ControlAxis> axes{};

  /// The physical value of speed of an element in deg/s, whose unit on the wire
  /// CONTROL_FLAG_HIGH_RES_SPEED chooses.
  constexpr double real_speed(std::size_t index) const noexcept {
    return detail::real_in_unit<FineSpeed>(axes[index].speed, control_mode, 0x80);
  }
  /// Sets speed of an element, and the flag to its unit. False, and nothing changes, while another
  /// element has a value in the other unit.
  [[nodiscard]] constexpr bool set_speed(std::size_t index, ControlSpeed value) noexcept {
    return detail::set_in_common_unit(
        axes, index, [](auto& one) -> auto& { return one.speed; }, value, control_mode, 0x80, false);
  }
  [[nodiscard]] constexpr bool set_speed(std::size_t index, FineSpeed value) noexcept {
    return detail::set_in_common_unit(
        axes, index, [](auto& one) -> auto& { return one.speed; }, value, control_mode, 0x80, true);
  }

  constexpr bool operator==(const Control&) const = default;
};

constexpr void get(const std::uint8_t* SBGC_RESTRICT from,
                   Control& SBGC_RESTRICT out) noexcept {
  get(from, out.control_mode);
  get(from + 1, out.axes);
}
constexpr void put(std::uint8_t* SBGC_RESTRICT to,
                   const Control& SBGC_RESTRICT in) noexcept {
  put(to, in.control_mode);
  put(to + 1, in.axes);
}

[[nodiscard]] constexpr Status decode(std::span<const std::uint8_t> body,
                                      Control& out) noexcept {
  if (body.size() != 13) return detail::wrong_size(body.size(), 13);
  get(body.data(), out);
  return {};
}

[[nodiscard]] constexpr WriteResult encode(const Control& in,
                                           std::span<std::uint8_t> out) noexcept {
  if (out.size() < 13) return {0, {Code::buffer_too_small}};
  put(out.data(), in);
  return {13, {}};
}

/// Move the camera, with a mode for each axis. Overrides RC until a command with MODE_NO_CONTROL
/// and zeros is sent. At most 50 a second. A board keeps the last speed when the link is lost. It
/// tells a target or a speed, never a step, so the same one may be sent again; the last one counts.
///
/// CMD_CONTROL (67), to the board, extended form; 15 bytes.
/// Effect: moves.
/// Since firmware 2.55b5.
/// Source: Outgoing commands L694-L715; Variables L1147-L1152. Errata: E021, E025, E212.
struct ControlExt {
  static constexpr CommandId command = CommandId::control;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::extended;
  static constexpr std::size_t min_size = 15;
  static constexpr std::size_t max_size = 15;
  static constexpr Availability since{2555, 0};

  /// Mode of each axis.
  Axes<ControlMode> control_mode{};
  /// Target of each axis.
  Axes<ControlAxis> axes{};

  /// The physical value of speed of an element in deg/s, whose unit on the wire
  /// CONTROL_FLAG_HIGH_RES_SPEED chooses.
  constexpr double real_speed(std::size_t index) const noexcept {
    return detail::real_in_unit<FineSpeed>(axes[index].speed, control_mode[index], 0x80);
  }
  /// Sets speed of an element, and the flag to its unit.
  constexpr void set_speed(std::size_t index, ControlSpeed value) noexcept {
    detail::set_in_unit(axes[index].speed, value, control_mode[index], 0x80, false);
  }
  constexpr void set_speed(std::size_t index, FineSpeed value) noexcept {
    detail::set_in_unit(axes[index].speed, value, control_mode[index], 0x80, true);
  }

  constexpr bool operator==(const ControlExt&) const = default;
};

constexpr void get(const std::uint8_t* SBGC_RESTRICT from,
                   ControlExt& SBGC_RESTRICT out) noexcept {
  get(from, out.control_mode);
  get(from + 3, out.axes);
}
constexpr void put(std::uint8_t* SBGC_RESTRICT to,
                   const ControlExt& SBGC_RESTRICT in) noexcept {
  put(to, in.control_mode);
  put(to + 3, in.axes);
}

[[nodiscard]] constexpr Status decode(std::span<const std::uint8_t> body,
                                      ControlExt& out) noexcept {
  if (body.size() != 15) return detail::wrong_size(body.size(), 15);
  get(body.data(), out);
  return {};
}

[[nodiscard]] constexpr WriteResult encode(const ControlExt& in,
                                           std::span<std::uint8_t> out) noexcept {
  if (out.size() < 15) return {0, {Code::buffer_too_small}};
  put(out.data(), in);
  return {15, {}};
}

/// Angles and targets of the camera.
///
/// CMD_GET_ANGLES (73), from the board; 18 bytes, and later firmware may append more.
/// Source: Incoming commands L428-L434; Variables L1156-L1161.
struct GetAngles {
  static constexpr CommandId command = CommandId::get_angles;
  static constexpr Direction direction = Direction::from_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 18;
  static constexpr std::size_t max_size = 18;
  static constexpr Availability since{};

  /// State of each axis.
  Axes<AxisState> axes{};
  /// What later firmware appends; kept, and written back.
  BoundedBytes<237> tail{};

  constexpr bool operator==(const GetAngles&) const = default;
};

constexpr void get(const std::uint8_t* SBGC_RESTRICT from,
                   GetAngles& SBGC_RESTRICT out) noexcept {
  get(from, out.axes);
}
constexpr void put(std::uint8_t* SBGC_RESTRICT to,
                   const GetAngles& SBGC_RESTRICT in) noexcept {
  put(to, in.axes);
}

[[nodiscard]] constexpr Status decode(std::span<const std::uint8_t> body,
                                      GetAngles& out) noexcept {
  if (body.size() < 18) return detail::wrong_size(body.size(), 18);
  get(body.data(), out);
  return detail::get_tail(body, 18, out.tail);
}

[[nodiscard]] constexpr WriteResult encode(const GetAngles& in,
                                           std::span<std::uint8_t> out) noexcept {
  const std::size_t size = 18 + in.tail.size();
  if (out.size() < size) return {0, {Code::buffer_too_small}};
  put(out.data(), in);
  detail::put_tail(out.data() + 18, in.tail);
  return {size, {}};
}

/// Ask for the angles and targets of the camera.
///
/// CMD_GET_ANGLES (73), to the board; 0 bytes.
/// Effect: reads.
/// Source: Outgoing commands L753-L755.
struct GetAnglesRequest {
  static constexpr CommandId command = CommandId::get_angles;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 0;
  static constexpr std::size_t max_size = 0;
  static constexpr Availability since{};

  constexpr bool operator==(const GetAnglesRequest&) const = default;
};

[[nodiscard]] constexpr Status decode(std::span<const std::uint8_t> body,
                                      GetAnglesRequest& out) noexcept {
  if (body.size() != 0) return detail::wrong_size(body.size(), 0);
  static_cast<void>(out);
  return {};
}

[[nodiscard]] constexpr WriteResult encode(const GetAnglesRequest& in,
                                           std::span<std::uint8_t> out) noexcept {
  static_cast<void>(in);
  static_cast<void>(out);
  return {0, {}};
}

/// Angles, targets and joint angles of the gimbal.
///
/// CMD_GET_ANGLES_EXT (61), from the board; 54 bytes, and later firmware may append more.
/// Since board 3.0.
/// Source: Incoming commands L436-L443; Variables L1162-L1165.
struct GetAnglesExt {
  static constexpr CommandId command = CommandId::get_angles_ext;
  static constexpr Direction direction = Direction::from_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 54;
  static constexpr std::size_t max_size = 54;
  static constexpr Availability since{0, 30};

  /// State of each axis.
  Axes<AxisStateExt> axes{};
  /// What later firmware appends; kept, and written back.
  BoundedBytes<201> tail{};

  constexpr bool operator==(const GetAnglesExt&) const = default;
};

constexpr void get(const std::uint8_t* SBGC_RESTRICT from,
                   GetAnglesExt& SBGC_RESTRICT out) noexcept {
  get(from, out.axes);
}
constexpr void put(std::uint8_t* SBGC_RESTRICT to,
                   const GetAnglesExt& SBGC_RESTRICT in) noexcept {
  put(to, in.axes);
}

[[nodiscard]] constexpr Status decode(std::span<const std::uint8_t> body,
                                      GetAnglesExt& out) noexcept {
  if (body.size() < 54) return detail::wrong_size(body.size(), 54);
  get(body.data(), out);
  return detail::get_tail(body, 54, out.tail);
}

[[nodiscard]] constexpr WriteResult encode(const GetAnglesExt& in,
                                           std::span<std::uint8_t> out) noexcept {
  const std::size_t size = 54 + in.tail.size();
  if (out.size() < size) return {0, {Code::buffer_too_small}};
  put(out.data(), in);
  detail::put_tail(out.data() + 54, in.tail);
  return {size, {}};
}

/// Ask for angles, targets and joint angles.
///
/// CMD_GET_ANGLES_EXT (61), to the board; 0 bytes.
/// Effect: reads.
/// Since board 3.0.
/// Source: Outgoing commands L753-L755.
struct GetAnglesExtRequest {
  static constexpr CommandId command = CommandId::get_angles_ext;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 0;
  static constexpr std::size_t max_size = 0;
  static constexpr Availability since{0, 30};

  constexpr bool operator==(const GetAnglesExtRequest&) const = default;
};

[[nodiscard]] constexpr Status decode(std::span<const std::uint8_t> body,
                                      GetAnglesExtRequest& out) noexcept {
  if (body.size() != 0) return detail::wrong_size(body.size(), 0);
  static_cast<void>(out);
  return {};
}

[[nodiscard]] constexpr WriteResult encode(const GetAnglesExtRequest& in,
                                           std::span<std::uint8_t> out) noexcept {
  static_cast<void>(in);
  static_cast<void>(out);
  return {0, {}};
}

/// Turn the motors on.
///
/// CMD_MOTORS_ON (77), to the board; 0 bytes.
/// Effect: moves.
/// Source: Outgoing commands L724-L726.
struct MotorsOn {
  static constexpr CommandId command = CommandId::motors_on;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 0;
  static constexpr std::size_t max_size = 0;
  static constexpr Availability since{};

  constexpr bool operator==(const MotorsOn&) const = default;
};

[[nodiscard]] constexpr Status decode(std::span<const std::uint8_t> body,
                                      MotorsOn& out) noexcept {
  if (body.size() != 0) return detail::wrong_size(body.size(), 0);
  static_cast<void>(out);
  return {};
}

[[nodiscard]] constexpr WriteResult encode(const MotorsOn& in,
                                           std::span<std::uint8_t> out) noexcept {
  static_cast<void>(in);
  static_cast<void>(out);
  return {0, {}};
}

/// Turn the motors off.
///
/// CMD_MOTORS_OFF (109), to the board, simple form; 0 bytes.
/// Effect: moves.
/// Firmware 2.68b7 and later takes MotorsOffExt instead.
/// Source: Outgoing commands L728-L730.
struct MotorsOff {
  static constexpr CommandId command = CommandId::motors_off;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::simple;
  static constexpr std::size_t min_size = 0;
  static constexpr std::size_t max_size = 0;
  static constexpr Availability since{};
  static constexpr Availability until{2687, 0};

  constexpr bool operator==(const MotorsOff&) const = default;
};

[[nodiscard]] constexpr Status decode(std::span<const std::uint8_t> body,
                                      MotorsOff& out) noexcept {
  if (body.size() != 0) return detail::wrong_size(body.size(), 0);
  static_cast<void>(out);
  return {};
}

[[nodiscard]] constexpr WriteResult encode(const MotorsOff& in,
                                           std::span<std::uint8_t> out) noexcept {
  static_cast<void>(in);
  static_cast<void>(out);
  return {0, {}};
}

/// Turn the motors off, in one of several ways.
///
/// CMD_MOTORS_OFF (109), to the board, extended form; 1 byte.
/// Effect: moves.
/// Since firmware 2.68b7.
/// Source: Outgoing commands L728-L730. Errata: E205.
struct MotorsOffExt {
  static constexpr CommandId command = CommandId::motors_off;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::extended;
  static constexpr std::size_t min_size = 1;
  static constexpr std::size_t max_size = 1;
  static constexpr Availability since{2687, 0};

  /// How to turn them off. Errata: E205.
  MotorsOffMode mode{};

  constexpr bool operator==(const MotorsOffExt&) const = default;
};

constexpr void get(const std::uint8_t* SBGC_RESTRICT from,
                   MotorsOffExt& SBGC_RESTRICT out) noexcept {
  get(from, out.mode);
}
constexpr void put(std::uint8_t* SBGC_RESTRICT to,
                   const MotorsOffExt& SBGC_RESTRICT in) noexcept {
  put(to, in.mode);
}

[[nodiscard]] constexpr Status decode(std::span<const std::uint8_t> body,
                                      MotorsOffExt& out) noexcept {
  if (body.size() != 1) return detail::wrong_size(body.size(), 1);
  get(body.data(), out);
  return {};
}

[[nodiscard]] constexpr WriteResult encode(const MotorsOffExt& in,
                                           std::span<std::uint8_t> out) noexcept {
  if (out.size() < 1) return {0, {Code::buffer_too_small}};
  put(out.data(), in);
  return {1, {}};
}

/// Carry out an action of the menu.
///
/// CMD_EXECUTE_MENU (69), to the board, simple form; 1 byte.
/// Effect: sets, stores, moves, restarts.
/// Source: Outgoing commands L732-L734; Variables L1166-L1167.
struct ExecuteMenu {
  static constexpr CommandId command = CommandId::execute_menu;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::simple;
  static constexpr std::size_t min_size = 1;
  static constexpr std::size_t max_size = 1;
  static constexpr Availability since{};

  /// Which action. Errata: E105.
  MenuCommand cmd_id{};

  constexpr bool operator==(const ExecuteMenu&) const = default;
};

constexpr void get(const std::uint8_t* SBGC_RESTRICT from,
                   ExecuteMenu& SBGC_RESTRICT out) noexcept {
  get(from, out.cmd_id);
}
constexpr void put(std::uint8_t* SBGC_RESTRICT to,
                   const ExecuteMenu& SBGC_RESTRICT in) noexcept {
  put(to, in.cmd_id);
}

[[nodiscard]] constexpr Status decode(std::span<const std::uint8_t> body,
                                      ExecuteMenu& out) noexcept {
  if (body.size() != 1) return detail::wrong_size(body.size(), 1);
  get(body.data(), out);
  return {};
}

[[nodiscard]] constexpr WriteResult encode(const ExecuteMenu& in,
                                           std::span<std::uint8_t> out) noexcept {
  if (out.size() < 1) return {0, {Code::buffer_too_small}};
  put(out.data(), in);
  return {1, {}};
}

/// Carry out an action of the menu, with a parameter that later firmware takes.
///
/// CMD_EXECUTE_MENU (69), to the board, extended form; 2 bytes.
/// Effect: sets, stores, moves, restarts.
/// Source: Outgoing commands L732-L734; Variables L1166-L1167. Errata: E207.
struct ExecuteMenuExt {
  static constexpr CommandId command = CommandId::execute_menu;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::extended;
  static constexpr std::size_t min_size = 2;
  static constexpr std::size_t max_size = 2;
  static constexpr Availability since{};

  /// Which action. Errata: E105.
  MenuCommand cmd_id{};
  /// Its meaning is not documented. Errata: E207.
  std::uint8_t param{};

  constexpr bool operator==(const ExecuteMenuExt&) const = default;
};

constexpr void get(const std::uint8_t* SBGC_RESTRICT from,
                   ExecuteMenuExt& SBGC_RESTRICT out) noexcept {
  get(from, out.cmd_id);
  get(from + 1, out.param);
}
constexpr void put(std::uint8_t* SBGC_RESTRICT to,
                   const ExecuteMenuExt& SBGC_RESTRICT in) noexcept {
  put(to, in.cmd_id);
  put(to + 1, in.param);
}

[[nodiscard]] constexpr Status decode(std::span<const std::uint8_t> body,
                                      ExecuteMenuExt& out) noexcept {
  if (body.size() != 2) return detail::wrong_size(body.size(), 2);
  get(body.data(), out);
  return {};
}

[[nodiscard]] constexpr WriteResult encode(const ExecuteMenuExt& in,
                                           std::span<std::uint8_t> out) noexcept {
  if (out.size() < 2) return {0, {Code::buffer_too_small}};
  put(out.data(), in);
  return {2, {}};
}

/// Tell the board how the frame accelerates and leans.
///
/// CMD_HELPER_DATA (72), to the board, simple form; 10 bytes.
/// Effect: moves.
/// Source: Outgoing commands L736-L751; Variables L1247-L1251. Errata: E025, E091.
struct HelperData {
  static constexpr CommandId command = CommandId::helper_data;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::simple;
  static constexpr std::size_t min_size = 10;
  static constexpr std::size_t max_size = 10;
  static constexpr Availability since{};

  /// Linear acceleration of the frame; keeps the horizon level in accelerated motion. Unit: g, one
  /// count is 1/512. Errata: E042, E074, E109.
  Xyz<Acceleration> frame_acc{};
  /// Inclination of the frame to the side. Unit: deg, one count is 360/16384. Range: -32768 to
  /// 32767. 0: with FRAME_ANGLE_PITCH 0 too, not used.
  Angle14 frame_angle_roll{};
  /// Inclination of the frame forwards. Unit: deg, one count is 360/16384. Range: -32768 to 32767.
  /// 0: with FRAME_ANGLE_ROLL 0 too, not used.
  Angle14 frame_angle_pitch{};

  constexpr bool operator==(const HelperData&) const = default;
};

constexpr void get(const std::uint8_t* SBGC_RESTRICT from,
                   HelperData& SBGC_RESTRICT out) noexcept {
  using M = HelperData;
  if (!std::is_constant_evaluated() &&
      detail::in_parallel(offsetof(M, frame_acc), offsetof(M, frame_angle_pitch), 8)) {
    detail::get_block(from, out, offsetof(M, frame_acc), 10);
    return;
  }
  get(from, out.frame_acc);
  get(from + 6, out.frame_angle_roll);
  get(from + 8, out.frame_angle_pitch);
}
constexpr void put(std::uint8_t* SBGC_RESTRICT to,
                   const HelperData& SBGC_RESTRICT in) noexcept {
  using M = HelperData;
  if (!std::is_constant_evaluated() &&
      detail::in_parallel(offsetof(M, frame_acc), offsetof(M, frame_angle_pitch), 8)) {
    detail::put_block(to, in, offsetof(M, frame_acc), 10);
    return;
  }
  put(to, in.frame_acc);
  put(to + 6, in.frame_angle_roll);
  put(to + 8, in.frame_angle_pitch);
}

[[nodiscard]] constexpr Status decode(std::span<const std::uint8_t> body,
                                      HelperData& out) noexcept {
  if (body.size() != 10) return detail::wrong_size(body.size(), 10);
  get(body.data(), out);
  return {};
}

[[nodiscard]] constexpr WriteResult encode(const HelperData& in,
                                           std::span<std::uint8_t> out) noexcept {
  if (out.size() < 10) return {0, {Code::buffer_too_small}};
  put(out.data(), in);
  return {10, {}};
}

[[gnu::always_inline]] inline bool add_in_memory(detail::ByteSum& sum,
                                                 const HelperData& in) noexcept {
  using M = HelperData;
  if (!(detail::in_parallel(offsetof(M, frame_acc), offsetof(M, frame_angle_pitch), 8))) return false;
  detail::add_block(sum, in, offsetof(M, frame_acc), 10);
  return true;
}

/// Tell the board how the frame accelerates, leans and turns.
///
/// CMD_HELPER_DATA (72), to the board, extended form; 20 bytes.
/// Effect: moves.
/// Since firmware 2.59.
/// Source: Outgoing commands L736-L751; Variables L1247-L1251. Errata: E025, E091.
struct HelperDataExt {
  static constexpr CommandId command = CommandId::helper_data;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::extended;
  static constexpr std::size_t min_size = 20;
  static constexpr std::size_t max_size = 20;
  static constexpr Availability since{2590, 0};

  /// Linear acceleration of the frame; keeps the horizon level in accelerated motion. Unit: g, one
  /// count is 1/512. Errata: E042, E074, E109.
  Xyz<Acceleration> frame_acc{};
  /// Inclination of the frame to the side. Unit: deg, one count is 360/16384. Range: -32768 to
  /// 32767. 0: with FRAME_ANGLE_PITCH 0 too, not used.
  Angle14 frame_angle_roll{};
  /// Inclination of the frame forwards. Unit: deg, one count is 360/16384. Range: -32768 to 32767.
  /// 0: with FRAME_ANGLE_ROLL 0 too, not used.
  Angle14 frame_angle_pitch{};
  /// Coordinates that all the vectors are given in. Errata: E080.
  CoordinateSystem coord_sys{};
  /// Angular speed of the frame; helps without encoders and without a second IMU. Unit: deg/s, one
  /// count is 2000/32767. 0: with all three 0, not used. Errata: E071, E109.
  Xyz<GyroRate> frame_speed{};
  /// Reserved; kept as it is.
  Bytes<3> reserved{};

  constexpr bool operator==(const HelperDataExt&) const = default;
};

constexpr void get(const std::uint8_t* SBGC_RESTRICT from,
                   HelperDataExt& SBGC_RESTRICT out) noexcept {
  using M = HelperDataExt;
  if (!std::is_constant_evaluated() &&
      detail::in_parallel(offsetof(M, frame_acc), offsetof(M, coord_sys), 10) &&
      detail::in_parallel(offsetof(M, frame_speed), offsetof(M, reserved), 6)) {
    detail::get_block(from, out, offsetof(M, frame_acc), 11);
    detail::get_block(from + 11, out, offsetof(M, frame_speed), 9);
    return;
  }
  get(from, out.frame_acc);
  get(from + 6, out.frame_angle_roll);
  get(from + 8, out.frame_angle_pitch);
  get(from + 10, out.coord_sys);
  get(from + 11, out.frame_speed);
  get(from + 17, out.reserved);
}
constexpr void put(std::uint8_t* SBGC_RESTRICT to,
                   const HelperDataExt& SBGC_RESTRICT in) noexcept {
  using M = HelperDataExt;
  if (!std::is_constant_evaluated() &&
      detail::in_parallel(offsetof(M, frame_acc), offsetof(M, coord_sys), 10) &&
      detail::in_parallel(offsetof(M, frame_speed), offsetof(M, reserved), 6)) {
    detail::put_block(to, in, offsetof(M, frame_acc), 11);
    detail::put_block(to + 11, in, offsetof(M, frame_speed), 9);
    return;
  }
  put(to, in.frame_acc);
  put(to + 6, in.frame_angle_roll);
  put(to + 8, in.frame_angle_pitch);
  put(to + 10, in.coord_sys);
  put(to + 11, in.frame_speed);
  put(to + 17, in.reserved);
}

[[nodiscard]] constexpr Status decode(std::span<const std::uint8_t> body,
                                      HelperDataExt& out) noexcept {
  if (body.size() != 20) return detail::wrong_size(body.size(), 20);
  get(body.data(), out);
  return {};
}

[[nodiscard]] constexpr WriteResult encode(const HelperDataExt& in,
                                           std::span<std::uint8_t> out) noexcept {
  if (out.size() < 20) return {0, {Code::buffer_too_small}};
  put(out.data(), in);
  return {20, {}};
}

[[gnu::always_inline]] inline bool add_in_memory(detail::ByteSum& sum,
                                                 const HelperDataExt& in) noexcept {
  using M = HelperDataExt;
  if (!(detail::in_parallel(offsetof(M, frame_acc), offsetof(M, coord_sys), 10) &&
      detail::in_parallel(offsetof(M, frame_speed), offsetof(M, reserved), 6))) return false;
  detail::add_block(sum, in, offsetof(M, frame_acc), 11);
  detail::add_block(sum, in, offsetof(M, frame_speed), 9);
  return true;
}

/// What says the same to firmware that no longer takes the message.
constexpr MotorsOffExt later_form(const MotorsOff&) noexcept {
  MotorsOffExt later{};
  return later;
}

}  // namespace sbgc::msg
