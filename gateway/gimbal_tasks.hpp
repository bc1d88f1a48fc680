/// Executes the commands of one gimbal.
#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <asio/cancellation_signal.hpp>
#include <asio/steady_timer.hpp>

#include <sbgc/client/speed_control.hpp>
#include <sbgc/json_dom.hpp>

#include "gateway/gimbal.hpp"
#include "gateway/gimbal_stops.hpp"
#include "gateway/orders.hpp"

namespace sbgc::tools {

/// The result of a command.
struct TaskOutcome {
  std::string status{"done"};  ///< done, failed, refused or unknown
  std::string code{};          ///< error code, for programs
  std::string message{};       ///< the same, for people
  Json result{};               ///< null if there is none
};

/// Runs one command after the other, on the strand of the gimbal. `stop` comes first: it ends the
/// current motion and queued motions; a stop that arrives while another is running joins it.
/// Turning motors off also takes precedence over the queue.
///
/// A speed ends after `longest_silence` without the next one. A camera that commands may have set
/// in motion is stopped when the broker is gone, when its line is back after a loss or silence, and
/// at the end of the gateway; or else by the next gateway. It counts as in motion until a stop has
/// ended, or until its last motion has succeeded. While a stop is long overdue, nothing moves it.
class GimbalTasks : public std::enable_shared_from_this<GimbalTasks> {
 public:
  using Clock = std::chrono::steady_clock;
  using Time = std::chrono::system_clock::time_point;
  using Done = std::function<void(TaskOutcome)>;

  /// The duration of a speed, and the longest silence of a line while the camera may be moving.
  static constexpr std::chrono::milliseconds longest_silence{500};

  struct Hooks {
    std::function<bool()> is_broker_there{};
    /// Reports an event that no command has requested: the kind, and a sentence.
    std::function<void(const std::string& kind, const std::string& message)> notify{};
    /// Reports that no command up to this one has left the camera in motion.
    std::function<void(std::int64_t command)> at_rest{};
    /// A moving gimbal that is silent for this long is lost.
    std::chrono::milliseconds stop_after{2'000};
  };

  struct Job {
    std::int64_t command{};  ///< of the journal: ids grow
    Order order{};
    std::optional<Time> deadline{};  ///< it must begin before
    Clock::time_point arrived{};
    std::uint64_t stops{};  ///< the value of stops() then: a later stop supersedes its motion
    Done done{};
  };

  /// `gimbal` must not be destroyed before shut_down() has completed. An earlier gateway may have
  /// set it in motion with the command `moved_by`.
  GimbalTasks(Gimbal& gimbal, Hooks hooks, std::optional<std::int64_t> moved_by);

  // Any thread; they take effect on the strand.

  /// Calls `done` exactly once, on the strand.
  void run(Job job);
  /// Tells the journal's command number of a stop passed to run().
  void recorded(std::int64_t stop);
  /// Returns the number of stops passed to run().
  std::uint64_t stops() const noexcept { return stop_count_; }
  void link_changed(bool is_online);
  void board_restarted();
  /// Stops the camera if a command has moved it, and ends running and queued commands. `done` is
  /// called when no work is left.
  void shut_down(std::function<void()> done);
  /// Makes no further attempt to stop the camera.
  void give_up();

 private:
  void add(Job job);
  void begin_next();
  void begin(const Order& order);
  void begin_after_speed();
  void finish(TaskOutcome outcome);
  void end(const Job& job, TaskOutcome outcome);
  void stop(Done done);
  void turn_motors_off(Job job);
  void end_motion();
  void halt(const char* reason, bool late = false);
  void stops_changed();
  void watch_silence();
  void end_waiting_motions(const char* code, const char* message);
  void watch();
  void look();
  bool may_go_on() const;
  bool is_moving() const;
  void report_rest();
  TaskOutcome set_speed(const SpeedOrder& order);

  template <class R>
  auto handler(std::function<TaskOutcome(const Result<R>&)> read);
  template <class R>
  void start(Task<Result<R>> task, std::function<TaskOutcome(const R&)> read);

  Gimbal& gimbal_;
  const Hooks hooks_;
  asio::steady_timer timer_;
  std::atomic<std::uint64_t> stop_count_{0};
  std::deque<Job> waiting_{};
  std::optional<Job> current_{};
  std::unique_ptr<asio::cancellation_signal> cancel_{};
  std::unique_ptr<SpeedControl> speed_{};
  bool is_turning_ = false;                         // speed_ holds a speed
  std::optional<Clock::time_point> moves_until_{};  // if no stop is confirmed before
  bool moved_before_ = false;                       // the current command
  GimbalStops stops_;
  std::function<void()> shut_down_{};  // called when nothing is owed
  bool was_left_moving_;               // by an earlier gateway
  Clock::time_point heard_{};          // when the line last carried something
  std::uint64_t frames_ = 0;           // the count at that time
  bool is_asking_ = false;
  bool is_silent_ = false;
  bool is_preparing_ = false;     // the current command waits for the end of the speed
  std::int64_t last_motion_ = 0;  // the last command that may have moved the camera
  std::int64_t reported_ = 0;     // of these, at rest
  bool is_online_ = false;
  bool is_watching_ = false;
  bool is_shut_down_ = false;
};

}  // namespace sbgc::tools
