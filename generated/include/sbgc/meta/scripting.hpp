// Generated from spec/ by generator/: edit those, then run ./dev generate.

/// Run-time metadata of the messages in <sbgc/messages/scripting.hpp>.
#pragma once

#include <cstddef>

#include <sbgc/internal/table.hpp>
#include <sbgc/messages/scripting.hpp>
#include <sbgc/meta.hpp>
#include <sbgc/meta/enums.hpp>
#include <sbgc/meta/units.hpp>

namespace sbgc {

template <>
struct Meta<msg::RunScript> {
  static constexpr MessageInfo info{
      .name = "RunScript", .command = "CMD_RUN_SCRIPT", .summary = "Start or stop a script.",
      .id = 57, .direction = Direction::to_board, .min_size = 34, .max_size = 34,
      .since = {.board = 30},
      .effects = Effects(Effect::sets) | Effect::stores | Effect::moves | Effect::restarts};
  static constexpr FieldInfo fields[] = {
      {.name = "mode", .spec_name = "MODE", .summary = "Operation."},
      {.name = "slot", .spec_name = "SLOT", .summary = "Script slot, counted from 0."},
      {.name = "reserved", .spec_name = "RESERVED", .summary = "Reserved; kept as it is.",
       .reserved = true},
  };
  template <class T> static constexpr detail::Slot slots[] = {
      {offsetof(T, mode), &detail::value_type<decltype(T::mode)>},
      {offsetof(T, slot), &detail::value_type<decltype(T::slot)>},
      {offsetof(T, reserved), &detail::value_type<decltype(T::reserved)>},
  };

  static constexpr void visit(auto& value, auto&& visitor) {
    visitor(fields[0], value.mode);
    visitor(fields[1], value.slot);
    visitor(fields[2], value.reserved);
  }
};

template <>
struct Meta<msg::ScriptDebug> {
  static constexpr MessageInfo info{
      .name = "ScriptDebug", .command = "CMD_SCRIPT_DEBUG",
      .summary = "Progress of a script started with debugging.", .id = 58,
      .direction = Direction::from_board, .min_size = 3, .max_size = 3, .since = {.board = 30}};
  static constexpr FieldInfo fields[] = {
      {.name = "cmd_count", .spec_name = "CMD_COUNT",
       .summary = "Number of the running script command."},
      {.name = "err_code", .spec_name = "ERR_CODE",
       .summary = "Error code; unlisted codes are possible."},
  };
  template <class T> static constexpr detail::Slot slots[] = {
      {offsetof(T, cmd_count), &detail::value_type<decltype(T::cmd_count)>},
      {offsetof(T, err_code), &detail::value_type<decltype(T::err_code)>},
  };

  static constexpr void visit(auto& value, auto&& visitor) {
    visitor(fields[0], value.cmd_count);
    visitor(fields[1], value.err_code);
    visitor(tail_field, value.tail);
  }
};

}  // namespace sbgc
