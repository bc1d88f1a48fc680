// Generated from spec/ by generator/: edit those, then run ./dev generate.

/// Settings that can be changed on the fly, without saving them.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include <sbgc/codec.hpp>
#include <sbgc/enums.hpp>
#include <sbgc/units.hpp>

namespace sbgc::msg {

static_assert(codec_version == 2, "generated code and runtime do not belong together");

/// One adjustable variable and its value.
struct AdjVarValue {
  /// Which variable (Appendix B).
  VariableId param_id{};
  /// The value, widened to 32 bits whatever the variable's own type is.
  std::int32_t param_value{};

  bool operator==(const AdjVarValue&) const = default;
  using FixedMembers = Members<&AdjVarValue::param_id, &AdjVarValue::param_value>;
};

/// RC signals that start actions; the range of a signal is split into five levels.
struct TriggerSlot {
  /// RC signal.
  RcMap src_ch{};
  /// Action that each level of the signal starts.
  std::array<MenuCommand, 5> action{};

  bool operator==(const TriggerSlot&) const = default;
  using FixedMembers = Members<&TriggerSlot::src_ch, &TriggerSlot::action>;
};

/// RC signals that change adjustable variables.
struct AnalogSlot {
  /// RC signal.
  RcMap src_ch{};
  /// Variable that it changes (Appendix B).
  VariableId param_id{};
  /// Begin of the working range, as a share of the variable's own range.
  std::uint8_t min_val{};
  /// End of the working range, as a share of the variable's own range.
  std::uint8_t max_val{};

  bool operator==(const AnalogSlot&) const = default;
  using FixedMembers = Members<&AnalogSlot::src_ch, &AnalogSlot::param_id, &AnalogSlot::min_val,
      &AnalogSlot::max_val>;
};

/// Values of adjustable variables.
///
/// CMD_SET_ADJ_VARS_VAL (31), in both directions; 1 to 201 bytes, and later firmware may append
/// more. Effect: sets, moves. Since board 3.0. Source: Incoming commands L505-L507.
struct SetAdjVarsVal {
  static constexpr CommandId command = CommandId::set_adj_vars_val;
  static constexpr Direction direction = Direction::both;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 1;
  static constexpr std::size_t max_size = 201;
  static constexpr Availability since{.board = 30};

  /// The variables.
  BoundedArray<AdjVarValue, 50> params{};
  /// What later firmware appends; kept, and written back.
  BoundedBytes<254> tail{};

  bool operator==(const SetAdjVarsVal&) const = default;
  [[gnu::always_inline]]
  static constexpr void varying_members(auto& self, auto& cursor) noexcept {
    std::uint8_t num_vars_count = 0;
    cursor.count(num_vars_count, self.params, "num_vars");
    cursor.counted(self.params, num_vars_count, "params");
  }
};

/// Ask for the values of adjustable variables.
///
/// CMD_GET_ADJ_VARS_VAL (64), to the board; 1 to 41 bytes. Effect: reads. Since board 3.0. Source:
/// Outgoing commands L793-L802; Variables L1174-L1176.
struct GetAdjVarsVal {
  static constexpr CommandId command = CommandId::get_adj_vars_val;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 1;
  static constexpr std::size_t max_size = 41;
  static constexpr Availability since{.board = 30};

  /// Which variables (Appendix B).
  BoundedArray<VariableId, 254> param_id{};

  bool operator==(const GetAdjVarsVal&) const = default;
  [[gnu::always_inline]]
  static constexpr void varying_members(auto& self, auto& cursor) noexcept {
    std::uint8_t num_vars_count = 0;
    cursor.count(num_vars_count, self.param_id, "num_vars");
    cursor.counted(self.param_id, num_vars_count, "param_id");
  }
};

/// Which RC signals start actions and which ones change adjustable variables.
///
/// CMD_READ_ADJ_VARS_CFG (43), from the board; 128 bytes, and later firmware may append more. Since
/// board 3.0. Source: Incoming commands L509-L535.
struct ReadAdjVarsCfg {
  static constexpr CommandId command = CommandId::read_adj_vars_cfg;
  static constexpr Direction direction = Direction::from_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 128;
  static constexpr std::size_t max_size = 128;
  static constexpr Availability since{.board = 30};

  /// RC signals that start actions; the range of a signal is split into five levels.
  std::array<TriggerSlot, 10> trigger_slots{};
  /// RC signals that change adjustable variables.
  std::array<AnalogSlot, 15> analog_slots{};
  /// Reserved; kept as it is.
  Bytes<8> reserved{};
  /// What later firmware appends; kept, and written back.
  BoundedBytes<127> tail{};

  bool operator==(const ReadAdjVarsCfg&) const = default;
  using FixedMembers = Members<&ReadAdjVarsCfg::trigger_slots, &ReadAdjVarsCfg::analog_slots,
      &ReadAdjVarsCfg::reserved>;
};

/// Ask which RC signals start actions and which ones change adjustable variables.
///
/// CMD_READ_ADJ_VARS_CFG (43), to the board; 0 bytes. Effect: reads. Since board 3.0. Source:
/// Outgoing commands L867-L869.
struct ReadAdjVarsCfgRequest {
  static constexpr CommandId command = CommandId::read_adj_vars_cfg;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 0;
  static constexpr std::size_t max_size = 0;
  static constexpr Availability since{.board = 30};

  bool operator==(const ReadAdjVarsCfgRequest&) const = default;
};

/// What one trigger slot and one analog slot do at the moment. From firmware 2.62b5 on a request of
/// 7 bytes gives these bytes other meanings.
///
/// CMD_ADJ_VARS_STATE (46), from the board; 15 bytes, and later firmware may append more. Since
/// board 3.0. Source: Incoming commands L592-L598; Variables L1228-L1232.
struct AdjVarsState {
  static constexpr CommandId command = CommandId::adj_vars_state;
  static constexpr Direction direction = Direction::from_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 15;
  static constexpr std::size_t max_size = 15;
  static constexpr Availability since{.board = 30};

  /// RC signal of the trigger slot. Range: -1 to 1.
  CentredRcSignal trigger_rc_data{};
  /// Action that it has started.
  MenuCommand trigger_action{};
  /// RC signal of the analog slot. Range: -1 to 1.
  CentredRcSignal analog_rc_data{};
  /// Value of the variable, in its own units.
  std::int32_t analog_value{};
  /// Reserved; kept as it is.
  Bytes<6> reserved{};
  /// What later firmware appends; kept, and written back.
  BoundedBytes<240> tail{};

  bool operator==(const AdjVarsState&) const = default;
  using FixedMembers = Members<&AdjVarsState::trigger_rc_data, &AdjVarsState::trigger_action,
      &AdjVarsState::analog_rc_data, &AdjVarsState::analog_value, &AdjVarsState::reserved>;
};

/// Ask what one trigger slot and one analog slot do.
///
/// CMD_ADJ_VARS_STATE (46), to the board, simple form; 2 bytes. Effect: reads. Since board 3.0.
/// Source: Outgoing commands L997-L1000.
struct AdjVarsStateRequest {
  static constexpr CommandId command = CommandId::adj_vars_state;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::simple;
  static constexpr std::size_t min_size = 2;
  static constexpr std::size_t max_size = 2;
  static constexpr Availability since{.board = 30};

  /// Trigger slot, counted from 0.
  std::uint8_t trigger_slot{};
  /// Analog slot, counted from 0.
  std::uint8_t analog_slot{};

  bool operator==(const AdjVarsStateRequest&) const = default;
  using FixedMembers = Members<&AdjVarsStateRequest::trigger_slot,
      &AdjVarsStateRequest::analog_slot>;
};

/// Ask for the state of adjustable variables, as later firmware does it.
///
/// CMD_ADJ_VARS_STATE (46), to the board, extended form; 7 bytes. Effect: reads. Since firmware
/// 2.62b5. Source: Outgoing commands L997-L1000.
struct AdjVarsStateRequestExt {
  static constexpr CommandId command = CommandId::adj_vars_state;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::extended;
  static constexpr std::size_t min_size = 7;
  static constexpr std::size_t max_size = 7;
  static constexpr Availability since{.firmware = 2625};

  /// Not documented.
  Bytes<7> params{};

  bool operator==(const AdjVarsStateRequestExt&) const = default;
  using FixedMembers = Members<&AdjVarsStateRequestExt::params>;
};

/// Store which RC signals start actions and which ones change adjustable variables.
///
/// CMD_WRITE_ADJ_VARS_CFG (44), to the board; 128 bytes, and later firmware may append more.
/// Effect: stores, moves. Since board 3.0. Source: Outgoing commands L871-L875.
struct WriteAdjVarsCfg : ReadAdjVarsCfg {
  static constexpr CommandId command = CommandId::write_adj_vars_cfg;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 128;
  static constexpr std::size_t max_size = 128;
  static constexpr Availability since{.board = 30};
  using Body = ReadAdjVarsCfg;

  bool operator==(const WriteAdjVarsCfg&) const = default;
};

}  // namespace sbgc::msg
