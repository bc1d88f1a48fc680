// Generated from spec/ by generator/: edit those, then run ./dev generate.

/// Settings that can be changed on the fly, without saving them.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <type_traits>

#include <sbgc/codec.hpp>
#include <sbgc/enums.hpp>
#include <sbgc/response.hpp>
#include <sbgc/units.hpp>

namespace sbgc::msg {

using sbgc::get;
using sbgc::put;

static_assert(codec_version == 1, "generated code and runtime do not belong together");

struct AdjVarsState;
struct ReadAdjVarsCfg;
struct SetAdjVarsVal;

/// One adjustable variable and its value.
struct AdjVarValue {
  static constexpr std::size_t wire_size = 5;

  /// Which variable (Appendix B).
  VariableId param_id{};
  /// The value, widened to 32 bits whatever the variable's own type is. Errata: E007.
  std::int32_t param_value{};

  constexpr bool operator==(const AdjVarValue&) const = default;
};

constexpr void get(const std::uint8_t* SBGC_RESTRICT from,
                   AdjVarValue& SBGC_RESTRICT out) noexcept {
  get(from, out.param_id);
  get(from + 1, out.param_value);
}
constexpr void put(std::uint8_t* SBGC_RESTRICT to,
                   const AdjVarValue& SBGC_RESTRICT in) noexcept {
  put(to, in.param_id);
  put(to + 1, in.param_value);
}

/// RC signals that start actions; the range of a signal is split into five levels.
struct TriggerSlot {
  static constexpr std::size_t wire_size = 6;

  /// RC signal. Errata: E104.
  RcMap src_ch{};
  /// Action that each level of the signal starts.
  std::array<MenuCommand, 5> action{};

  constexpr bool operator==(const TriggerSlot&) const = default;
};

constexpr void get(const std::uint8_t* SBGC_RESTRICT from,
                   TriggerSlot& SBGC_RESTRICT out) noexcept {
  get(from, out.src_ch);
  get(from + 1, out.action);
}
constexpr void put(std::uint8_t* SBGC_RESTRICT to,
                   const TriggerSlot& SBGC_RESTRICT in) noexcept {
  put(to, in.src_ch);
  put(to + 1, in.action);
}

/// RC signals that change adjustable variables.
struct AnalogSlot {
  static constexpr std::size_t wire_size = 4;

  /// RC signal. Errata: E104.
  RcMap src_ch{};
  /// Variable that it changes (Appendix B).
  VariableId param_id{};
  /// Begin of the working range, as a share of the variable's own range. Errata: E073.
  std::uint8_t min_val{};
  /// End of the working range, as a share of the variable's own range. Errata: E073.
  std::uint8_t max_val{};

  constexpr bool operator==(const AnalogSlot&) const = default;
};

constexpr void get(const std::uint8_t* SBGC_RESTRICT from,
                   AnalogSlot& SBGC_RESTRICT out) noexcept {
  using M = AnalogSlot;
  if (!std::is_constant_evaluated() &&
      detail::in_parallel(offsetof(M, src_ch), offsetof(M, max_val), 3)) {
    detail::get_block(from, out, offsetof(M, src_ch), 4);
    return;
  }
  get(from, out.src_ch);
  get(from + 1, out.param_id);
  get(from + 2, out.min_val);
  get(from + 3, out.max_val);
}
constexpr void put(std::uint8_t* SBGC_RESTRICT to,
                   const AnalogSlot& SBGC_RESTRICT in) noexcept {
  using M = AnalogSlot;
  if (!std::is_constant_evaluated() &&
      detail::in_parallel(offsetof(M, src_ch), offsetof(M, max_val), 3)) {
    detail::put_block(to, in, offsetof(M, src_ch), 4);
    return;
  }
  put(to, in.src_ch);
  put(to + 1, in.param_id);
  put(to + 2, in.min_val);
  put(to + 3, in.max_val);
}

/// Values of adjustable variables.
///
/// CMD_SET_ADJ_VARS_VAL (31), in both directions; 1 to 201 bytes, and later firmware may append
/// more.
/// Effect: sets, moves.
/// Since board 3.0.
/// Source: Incoming commands L505-L507.
struct SetAdjVarsVal {
  static constexpr CommandToBoard command = CommandToBoard::set_adj_vars_val;
  static constexpr Direction direction = Direction::both;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 1;
  static constexpr std::size_t max_size = 201;
  static constexpr Availability since{0, 30};
  using Response = void;

  /// The variables.
  BoundedArray<AdjVarValue, 50> params{};
  /// What later firmware appends; kept, and written back.
  BoundedBytes<254> tail{};

  constexpr bool operator==(const SetAdjVarsVal&) const = default;
};

[[nodiscard]] constexpr Status decode(std::span<const std::uint8_t> body,
                                      SetAdjVarsVal& out) noexcept {
  detail::Reader reader(body, 0);
  std::uint8_t num_vars_count = 0;
  reader.value(num_vars_count, "num_vars");
  reader.array(out.params, num_vars_count, "params");
  return reader.end(out.tail);
}

[[nodiscard]] constexpr WriteResult encode(const SetAdjVarsVal& in,
                                           std::span<std::uint8_t> out) noexcept {
  detail::Writer writer(out, 0);
  writer.value(static_cast<std::uint8_t>(in.params.size()), "num_vars");
  writer.array(in.params, "params");
  writer.array(in.tail, "tail");
  return writer.end();
}

/// Ask for the values of adjustable variables.
///
/// CMD_GET_ADJ_VARS_VAL (64), to the board; 1 to 41 bytes.
/// Effect: reads.
/// Since board 3.0.
/// Source: Outgoing commands L793-L802; Variables L1174-L1176. Errata: E090.
struct GetAdjVarsVal {
  static constexpr CommandToBoard command = CommandToBoard::get_adj_vars_val;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 1;
  static constexpr std::size_t max_size = 41;
  static constexpr Availability since{0, 30};
  using Response = SetAdjVarsVal;

  /// Which variables (Appendix B). Errata: E042.
  BoundedArray<VariableId, 254> param_id{};

  constexpr bool operator==(const GetAdjVarsVal&) const = default;
};

[[nodiscard]] constexpr Status decode(std::span<const std::uint8_t> body,
                                      GetAdjVarsVal& out) noexcept {
  detail::Reader reader(body, 0);
  std::uint8_t num_vars_count = 0;
  reader.value(num_vars_count, "num_vars");
  reader.array(out.param_id, num_vars_count, "param_id");
  return reader.end();
}

[[nodiscard]] constexpr WriteResult encode(const GetAdjVarsVal& in,
                                           std::span<std::uint8_t> out) noexcept {
  detail::Writer writer(out, 0);
  writer.value(static_cast<std::uint8_t>(in.param_id.size()), "num_vars");
  writer.array(in.param_id, "param_id");
  return writer.end();
}

/// Which RC signals start actions and which ones change adjustable variables.
///
/// CMD_READ_ADJ_VARS_CFG (43), from the board; 128 bytes, and later firmware may append more.
/// Since board 3.0.
/// Source: Incoming commands L509-L535. Errata: E114.
struct ReadAdjVarsCfg {
  static constexpr CommandFromBoard command = CommandFromBoard::read_adj_vars_cfg;
  static constexpr Direction direction = Direction::from_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 128;
  static constexpr std::size_t max_size = 128;
  static constexpr Availability since{0, 30};

  /// RC signals that start actions; the range of a signal is split into five levels.
  std::array<TriggerSlot, 10> trigger_slots{};
  /// RC signals that change adjustable variables.
  std::array<AnalogSlot, 15> analog_slots{};
  /// Reserved; kept as it is.
  Bytes<8> reserved{};
  /// What later firmware appends; kept, and written back.
  BoundedBytes<127> tail{};

  constexpr bool operator==(const ReadAdjVarsCfg&) const = default;
};

constexpr void get(const std::uint8_t* SBGC_RESTRICT from,
                   ReadAdjVarsCfg& SBGC_RESTRICT out) noexcept {
  using M = ReadAdjVarsCfg;
  if (!std::is_constant_evaluated() &&
      detail::in_parallel(offsetof(M, trigger_slots), offsetof(M, reserved), 120)) {
    detail::get_block(from, out, offsetof(M, trigger_slots), 128);
    return;
  }
  get(from, out.trigger_slots);
  get(from + 60, out.analog_slots);
  get(from + 120, out.reserved);
}
constexpr void put(std::uint8_t* SBGC_RESTRICT to,
                   const ReadAdjVarsCfg& SBGC_RESTRICT in) noexcept {
  using M = ReadAdjVarsCfg;
  if (!std::is_constant_evaluated() &&
      detail::in_parallel(offsetof(M, trigger_slots), offsetof(M, reserved), 120)) {
    detail::put_block(to, in, offsetof(M, trigger_slots), 128);
    return;
  }
  put(to, in.trigger_slots);
  put(to + 60, in.analog_slots);
  put(to + 120, in.reserved);
}

[[nodiscard]] constexpr Status decode(std::span<const std::uint8_t> body,
                                      ReadAdjVarsCfg& out) noexcept {
  if (body.size() < 128) return detail::wrong_size(body.size(), 128);
  get(body.data(), out);
  return detail::get_tail(body, 128, out.tail);
}

[[nodiscard]] constexpr WriteResult encode(const ReadAdjVarsCfg& in,
                                           std::span<std::uint8_t> out) noexcept {
  const std::size_t size = 128 + in.tail.size();
  if (out.size() < size) return {0, {Code::buffer_too_small}};
  put(out.data(), in);
  detail::put_tail(out.data() + 128, in.tail);
  return {size, {}};
}

[[gnu::always_inline]] inline bool add_in_memory(detail::ByteSum& sum,
                                                 const ReadAdjVarsCfg& in) noexcept {
  using M = ReadAdjVarsCfg;
  if (!(detail::in_parallel(offsetof(M, trigger_slots), offsetof(M, reserved), 120))) return false;
  detail::add_block(sum, in, offsetof(M, trigger_slots), 128);
  if (!in.tail.empty()) sum.add(byte_sum(in.tail.data(), in.tail.size()));
  return true;
}

/// Ask which RC signals start actions and which ones change adjustable variables.
///
/// CMD_READ_ADJ_VARS_CFG (43), to the board; 0 bytes.
/// Effect: reads.
/// Since board 3.0.
/// Source: Outgoing commands L867-L869.
struct ReadAdjVarsCfgRequest {
  static constexpr CommandToBoard command = CommandToBoard::read_adj_vars_cfg;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 0;
  static constexpr std::size_t max_size = 0;
  static constexpr Availability since{0, 30};
  using Response = ReadAdjVarsCfg;

  constexpr bool operator==(const ReadAdjVarsCfgRequest&) const = default;
};

[[nodiscard]] constexpr Status decode(std::span<const std::uint8_t> body,
                                      ReadAdjVarsCfgRequest& out) noexcept {
  if (body.size() != 0) return detail::wrong_size(body.size(), 0);
  static_cast<void>(out);
  return {};
}

[[nodiscard]] constexpr WriteResult encode(const ReadAdjVarsCfgRequest& in,
                                           std::span<std::uint8_t> out) noexcept {
  static_cast<void>(in);
  static_cast<void>(out);
  return {0, {}};
}

/// What one trigger slot and one analog slot do at the moment. From firmware 2.62b5 on a request of
/// 7 bytes gives these bytes other meanings.
///
/// CMD_ADJ_VARS_STATE (46), from the board; 15 bytes, and later firmware may append more.
/// Since board 3.0.
/// Source: Incoming commands L592-L598; Variables L1228-L1232. Errata: E208.
struct AdjVarsState {
  static constexpr CommandFromBoard command = CommandFromBoard::adj_vars_state;
  static constexpr Direction direction = Direction::from_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 15;
  static constexpr std::size_t max_size = 15;
  static constexpr Availability since{0, 30};

  /// RC signal of the trigger slot. Unit: no unit, one count is 1/500. Range: -500 to 500. Errata:
  /// E070.
  CentredRcSignal trigger_rc_data{};
  /// Action that it has started. Range: 0 to 255.
  MenuCommand trigger_action{};
  /// RC signal of the analog slot. Unit: no unit, one count is 1/500. Range: -500 to 500. Errata:
  /// E070.
  CentredRcSignal analog_rc_data{};
  /// Value of the variable, in its own units.
  std::int32_t analog_value{};
  /// Reserved; kept as it is.
  Bytes<6> reserved{};
  /// What later firmware appends; kept, and written back.
  BoundedBytes<240> tail{};

  constexpr bool operator==(const AdjVarsState&) const = default;
};

constexpr void get(const std::uint8_t* SBGC_RESTRICT from,
                   AdjVarsState& SBGC_RESTRICT out) noexcept {
  get(from, out.trigger_rc_data);
  get(from + 2, out.trigger_action);
  get(from + 3, out.analog_rc_data);
  get(from + 5, out.analog_value);
  get(from + 9, out.reserved);
}
constexpr void put(std::uint8_t* SBGC_RESTRICT to,
                   const AdjVarsState& SBGC_RESTRICT in) noexcept {
  put(to, in.trigger_rc_data);
  put(to + 2, in.trigger_action);
  put(to + 3, in.analog_rc_data);
  put(to + 5, in.analog_value);
  put(to + 9, in.reserved);
}

[[nodiscard]] constexpr Status decode(std::span<const std::uint8_t> body,
                                      AdjVarsState& out) noexcept {
  if (body.size() < 15) return detail::wrong_size(body.size(), 15);
  get(body.data(), out);
  return detail::get_tail(body, 15, out.tail);
}

[[nodiscard]] constexpr WriteResult encode(const AdjVarsState& in,
                                           std::span<std::uint8_t> out) noexcept {
  const std::size_t size = 15 + in.tail.size();
  if (out.size() < size) return {0, {Code::buffer_too_small}};
  put(out.data(), in);
  detail::put_tail(out.data() + 15, in.tail);
  return {size, {}};
}

/// Ask what one trigger slot and one analog slot do.
///
/// CMD_ADJ_VARS_STATE (46), to the board, simple form; 2 bytes.
/// Effect: reads.
/// Since board 3.0.
/// Source: Outgoing commands L997-L1000.
struct AdjVarsStateRequest {
  static constexpr CommandToBoard command = CommandToBoard::adj_vars_state;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::simple;
  static constexpr std::size_t min_size = 2;
  static constexpr std::size_t max_size = 2;
  static constexpr Availability since{0, 30};
  using Response = AdjVarsState;

  /// Trigger slot, counted from 0. Errata: E114.
  std::uint8_t trigger_slot{};
  /// Analog slot, counted from 0. Errata: E114.
  std::uint8_t analog_slot{};

  constexpr bool operator==(const AdjVarsStateRequest&) const = default;
};

constexpr void get(const std::uint8_t* SBGC_RESTRICT from,
                   AdjVarsStateRequest& SBGC_RESTRICT out) noexcept {
  get(from, out.trigger_slot);
  get(from + 1, out.analog_slot);
}
constexpr void put(std::uint8_t* SBGC_RESTRICT to,
                   const AdjVarsStateRequest& SBGC_RESTRICT in) noexcept {
  put(to, in.trigger_slot);
  put(to + 1, in.analog_slot);
}

[[nodiscard]] constexpr Status decode(std::span<const std::uint8_t> body,
                                      AdjVarsStateRequest& out) noexcept {
  if (body.size() != 2) return detail::wrong_size(body.size(), 2);
  get(body.data(), out);
  return {};
}

[[nodiscard]] constexpr WriteResult encode(const AdjVarsStateRequest& in,
                                           std::span<std::uint8_t> out) noexcept {
  if (out.size() < 2) return {0, {Code::buffer_too_small}};
  put(out.data(), in);
  return {2, {}};
}

/// Ask for the state of adjustable variables, as later firmware does it.
///
/// CMD_ADJ_VARS_STATE (46), to the board, extended form; 7 bytes.
/// Effect: reads.
/// Since firmware 2.62b5.
/// Source: Outgoing commands L997-L1000. Errata: E208.
struct AdjVarsStateRequestExt {
  static constexpr CommandToBoard command = CommandToBoard::adj_vars_state;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::extended;
  static constexpr std::size_t min_size = 7;
  static constexpr std::size_t max_size = 7;
  static constexpr Availability since{2625, 0};
  using Response = AdjVarsState;

  /// Not documented. Errata: E208.
  Bytes<7> params{};

  constexpr bool operator==(const AdjVarsStateRequestExt&) const = default;
};

constexpr void get(const std::uint8_t* SBGC_RESTRICT from,
                   AdjVarsStateRequestExt& SBGC_RESTRICT out) noexcept {
  get(from, out.params);
}
constexpr void put(std::uint8_t* SBGC_RESTRICT to,
                   const AdjVarsStateRequestExt& SBGC_RESTRICT in) noexcept {
  put(to, in.params);
}

[[nodiscard]] constexpr Status decode(std::span<const std::uint8_t> body,
                                      AdjVarsStateRequestExt& out) noexcept {
  if (body.size() != 7) return detail::wrong_size(body.size(), 7);
  get(body.data(), out);
  return {};
}

[[nodiscard]] constexpr WriteResult encode(const AdjVarsStateRequestExt& in,
                                           std::span<std::uint8_t> out) noexcept {
  if (out.size() < 7) return {0, {Code::buffer_too_small}};
  put(out.data(), in);
  return {7, {}};
}

/// Store which RC signals start actions and which ones change adjustable variables.
///
/// CMD_WRITE_ADJ_VARS_CFG (44), to the board; 128 bytes, and later firmware may append more.
/// Effect: stores, moves.
/// Since board 3.0.
/// Source: Outgoing commands L871-L875.
struct WriteAdjVarsCfg : ReadAdjVarsCfg {
  static constexpr CommandToBoard command = CommandToBoard::write_adj_vars_cfg;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 128;
  static constexpr std::size_t max_size = 128;
  static constexpr Availability since{0, 30};
  using Response = void;

  constexpr bool operator==(const WriteAdjVarsCfg&) const = default;
};

}  // namespace sbgc::msg
