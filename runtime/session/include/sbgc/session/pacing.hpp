/// Pauses between commands.
#pragma once

#include <cstddef>

#include <sbgc/line.hpp>
#include <sbgc/protocol.hpp>
#include <sbgc/session/event.hpp>

namespace sbgc::detail {

/// Returns the pause after a command with these frame sizes: longer for larger frames, as the
/// protocol requires, and never shorter than the response takes on the line, so that the board's
/// output buffer does not overflow.
constexpr Duration pause_after(const SessionOptions& options, std::size_t request_size,
                               std::size_t response_size) noexcept {
  const Duration shortest = options.pacing.shortest;
  const Duration longest = options.pacing.longest;
  if (longest <= Duration{}) return {};
  constexpr auto both_largest = static_cast<std::int32_t>(2 * max_frame_size);
  const auto both = static_cast<std::int32_t>(request_size + response_size);
  const Duration pause = shortest + Duration{((longest - shortest) * both).us / both_largest};
  const Duration response = wire_time(options.line, response_size);
  return pause < response ? response : pause;
}

}  // namespace sbgc::detail
