/// The factory defaults of a profile, as tasks. The protocol has no request for them, only one that
/// goes back to them.
#pragma once

#include <cstdint>

#include <sbgc/client/options.hpp>
#include <sbgc/client/parameters.hpp>
#include <sbgc/client/task.hpp>

namespace sbgc::tools {

/// Sets a profile to its defaults. Without a confirmation, it succeeds only if the parameters of
/// the profile are no longer those of `before`; otherwise it fails with ErrorCode::unconfirmed.
Task<Result<void>> use_defaults(std::uint8_t profile, ParameterSet before, CallOptions options);

/// The same, and returns the parameters of the profile. If nothing shows that they are the
/// defaults, it changes one in the profile and looks whether that goes back.
Task<Result<ParameterSet>> find_defaults(std::uint8_t profile, ParameterSet before,
                                         CallOptions options);

}  // namespace sbgc::tools
