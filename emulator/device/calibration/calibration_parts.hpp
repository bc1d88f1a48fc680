/// The parts that calibrations and the automatic tuning use.
#pragma once

#include <sbgc/emulator/board_options.hpp>
#include <sbgc/emulator/memory.hpp>

namespace sbgc::emulator {

class AutoTuning;
class Calibrations;
class Outputs;
class Parameters;
class Ports;
class Restarts;
struct Imus;

struct CalibrationParts {
  const BoardOptions& options;
  Memory& memory;
  Parameters& parameters;
  Gimbal& gimbal;
  Imus& imus;
  Outputs& outputs;
  Ports& ports;
  Restarts& restarts;
  Calibrations& calibrations;
  AutoTuning& auto_tuning;
};

}  // namespace sbgc::emulator
