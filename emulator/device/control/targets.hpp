/// The targets of each axis in a request to move the camera.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

#include <sbgc/emulator/gimbal.hpp>
#include <sbgc/messages/control.hpp>
#include <sbgc/time.hpp>
#include <sbgc/types.hpp>

namespace sbgc::emulator {

class ControlLink;
class Parameters;
class QuaternionControl;
class Tasks;
struct Modes;

/// The parts that commands to move the camera use.
struct ControlParts {
  ControlLink& control_link;
  QuaternionControl& quaternions;
  Tasks& tasks;
  Modes& modes;
  Gimbal& gimbal;
  const Parameters& parameters;
  const Tuning& tuning;
};

struct AxisTarget {
  msg::ControlMode mode{};
  double speed{};         ///< deg/s
  double angle{};         ///< degrees
  std::int32_t signal{};  ///< the raw angle, which is an RC signal in some modes
};
/// Axes without a target keep their state.
using AxisTargets = Axes<std::optional<AxisTarget>>;

AxisTargets targets_of(const msg::ControlExtCommand& request);

/// Returns the command for the gimbal; nothing if there is no such mode. MODE_IGNORE results in no
/// command and must be handled before.
std::optional<AxisCommand> command_of(const ControlParts& parts, std::size_t axis,
                                      const AxisTarget& target, Instant now);

/// True if the end of the motion must be confirmed.
bool is_task(const AxisTarget& target);

}  // namespace sbgc::emulator
