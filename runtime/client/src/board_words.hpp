/// What the board says, in words.
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include <sbgc/codec.hpp>

namespace sbgc::detail {

/// "CMD_BEEP_SOUND", or "command 89" if no message in this direction has the id.
std::string command_name(std::uint8_t id, Direction direction);
/// What the board says in a message that reports a failure: "WRONG_STATE" in an error, or
/// "err_code ERR_FILE_NOT_FOUND (2)".
std::string describe(std::uint8_t id, std::span<const std::uint8_t> body);

}  // namespace sbgc::detail
