/// The output of `sbgc --version`.
#pragma once

#include <string>

namespace sbgc::tools {

/// Returns the version of the library and the command, the protocol, and the fingerprint of its
/// model.
std::string version_text();

}  // namespace sbgc::tools
