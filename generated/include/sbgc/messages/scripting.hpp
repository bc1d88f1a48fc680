// Generated from spec/ by generator/: edit those, then run ./dev generate.

/// Scripts that the user writes and the board runs.
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

/// Start or stop a script.
///
/// CMD_RUN_SCRIPT (57), to the board; 34 bytes.
/// Effect: sets, stores, moves, restarts.
/// Since board 3.0.
/// Source: Outgoing commands L934-L938.
struct RunScript {
  static constexpr CommandToBoard command = CommandToBoard::run_script;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 34;
  static constexpr std::size_t max_size = 34;
  static constexpr Availability since{0, 30};
  using Response = void;

  /// What to do. Errata: E105.
  ScriptMode mode{};
  /// Slot of the script; whether slots count from 0 or from 1 is unknown. Errata: E079.
  std::uint8_t slot{};
  /// Reserved; kept as it is.
  Bytes<32> reserved{};

  constexpr bool operator==(const RunScript&) const = default;
};

constexpr void get(const std::uint8_t* SBGC_RESTRICT from,
                   RunScript& SBGC_RESTRICT out) noexcept {
  using M = RunScript;
  if (!std::is_constant_evaluated() &&
      detail::in_parallel(offsetof(M, mode), offsetof(M, reserved), 2)) {
    detail::get_block(from, out, offsetof(M, mode), 34);
    return;
  }
  get(from, out.mode);
  get(from + 1, out.slot);
  get(from + 2, out.reserved);
}
constexpr void put(std::uint8_t* SBGC_RESTRICT to,
                   const RunScript& SBGC_RESTRICT in) noexcept {
  using M = RunScript;
  if (!std::is_constant_evaluated() &&
      detail::in_parallel(offsetof(M, mode), offsetof(M, reserved), 2)) {
    detail::put_block(to, in, offsetof(M, mode), 34);
    return;
  }
  put(to, in.mode);
  put(to + 1, in.slot);
  put(to + 2, in.reserved);
}

[[nodiscard]] constexpr Status decode(std::span<const std::uint8_t> body,
                                      RunScript& out) noexcept {
  if (body.size() != 34) return detail::wrong_size(body.size(), 34);
  get(body.data(), out);
  return {};
}

[[nodiscard]] constexpr WriteResult encode(const RunScript& in,
                                           std::span<std::uint8_t> out) noexcept {
  if (out.size() < 34) return {0, {Code::buffer_too_small}};
  put(out.data(), in);
  return {34, {}};
}

[[gnu::always_inline]] inline bool add_in_memory(detail::ByteSum& sum,
                                                 const RunScript& in) noexcept {
  using M = RunScript;
  if (!(detail::in_parallel(offsetof(M, mode), offsetof(M, reserved), 2))) return false;
  detail::add_block(sum, in, offsetof(M, mode), 34);
  return true;
}

/// Progress of a script that was started with debugging.
///
/// CMD_SCRIPT_DEBUG (58), from the board; 3 bytes, and later firmware may append more.
/// Since board 3.0.
/// Source: Incoming commands L577-L580; Outgoing commands L916-L928.
struct ScriptDebug {
  static constexpr CommandFromBoard command = CommandFromBoard::script_debug;
  static constexpr Direction direction = Direction::from_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 3;
  static constexpr std::size_t max_size = 3;
  static constexpr Availability since{0, 30};

  /// Number of the script's command that runs now.
  std::uint16_t cmd_count{};
  /// What went wrong; codes that are not listed are possible. Errata: E110.
  FileError err_code{};
  /// What later firmware appends; kept, and written back.
  BoundedBytes<252> tail{};

  constexpr bool operator==(const ScriptDebug&) const = default;
};

constexpr void get(const std::uint8_t* SBGC_RESTRICT from,
                   ScriptDebug& SBGC_RESTRICT out) noexcept {
  get(from, out.cmd_count);
  get(from + 2, out.err_code);
}
constexpr void put(std::uint8_t* SBGC_RESTRICT to,
                   const ScriptDebug& SBGC_RESTRICT in) noexcept {
  put(to, in.cmd_count);
  put(to + 2, in.err_code);
}

[[nodiscard]] constexpr Status decode(std::span<const std::uint8_t> body,
                                      ScriptDebug& out) noexcept {
  if (body.size() < 3) return detail::wrong_size(body.size(), 3);
  get(body.data(), out);
  return detail::get_tail(body, 3, out.tail);
}

[[nodiscard]] constexpr WriteResult encode(const ScriptDebug& in,
                                           std::span<std::uint8_t> out) noexcept {
  const std::size_t size = 3 + in.tail.size();
  if (out.size() < size) return {0, {Code::buffer_too_small}};
  put(out.data(), in);
  detail::put_tail(out.data() + 3, in.tail);
  return {size, {}};
}

}  // namespace sbgc::msg
