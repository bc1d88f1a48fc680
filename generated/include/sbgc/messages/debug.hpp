// Generated from spec/ by generator/: edit those, then run ./dev generate.

/// Firmware variables that show the state of the system, and copies of the traffic.
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

struct DebugVars3;
struct DebugVarsInfo3;

/// The variables.
struct DebugVarInfo {
  /// Name of the variable.
  BoundedText<255> var_name{};
  /// Its type.
  DebugVarType var_type{};
  /// Number of elements; no board is known to send arrays. 0: a scalar. 1: a scalar.
  std::uint16_t arr_size{};

  bool operator==(const DebugVarInfo&) const = default;
  SBGC_ALWAYS_INLINE
  static constexpr void varying_members(auto& self, auto& cursor) noexcept {
    cursor.value(self.var_name, "var_name");
    cursor.value(self.var_type, "var_type");
    cursor.value(self.arr_size, "arr_size");
  }
};

/// Names and types of the debug variables, in the order of CMD_DEBUG_VARS_3.
///
/// CMD_DEBUG_VARS_INFO_3 (253), from the board; 1 to 255 bytes, and later firmware may append more.
/// Since board 3.0. Source: Incoming commands L476-L487; Variables L1185-L1189.
struct DebugVarsInfo3 {
  static constexpr CommandFromBoard command = CommandFromBoard::debug_vars_info_3;
  static constexpr Direction direction = Direction::from_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 1;
  static constexpr std::size_t max_size = 255;
  static constexpr Availability since{.board = 30};

  /// The variables.
  BoundedArray<DebugVarInfo, 63> vars{};
  /// Bytes appended by later firmware; preserved and written back.
  BoundedBytes<254> tail{};

  bool operator==(const DebugVarsInfo3&) const = default;
  SBGC_ALWAYS_INLINE
  static constexpr void varying_members(auto& self, auto& cursor) noexcept {
    std::uint8_t debug_vars_num_count = 0;
    cursor.count(debug_vars_num_count, self.vars, "debug_vars_num");
    cursor.counted(self.vars, debug_vars_num_count, "vars");
  }
};

/// Request the names and types of the debug variables.
///
/// CMD_DEBUG_VARS_INFO_3 (253), to the board; 0 or 1 byte. Effect: reads. Since board 3.0. Source:
/// Outgoing commands L847.
struct DebugVarsInfo3Request {
  static constexpr CommandToBoard command = CommandToBoard::debug_vars_info_3;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 0;
  static constexpr std::size_t max_size = 1;
  static constexpr Availability since{.board = 30};
  using Response = DebugVarsInfo3;

  /// First variable to describe, if there are several pages; the last one is empty. Since firmware
  /// 2.72; before, the body ends here.
  Optional<std::uint8_t> start_idx{};

  bool operator==(const DebugVarsInfo3Request&) const = default;
  SBGC_ALWAYS_INLINE
  static constexpr void varying_members(auto& self, auto& cursor) noexcept {
    cursor.appended(self.start_idx, "start_idx");
  }
};

/// Values of the debug variables.
///
/// CMD_DEBUG_VARS_3 (254), from the board; 0 to 255 bytes, and later firmware may append more.
/// Since board 3.0. Source: Incoming commands L489-L499.
struct DebugVars3 {
  static constexpr CommandFromBoard command = CommandFromBoard::debug_vars_3;
  static constexpr Direction direction = Direction::from_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 0;
  static constexpr std::size_t max_size = 255;
  static constexpr Availability since{.board = 30};

  /// Facts from earlier messages that the body needs for decoding.
  struct Context {
    /// The types announced by CMD_DEBUG_VARS_INFO_3; the values cannot be decoded without them.
    NumberTypes types{};

    /// Calls `visitor(fact)` for each of them.
    static constexpr void visit(auto& context, auto&& visitor) {
      visitor(context.types);
    }
  };

  /// The values in sequence, each with the type and the number of elements announced by
  /// CMD_DEBUG_VARS_INFO_3. The set of variables depends on the firmware.
  BoundedArray<Number, 255> var_value{};
  /// Bytes appended by later firmware; preserved and written back.
  BoundedBytes<255> tail{};

  bool operator==(const DebugVars3&) const = default;
  SBGC_ALWAYS_INLINE
  static constexpr void varying_members(auto& self, auto& cursor, const Context& context) noexcept {
    cursor.numbers(self.var_value, context.types, "var_value");
  }
};

/// Request the values of the debug variables.
///
/// CMD_DEBUG_VARS_3 (254), to the board, simple form; 0 bytes. Effect: reads. Since board 3.0.
/// Source: Outgoing commands L849.
struct DebugVars3Request {
  static constexpr CommandToBoard command = CommandToBoard::debug_vars_3;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::simple;
  static constexpr std::size_t min_size = 0;
  static constexpr std::size_t max_size = 0;
  static constexpr Availability since{.board = 30};
  using Response = DebugVars3;

  bool operator==(const DebugVars3Request&) const = default;
};

/// Request the values of selected debug variables. The response begins with the same masks; then
/// come the values of the selected variables. Nothing in it tells it from the response with all
/// values, so it is to be read as bytes.
///
/// CMD_DEBUG_VARS_3 (254), to the board, selected form; 4 to 32 bytes. Effect: reads. Since
/// firmware 2.72. Source: Outgoing commands L849.
struct DebugVars3RequestSelected {
  static constexpr CommandToBoard command = CommandToBoard::debug_vars_3;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::selected;
  static constexpr std::size_t min_size = 4;
  static constexpr std::size_t max_size = 32;
  static constexpr Availability since{.firmware = 2720};
  using Response = void;

  /// Bits of the selected variables, starting with the first variable. At least 1. At most 8.
  BoundedArray<std::uint32_t, 63> selected_mask{};

  bool operator==(const DebugVars3RequestSelected&) const = default;
  SBGC_ALWAYS_INLINE
  static constexpr void varying_members(auto& self, auto& cursor) noexcept {
    cursor.rest(self.selected_mask, "selected_mask", 1);
  }
};

/// Copy of a message on another port of the board.
///
/// CMD_SET_DEBUG_PORT (249), from the board; 4 to 255 bytes. Since firmware 2.60. Source: Later
/// firmware.
struct SetDebugPort {
  static constexpr CommandFromBoard command = CommandFromBoard::set_debug_port;
  static constexpr Direction direction = Direction::from_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 4;
  static constexpr std::size_t max_size = 255;
  static constexpr Availability since{.firmware = 2600};

  /// Time since the board started. Unit: ms.
  MillisecondClock time_ms{};
  /// Port and direction of the message.
  DebugPortLine port_and_dir{};
  /// Command of the message.
  std::uint8_t cmd_id{};
  /// Body of the message.
  BoundedBytes<251> payload{};

  bool operator==(const SetDebugPort&) const = default;
  using FixedMembers = Members<&SetDebugPort::time_ms, &SetDebugPort::port_and_dir,
      &SetDebugPort::cmd_id>;
  SBGC_ALWAYS_INLINE
  static constexpr void varying_members(auto& self, auto& cursor) noexcept {
    cursor.rest(self.payload, "payload");
  }
};

/// Start or stop the copies of the messages on the board's other ports.
///
/// CMD_SET_DEBUG_PORT (249), to the board; 16 bytes. Effect: sets. Since firmware 2.60. Source:
/// Later firmware.
struct SetDebugPortRequest {
  static constexpr CommandToBoard command = CommandToBoard::set_debug_port;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 16;
  static constexpr std::size_t max_size = 16;
  static constexpr Availability since{.firmware = 2600};
  using Response = void;

  /// Operation.
  DebugPortAction action{};
  /// Messages that are not copied. Of boards with PLUS_VER.
  DebugPortCommands cmd_filter{};
  /// Reserved; kept as it is.
  Bytes<11> reserved{};

  bool operator==(const SetDebugPortRequest&) const = default;
  using FixedMembers = Members<&SetDebugPortRequest::action, &SetDebugPortRequest::cmd_filter,
      &SetDebugPortRequest::reserved>;
};

}  // namespace sbgc::msg
