/// Frames from JSON lines, as printed by `sbgc decode`.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace sbgc::tools {

struct EncodeRules {
  bool no_validate = false;  ///< also encode values that the specification does not allow
  bool defaults = false;     ///< fill in fields that a line leaves out
};

/// Returns the frame that a line describes. The line may be untrusted. Throws std::runtime_error,
/// which describes the error in it.
std::vector<std::uint8_t> encode_line(const std::string& text, const EncodeRules& rules);

}  // namespace sbgc::tools
