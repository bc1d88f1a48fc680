// Generated from spec/ by generator/: edit those, then run ./dev generate.

/// Variables inside the firmware that show the state of the system.
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

struct DebugVars3;
struct DebugVarsInfo3;

/// The variables.
struct DebugVarInfo {
  /// Name of the variable.
  BoundedText<255> var_name{};
  /// Its type. Errata: E055.
  DebugVarType var_type{};
  /// How many elements it has; no board is known to send arrays. 0: a scalar. 1: a scalar. Errata:
  /// E006, E113, E218.
  std::uint16_t arr_size{};

  constexpr bool operator==(const DebugVarInfo&) const = default;
};

constexpr void read(detail::Reader& reader, DebugVarInfo& out) noexcept {
  reader.value(out.var_name, "var_name");
  reader.value(out.var_type, "var_type");
  reader.value(out.arr_size, "arr_size");
}
constexpr void write(detail::Writer& writer, const DebugVarInfo& in) noexcept {
  writer.value(in.var_name, "var_name");
  writer.value(in.var_type, "var_type");
  writer.value(in.arr_size, "arr_size");
}

/// Names and types of the debug variables, in the order of CMD_DEBUG_VARS_3.
///
/// CMD_DEBUG_VARS_INFO_3 (253), from the board; 1 to 255 bytes, and later firmware may append more.
/// Since board 3.0.
/// Source: Incoming commands L476-L487; Variables L1185-L1189. Errata: E027.
struct DebugVarsInfo3 {
  static constexpr CommandFromBoard command = CommandFromBoard::debug_vars_info_3;
  static constexpr Direction direction = Direction::from_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 1;
  static constexpr std::size_t max_size = 255;
  static constexpr Availability since{0, 30};

  /// The variables. Errata: E027.
  BoundedArray<DebugVarInfo, 63> vars{};
  /// What later firmware appends; kept, and written back.
  BoundedBytes<254> tail{};

  constexpr bool operator==(const DebugVarsInfo3&) const = default;
};

[[nodiscard]] constexpr Status decode(std::span<const std::uint8_t> body,
                                      DebugVarsInfo3& out) noexcept {
  detail::Reader reader(body, 0);
  std::uint8_t debug_vars_num_count = 0;
  reader.value(debug_vars_num_count, "debug_vars_num");
  reader.array(out.vars, debug_vars_num_count, "vars");
  return reader.end(out.tail);
}

[[nodiscard]] constexpr WriteResult encode(const DebugVarsInfo3& in,
                                           std::span<std::uint8_t> out) noexcept {
  detail::Writer writer(out, 0);
  writer.value(static_cast<std::uint8_t>(in.vars.size()), "debug_vars_num");
  writer.array(in.vars, "vars");
  writer.array(in.tail, "tail");
  return writer.end();
}

/// Ask for names and types of the debug variables.
///
/// CMD_DEBUG_VARS_INFO_3 (253), to the board; 0 bytes.
/// Effect: reads.
/// Since board 3.0.
/// Source: Outgoing commands L847.
struct DebugVarsInfo3Request {
  static constexpr CommandToBoard command = CommandToBoard::debug_vars_info_3;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 0;
  static constexpr std::size_t max_size = 0;
  static constexpr Availability since{0, 30};
  using Response = DebugVarsInfo3;

  constexpr bool operator==(const DebugVarsInfo3Request&) const = default;
};

[[nodiscard]] constexpr Status decode(std::span<const std::uint8_t> body,
                                      DebugVarsInfo3Request& out) noexcept {
  if (body.size() != 0) return detail::wrong_size(body.size(), 0);
  static_cast<void>(out);
  return {};
}

[[nodiscard]] constexpr WriteResult encode(const DebugVarsInfo3Request& in,
                                           std::span<std::uint8_t> out) noexcept {
  static_cast<void>(in);
  static_cast<void>(out);
  return {0, {}};
}

/// Values of the debug variables.
///
/// CMD_DEBUG_VARS_3 (254), from the board; 0 to 255 bytes, and later firmware may append more.
/// Since board 3.0.
/// Source: Incoming commands L489-L499. Errata: E113.
struct DebugVars3 {
  static constexpr CommandFromBoard command = CommandFromBoard::debug_vars_3;
  static constexpr Direction direction = Direction::from_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 0;
  static constexpr std::size_t max_size = 255;
  static constexpr Availability since{0, 30};

  /// What has to be known from earlier messages to read the body.
  struct Context {
    /// The types that CMD_DEBUG_VARS_INFO_3 has announced; without them the values are not read.
    NumberTypes types{};
  };

  /// The values one behind the other, each with the type and the number of elements that
  /// CMD_DEBUG_VARS_INFO_3 announces; which variables there are differs between firmwares. Errata:
  /// E113.
  BoundedArray<Number, 255> var_value{};
  /// What later firmware appends; kept, and written back.
  BoundedBytes<255> tail{};

  constexpr bool operator==(const DebugVars3&) const = default;
};

[[nodiscard]] constexpr Status decode(std::span<const std::uint8_t> body,
                                      DebugVars3& out,
                                      const DebugVars3::Context& context = {}) noexcept {
  detail::Reader reader(body, 0);
  reader.numbers(out.var_value, context.types);
  return reader.end(out.tail);
}

[[nodiscard]] constexpr WriteResult encode(const DebugVars3& in,
                                           std::span<std::uint8_t> out) noexcept {
  detail::Writer writer(out, 0);
  writer.numbers(in.var_value, "var_value");
  writer.array(in.tail, "tail");
  return writer.end();
}

/// Ask for the values of the debug variables.
///
/// CMD_DEBUG_VARS_3 (254), to the board; 0 bytes.
/// Effect: reads.
/// Since board 3.0.
/// Source: Outgoing commands L849.
struct DebugVars3Request {
  static constexpr CommandToBoard command = CommandToBoard::debug_vars_3;
  static constexpr Direction direction = Direction::to_board;
  static constexpr Form form = Form::only;
  static constexpr std::size_t min_size = 0;
  static constexpr std::size_t max_size = 0;
  static constexpr Availability since{0, 30};
  using Response = DebugVars3;

  constexpr bool operator==(const DebugVars3Request&) const = default;
};

[[nodiscard]] constexpr Status decode(std::span<const std::uint8_t> body,
                                      DebugVars3Request& out) noexcept {
  if (body.size() != 0) return detail::wrong_size(body.size(), 0);
  static_cast<void>(out);
  return {};
}

[[nodiscard]] constexpr WriteResult encode(const DebugVars3Request& in,
                                           std::span<std::uint8_t> out) noexcept {
  static_cast<void>(in);
  static_cast<void>(out);
  return {0, {}};
}

}  // namespace sbgc::msg
