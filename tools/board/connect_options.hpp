/// Converts the options of a gimbal to those of the library.
#pragma once

#include <sbgc/client/options.hpp>

#include "command/gimbal_options.hpp"

namespace sbgc::tools {

/// Returns the options with those of the named gimbal in the configuration file filled in. Throws
/// CommandError.
GimbalOptions with_configuration(const GimbalOptions& options);

/// Returns the options of the library, without `wrap`.
ConnectOptions connect_options(const GimbalOptions& options);

/// Says that a capture holds the password.
void warn_of_password_in(const std::string& capture);

/// Returns the options of a call that takes a timeout of its own.
CallOptions call_options(const GimbalOptions& options);

}  // namespace sbgc::tools
