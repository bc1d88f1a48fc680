/// Versions, numbers and errors in words.
#pragma once

#include <cstdint>
#include <string>
#include <system_error>

#include <sbgc/status.hpp>

namespace sbgc::detail {

/// 2439 -> "2.43b9", 2590 -> "2.59".
std::string firmware_text(std::uint16_t version);
/// 30 -> "3.0".
std::string board_text(std::uint8_t version);
/// Without decimals where there are none.
std::string number_text(double value);
/// "note_length: The value does not fit into the field".
std::string status_text(const Status& status);
/// A sentence as this library writes them: without the final stop.
std::string without_stop(std::string sentence);

}  // namespace sbgc::detail
