/// What a file has to replay.
#pragma once

#include <string>

namespace sbgc::tools {

/// Reads a capture, or the raw bytes of a board. Returns a message about its damaged parts, which a
/// replay leaves out; "" if there are none. Throws CommandError if it has nothing to replay.
std::string check_capture(const std::string& file);
/// The same for the file at an address; "" if that is not of a capture, or there is no such file.
std::string damage_at(const std::string& address);

}  // namespace sbgc::tools
