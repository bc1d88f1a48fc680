/// The pending stops of one gimbal.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <asio/steady_timer.hpp>

#include <sbgc/any.hpp>
#include <sbgc/result.hpp>

#include "gateway/gimbal.hpp"
#include "move/owed_stop.hpp"

namespace sbgc::tools {

/// Repeats a stop, and motors off, until they are done, before everything else. Stops that arrive
/// while one is pending join it. Everything runs on the strand of the gimbal.
class GimbalStops {
 public:
  /// Called once: when the stop has ended or, with an error, when OwedStop::patience has passed.
  using Then = std::function<void(const Result<void>&)>;

  struct Hooks {
    /// The object that must stay alive while something runs.
    std::function<std::shared_ptr<void>()> owner{};
    /// Reports the kind of an event, and a sentence.
    std::function<void(const std::string& kind, const std::string& message)> notify{};
    /// False if motion may have been commanded again after the stop.
    std::function<bool()> is_final{};
    /// Called before waiting callers when is_owed(), is_stopping() or is_late() has changed.
    std::function<void()> changed{};
  };

  GimbalStops(Gimbal& gimbal, Hooks hooks);
  GimbalStops(const GimbalStops&) = delete;
  GimbalStops& operator=(const GimbalStops&) = delete;
  ~GimbalStops() = default;

  void stop(Then then);
  /// Nobody waits for it, so an event reports its result. If it is `late`, something else may
  /// control the camera by now. The first reason counts.
  void stop_because(const std::string& reason, bool late);
  /// `request` turns the motors off.
  void turn_motors_off(const AnyMessage& request, Then then);

  void link_changed(bool is_online);
  void board_restarted();

  /// True if a stop or motors off is pending.
  bool is_owed() const { return stop_.owed || motors_off_.owed; }
  /// True if a stop is pending, and its callers have no result yet.
  bool is_stopping() const { return stop_.owed && !stop_.is_late; }
  /// True if something is pending for longer than OwedStop::patience: all motion is refused.
  bool is_late() const { return stop_.is_late || motors_off_.is_late; }
  /// Makes no further attempt.
  void close();

 private:
  using Clock = OwedStop::Clock;

  struct Waiter {
    Clock::time_point until{};
    Then then{};
  };
  struct Debt {
    const char* what{};
    std::optional<OwedStop> owed{};
    std::vector<Waiter> waiters{};
    std::string reason{};  // of an event at the end
    Clock::time_point since{};
    bool is_running = false;
    bool is_late = false;
    ClientError last{};  // of the last attempt
  };

  void add(Debt& debt, OwedStop owed, Then then);
  void attempt(Debt& debt);
  void take(Debt& debt, const Result<void>& ended, Clock::time_point began);
  void end(Debt& debt, const Result<void>& ended);
  void watch();
  void look(Debt& debt);
  void changed();

  Gimbal& gimbal_;
  const Hooks hooks_;
  asio::steady_timer timer_;
  Debt stop_{"the stop"};
  Debt motors_off_{"motors off"};
  bool is_online_ = false;
  bool is_watching_ = false;
  bool is_closed_ = false;
};

}  // namespace sbgc::tools
