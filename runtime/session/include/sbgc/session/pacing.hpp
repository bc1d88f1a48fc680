/// Times of frames on the line, and pauses between commands.
#pragma once

#include <cstddef>
#include <cstdint>

#include <sbgc/internal/compiler.hpp>
#include <sbgc/line.hpp>
#include <sbgc/protocol.hpp>
#include <sbgc/session/event.hpp>
#include <sbgc/session/ticks.hpp>

namespace sbgc::detail {

/// The options of a session, preprocessed: all divisions are done.
class Settings {
 public:
  Ticks late;
  Ticks duplicates;
  Ticks idle;
  std::uint32_t stream_limit{};  // in bytes per second, 0: unlimited
  std::uint8_t attempts;
  bool until_response;

  // Inlined, so that the compiler converts constant options.
  SBGC_ALWAYS_INLINE explicit Settings(const SessionOptions& options) noexcept
      : late(ticks_of(options.late)),
        duplicates(ticks_of(options.duplicate_window)),
        idle(ticks_of(options.idle)),
        attempts(options.attempts),
        until_response(options.pacing.until_response),
        stream_percent_(options.stream_percent),
        longest_pause_(ticks_of(options.pacing.longest)),
        shortest_pause_(shorter(ticks_of(options.pacing.shortest), longest_pause_)),
        pause_per_byte_((longest_pause_ - shortest_pause_ + both_largest - 1) / both_largest) {
    set_line(options.line);
  }

  SBGC_ALWAYS_INLINE void set_line(const LineSettings& line) noexcept {
    const std::uint32_t all = bytes_per_second(line);
    stream_limit = all / 100 * stream_percent_ + all % 100 * stream_percent_ / 100;
    // Slower lines are not used, and the product in frame_time() would overflow.
    constexpr std::uint32_t slowest = 300;
    const std::uint32_t rate = line.baud_rate < slowest ? slowest : line.baud_rate;
    const std::uint32_t bits = 256 * bits_per_byte(line.parity);
    us_per_256_bytes_ = line.baud_rate == 0 ? 0 : bits * 1'000'000 / rate;
  }

  /// Like wire_time(), to a microsecond, for one frame.
  Ticks frame_time(std::size_t frame_size) const noexcept {
    return (static_cast<Ticks>(frame_size) * us_per_256_bytes_ + 255) / 256;
  }

  /// Returns the pause after a command with these frame sizes: longer for larger frames, as the
  /// protocol requires, and never shorter than `response_time`, which the response takes on the
  /// line, so that the board's output buffer does not overflow.
  Ticks pause_after(std::size_t request_size, std::size_t response_size,
                    Ticks response_time) const noexcept {
    if (longest_pause_ == 0) return 0;
    const auto both = static_cast<std::uint32_t>(request_size + response_size);
    const Ticks pause = shortest_pause_ + pause_per_byte_ * (longer(both, small) - small);
    return longer(shorter(pause, longest_pause_), response_time);
  }

 private:
  static constexpr std::uint32_t small = 48;  // both frames: after these, the pause is shortest
  static constexpr std::uint32_t both_largest = 2 * max_frame_size - small;

  std::uint8_t stream_percent_;
  Ticks us_per_256_bytes_{};
  Ticks longest_pause_;
  Ticks shortest_pause_;
  Ticks pause_per_byte_;  // rounded up
};

}  // namespace sbgc::detail
