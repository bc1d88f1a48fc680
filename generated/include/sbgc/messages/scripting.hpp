// Generated from spec/ by generator/: edit those, then run ./dev generate.

/// User scripts that the board runs.
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

/// Start or stop a script.
///
/// CMD_RUN_SCRIPT (57), to the board; 34 bytes. Effect: sets, stores, moves, restarts. Since board
/// 3.0. Source: Outgoing commands L934-L938.
struct RunScript {
  static constexpr CommandToBoard command = CommandToBoard::run_script;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 34;
  static constexpr std::size_t max_size = 34;
  static constexpr Availability since{.board = 30};
  using Response = void;

  /// Operation.
  ScriptMode mode{};
  /// Script slot, counted from 0.
  std::uint8_t slot{};
  /// Reserved; kept as it is.
  Bytes<32> reserved{};

  bool operator==(const RunScript&) const = default;
  using FixedMembers = Members<&RunScript::mode, &RunScript::slot, &RunScript::reserved>;
};

/// Progress of a script started with debugging.
///
/// CMD_SCRIPT_DEBUG (58), from the board; 3 bytes, and later firmware may append more. Since board
/// 3.0. Source: Incoming commands L577-L580; Outgoing commands L916-L928.
struct ScriptDebug {
  static constexpr CommandFromBoard command = CommandFromBoard::script_debug;
  static constexpr Direction direction = Direction::from_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 3;
  static constexpr std::size_t max_size = 3;
  static constexpr Availability since{.board = 30};

  /// Number of the running script command.
  std::uint16_t cmd_count{};
  /// Error code; unlisted codes are possible.
  FileError err_code{};
  /// Bytes appended by later firmware; preserved and written back.
  BoundedBytes<252> tail{};

  bool operator==(const ScriptDebug&) const = default;
  using FixedMembers = Members<&ScriptDebug::cmd_count, &ScriptDebug::err_code>;
};

}  // namespace sbgc::msg
