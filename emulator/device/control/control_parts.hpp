/// The parts that commands to move the camera use.
#pragma once

#include <sbgc/emulator/gimbal.hpp>

namespace sbgc::emulator {

class ControlLink;
class Parameters;
class QuaternionControl;
class Tasks;
struct Modes;

struct ControlParts {
  ControlLink& control_link;
  QuaternionControl& quaternions;
  Tasks& tasks;
  Modes& modes;
  Gimbal& gimbal;
  const Parameters& parameters;
  const Tuning& tuning;
};

}  // namespace sbgc::emulator
