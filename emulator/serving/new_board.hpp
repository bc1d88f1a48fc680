/// The inputs of a new board: shares and motions in text form, and its memory.
#pragma once

#include <optional>
#include <string_view>

#include <sbgc/emulator/board_options.hpp>
#include <sbgc/emulator/disturbance.hpp>
#include <sbgc/emulator/memory.hpp>

namespace sbgc::serving {

/// Parses "0.01" or "1%". Returns nothing for other text or a share outside the range.
std::optional<double> read_share(std::string_view text, double least, double most);

/// Returns the motion with this name, such as "handheld".
std::optional<emulator::Disturbance::Kind> motion_named(std::string_view name);

/// Returns a new memory; the accelerometer is calibrated unless a fault says otherwise.
emulator::Memory new_memory(const emulator::BoardOptions& board);

}  // namespace sbgc::serving
