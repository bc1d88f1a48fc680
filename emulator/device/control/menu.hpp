/// The menu actions, started by a button, an RC signal or a request.
#pragma once

#include <cstddef>

#include <sbgc/emulator/gimbal.hpp>
#include <sbgc/enums.hpp>
#include <sbgc/time.hpp>

#include "device/calibration/calibrations.hpp"

namespace sbgc::emulator {

class FileSystem;
class QuaternionControl;
class RemoteControl;
class Scripts;
class Streams;
class Tasks;
struct Modes;

/// The parts that the actions of the menu, tasks and events use.
struct MenuParts {
  CalibrationParts& calibration;
  const BoardOptions& options;
  Parameters& parameters;
  const FileSystem& files;
  Gimbal& gimbal;
  const Tuning& tuning;
  Ports& ports;
  Streams& streams;
  RemoteControl& remote;
  Calibrations& calibrations;
  AutoTuning& auto_tuning;
  Scripts& scripts;
  QuaternionControl& quaternions;
  Tasks& tasks;
  Modes& modes;
  Imus& imus;
  Restarts& restarts;
};

/// Executes an action. Returns false if there is no such action.
bool execute_menu(MenuParts& parts, msg::MenuCommand action, Instant now);

}  // namespace sbgc::emulator
