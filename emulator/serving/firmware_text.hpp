/// Firmware versions as users write them.
#pragma once

#include <string>

#include <sbgc/enums.hpp>

namespace sbgc::serving {

/// Any version, for example "2.43b9" or "2.73.1". Throws std::invalid_argument with a sentence that
/// states the error and the expected format.
msg::FirmwareVersion read_firmware(const std::string& text);

}  // namespace sbgc::serving
