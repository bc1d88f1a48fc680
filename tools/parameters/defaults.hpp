/// The factory defaults of a board. The protocol has no request for them, only one that goes back
/// to them.
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
/// The protocol has no request for them: sets one profile to its defaults, reads it, and writes all
/// parameters back. `before` has these parameters and must be saved. Throws CommandError; if the
/// parameters could not be written back, it has printed what the board holds.
ParameterSet read_defaults(Client& client, const Backup& before, std::uint8_t profile,
                           const CallOptions& options);

/// Keeps the factory defaults of a board on this machine, in ~/.cache/sbgc. Without such a folder,
/// it does nothing.
void keep_defaults(const BoardIdentity& board, const ParameterSet& defaults);

/// Returns the defaults that were kept. Throws CommandError, which says how to read them, if there
/// are none of this board with its firmware.
ParameterSet kept_defaults(const BoardIdentity& board);

/// Sets a profile to its defaults. Without a confirmation, it succeeds only if the parameters of
/// the profile are no longer those of `before`; otherwise it fails with ErrorCode::unconfirmed.
Task<Result<void>> use_defaults(std::uint8_t profile, ParameterSet before, CallOptions options);

/// The same, and returns the parameters of the profile. If nothing shows that they are the
/// defaults, it changes one in the profile and looks whether that goes back.
Task<Result<ParameterSet>> find_defaults(std::uint8_t profile, ParameterSet before,
                                         CallOptions options);

}  // namespace sbgc::tools
