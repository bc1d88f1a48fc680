/// Recorded motion of the frame that carries a gimbal.
#pragma once

#include <filesystem>
#include <istream>
#include <string>
#include <vector>

#include <sbgc/emulator/disturbance.hpp>

namespace sbgc::serving {

/// Reads lines "time,roll,pitch,yaw": ascending seconds, and degrees. Empty lines, lines that begin
/// with '#' and a heading in the first line are skipped. Times count from the first. Throws
/// std::runtime_error; its text begins with `name` and the number of the line.
std::vector<emulator::FrameAngles> read_motion(std::istream& text, const std::string& name);

/// The same from a file. Also throws std::runtime_error if it cannot be read.
std::vector<emulator::FrameAngles> load_motion(const std::filesystem::path& file);

}  // namespace sbgc::serving
