// Generated from spec/ by generator/: edit those, then run ./dev generate.

/// Run-time metadata of the messages in <sbgc/messages/debug.hpp>.
#pragma once

#include <cstddef>

#include <sbgc/internal/table.hpp>
#include <sbgc/messages/debug.hpp>
#include <sbgc/meta.hpp>
#include <sbgc/meta/enums.hpp>
#include <sbgc/meta/units.hpp>

namespace sbgc {

template <>
struct Meta<msg::DebugVarInfo> {
  static constexpr Special arr_size_special[] = {
      {0, "a scalar"},
      {1, "a scalar"},
  };
  static constexpr FieldInfo fields[] = {
      {.name = "var_name", .spec_name = "VAR_NAME", .summary = "Name of the variable."},
      {.name = "var_type", .spec_name = "VAR_TYPE", .summary = "Its type."},
      {.name = "arr_size", .spec_name = "ARR_SIZE",
       .summary = "Number of elements; no board is known to send arrays.",
       .special = arr_size_special},
  };
  template <class T> static constexpr detail::Slot slots[] = {
      {offsetof(T, var_name), &detail::value_type<decltype(T::var_name)>},
      {offsetof(T, var_type), &detail::value_type<decltype(T::var_type)>},
      {offsetof(T, arr_size), &detail::value_type<decltype(T::arr_size)>},
  };

  static constexpr void visit(auto& value, auto&& visitor) {
    visitor(fields[0], value.var_name);
    visitor(fields[1], value.var_type);
    visitor(fields[2], value.arr_size);
  }
};

template <>
struct Meta<msg::DebugVarsInfo3> {
  static constexpr MessageInfo info{
      .name = "DebugVarsInfo3", .command = "CMD_DEBUG_VARS_INFO_3",
      .summary = "Names and types of the debug variables, in the order of CMD_DEBUG_VARS_3.",
      .id = 253, .direction = Direction::from_board, .min_size = 1, .max_size = 255,
      .since = {.board = 30}};
  static constexpr Range debug_vars_num_range{1, 255};
  static constexpr FieldInfo fields[] = {
      {.name = "debug_vars_num", .spec_name = "DEBUG_VARS_NUM",
       .summary = "Number of variables that follow.", .range = &debug_vars_num_range},
      {.name = "vars", .spec_name = "vars", .summary = "The variables."},
  };
  template <class T> static constexpr detail::Slot slots[] = {
      {offsetof(T, vars), &detail::counter_type<decltype(T::vars)>},
      {offsetof(T, vars), &detail::value_type<decltype(T::vars)>},
  };

  static constexpr void visit(auto& value, auto&& visitor) {
    visitor(fields[0], Counter{value.vars.size()});
    visitor(fields[1], value.vars);
    visitor(tail_field, value.tail);
  }
};

template <>
struct Meta<msg::DebugVarsInfo3Request> {
  static constexpr const char* answers[] = {"DebugVarsInfo3"};
  static constexpr MessageInfo info{
      .name = "DebugVarsInfo3Request", .command = "CMD_DEBUG_VARS_INFO_3",
      .summary = "Request the names and types of the debug variables.", .id = 253,
      .direction = Direction::to_board, .min_size = 0, .max_size = 1, .since = {.board = 30},
      .answers = answers, .effects = Effects(Effect::reads)};
  static constexpr FieldInfo fields[] = {
      {.name = "start_idx", .spec_name = "START_IDX",
       .summary = "First variable to describe, if there are several pages; the last one is empty.",
       .since = {.firmware = 2720}},
  };
  template <class T> static constexpr detail::Slot slots[] = {
      {offsetof(T, start_idx), &detail::value_type<decltype(T::start_idx)>},
  };

  static constexpr void visit(auto& value, auto&& visitor) {
    visitor(fields[0], value.start_idx);
  }
};

template <>
struct Meta<msg::DebugVars3> {
  static constexpr MessageInfo info{
      .name = "DebugVars3", .command = "CMD_DEBUG_VARS_3",
      .summary = "Values of the debug variables.", .id = 254, .direction = Direction::from_board,
      .min_size = 0, .max_size = 255, .since = {.board = 30}};
  static constexpr FieldInfo fields[] = {
      {.name = "var_value", .spec_name = "VAR_VALUE",
       .summary = "The values in sequence, each with the type and the number of elements announced by CMD_DEBUG_VARS_INFO_3. The set of variables depends on the firmware."},
  };
  template <class T> static constexpr detail::Slot slots[] = {
      {offsetof(T, var_value), &detail::value_type<decltype(T::var_value)>},
  };

  static constexpr void visit(auto& value, auto&& visitor) {
    visitor(fields[0], value.var_value);
    visitor(tail_field, value.tail);
  }
};

template <>
struct Meta<msg::DebugVars3Request> {
  static constexpr const char* answers[] = {"DebugVars3"};
  static constexpr MessageInfo info{
      .name = "DebugVars3Request", .command = "CMD_DEBUG_VARS_3",
      .summary = "Request the values of the debug variables.", .id = 254,
      .direction = Direction::to_board, .min_size = 0, .max_size = 0, .since = {.board = 30},
      .answers = answers, .effects = Effects(Effect::reads)};

  static constexpr void visit(auto&, auto&&) {
  }
};

template <>
struct Meta<msg::DebugVars3RequestSelected> {
  static constexpr MessageInfo info{
      .name = "DebugVars3RequestSelected", .command = "CMD_DEBUG_VARS_3",
      .summary = "Request the values of selected debug variables.", .id = 254,
      .direction = Direction::to_board, .min_size = 4, .max_size = 32, .since = {.firmware = 2720},
      .effects = Effects(Effect::reads)};
  static constexpr FieldInfo fields[] = {
      {.name = "selected_mask", .spec_name = "SELECTED_MASK",
       .summary = "Bits of the selected variables, starting with the first variable.",
       .min_count = 1, .max_count = 8},
  };
  template <class T> static constexpr detail::Slot slots[] = {
      {offsetof(T, selected_mask), &detail::value_type<decltype(T::selected_mask)>},
  };

  static constexpr void visit(auto& value, auto&& visitor) {
    visitor(fields[0], value.selected_mask);
  }
};

template <>
struct Meta<msg::SetDebugPort> {
  static constexpr MessageInfo info{
      .name = "SetDebugPort", .command = "CMD_SET_DEBUG_PORT",
      .summary = "Copy of a message on another port of the board.", .id = 249,
      .direction = Direction::from_board, .min_size = 4, .max_size = 255,
      .since = {.firmware = 2600}};
  static constexpr FieldInfo fields[] = {
      {.name = "time_ms", .spec_name = "TIME_MS", .summary = "Time since the board started.",
       .unit = &UnitMeta<msg::MillisecondClock>::info},
      {.name = "port_and_dir", .spec_name = "PORT_AND_DIR",
       .summary = "Port and direction of the message."},
      {.name = "cmd_id", .spec_name = "CMD_ID", .summary = "Command of the message."},
      {.name = "payload", .spec_name = "PAYLOAD", .summary = "Body of the message."},
  };
  template <class T> static constexpr detail::Slot slots[] = {
      {offsetof(T, time_ms), &detail::value_type<decltype(T::time_ms)>},
      {offsetof(T, port_and_dir), &detail::value_type<decltype(T::port_and_dir)>},
      {offsetof(T, cmd_id), &detail::value_type<decltype(T::cmd_id)>},
      {offsetof(T, payload), &detail::value_type<decltype(T::payload)>},
  };

  static constexpr void visit(auto& value, auto&& visitor) {
    visitor(fields[0], value.time_ms);
    visitor(fields[1], value.port_and_dir);
    visitor(fields[2], value.cmd_id);
    visitor(fields[3], value.payload);
  }
};

template <>
struct Meta<msg::SetDebugPortRequest> {
  static constexpr MessageInfo info{
      .name = "SetDebugPortRequest", .command = "CMD_SET_DEBUG_PORT",
      .summary = "Start or stop the copies of the messages on the board's other ports.", .id = 249,
      .direction = Direction::to_board, .min_size = 16, .max_size = 16, .since = {.firmware = 2600},
      .effects = Effects(Effect::sets)};
  static constexpr FieldInfo fields[] = {
      {.name = "action", .spec_name = "ACTION", .summary = "Operation."},
      {.name = "cmd_filter", .spec_name = "CMD_FILTER", .summary = "Messages that are not copied.",
       .since = {.features = 0x100000000}},
      {.name = "reserved", .spec_name = "RESERVED", .summary = "Reserved; kept as it is.",
       .reserved = true},
  };
  template <class T> static constexpr detail::Slot slots[] = {
      {offsetof(T, action), &detail::value_type<decltype(T::action)>},
      {offsetof(T, cmd_filter), &detail::value_type<decltype(T::cmd_filter)>},
      {offsetof(T, reserved), &detail::value_type<decltype(T::reserved)>},
  };

  static constexpr void visit(auto& value, auto&& visitor) {
    visitor(fields[0], value.action);
    visitor(fields[1], value.cmd_filter);
    visitor(fields[2], value.reserved);
  }
};

}  // namespace sbgc
