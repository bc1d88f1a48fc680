// Generated from spec/ by generator/: edit those, then run ./dev generate.

/// Run-time metadata of the messages in <sbgc/messages/adjustable_variables.hpp>.
#pragma once

#include <cstddef>

#include <sbgc/internal/table.hpp>
#include <sbgc/messages/adjustable_variables.hpp>
#include <sbgc/meta.hpp>
#include <sbgc/meta/enums.hpp>
#include <sbgc/meta/units.hpp>

namespace sbgc {

template <>
struct Meta<msg::AdjVarValue> {
  static constexpr FieldInfo fields[] = {
      {.name = "param_id", .spec_name = "PARAM_ID", .summary = "The variable (Appendix B)."},
      {.name = "param_value", .spec_name = "PARAM_VALUE",
       .summary = "The value, extended to 32 bits whatever the type of the variable.",
       .is_variable_value = true},
  };
  template <class T> static constexpr detail::Slot slots[] = {
      {offsetof(T, param_id), &detail::value_type<decltype(T::param_id)>},
      {offsetof(T, param_value), &detail::value_type<decltype(T::param_value)>},
  };

  static constexpr void visit(auto& value, auto&& visitor) {
    visitor(fields[0], value.param_id);
    visitor(fields[1], value.param_value);
  }
};

template <>
struct Meta<msg::TriggerSlot> {
  static constexpr FieldInfo fields[] = {
      {.name = "src_ch", .spec_name = "SRC_CH", .summary = "RC signal.",
       .saved_as = "adj__vars__trigger/src__ch"},
      {.name = "action", .spec_name = "ACTION{1..5}", .summary = "Action of each signal level.",
       .saved_as = "adj__vars__trigger/action"},
  };
  template <class T> static constexpr detail::Slot slots[] = {
      {offsetof(T, src_ch), &detail::value_type<decltype(T::src_ch)>},
      {offsetof(T, action), &detail::value_type<decltype(T::action)>},
  };

  static constexpr void visit(auto& value, auto&& visitor) {
    visitor(fields[0], value.src_ch);
    visitor(fields[1], value.action);
  }
};

template <>
struct Meta<msg::AnalogSlot> {
  static constexpr FieldInfo fields[] = {
      {.name = "src_ch", .spec_name = "SRC_CH", .summary = "RC signal."},
      {.name = "param_id", .spec_name = "PARAM_ID", .summary = "Variable to change (Appendix B)."},
      {.name = "min_val", .spec_name = "MIN_VAL",
       .summary = "Start of the working range, as a fraction of the variable's range."},
      {.name = "max_val", .spec_name = "MAX_VAL",
       .summary = "End of the working range, as a fraction of the variable's range."},
  };
  template <class T> static constexpr detail::Slot slots[] = {
      {offsetof(T, src_ch), &detail::value_type<decltype(T::src_ch)>},
      {offsetof(T, param_id), &detail::value_type<decltype(T::param_id)>},
      {offsetof(T, min_val), &detail::value_type<decltype(T::min_val)>},
      {offsetof(T, max_val), &detail::value_type<decltype(T::max_val)>},
  };

  static constexpr void visit(auto& value, auto&& visitor) {
    visitor(fields[0], value.src_ch);
    visitor(fields[1], value.param_id);
    visitor(fields[2], value.min_val);
    visitor(fields[3], value.max_val);
  }
};

template <>
struct Meta<msg::AdjVarInfo> {
  static constexpr FieldInfo fields[] = {
      {.name = "var_id", .spec_name = "VAR_ID", .summary = "The variable."},
      {.name = "name", .spec_name = "NAME", .summary = "Its name, at most 16 characters."},
      {.name = "range_min", .spec_name = "RANGE_MIN", .summary = "Its lowest value."},
      {.name = "range_max", .spec_name = "RANGE_MAX", .summary = "Its highest value."},
      {.name = "value", .spec_name = "VALUE", .summary = "Its value.", .is_variable_value = true},
  };
  template <class T> static constexpr detail::Slot slots[] = {
      {offsetof(T, var_id), &detail::value_type<decltype(T::var_id)>},
      {offsetof(T, name), &detail::value_type<decltype(T::name)>},
      {offsetof(T, range_min), &detail::value_type<decltype(T::range_min)>},
      {offsetof(T, range_max), &detail::value_type<decltype(T::range_max)>},
      {offsetof(T, value), &detail::value_type<decltype(T::value)>},
  };

  static constexpr void visit(auto& value, auto&& visitor) {
    visitor(fields[0], value.var_id);
    visitor(fields[1], value.name);
    visitor(fields[2], value.range_min);
    visitor(fields[3], value.range_max);
    visitor(fields[4], value.value);
  }
  /// Calls `check(field, low, field, high, is_strict)` for each rule that low is not above high.
  template <class T, class Check>
  static constexpr void rules(const T& value, Check&& check) {
    check(fields[2], value.range_min, fields[3], value.range_max, false);
  }
};

template <>
struct Meta<msg::AdjVarFloat> {
  static constexpr FieldInfo fields[] = {
      {.name = "id", .spec_name = "ID", .summary = "The variable (Appendix B)."},
      {.name = "value", .spec_name = "VALUE", .summary = "The value."},
  };
  template <class T> static constexpr detail::Slot slots[] = {
      {offsetof(T, id), &detail::value_type<decltype(T::id)>},
      {offsetof(T, value), &detail::value_type<decltype(T::value)>},
  };

  static constexpr void visit(auto& value, auto&& visitor) {
    visitor(fields[0], value.id);
    visitor(fields[1], value.value);
  }
};

template <>
struct Meta<msg::SetAdjVarsVal> {
  static constexpr MessageInfo info{
      .name = "SetAdjVarsVal", .command = "CMD_SET_ADJ_VARS_VAL",
      .summary = "Values of adjustable variables.", .id = 31, .direction = Direction::both,
      .min_size = 1, .max_size = 201, .since = {.board = 30},
      .effects = Effects(Effect::sets) | Effect::moves};
  static constexpr Range num_vars_range{1, 40};
  static constexpr FieldInfo fields[] = {
      {.name = "num_vars", .spec_name = "NUM_VARS", .summary = "Number of variables that follow.",
       .range = &num_vars_range},
      {.name = "params", .spec_name = "params", .summary = "The variables."},
  };
  template <class T> static constexpr detail::Slot slots[] = {
      {offsetof(T, params), &detail::counter_type<decltype(T::params)>},
      {offsetof(T, params), &detail::value_type<decltype(T::params)>},
  };

  static constexpr void visit(auto& value, auto&& visitor) {
    visitor(fields[0], Counter{value.params.size()});
    visitor(fields[1], value.params);
    visitor(tail_field, value.tail);
  }
};

template <>
struct Meta<msg::GetAdjVarsVal> {
  static constexpr const char* answers[] = {"SetAdjVarsVal"};
  static constexpr MessageInfo info{
      .name = "GetAdjVarsVal", .command = "CMD_GET_ADJ_VARS_VAL",
      .summary = "Request the values of adjustable variables.", .id = 64,
      .direction = Direction::to_board, .min_size = 1, .max_size = 41, .since = {.board = 30},
      .answers = answers, .effects = Effects(Effect::reads)};
  static constexpr Range num_vars_range{1, 40};
  static constexpr FieldInfo fields[] = {
      {.name = "num_vars", .spec_name = "NUM_VARS", .summary = "Number of variables that follow.",
       .range = &num_vars_range},
      {.name = "param_id", .spec_name = "PARAM_ID", .summary = "The variables (Appendix B)."},
  };
  template <class T> static constexpr detail::Slot slots[] = {
      {offsetof(T, param_id), &detail::counter_type<decltype(T::param_id)>},
      {offsetof(T, param_id), &detail::value_type<decltype(T::param_id)>},
  };

  static constexpr void visit(auto& value, auto&& visitor) {
    visitor(fields[0], Counter{value.param_id.size()});
    visitor(fields[1], value.param_id);
  }
};

template <>
struct Meta<msg::ReadAdjVarsCfg> {
  static constexpr MessageInfo info{
      .name = "ReadAdjVarsCfg", .command = "CMD_READ_ADJ_VARS_CFG",
      .summary = "RC signals that trigger actions or change adjustable variables.", .id = 43,
      .direction = Direction::from_board, .min_size = 128, .max_size = 128, .since = {.board = 30}};
  static constexpr FieldInfo fields[] = {
      {.name = "trigger_slots", .spec_name = "trigger_slots",
       .summary = "RC signals that trigger actions; the range of a signal is split into five levels."},
      {.name = "analog_slots", .spec_name = "analog_slots",
       .summary = "RC signals that change adjustable variables."},
      {.name = "reserved", .spec_name = "RESERVED", .summary = "Reserved; kept as it is.",
       .reserved = true},
  };
  template <class T> static constexpr detail::Slot slots[] = {
      {offsetof(T, trigger_slots), &detail::value_type<decltype(T::trigger_slots)>},
      {offsetof(T, analog_slots), &detail::value_type<decltype(T::analog_slots)>},
      {offsetof(T, reserved), &detail::value_type<decltype(T::reserved)>},
  };

  static constexpr void visit(auto& value, auto&& visitor) {
    visitor(fields[0], value.trigger_slots);
    visitor(fields[1], value.analog_slots);
    visitor(fields[2], value.reserved);
    visitor(tail_field, value.tail);
  }
};

template <>
struct Meta<msg::ReadAdjVarsCfgRequest> {
  static constexpr const char* answers[] = {"ReadAdjVarsCfg"};
  static constexpr MessageInfo info{
      .name = "ReadAdjVarsCfgRequest", .command = "CMD_READ_ADJ_VARS_CFG",
      .summary = "Request the RC signals that trigger actions or change adjustable variables.",
      .id = 43, .direction = Direction::to_board, .min_size = 0, .max_size = 0,
      .since = {.board = 30}, .answers = answers, .effects = Effects(Effect::reads)};

  static constexpr void visit(auto&, auto&&) {
  }
};

template <>
struct Meta<msg::AdjVarsState> {
  static constexpr MessageInfo info{
      .name = "AdjVarsState", .command = "CMD_ADJ_VARS_STATE",
      .summary = "Current state of one trigger slot and one analog slot.", .id = 46,
      .direction = Direction::from_board, .min_size = 15, .max_size = 15, .since = {.board = 30}};
  static constexpr Range trigger_rc_data_range{-500, 500};
  static constexpr Range trigger_action_range{0, 255};
  static constexpr Range analog_rc_data_range{-500, 500};
  static constexpr FieldInfo fields[] = {
      {.name = "trigger_rc_data", .spec_name = "TRIGGER_RC_DATA",
       .summary = "RC signal of the trigger slot.", .unit = &UnitMeta<msg::CentredRcSignal>::info,
       .range = &trigger_rc_data_range},
      {.name = "trigger_action", .spec_name = "TRIGGER_ACTION",
       .summary = "Action that the slot triggered.", .range = &trigger_action_range},
      {.name = "analog_rc_data", .spec_name = "ANALOG_RC_DATA",
       .summary = "RC signal of the analog slot.", .unit = &UnitMeta<msg::CentredRcSignal>::info,
       .range = &analog_rc_data_range},
      {.name = "analog_value", .spec_name = "ANALOG_VALUE",
       .summary = "Value of the variable, in its own units."},
      {.name = "reserved", .spec_name = "RESERVED", .summary = "Reserved; kept as it is.",
       .reserved = true},
  };
  template <class T> static constexpr detail::Slot slots[] = {
      {offsetof(T, trigger_rc_data), &detail::value_type<decltype(T::trigger_rc_data)>},
      {offsetof(T, trigger_action), &detail::value_type<decltype(T::trigger_action)>},
      {offsetof(T, analog_rc_data), &detail::value_type<decltype(T::analog_rc_data)>},
      {offsetof(T, analog_value), &detail::value_type<decltype(T::analog_value)>},
      {offsetof(T, reserved), &detail::value_type<decltype(T::reserved)>},
  };

  static constexpr void visit(auto& value, auto&& visitor) {
    visitor(fields[0], value.trigger_rc_data);
    visitor(fields[1], value.trigger_action);
    visitor(fields[2], value.analog_rc_data);
    visitor(fields[3], value.analog_value);
    visitor(fields[4], value.reserved);
    visitor(tail_field, value.tail);
  }
};

template <>
struct Meta<msg::AdjVarsStateExt> {
  static constexpr MessageInfo info{
      .name = "AdjVarsStateExt", .command = "CMD_ADJ_VARS_STATE",
      .summary = "Current state of a trigger slot, two RC signals and two variables.", .id = 46,
      .direction = Direction::from_board, .min_size = 15, .max_size = 15,
      .since = {.firmware = 2625}};
  static constexpr Range trigger_rc_data_range{-16384, 16384};
  static constexpr Range trigger_action_range{0, 255};
  static constexpr Range analog_src_value_range{-16384, 16384};
  static constexpr Range lut_src_value_range{-16384, 16384};
  static constexpr FieldInfo fields[] = {
      {.name = "trigger_rc_data", .spec_name = "TRIGGER_RC_DATA",
       .summary = "RC signal of the trigger slot.", .unit = &UnitMeta<msg::FineRcSignal>::info,
       .range = &trigger_rc_data_range},
      {.name = "trigger_action", .spec_name = "TRIGGER_ACTION",
       .summary = "Action that the slot triggered.", .range = &trigger_action_range},
      {.name = "analog_src_value", .spec_name = "ANALOG_SRC_VALUE",
       .summary = "RC signal of ANALOG_SRC_ID.", .unit = &UnitMeta<msg::FineRcSignal>::info,
       .range = &analog_src_value_range},
      {.name = "analog_var_value", .spec_name = "ANALOG_VAR_VALUE",
       .summary = "Value of ANALOG_VAR_ID, in its own units."},
      {.name = "lut_src_value", .spec_name = "LUT_SRC_VALUE", .summary = "RC signal of LUT_SRC_ID.",
       .unit = &UnitMeta<msg::FineRcSignal>::info, .range = &lut_src_value_range},
      {.name = "lut_var_value", .spec_name = "LUT_VAR_VALUE",
       .summary = "Value of LUT_VAR_ID, in its own units."},
  };
  template <class T> static constexpr detail::Slot slots[] = {
      {offsetof(T, trigger_rc_data), &detail::value_type<decltype(T::trigger_rc_data)>},
      {offsetof(T, trigger_action), &detail::value_type<decltype(T::trigger_action)>},
      {offsetof(T, analog_src_value), &detail::value_type<decltype(T::analog_src_value)>},
      {offsetof(T, analog_var_value), &detail::value_type<decltype(T::analog_var_value)>},
      {offsetof(T, lut_src_value), &detail::value_type<decltype(T::lut_src_value)>},
      {offsetof(T, lut_var_value), &detail::value_type<decltype(T::lut_var_value)>},
  };

  static constexpr void visit(auto& value, auto&& visitor) {
    visitor(fields[0], value.trigger_rc_data);
    visitor(fields[1], value.trigger_action);
    visitor(fields[2], value.analog_src_value);
    visitor(fields[3], value.analog_var_value);
    visitor(fields[4], value.lut_src_value);
    visitor(fields[5], value.lut_var_value);
    visitor(tail_field, value.tail);
  }
};

template <>
struct Meta<msg::AdjVarsStateRequest> {
  static constexpr const char* answers[] = {"AdjVarsState"};
  static constexpr MessageInfo info{
      .name = "AdjVarsStateRequest", .command = "CMD_ADJ_VARS_STATE",
      .summary = "Request the state of one trigger slot and one analog slot.", .id = 46,
      .direction = Direction::to_board, .min_size = 2, .max_size = 2, .since = {.board = 30},
      .answers = answers, .effects = Effects(Effect::reads)};
  static constexpr FieldInfo fields[] = {
      {.name = "trigger_slot", .spec_name = "TRIGGER_SLOT",
       .summary = "Trigger slot, counted from 0."},
      {.name = "analog_slot", .spec_name = "ANALOG_SLOT", .summary = "Analog slot, counted from 0."},
  };
  template <class T> static constexpr detail::Slot slots[] = {
      {offsetof(T, trigger_slot), &detail::value_type<decltype(T::trigger_slot)>},
      {offsetof(T, analog_slot), &detail::value_type<decltype(T::analog_slot)>},
  };

  static constexpr void visit(auto& value, auto&& visitor) {
    visitor(fields[0], value.trigger_slot);
    visitor(fields[1], value.analog_slot);
  }
};

template <>
struct Meta<msg::AdjVarsStateRequestExt> {
  static constexpr const char* answers[] = {"AdjVarsStateExt"};
  static constexpr MessageInfo info{
      .name = "AdjVarsStateRequestExt", .command = "CMD_ADJ_VARS_STATE",
      .summary = "Request the state of a trigger slot, two RC signals and two variables.", .id = 46,
      .direction = Direction::to_board, .min_size = 7, .max_size = 7, .since = {.firmware = 2625},
      .answers = answers, .effects = Effects(Effect::reads)};
  static constexpr Range trigger_slot_range{0, 9};
  static constexpr FieldInfo fields[] = {
      {.name = "trigger_slot", .spec_name = "TRIGGER_SLOT",
       .summary = "Trigger slot, counted from 0.", .range = &trigger_slot_range},
      {.name = "analog_src_id", .spec_name = "ANALOG_SRC_ID", .summary = "RC signal to report."},
      {.name = "analog_var_id", .spec_name = "ANALOG_VAR_ID", .summary = "Variable to report."},
      {.name = "lut_src_id", .spec_name = "LUT_SRC_ID",
       .summary = "RC signal of a lookup table to report."},
      {.name = "lut_var_id", .spec_name = "LUT_VAR_ID",
       .summary = "Variable of a lookup table to report."},
  };
  template <class T> static constexpr detail::Slot slots[] = {
      {offsetof(T, trigger_slot), &detail::value_type<decltype(T::trigger_slot)>},
      {offsetof(T, analog_src_id), &detail::value_type<decltype(T::analog_src_id)>},
      {offsetof(T, analog_var_id), &detail::value_type<decltype(T::analog_var_id)>},
      {offsetof(T, lut_src_id), &detail::value_type<decltype(T::lut_src_id)>},
      {offsetof(T, lut_var_id), &detail::value_type<decltype(T::lut_var_id)>},
  };

  static constexpr void visit(auto& value, auto&& visitor) {
    visitor(fields[0], value.trigger_slot);
    visitor(fields[1], value.analog_src_id);
    visitor(fields[2], value.analog_var_id);
    visitor(fields[3], value.lut_src_id);
    visitor(fields[4], value.lut_var_id);
  }
};

template <>
struct Meta<msg::AdjVarsInfo> {
  static constexpr MessageInfo info{
      .name = "AdjVarsInfo", .command = "CMD_ADJ_VARS_INFO",
      .summary = "Names, ranges and values of adjustable variables.", .id = 132,
      .direction = Direction::from_board, .min_size = 1, .max_size = 255,
      .since = {.firmware = 2730}};
  static constexpr FieldInfo fields[] = {
      {.name = "total_number", .spec_name = "TOTAL_NUMBER",
       .summary = "Number of variables of the board, of which a message holds a part."},
      {.name = "vars", .spec_name = "vars", .summary = "The variables, from START_ID on."},
  };
  template <class T> static constexpr detail::Slot slots[] = {
      {offsetof(T, total_number), &detail::value_type<decltype(T::total_number)>},
      {offsetof(T, vars), &detail::value_type<decltype(T::vars)>},
  };

  static constexpr void visit(auto& value, auto&& visitor) {
    visitor(fields[0], value.total_number);
    visitor(fields[1], value.vars);
  }
};

template <>
struct Meta<msg::AdjVarsInfoRequest> {
  static constexpr const char* answers[] = {"AdjVarsInfo"};
  static constexpr MessageInfo info{
      .name = "AdjVarsInfoRequest", .command = "CMD_ADJ_VARS_INFO",
      .summary = "Request names, ranges and values of adjustable variables.", .id = 132,
      .direction = Direction::to_board, .min_size = 1, .max_size = 1, .since = {.firmware = 2730},
      .answers = answers, .effects = Effects(Effect::reads)};
  static constexpr FieldInfo fields[] = {
      {.name = "start_id", .spec_name = "START_ID",
       .summary = "First variable to describe; for the next page, the last one that came, plus 1. The last page is empty."},
  };
  template <class T> static constexpr detail::Slot slots[] = {
      {offsetof(T, start_id), &detail::value_type<decltype(T::start_id)>},
  };

  static constexpr void visit(auto& value, auto&& visitor) {
    visitor(fields[0], value.start_id);
  }
};

template <>
struct Meta<msg::AdjVarsInfoRequestAll> {
  static constexpr const char* answers[] = {"AdjVarsInfo"};
  static constexpr MessageInfo info{
      .name = "AdjVarsInfoRequestAll", .command = "CMD_ADJ_VARS_INFO",
      .summary = "Request names, ranges and values of adjustable variables, starting with the first.",
      .id = 132, .direction = Direction::to_board, .min_size = 0, .max_size = 0,
      .since = {.firmware = 2730}, .unconfirmed = true, .answers = answers,
      .effects = Effects(Effect::reads)};

  static constexpr void visit(auto&, auto&&) {
  }
};

template <>
struct Meta<msg::SetAdjVarsValF> {
  static constexpr MessageInfo info{
      .name = "SetAdjVarsValF", .command = "CMD_SET_ADJ_VARS_VAL_F",
      .summary = "Values of adjustable variables in floating point.", .id = 134,
      .direction = Direction::both, .min_size = 1, .max_size = 201, .since = {.firmware = 2734},
      .effects = Effects(Effect::sets) | Effect::moves};
  static constexpr Range num_params_range{1, 40};
  static constexpr FieldInfo fields[] = {
      {.name = "num_params", .spec_name = "NUM_PARAMS",
       .summary = "Number of variables that follow.", .range = &num_params_range},
      {.name = "params", .spec_name = "params", .summary = "The variables."},
  };
  template <class T> static constexpr detail::Slot slots[] = {
      {offsetof(T, params), &detail::counter_type<decltype(T::params)>},
      {offsetof(T, params), &detail::value_type<decltype(T::params)>},
  };

  static constexpr void visit(auto& value, auto&& visitor) {
    visitor(fields[0], Counter{value.params.size()});
    visitor(fields[1], value.params);
    visitor(tail_field, value.tail);
  }
};

template <>
struct Meta<msg::GetAdjVarsValF> {
  static constexpr const char* answers[] = {"SetAdjVarsValF"};
  static constexpr MessageInfo info{
      .name = "GetAdjVarsValF", .command = "CMD_GET_ADJ_VARS_VAL_F",
      .summary = "Request the values of adjustable variables in floating point.", .id = 135,
      .direction = Direction::to_board, .min_size = 1, .max_size = 41, .since = {.firmware = 2734},
      .answers = answers, .effects = Effects(Effect::reads)};
  static constexpr Range num_params_range{1, 40};
  static constexpr FieldInfo fields[] = {
      {.name = "num_params", .spec_name = "NUM_PARAMS",
       .summary = "Number of variables that follow.", .range = &num_params_range},
      {.name = "id", .spec_name = "ID", .summary = "The variables (Appendix B)."},
  };
  template <class T> static constexpr detail::Slot slots[] = {
      {offsetof(T, id), &detail::counter_type<decltype(T::id)>},
      {offsetof(T, id), &detail::value_type<decltype(T::id)>},
  };

  static constexpr void visit(auto& value, auto&& visitor) {
    visitor(fields[0], Counter{value.id.size()});
    visitor(fields[1], value.id);
  }
};

template <>
struct Meta<msg::WriteAdjVarsCfg> : Meta<msg::ReadAdjVarsCfg> {
  static constexpr MessageInfo info{
      .name = "WriteAdjVarsCfg", .command = "CMD_WRITE_ADJ_VARS_CFG",
      .summary = "Store the RC signals that trigger actions or change adjustable variables.",
      .id = 44, .direction = Direction::to_board, .min_size = 128, .max_size = 128,
      .since = {.board = 30}, .stores = "ReadAdjVarsCfg",
      .effects = Effects(Effect::stores) | Effect::moves};
};

}  // namespace sbgc
