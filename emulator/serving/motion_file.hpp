/// Recorded motion of the frame that carries a gimbal.
#pragma once

#include <filesystem>
#include <istream>
#include <string>
#include <vector>

#include <sbgc/emulator/disturbance.hpp>

namespace sbgc::serving {

/// Reads lines "time,roll,pitch,yaw", in ascending seconds and degrees. Skips empty lines, lines
/// that start with '#', and a header in the first line. Times are relative to the first one. Throws
/// std::runtime_error whose text begins with `name` and the line number.
std::vector<emulator::FrameAngles> read_motion(std::istream& text, const std::string& name);

/// Reads the same from a file. Also throws std::runtime_error if the file cannot be read.
std::vector<emulator::FrameAngles> load_motion(const std::filesystem::path& file);

}  // namespace sbgc::serving
