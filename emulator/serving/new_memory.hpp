/// The memory of a board as it is delivered.
#pragma once

#include <sbgc/emulator/board_options.hpp>
#include <sbgc/emulator/memory.hpp>

namespace sbgc::serving {

/// A gimbal is delivered with a calibrated accelerometer, unless the fault is that it is not.
emulator::Memory new_memory(const emulator::BoardOptions& board);

}  // namespace sbgc::serving
