#include "device/debug/debugging.hpp"

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <string_view>

#include <sbgc/messages/debug.hpp>
#include <sbgc/meta/enums.hpp>

#include "device/parameters/parameters.hpp"
#include "device/peripherals/outputs.hpp"
#include "device/ports.hpp"
#include "device/realtime/measured_parts.hpp"
#include "device/scripting/scripts.hpp"
#include "device/system/restarts.hpp"
#include "physics/quantities.hpp"

namespace sbgc::emulator {
namespace {

/// The source of the values.
struct View {
  MeasuredParts& parts;
  Sample sample;
  Instant now;
};

struct Variable {
  std::string_view name;
  msg::DebugVarKind kind;
  double (*value)(const View& view);
  msg::DebugVarAxis axis = msg::DebugVarAxis::no_axis;
  bool is_angle = false;  ///< 16384 counts per turn
};

/// Returns the raw value.
double counts(double degrees) { return wire_angle(degrees).raw(); }
double counts(msg::GyroRate rate) { return rate.raw(); }

using Axis = msg::DebugVarAxis;

// Scalars only: readers of real boards do not support arrays.
constexpr std::array<Variable, 18> variables{{
    {"UPTIME_MS", msg::DebugVarKind::uint32,
     [](const View& v) {
       return std::floor(static_cast<double>((v.now - v.parts.restarts.started()).us) / 1000);
     }},
    {"ROLL", msg::DebugVarKind::int16, [](const View& v) { return counts(v.sample.angles.roll); },
     Axis::roll, true},
    {"PITCH", msg::DebugVarKind::int16, [](const View& v) { return counts(v.sample.angles.pitch); },
     Axis::pitch, true},
    {"YAW", msg::DebugVarKind::int16, [](const View& v) { return counts(v.sample.angles.yaw); },
     Axis::yaw, true},
    {"YAW_JOINT", msg::DebugVarKind::int32,
     [](const View& v) { return v.sample.joints.yaw / msg::LongAngle14(1).degrees(); }, Axis::yaw,
     true},
    {"GYRO_X", msg::DebugVarKind::int16,
     [](const View& v) { return counts(saturated<msg::GyroRate>(v.sample.gyro.x)); }},
    {"GYRO_Y", msg::DebugVarKind::int16,
     [](const View& v) { return counts(saturated<msg::GyroRate>(v.sample.gyro.y)); }},
    {"GYRO_Z", msg::DebugVarKind::int16,
     [](const View& v) { return counts(saturated<msg::GyroRate>(v.sample.gyro.z)); }},
    {"POWER_ROLL", msg::DebugVarKind::uint8,
     [](const View& v) { return v.sample.power.roll * 255; }, Axis::roll},
    {"POWER_PITCH", msg::DebugVarKind::uint8,
     [](const View& v) { return v.sample.power.pitch * 255; }, Axis::pitch},
    {"POWER_YAW", msg::DebugVarKind::uint8, [](const View& v) { return v.sample.power.yaw * 255; },
     Axis::yaw},
    {"BATTERY", msg::DebugVarKind::float32,
     [](const View& v) { return v.parts.measured_battery(v.sample); }},
    {"TEMPERATURE", msg::DebugVarKind::int8, [](const View& v) { return v.sample.temperature; }},
    {"ERRORS", msg::DebugVarKind::uint16,
     [](const View& v) -> double { return v.parts.errors(v.now).raw(); }},
    {"PROFILE", msg::DebugVarKind::uint8,
     [](const View& v) -> double { return v.parts.parameters.profile(); }},
    {"SCRIPT_CMD", msg::DebugVarKind::uint16,
     [](const View& v) -> double { return v.parts.scripts.command(); }},
    {"SOUND", msg::DebugVarKind::uint16,
     [](const View& v) -> double {
       const auto sound = v.parts.outputs.sound();
       return sound ? sound->mode.raw() : 0;
     }},
    {"HIGH_PINS", msg::DebugVarKind::uint16,
     [](const View& v) -> double { return v.parts.outputs.high_pins(); }},
}};

/// Returns the nearest number of this type; integers out of range wrap.
Number number(NumberType type, double value) {
  if (type == NumberType::f32) {
    return {type, std::bit_cast<std::uint32_t>(static_cast<float>(value))};
  }
  const auto bits = static_cast<std::uint64_t>(std::llround(value));
  const unsigned unused = 64 - 8 * static_cast<unsigned>(size_of(type));
  return {type, static_cast<std::uint32_t>(bits << unused >> unused)};
}

}  // namespace

msg::DebugVarsInfo3 debug_variables_info(std::size_t first) {
  msg::DebugVarsInfo3 info;
  for (std::size_t i = first; i < variables.size(); ++i) {
    const Variable& variable = variables[i];
    msg::DebugVarInfo one;
    one.var_name.assign(variable.name);
    one.var_type.set_kind(variable.kind);
    one.var_type.set_axis(variable.axis);
    if (variable.is_angle) one.var_type.set_flags(msg::DebugVarFlag::angle14);
    info.vars.push_back(one);
  }
  return info;
}

msg::DebugVars3 debug_variable_values(MeasuredParts& parts, Instant now) {
  const View view{parts, parts.gimbal.sample(now), now};
  msg::DebugVars3 values;
  for (const Variable& variable : variables) {
    values.var_value.push_back(number(number_type(variable.kind), variable.value(view)));
  }
  return values;
}

namespace {

/// The flag of a command has the same name; other commands have none.
bool is_filtered(msg::DebugPortCommands filter, std::uint8_t command, bool is_to_host) {
  const auto name_of = [command](const EnumInfo& info) {
    for (const ValueInfo& value : info.values) {
      if (value.value == command) return std::string_view(value.name);
    }
    return std::string_view();
  };
  std::string_view name = is_to_host ? name_of(EnumMeta<msg::CommandFromBoard>::info)
                                     : name_of(EnumMeta<msg::CommandToBoard>::info);
  constexpr std::string_view prefix = "CMD_";
  if (name.starts_with(prefix)) name.remove_prefix(prefix.size());
  for (const ValueInfo& flag : EnumMeta<msg::DebugPortCommand>::info.values) {
    if (name == flag.name) return filter.has(static_cast<msg::DebugPortCommand>(flag.value));
  }
  return false;
}

}  // namespace

void DebugCopies::copy(Ports& ports, msg::MillisecondClock time, std::size_t port,
                       const Frame& frame, bool is_to_host) {
  // Copies of copies would never end.
  if (frame.id == static_cast<std::uint8_t>(msg::SetDebugPort::command) && is_to_host) return;
  for (std::size_t to = 0; to < filters_.size(); ++to) {
    if (to == port || !filters_[to] || is_filtered(*filters_[to], frame.id, is_to_host)) continue;
    msg::SetDebugPort copy;
    copy.time_ms = time;
    static_cast<void>(copy.port_and_dir.set_port(static_cast<std::uint8_t>(port)));
    copy.port_and_dir.set_direction(is_to_host);
    copy.cmd_id = frame.id;
    // The longest bodies do not fit and are cut off.
    for (const std::uint8_t byte : frame.body) {
      if (!copy.payload.push_back(byte)) break;
    }
    static_cast<void>(ports.offer(to, copy));
  }
}

}  // namespace sbgc::emulator
