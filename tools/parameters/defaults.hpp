/// The factory defaults of a board. The protocol has no request for reading them, only one for
/// resetting to them.
#pragma once

#include <cstdint>
#include <string>

#include <sbgc/client/backup.hpp>
#include <sbgc/client/client.hpp>
#include <sbgc/client/options.hpp>
#include <sbgc/client/parameters.hpp>
#include <sbgc/client/task.hpp>

namespace sbgc::tools {

/// Returns the factory defaults as the parameters of every profile.
///
/// The protocol has no request for them: sets one profile to its defaults, reads it, and restores
/// all parameters. `before` has these parameters and must be saved. Throws CommandError; if the
/// parameters could not be restored, it has printed the values on the board.
ParameterSet read_defaults(Client& client, const Backup& before, std::uint8_t profile,
                           const CallOptions& options);

/// Stores the factory defaults of a board on this machine, in ~/.cache/sbgc. Does nothing without
/// such a folder.
void keep_defaults(const BoardIdentity& board, const ParameterSet& defaults);

/// Returns the stored defaults. Throws CommandError, which explains how to read them, if there are
/// none for this board with its firmware.
ParameterSet kept_defaults(const BoardIdentity& board);

/// Sets a profile to its defaults. Without a confirmation, it succeeds only if the parameters of
/// the profile are no longer those of `before`; otherwise it fails with ErrorCode::unconfirmed.
Task<Result<void>> use_defaults(std::uint8_t profile, ParameterSet before, CallOptions options);

/// The same, and returns the parameters of the profile. If it is uncertain that they are the
/// defaults, it changes one in the profile and checks whether it is reset.
Task<Result<ParameterSet>> find_defaults(std::uint8_t profile, ParameterSet before,
                                         CallOptions options);

}  // namespace sbgc::tools
