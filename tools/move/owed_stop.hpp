/// A stop that has been commanded, and has not been seen yet.
#pragma once

#include <chrono>
#include <optional>
#include <utility>

#include <sbgc/any.hpp>
#include <sbgc/client/motion.hpp>
#include <sbgc/result.hpp>

namespace sbgc::tools {

/// Stays owed until the camera has come to rest or, for motors off, until the board has confirmed
/// them: over silence, and over the loss of the line. Who owes it makes one attempt after the
/// other, and tells how each has ended.
class OwedStop {
 public:
  using Clock = std::chrono::steady_clock;
  using Time = Clock::time_point;

  enum class State : std::uint8_t {
    owed,
    done,
    failed,  ///< something else turns the camera, and will go on
  };

  /// So long, the camera of a board that answers may turn on; and so long, who has commanded the
  /// stop waits for a result.
  static constexpr std::chrono::milliseconds patience{3'000};
  /// The motors lose their power within this time of the command, or the camera only stops.
  static constexpr std::chrono::seconds longest_motors_off{10};

  OwedStop() = default;
  /// Motors off. `request` turns them off.
  explicit OwedStop(AnyMessage request, Time now = Clock::now())
      : motors_off_(std::move(request)), end_of_motors_off_(now + longest_motors_off) {}

  /// The next attempt; its success means that the stop is done.
  Task<Result<void>> attempt(Time now = Clock::now());
  /// True if the last attempt was for the motors.
  bool turns_motors_off() const noexcept { return motors_off_.has_value(); }
  /// The attempt that began at `began` has ended.
  State take(const Result<void>& ended, Time began, Time now = Clock::now());

  /// Somebody else may control the camera by now: if it stands, it is left alone.
  void line_lost() noexcept { reads_first_ = true; }
  /// Motors that have been switched on again are not turned off.
  void board_restarted() noexcept {
    motors_off_.reset();
    reads_first_ = true;
  }

 private:
  std::optional<AnyMessage> motors_off_{};
  Time end_of_motors_off_{};
  bool reads_first_ = false;
  Time refused_since_ = Time::max();  // by a board that answers
};

}  // namespace sbgc::tools
