/// The faults of `sbgc emulate --fault`, by name.
#pragma once

#include <string>

#include <sbgc/emulator/board_options.hpp>

namespace sbgc::serving {

/// The names of all faults with their values, for the help: "low-battery, imu, resonance=37Hz …".
std::string fault_names();

/// Adds the faults of a list such as "low-battery,resonance=37Hz:0.1:pitch" to the board. Returns a
/// sentence that states the first mistake and the expected format, or "".
[[nodiscard]] std::string add_faults(const std::string& list, emulator::BoardOptions& board);

}  // namespace sbgc::serving
