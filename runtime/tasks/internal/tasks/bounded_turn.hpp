/// Turning with a bound: the motion ends by itself when no more commands arrive.
#pragma once

#include <chrono>
#include <functional>
#include <optional>

#include <sbgc/client/motion.hpp>
#include <sbgc/client/motion_bound.hpp>
#include <sbgc/client/task.hpp>
#include <sbgc/messages/control.hpp>

#include "tasks/angle_polls.hpp"

namespace sbgc::detail {

/// Turning by targets: each command is a target a short way ahead.
class ShortTargets {
 public:
  using Speed = Axes<msg::ControlSpeed>;
  using Angles = Axes<msg::Angle14>;

  explicit ShortTargets(std::chrono::milliseconds lookahead) noexcept : lookahead_(lookahead) {}

  struct Command {
    Speed speed{};  ///< without a sign, and never 0, which means another speed
    Angles angle{};
  };
  /// Returns the command for a camera that was at these angles `age` ago, and has turned at this
  /// speed since. At least one axis must have a speed; axes without one stay where they were when
  /// they first had none.
  Command next(const Speed& speed, const Angles& measured, Duration age = {});

 private:
  std::chrono::milliseconds lookahead_;
  Axes<Optional<msg::Angle14>> held_{};
};

/// Turns the camera with the bound of SpeedControlOptions::bound.
class BoundedTurn {
 public:
  BoundedTurn(MotionBound bound, std::chrono::milliseconds lookahead) noexcept
      : bound_(bound), lookahead_(lookahead), targets_(lookahead) {}

  /// Fails if the lookahead is impossible.
  Result<void> check() const;
  /// Commands a speed, which lasts for the lookahead; fails if that is not possible by `not_after`.
  Task<Result<void>> turn(Axes<msg::ControlSpeed> speed, Instant not_after = Instant::never);
  /// Stops the camera, unless it `turns_again` meanwhile, and removes the timeout, so that it stays
  /// where it is.
  Task<Result<void>> stop(std::function<bool()> turns_again);
  /// Removes the timeout, which also ends motion commanded by others.
  Task<Result<void>> let_go();

  /// The angles during the motion.
  AnglePolls& polls() noexcept { return polls_; }
  /// Returns the time at which the next command must be sent, with or without new angles, so that
  /// the motion does not end; `never` if the last angles are too old to do without.
  Instant next_command(Instant now) const noexcept;
  /// True if the motion has ended because the last command is too old.
  bool has_lapsed(Instant now) const noexcept;

 private:
  Task<Result<void>> begin();
  Task<Result<void>> begin_timeout(bool is_choice);
  Task<Result<void>> renew_timeout();

  MotionBound bound_;
  std::chrono::milliseconds lookahead_;
  ShortTargets targets_;
  AnglePolls polls_{};
  Instant sent_{};  // the last command
  /// The request that limits the motion, once it has been sent.
  std::optional<msg::ControlConfig> timeout_{};
  Instant renewal_{};
};

}  // namespace sbgc::detail
