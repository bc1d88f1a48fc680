// Generated from spec/ by generator/: edit those, then run ./dev generate.

/// Run-time metadata of the messages in <sbgc/messages/debug.hpp>.
#pragma once

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
      {.name = "var_name",
       .spec_name = "VAR_NAME",
       .summary = "Name of the variable."},
      {.name = "var_type",
       .spec_name = "VAR_TYPE",
       .summary = "Its type."},
      {.name = "arr_size",
       .spec_name = "ARR_SIZE",
       .summary = "Number of elements; no board is known to send arrays.",
       .special = arr_size_special},
  };

  /// Calls `visitor(field, member)` for each member in wire order.
  template <class T, class Visitor>
  static constexpr void visit(T& value, Visitor&& visitor) {
    visitor(fields[0], value.var_name);
    visitor(fields[1], value.var_type);
    visitor(fields[2], value.arr_size);
  }
};

template <>
struct Meta<msg::DebugVarsInfo3> {
  static constexpr MessageInfo info{
      .name = "DebugVarsInfo3",
      .command = "CMD_DEBUG_VARS_INFO_3",
      .summary = "Names and types of the debug variables, in the order of CMD_DEBUG_VARS_3.",
      .id = 253,
      .direction = Direction::from_board,
      .min_size = 1,
      .max_size = 255,
      .since = {.board = 30}};
  static constexpr Range debug_vars_num_range{1, 255};
  static constexpr FieldInfo fields[] = {
      {.name = "debug_vars_num",
       .spec_name = "DEBUG_VARS_NUM",
       .summary = "Number of variables that follow.",
       .range = &debug_vars_num_range},
      {.name = "vars",
       .spec_name = "vars",
       .summary = "The variables."},
  };

  /// Calls `visitor(field, member)` for each member in wire order.
  template <class T, class Visitor>
  static constexpr void visit(T& value, Visitor&& visitor) {
    visitor(fields[0], Counter{value.vars.size()});
    visitor(fields[1], value.vars);
    visitor(tail_field, value.tail);
  }
};

template <>
struct Meta<msg::DebugVarsInfo3Request> {
  static constexpr const char* answers[] = {"DebugVarsInfo3"};
  static constexpr MessageInfo info{
      .name = "DebugVarsInfo3Request",
      .command = "CMD_DEBUG_VARS_INFO_3",
      .summary = "Request the names and types of the debug variables.",
      .id = 253,
      .direction = Direction::to_board,
      .min_size = 0,
      .max_size = 0,
      .since = {.board = 30},
      .answers = answers,
      .effects = Effects(Effect::reads)};

  /// Calls `visitor(field, member)` for each member in wire order.
  template <class T, class Visitor>
  static constexpr void visit(T&, Visitor&&) {
  }
};

template <>
struct Meta<msg::DebugVars3> {
  static constexpr MessageInfo info{
      .name = "DebugVars3",
      .command = "CMD_DEBUG_VARS_3",
      .summary = "Values of the debug variables.",
      .id = 254,
      .direction = Direction::from_board,
      .min_size = 0,
      .max_size = 255,
      .since = {.board = 30}};
  static constexpr FieldInfo fields[] = {
      {.name = "var_value",
       .spec_name = "VAR_VALUE",
       .summary = "The values in sequence, each with the type and the number of elements announced by CMD_DEBUG_VARS_INFO_3. The set of variables depends on the firmware."},
  };

  /// Calls `visitor(field, member)` for each member in wire order.
  template <class T, class Visitor>
  static constexpr void visit(T& value, Visitor&& visitor) {
    visitor(fields[0], value.var_value);
    visitor(tail_field, value.tail);
  }
};

template <>
struct Meta<msg::DebugVars3Request> {
  static constexpr const char* answers[] = {"DebugVars3"};
  static constexpr MessageInfo info{
      .name = "DebugVars3Request",
      .command = "CMD_DEBUG_VARS_3",
      .summary = "Request the values of the debug variables.",
      .id = 254,
      .direction = Direction::to_board,
      .min_size = 0,
      .max_size = 0,
      .since = {.board = 30},
      .answers = answers,
      .effects = Effects(Effect::reads)};

  /// Calls `visitor(field, member)` for each member in wire order.
  template <class T, class Visitor>
  static constexpr void visit(T&, Visitor&&) {
  }
};

}  // namespace sbgc
