/// New firmware for the modules of a board.
///
/// A module whose update was interrupted has no firmware, and does not work until a later update
/// completes. Keep the power on.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include <sbgc/client/progress.hpp>
#include <sbgc/client/task.hpp>
#include <sbgc/messages/modules.hpp>
#include <sbgc/responses/modules.hpp>

namespace sbgc {

/// The largest firmware of a module, in bytes. Assumption.
inline constexpr std::size_t max_module_firmware = 4U << 20U;

/// Returns the reason why a file cannot be the firmware of a module; nothing if it can.
std::optional<ClientError> module_firmware_problem(std::size_t size);

namespace tasks {

/// Loads firmware into a module that CMD_MODULE_LIST lists. Each part is sent once, after the board
/// has confirmed the previous one. Any error ends the update, and names the part that was confirmed
/// last; it can only be repeated from the beginning then. Progress counts bytes; if its handler
/// returns false, the update ends as with an error.
///
/// A line that may duplicate packets, UDP or one with a ConnectOptions::duplicate_window, is
/// rejected with ErrorCode::unsupported: confirmations do not name their part. Errors: those of
/// Client::call(); `invalid` like module_firmware_problem(), `not_found` if the board does not list
/// the module.
Task<Result<void>> flash_module(msg::ModuleId module, std::vector<std::uint8_t> firmware,
                                ProgressHandler progress = {});

}  // namespace tasks
}  // namespace sbgc
