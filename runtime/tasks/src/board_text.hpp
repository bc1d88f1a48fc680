/// Messages of the board as text.
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include <sbgc/codec.hpp>
#include <sbgc/status.hpp>

namespace sbgc {
struct Contexts;
}

namespace sbgc::detail {

/// For example "CMD_BEEP_SOUND", or "command 89" if no message in this direction has the id.
std::string command_name(std::uint8_t id, Direction direction);
/// Describes a message that reports a failure: "WRONG_STATE" for an error, or "err_code
/// ERR_FILE_NOT_FOUND (2)".
std::string describe(std::uint8_t id, std::span<const std::uint8_t> body);
/// For example "CMD_BOARD_INFO cannot be decoded: 17 bytes, the message needs 18". `status` is the
/// result of decoding.
std::string undecodable(const Status& status, std::uint8_t id, std::span<const std::uint8_t> body,
                        const Contexts& contexts);

}  // namespace sbgc::detail
