/// A stop that has been commanded, but not verified yet.
#pragma once

#include <chrono>
#include <optional>
#include <utility>

#include <sbgc/any.hpp>
#include <sbgc/client/motion.hpp>
#include <sbgc/result.hpp>

namespace sbgc::tools {

/// Remains owed until the camera has come to rest or, for motors off, until the board has confirmed
/// it: even during silence and after the loss of the line. Its owner makes one attempt after the
/// other, and reports the result of each.
class OwedStop {
 public:
  using Clock = std::chrono::steady_clock;
  using Time = Clock::time_point;

  enum class State : std::uint8_t {
    owed,
    done,
    failed,  ///< something else keeps turning the camera
  };

  /// The time for which the camera of an answering board may keep turning, and for which the sender
  /// of the stop waits for a result.
  static constexpr std::chrono::milliseconds patience{3'000};
  /// Motors that are not off this long after the command are not turned off; the camera is stopped.
  static constexpr std::chrono::seconds longest_motors_off{10};

  OwedStop() = default;
  /// Motors off; `request` turns them off.
  explicit OwedStop(AnyMessage request, Time now = Clock::now())
      : motors_off_(std::move(request)), end_of_motors_off_(now + longest_motors_off) {}

  /// Makes the next attempt; its success means that the stop is done.
  Task<Result<void>> attempt(Time now = Clock::now());
  /// True if the last attempt was for the motors.
  bool turns_motors_off() const noexcept { return motors_off_.has_value(); }
  /// Processes the result of the attempt that began at `began`.
  State take(const Result<void>& ended, Time began, Time now = Clock::now());

  /// Something else may control the camera by now: if it stands still, it is left alone.
  void line_lost() noexcept { reads_first_ = true; }
  /// Motors that have been turned on again are not turned off.
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
