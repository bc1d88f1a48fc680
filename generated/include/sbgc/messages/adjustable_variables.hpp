// Generated from spec/ by generator/: edit those, then run ./dev generate.

/// Parameters that can be changed on the fly, without saving them.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include <sbgc/codec.hpp>
#include <sbgc/internal/compiler.hpp>
#include <sbgc/enums.hpp>
#include <sbgc/response.hpp>
#include <sbgc/units.hpp>

namespace sbgc::msg {

static_assert(codec_version == 3, "generated code and runtime do not match");

struct AdjVarsInfo;
struct AdjVarsState;
struct AdjVarsStateExt;
struct ReadAdjVarsCfg;
struct SetAdjVarsVal;
struct SetAdjVarsValF;

/// One adjustable variable and its value.
struct AdjVarValue {
  /// The variable (Appendix B).
  VariableId param_id{};
  /// The value, extended to 32 bits whatever the type of the variable.
  std::int32_t param_value{};

  bool operator==(const AdjVarValue&) const = default;
  using FixedMembers = Members<&AdjVarValue::param_id, &AdjVarValue::param_value>;
};

/// RC signals that trigger actions; the range of a signal is split into five levels.
struct TriggerSlot {
  /// RC signal.
  RcMap src_ch{};
  /// Action of each signal level.
  std::array<MenuCommand, 5> action{};

  bool operator==(const TriggerSlot&) const = default;
  using FixedMembers = Members<&TriggerSlot::src_ch, &TriggerSlot::action>;
};

/// RC signals that change adjustable variables.
struct AnalogSlot {
  /// RC signal.
  RcMap src_ch{};
  /// Variable to change (Appendix B).
  VariableId param_id{};
  /// Start of the working range, as a fraction of the variable's range.
  std::uint8_t min_val{};
  /// End of the working range, as a fraction of the variable's range.
  std::uint8_t max_val{};

  bool operator==(const AnalogSlot&) const = default;
  using FixedMembers = Members<&AnalogSlot::src_ch, &AnalogSlot::param_id, &AnalogSlot::min_val,
      &AnalogSlot::max_val>;
};

/// Name, range and value of one adjustable variable.
struct AdjVarInfo {
  /// The variable.
  VariableId var_id{};
  /// Its name, at most 16 characters.
  BoundedText<255> name{};
  /// Its lowest value.
  std::int16_t range_min{};
  /// Its highest value.
  std::int16_t range_max{};
  /// Its value.
  std::int32_t value{};

  bool operator==(const AdjVarInfo&) const = default;
  SBGC_ALWAYS_INLINE
  static constexpr void varying_members(auto& self, auto& cursor) noexcept {
    cursor.value(self.var_id, "var_id");
    cursor.value(self.name, "name");
    cursor.value(self.range_min, "range_min");
    cursor.value(self.range_max, "range_max");
    cursor.value(self.value, "value");
  }
};

/// One adjustable variable and its value in floating point.
struct AdjVarFloat {
  /// The variable (Appendix B).
  VariableId id{};
  /// The value.
  float value{};

  bool operator==(const AdjVarFloat&) const = default;
  using FixedMembers = Members<&AdjVarFloat::id, &AdjVarFloat::value>;
};

/// Values of adjustable variables.
///
/// CMD_SET_ADJ_VARS_VAL (31), in both directions; 1 to 201 bytes, and later firmware may append
/// more. Effect: sets, moves. Since board 3.0. Source: Incoming commands L505-L507.
struct SetAdjVarsVal {
  static constexpr CommandToBoard command = CommandToBoard::set_adj_vars_val;
  static constexpr Direction direction = Direction::both;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 1;
  static constexpr std::size_t max_size = 201;
  static constexpr Availability since{.board = 30};
  using Response = void;

  /// The variables.
  BoundedArray<AdjVarValue, 50> params{};
  /// Bytes appended by later firmware; preserved and written back.
  BoundedBytes<254> tail{};

  bool operator==(const SetAdjVarsVal&) const = default;
  SBGC_ALWAYS_INLINE
  static constexpr void varying_members(auto& self, auto& cursor) noexcept {
    std::uint8_t num_vars_count = 0;
    cursor.count(num_vars_count, self.params, "num_vars");
    cursor.counted(self.params, num_vars_count, "params");
  }
};

/// Request the values of adjustable variables.
///
/// CMD_GET_ADJ_VARS_VAL (64), to the board; 1 to 41 bytes. Effect: reads. Since board 3.0. Source:
/// Outgoing commands L793-L802; Variables L1174-L1176.
struct GetAdjVarsVal {
  static constexpr CommandToBoard command = CommandToBoard::get_adj_vars_val;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 1;
  static constexpr std::size_t max_size = 41;
  static constexpr Availability since{.board = 30};
  using Response = SetAdjVarsVal;

  /// The variables (Appendix B).
  BoundedArray<VariableId, 254> param_id{};

  bool operator==(const GetAdjVarsVal&) const = default;
  SBGC_ALWAYS_INLINE
  static constexpr void varying_members(auto& self, auto& cursor) noexcept {
    std::uint8_t num_vars_count = 0;
    cursor.count(num_vars_count, self.param_id, "num_vars");
    cursor.counted(self.param_id, num_vars_count, "param_id");
  }
};

/// RC signals that trigger actions or change adjustable variables.
///
/// CMD_READ_ADJ_VARS_CFG (43), from the board; 128 bytes, and later firmware may append more. Since
/// board 3.0. Source: Incoming commands L509-L535.
struct ReadAdjVarsCfg {
  static constexpr CommandFromBoard command = CommandFromBoard::read_adj_vars_cfg;
  static constexpr Direction direction = Direction::from_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 128;
  static constexpr std::size_t max_size = 128;
  static constexpr Availability since{.board = 30};

  /// RC signals that trigger actions; the range of a signal is split into five levels.
  std::array<TriggerSlot, 10> trigger_slots{};
  /// RC signals that change adjustable variables.
  std::array<AnalogSlot, 15> analog_slots{};
  /// Reserved; kept as it is.
  Bytes<8> reserved{};
  /// Bytes appended by later firmware; preserved and written back.
  BoundedBytes<127> tail{};

  bool operator==(const ReadAdjVarsCfg&) const = default;
  using FixedMembers = Members<&ReadAdjVarsCfg::trigger_slots, &ReadAdjVarsCfg::analog_slots,
      &ReadAdjVarsCfg::reserved>;
};

/// Request the RC signals that trigger actions or change adjustable variables.
///
/// CMD_READ_ADJ_VARS_CFG (43), to the board; 0 bytes. Effect: reads. Since board 3.0. Source:
/// Outgoing commands L867-L869.
struct ReadAdjVarsCfgRequest {
  static constexpr CommandToBoard command = CommandToBoard::read_adj_vars_cfg;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 0;
  static constexpr std::size_t max_size = 0;
  static constexpr Availability since{.board = 30};
  using Response = ReadAdjVarsCfg;

  bool operator==(const ReadAdjVarsCfgRequest&) const = default;
};

/// Current state of one trigger slot and one analog slot. The response to the 2-byte request. That
/// to the 7-byte request has the same size: the request decides.
///
/// CMD_ADJ_VARS_STATE (46), from the board, simple form; 15 bytes, and later firmware may append
/// more. Since board 3.0. Source: Incoming commands L592-L598; Variables L1228-L1232.
struct AdjVarsState {
  static constexpr CommandFromBoard command = CommandFromBoard::adj_vars_state;
  static constexpr Direction direction = Direction::from_board;
  static constexpr Form form = Form::simple;
  static constexpr std::size_t min_size = 15;
  static constexpr std::size_t max_size = 15;
  static constexpr Availability since{.board = 30};

  /// RC signal of the trigger slot. Range: -1 to 1.
  CentredRcSignal trigger_rc_data{};
  /// Action that the slot triggered.
  MenuCommand trigger_action{};
  /// RC signal of the analog slot. Range: -1 to 1.
  CentredRcSignal analog_rc_data{};
  /// Value of the variable, in its own units.
  std::int32_t analog_value{};
  /// Reserved; kept as it is.
  Bytes<6> reserved{};
  /// Bytes appended by later firmware; preserved and written back.
  BoundedBytes<240> tail{};

  bool operator==(const AdjVarsState&) const = default;
  using FixedMembers = Members<&AdjVarsState::trigger_rc_data, &AdjVarsState::trigger_action,
      &AdjVarsState::analog_rc_data, &AdjVarsState::analog_value, &AdjVarsState::reserved>;
};

/// Current state of a trigger slot, two RC signals and two variables. The response to the 7-byte
/// request. That to the 2-byte request has the same size: the request decides.
///
/// CMD_ADJ_VARS_STATE (46), from the board, extended form; 15 bytes, and later firmware may append
/// more. Since firmware 2.62b5. Source: Later firmware.
struct AdjVarsStateExt {
  static constexpr CommandFromBoard command = CommandFromBoard::adj_vars_state;
  static constexpr Direction direction = Direction::from_board;
  static constexpr Form form = Form::extended;
  static constexpr std::size_t min_size = 15;
  static constexpr std::size_t max_size = 15;
  static constexpr Availability since{.firmware = 2625};

  /// RC signal of the trigger slot. Range: -1 to 1.
  FineRcSignal trigger_rc_data{};
  /// Action that the slot triggered.
  MenuCommand trigger_action{};
  /// RC signal of ANALOG_SRC_ID. Range: -1 to 1.
  FineRcSignal analog_src_value{};
  /// Value of ANALOG_VAR_ID, in its own units.
  float analog_var_value{};
  /// RC signal of LUT_SRC_ID. Range: -1 to 1.
  FineRcSignal lut_src_value{};
  /// Value of LUT_VAR_ID, in its own units.
  float lut_var_value{};
  /// Bytes appended by later firmware; preserved and written back.
  BoundedBytes<240> tail{};

  bool operator==(const AdjVarsStateExt&) const = default;
  using FixedMembers = Members<&AdjVarsStateExt::trigger_rc_data, &AdjVarsStateExt::trigger_action,
      &AdjVarsStateExt::analog_src_value, &AdjVarsStateExt::analog_var_value,
      &AdjVarsStateExt::lut_src_value, &AdjVarsStateExt::lut_var_value>;
};

/// Request the state of one trigger slot and one analog slot.
///
/// CMD_ADJ_VARS_STATE (46), to the board, simple form; 2 bytes. Effect: reads. Since board 3.0.
/// Source: Outgoing commands L997-L1000.
struct AdjVarsStateRequest {
  static constexpr CommandToBoard command = CommandToBoard::adj_vars_state;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::simple;
  static constexpr std::size_t min_size = 2;
  static constexpr std::size_t max_size = 2;
  static constexpr Availability since{.board = 30};
  using Response = AdjVarsState;

  /// Trigger slot, counted from 0.
  std::uint8_t trigger_slot{};
  /// Analog slot, counted from 0.
  std::uint8_t analog_slot{};

  bool operator==(const AdjVarsStateRequest&) const = default;
  using FixedMembers = Members<&AdjVarsStateRequest::trigger_slot,
      &AdjVarsStateRequest::analog_slot>;
};

/// Request the state of a trigger slot, two RC signals and two variables.
///
/// CMD_ADJ_VARS_STATE (46), to the board, extended form; 7 bytes. Effect: reads. Since firmware
/// 2.62b5. Source: Outgoing commands L997-L1000.
struct AdjVarsStateRequestExt {
  static constexpr CommandToBoard command = CommandToBoard::adj_vars_state;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::extended;
  static constexpr std::size_t min_size = 7;
  static constexpr std::size_t max_size = 7;
  static constexpr Availability since{.firmware = 2625};
  using Response = AdjVarsStateExt;

  /// Trigger slot, counted from 0. Range: 0 to 9.
  std::uint8_t trigger_slot{};
  /// RC signal to report.
  std::uint16_t analog_src_id{};
  /// Variable to report.
  VariableId analog_var_id{};
  /// RC signal of a lookup table to report.
  std::uint16_t lut_src_id{};
  /// Variable of a lookup table to report.
  VariableId lut_var_id{};

  bool operator==(const AdjVarsStateRequestExt&) const = default;
  using FixedMembers = Members<&AdjVarsStateRequestExt::trigger_slot,
      &AdjVarsStateRequestExt::analog_src_id, &AdjVarsStateRequestExt::analog_var_id,
      &AdjVarsStateRequestExt::lut_src_id, &AdjVarsStateRequestExt::lut_var_id>;
};

/// Names, ranges and values of adjustable variables.
///
/// CMD_ADJ_VARS_INFO (132), from the board; 1 to 255 bytes. Since firmware 2.73. Source: Later
/// firmware.
struct AdjVarsInfo {
  static constexpr CommandFromBoard command = CommandFromBoard::adj_vars_info;
  static constexpr Direction direction = Direction::from_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 1;
  static constexpr std::size_t max_size = 255;
  static constexpr Availability since{.firmware = 2730};

  /// Number of variables of the board, of which a message holds a part.
  std::uint8_t total_number{};
  /// The variables, from START_ID on.
  BoundedArray<AdjVarInfo, 25> vars{};

  bool operator==(const AdjVarsInfo&) const = default;
  using FixedMembers = Members<&AdjVarsInfo::total_number>;
  SBGC_ALWAYS_INLINE
  static constexpr void varying_members(auto& self, auto& cursor) noexcept {
    cursor.rest(self.vars, "vars");
  }
};

/// Request names, ranges and values of adjustable variables.
///
/// CMD_ADJ_VARS_INFO (132), to the board, simple form; 1 byte. Effect: reads. Since firmware 2.73.
/// Source: Later firmware.
struct AdjVarsInfoRequest {
  static constexpr CommandToBoard command = CommandToBoard::adj_vars_info;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::simple;
  static constexpr std::size_t min_size = 1;
  static constexpr std::size_t max_size = 1;
  static constexpr Availability since{.firmware = 2730};
  using Response = AdjVarsInfo;

  /// First variable to describe; for the next page, the last one that came, plus 1. The last page
  /// is empty.
  VariableId start_id{};

  bool operator==(const AdjVarsInfoRequest&) const = default;
  using FixedMembers = Members<&AdjVarsInfoRequest::start_id>;
};

/// Request names, ranges and values of adjustable variables, starting with the first.
///
/// CMD_ADJ_VARS_INFO (132), to the board, all form; 0 bytes. Effect: reads. Since firmware 2.73.
/// Unconfirmed. Source: Later firmware.
struct AdjVarsInfoRequestAll {
  static constexpr CommandToBoard command = CommandToBoard::adj_vars_info;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::all;
  static constexpr std::size_t min_size = 0;
  static constexpr std::size_t max_size = 0;
  static constexpr Availability since{.firmware = 2730};
  using Response = AdjVarsInfo;

  bool operator==(const AdjVarsInfoRequestAll&) const = default;
};

/// Values of adjustable variables in floating point.
///
/// CMD_SET_ADJ_VARS_VAL_F (134), in both directions; 1 to 201 bytes, and later firmware may append
/// more. Effect: sets, moves. Since firmware 2.73.4. Source: Later firmware.
struct SetAdjVarsValF {
  static constexpr CommandToBoard command = CommandToBoard::set_adj_vars_val_f;
  static constexpr Direction direction = Direction::both;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 1;
  static constexpr std::size_t max_size = 201;
  static constexpr Availability since{.firmware = 2734};
  using Response = void;

  /// The variables.
  BoundedArray<AdjVarFloat, 50> params{};
  /// Bytes appended by later firmware; preserved and written back.
  BoundedBytes<254> tail{};

  bool operator==(const SetAdjVarsValF&) const = default;
  SBGC_ALWAYS_INLINE
  static constexpr void varying_members(auto& self, auto& cursor) noexcept {
    std::uint8_t num_params_count = 0;
    cursor.count(num_params_count, self.params, "num_params");
    cursor.counted(self.params, num_params_count, "params");
  }
};

/// Request the values of adjustable variables in floating point.
///
/// CMD_GET_ADJ_VARS_VAL_F (135), to the board; 1 to 41 bytes. Effect: reads. Since firmware 2.73.4.
/// Source: Later firmware.
struct GetAdjVarsValF {
  static constexpr CommandToBoard command = CommandToBoard::get_adj_vars_val_f;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 1;
  static constexpr std::size_t max_size = 41;
  static constexpr Availability since{.firmware = 2734};
  using Response = SetAdjVarsValF;

  /// The variables (Appendix B).
  BoundedArray<VariableId, 254> id{};

  bool operator==(const GetAdjVarsValF&) const = default;
  SBGC_ALWAYS_INLINE
  static constexpr void varying_members(auto& self, auto& cursor) noexcept {
    std::uint8_t num_params_count = 0;
    cursor.count(num_params_count, self.id, "num_params");
    cursor.counted(self.id, num_params_count, "id");
  }
};

/// Store the RC signals that trigger actions or change adjustable variables.
///
/// CMD_WRITE_ADJ_VARS_CFG (44), to the board; 128 bytes, and later firmware may append more.
/// Effect: stores, moves. Since board 3.0. Source: Outgoing commands L871-L875.
struct WriteAdjVarsCfg : ReadAdjVarsCfg {
  static constexpr CommandToBoard command = CommandToBoard::write_adj_vars_cfg;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 128;
  static constexpr std::size_t max_size = 128;
  static constexpr Availability since{.board = 30};
  using Response = void;
  using Body = ReadAdjVarsCfg;

  bool operator==(const WriteAdjVarsCfg&) const = default;
};

}  // namespace sbgc::msg
