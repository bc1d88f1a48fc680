/// Frames without their start bytes.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include <sbgc/frame.hpp>

namespace sbgc::tools {

/// A frame as programs keep it that take off the start byte, and perhaps the checksum behind the
/// body.
struct BareFrame {
  Frame frame{};  ///< its offset is that of the id
  bool has_checksum{};
};

/// Returns the frames of known commands that the bytes are; none if they are anything else as well.
std::vector<BareFrame> bare_frames(std::span<const std::uint8_t> bytes);

/// "without its start byte and the checksum behind the body".
std::string what_is_missing(const BareFrame& bare);

}  // namespace sbgc::tools
