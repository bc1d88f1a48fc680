/// When the next command may be sent.
#pragma once

#include <cstddef>

#include <sbgc/line.hpp>
#include <sbgc/protocol.hpp>
#include <sbgc/session/event.hpp>

namespace sbgc::detail {

/// The break behind a command with these frame sizes: longer for larger ones, as the protocol asks,
/// and never shorter than the answer takes on the line, lest the board's output buffer fill up.
constexpr Duration pause_behind(const SessionOptions& options, std::size_t request_size,
                                std::size_t answer_size) noexcept {
  const auto [shortest, longest] = options.pacing;
  if (longest <= Duration{}) return {};
  constexpr auto both_largest = static_cast<std::int32_t>(2 * max_frame_size);
  const auto both = static_cast<std::int32_t>(request_size + answer_size);
  const Duration pause = shortest + Duration{((longest - shortest) * both).us / both_largest};
  const Duration answer = wire_time(options.line, answer_size);
  return pause < answer ? answer : pause;
}

}  // namespace sbgc::detail
