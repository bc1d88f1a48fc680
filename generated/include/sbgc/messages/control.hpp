// Generated from spec/ by generator/: edit those, then run ./dev generate.

/// Moving the camera and querying its orientation.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include <sbgc/codec.hpp>
#include <sbgc/enums.hpp>
#include <sbgc/flag_unit.hpp>
#include <sbgc/response.hpp>
#include <sbgc/units.hpp>

namespace sbgc::msg {

static_assert(codec_version == 2, "generated code and runtime do not match");

struct GetAngles;
struct GetAnglesExt;

/// Target of each axis.
struct ControlAxis {
  /// Speed of the motion; the acceleration limit in the parameters may restrict it. Unit: deg/s.
  /// Interpreted as FineSpeed if CONTROL_FLAG_HIGH_RES_SPEED is set.
  ControlSpeed speed{};
  /// Target angle; in MODE_RC the RC signal, -500 to 500. Unit: deg.
  Angle14 angle{};

  bool operator==(const ControlAxis&) const = default;
  using FixedMembers = Members<&ControlAxis::speed, &ControlAxis::angle>;
};

/// State of each axis.
struct AxisState {
  /// Measured angle; wraps after two full turns. Unit: deg.
  Angle14 imu_angle{};
  /// Target angle, set by RC or by control commands. Unit: deg.
  Angle14 rc_target_angle{};
  /// Target speed; 0 once the target is reached. Unit: deg/s.
  ControlSpeed rc_speed{};

  bool operator==(const AxisState&) const = default;
  using FixedMembers = Members<&AxisState::imu_angle, &AxisState::rc_target_angle,
      &AxisState::rc_speed>;
};

/// State of each axis.
struct AxisStateExt {
  /// Measured angle; wraps after two full turns. Unit: deg.
  Angle14 imu_angle{};
  /// Target angle. Unit: deg.
  Angle14 rc_target_angle{};
  /// Angle of the joint, from an encoder or the second IMU; 0 in the normal position, accumulated
  /// over full turns. Unit: deg.
  LongAngle14 stator_rotor_angle{};
  /// Reserved; kept as it is.
  Bytes<10> reserved{};

  bool operator==(const AxisStateExt&) const = default;
  using FixedMembers = Members<&AxisStateExt::imu_angle, &AxisStateExt::rc_target_angle,
      &AxisStateExt::stator_rotor_angle, &AxisStateExt::reserved>;
};

/// Move the camera, with one mode for all axes. Overrides RC until a command with MODE_NO_CONTROL
/// and zeros. Send at most 50 per second. A board keeps the last speed when the link is lost. The
/// command sets a target or a speed, never a step, so it may be repeated; the last one counts.
///
/// CMD_CONTROL (67), to the board, simple form; 13 bytes. Effect: moves. Source: Outgoing commands
/// L694-L715; Variables L1147-L1152.
struct Control {
  static constexpr CommandToBoard command = CommandToBoard::control;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::simple;
  static constexpr std::size_t min_size = 13;
  static constexpr std::size_t max_size = 13;
  static constexpr Availability since{};
  using Response = void;

  /// Mode of all three axes.
  ControlMode control_mode{};
  /// Target of each axis.
  Axes<ControlAxis> axes{};

  /// Returns the physical value of speed of an element in deg/s; CONTROL_FLAG_HIGH_RES_SPEED
  /// selects its unit on the wire.
  constexpr double real_speed(std::size_t index) const noexcept {
    return detail::real_in_unit<FineSpeed>(axes[index].speed, control_mode, 0x80);
  }
  /// Sets speed of an element and the flag that selects its unit. Returns false and changes nothing
  /// if another element has a value in the other unit.
  [[nodiscard]] constexpr bool set_speed(std::size_t index, ControlSpeed value) noexcept {
    return detail::set_in_common_unit(
        axes, index, [](auto& one) -> auto& { return one.speed; }, value, control_mode, 0x80, false);
  }
  [[nodiscard]] constexpr bool set_speed(std::size_t index, FineSpeed value) noexcept {
    return detail::set_in_common_unit(
        axes, index, [](auto& one) -> auto& { return one.speed; }, value, control_mode, 0x80, true);
  }
  /// As above, in the usual unit.
  template <std::int64_t numerator, std::int64_t denominator>
  [[nodiscard]] constexpr bool set_speed(
      std::size_t index, Physical<ControlSpeed::unit_type, numerator, denominator> value) noexcept {
    return set_speed(index, ControlSpeed(value));
  }

  bool operator==(const Control&) const = default;
  using FixedMembers = Members<&Control::control_mode, &Control::axes>;
};

/// Move the camera, with a mode for each axis. Overrides RC until a command with MODE_NO_CONTROL
/// and zeros. Send at most 50 per second. A board keeps the last speed when the link is lost. The
/// command sets a target or a speed, never a step, so it may be repeated; the last one counts.
///
/// CMD_CONTROL (67), to the board, extended form; 15 bytes. Effect: moves. Since firmware 2.55b5.
/// Source: Outgoing commands L694-L715; Variables L1147-L1152.
struct ControlExt {
  static constexpr CommandToBoard command = CommandToBoard::control;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::extended;
  static constexpr std::size_t min_size = 15;
  static constexpr std::size_t max_size = 15;
  static constexpr Availability since{.firmware = 2555};
  using Response = void;

  /// Mode of each axis.
  Axes<ControlMode> control_mode{};
  /// Target of each axis.
  Axes<ControlAxis> axes{};

  /// Returns the physical value of speed of an element in deg/s; CONTROL_FLAG_HIGH_RES_SPEED
  /// selects its unit on the wire.
  constexpr double real_speed(std::size_t index) const noexcept {
    return detail::real_in_unit<FineSpeed>(axes[index].speed, control_mode[index], 0x80);
  }
  /// Sets speed of an element and the flag that selects its unit.
  constexpr void set_speed(std::size_t index, ControlSpeed value) noexcept {
    detail::set_in_unit(axes[index].speed, value, control_mode[index], 0x80, false);
  }
  constexpr void set_speed(std::size_t index, FineSpeed value) noexcept {
    detail::set_in_unit(axes[index].speed, value, control_mode[index], 0x80, true);
  }
  /// As above, in the usual unit.
  template <std::int64_t numerator, std::int64_t denominator>
  constexpr void set_speed(
      std::size_t index, Physical<ControlSpeed::unit_type, numerator, denominator> value) noexcept {
    set_speed(index, ControlSpeed(value));
  }

  bool operator==(const ControlExt&) const = default;
  using FixedMembers = Members<&ControlExt::control_mode, &ControlExt::axes>;
};

/// Camera angles and targets.
///
/// CMD_GET_ANGLES (73), from the board; 18 bytes, and later firmware may append more. Source:
/// Incoming commands L428-L434; Variables L1156-L1161.
struct GetAngles {
  static constexpr CommandFromBoard command = CommandFromBoard::get_angles;
  static constexpr Direction direction = Direction::from_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 18;
  static constexpr std::size_t max_size = 18;
  static constexpr Availability since{};

  /// State of each axis.
  Axes<AxisState> axes{};
  /// Bytes appended by later firmware; preserved and written back.
  BoundedBytes<237> tail{};

  bool operator==(const GetAngles&) const = default;
  using FixedMembers = Members<&GetAngles::axes>;
};

/// Request camera angles and targets.
///
/// CMD_GET_ANGLES (73), to the board; 0 bytes. Effect: reads. Source: Outgoing commands L753-L755.
struct GetAnglesRequest {
  static constexpr CommandToBoard command = CommandToBoard::get_angles;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 0;
  static constexpr std::size_t max_size = 0;
  static constexpr Availability since{};
  using Response = GetAngles;

  bool operator==(const GetAnglesRequest&) const = default;
};

/// Camera angles, targets and joint angles.
///
/// CMD_GET_ANGLES_EXT (61), from the board; 54 bytes, and later firmware may append more. Since
/// board 3.0. Source: Incoming commands L436-L443; Variables L1162-L1165.
struct GetAnglesExt {
  static constexpr CommandFromBoard command = CommandFromBoard::get_angles_ext;
  static constexpr Direction direction = Direction::from_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 54;
  static constexpr std::size_t max_size = 54;
  static constexpr Availability since{.board = 30};

  /// State of each axis.
  Axes<AxisStateExt> axes{};
  /// Bytes appended by later firmware; preserved and written back.
  BoundedBytes<201> tail{};

  bool operator==(const GetAnglesExt&) const = default;
  using FixedMembers = Members<&GetAnglesExt::axes>;
};

/// Request angles, targets and joint angles.
///
/// CMD_GET_ANGLES_EXT (61), to the board; 0 bytes. Effect: reads. Since board 3.0. Source: Outgoing
/// commands L753-L755.
struct GetAnglesExtRequest {
  static constexpr CommandToBoard command = CommandToBoard::get_angles_ext;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 0;
  static constexpr std::size_t max_size = 0;
  static constexpr Availability since{.board = 30};
  using Response = GetAnglesExt;

  bool operator==(const GetAnglesExtRequest&) const = default;
};

/// Turn the motors on.
///
/// CMD_MOTORS_ON (77), to the board; 0 bytes. Effect: moves. Source: Outgoing commands L724-L726.
struct MotorsOn {
  static constexpr CommandToBoard command = CommandToBoard::motors_on;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 0;
  static constexpr std::size_t max_size = 0;
  static constexpr Availability since{};
  using Response = void;

  bool operator==(const MotorsOn&) const = default;
};

/// Turn the motors off.
///
/// CMD_MOTORS_OFF (109), to the board, simple form; 0 bytes. Effect: moves. Firmware 2.68b7 and
/// later accepts MotorsOffExt instead. Source: Outgoing commands L728-L730.
struct MotorsOff {
  static constexpr CommandToBoard command = CommandToBoard::motors_off;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::simple;
  static constexpr std::size_t min_size = 0;
  static constexpr std::size_t max_size = 0;
  static constexpr Availability since{};
  static constexpr Availability until{.firmware = 2687};
  using Response = void;

  bool operator==(const MotorsOff&) const = default;
};

/// Turn the motors off, in one of several ways.
///
/// CMD_MOTORS_OFF (109), to the board, extended form; 1 byte. Effect: moves. Since firmware 2.68b7.
/// Source: Outgoing commands L728-L730.
struct MotorsOffExt {
  static constexpr CommandToBoard command = CommandToBoard::motors_off;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::extended;
  static constexpr std::size_t min_size = 1;
  static constexpr std::size_t max_size = 1;
  static constexpr Availability since{.firmware = 2687};
  using Response = void;

  /// How to turn them off.
  MotorsOffMode mode{};

  bool operator==(const MotorsOffExt&) const = default;
  using FixedMembers = Members<&MotorsOffExt::mode>;
};

/// Execute a menu action.
///
/// CMD_EXECUTE_MENU (69), to the board, simple form; 1 byte. Effect: sets, stores, moves, restarts.
/// Source: Outgoing commands L732-L734; Variables L1166-L1167.
struct ExecuteMenu {
  static constexpr CommandToBoard command = CommandToBoard::execute_menu;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::simple;
  static constexpr std::size_t min_size = 1;
  static constexpr std::size_t max_size = 1;
  static constexpr Availability since{};
  using Response = void;

  /// Which action.
  MenuCommand cmd_id{};

  bool operator==(const ExecuteMenu&) const = default;
  using FixedMembers = Members<&ExecuteMenu::cmd_id>;
};

/// Execute a menu action, with a parameter of later firmware.
///
/// CMD_EXECUTE_MENU (69), to the board, extended form; 2 bytes. Effect: sets, stores, moves,
/// restarts. Source: Outgoing commands L732-L734; Variables L1166-L1167.
struct ExecuteMenuExt {
  static constexpr CommandToBoard command = CommandToBoard::execute_menu;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::extended;
  static constexpr std::size_t min_size = 2;
  static constexpr std::size_t max_size = 2;
  static constexpr Availability since{};
  using Response = void;

  /// Which action.
  MenuCommand cmd_id{};
  /// Its meaning is not documented.
  std::uint8_t param{};

  bool operator==(const ExecuteMenuExt&) const = default;
  using FixedMembers = Members<&ExecuteMenuExt::cmd_id, &ExecuteMenuExt::param>;
};

/// Report acceleration and tilt of the frame to the board.
///
/// CMD_HELPER_DATA (72), to the board, simple form; 10 bytes. Effect: moves. Source: Outgoing
/// commands L736-L751; Variables L1247-L1251.
struct HelperData {
  static constexpr CommandToBoard command = CommandToBoard::helper_data;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::simple;
  static constexpr std::size_t min_size = 10;
  static constexpr std::size_t max_size = 10;
  static constexpr Availability since{};
  using Response = void;

  /// Linear acceleration of the frame; keeps the horizon level during acceleration. Unit: g.
  Xyz<Acceleration> frame_acc{};
  /// Sideways tilt of the frame. Unit: deg. 0: with FRAME_ANGLE_PITCH 0 too, not used.
  Angle14 frame_angle_roll{};
  /// Forward tilt of the frame. Unit: deg. 0: with FRAME_ANGLE_ROLL 0 too, not used.
  Angle14 frame_angle_pitch{};

  bool operator==(const HelperData&) const = default;
  using FixedMembers = Members<&HelperData::frame_acc, &HelperData::frame_angle_roll,
      &HelperData::frame_angle_pitch>;
};

/// Report acceleration, tilt and rotation of the frame to the board.
///
/// CMD_HELPER_DATA (72), to the board, extended form; 20 bytes. Effect: moves. Since firmware 2.59.
/// Source: Outgoing commands L736-L751; Variables L1247-L1251.
struct HelperDataExt {
  static constexpr CommandToBoard command = CommandToBoard::helper_data;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::extended;
  static constexpr std::size_t min_size = 20;
  static constexpr std::size_t max_size = 20;
  static constexpr Availability since{.firmware = 2590};
  using Response = void;

  /// Linear acceleration of the frame; keeps the horizon level during acceleration. Unit: g.
  Xyz<Acceleration> frame_acc{};
  /// Sideways tilt of the frame. Unit: deg. 0: with FRAME_ANGLE_PITCH 0 too, not used.
  Angle14 frame_angle_roll{};
  /// Forward tilt of the frame. Unit: deg. 0: with FRAME_ANGLE_ROLL 0 too, not used.
  Angle14 frame_angle_pitch{};
  /// Coordinate system of all the vectors.
  CoordinateSystem coord_sys{};
  /// Angular speed of the frame; useful without encoders and a second IMU. Unit: deg/s. 0: with all
  /// three 0, not used.
  Xyz<GyroRate> frame_speed{};
  /// Reserved; kept as it is.
  Bytes<3> reserved{};

  bool operator==(const HelperDataExt&) const = default;
  using FixedMembers = Members<&HelperDataExt::frame_acc, &HelperDataExt::frame_angle_roll,
      &HelperDataExt::frame_angle_pitch, &HelperDataExt::coord_sys, &HelperDataExt::frame_speed,
      &HelperDataExt::reserved>;
};

/// Returns the equivalent message for firmware that no longer accepts this one.
constexpr MotorsOffExt later_form(const MotorsOff&) noexcept {
  MotorsOffExt later{};
  return later;
}

}  // namespace sbgc::msg
