/// Carries out the commands of one gimbal.
#pragma once

#include <chrono>
#include <deque>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include <asio/cancellation_signal.hpp>
#include <asio/steady_timer.hpp>

#include <sbgc/client/speed_control.hpp>
#include <sbgc/json_dom.hpp>

#include "gateway/gimbal.hpp"
#include "gateway/orders.hpp"

namespace sbgc::tools {

/// How a command has ended.
struct TaskOutcome {
  std::string status{"done"};  ///< done, failed, refused or unknown
  std::string code{};          ///< of an error, for programs
  std::string message{};       ///< the same, for people
  Json result{};               ///< null if there is none
};

/// Runs one command after the other, on the strand of the gimbal. `stop` goes first: it ends the
/// motion, and the motions that wait.
///
/// A speed ends after `longest_silence` without the next one. While the camera moves because of a
/// command, it stops when the broker is gone.
class GimbalTasks : public std::enable_shared_from_this<GimbalTasks> {
 public:
  using Clock = std::chrono::steady_clock;
  using Time = std::chrono::system_clock::time_point;
  using Done = std::function<void(TaskOutcome)>;

  /// How long a speed lasts.
  static constexpr std::chrono::milliseconds longest_silence{500};

  struct Hooks {
    std::function<bool()> is_broker_there{};
    /// Reports what no command has asked for: the kind, and a sentence.
    std::function<void(const std::string& kind, const std::string& message)> notify{};
  };

  struct Job {
    Order order{};
    std::optional<Time> deadline{};  ///< it must begin before
    Done done{};
  };

  /// `gimbal` must not be destroyed before shut_down() has completed.
  GimbalTasks(Gimbal& gimbal, Hooks hooks);

  // Any thread; what they do happens on the strand.

  /// Calls `done` exactly once, on the strand.
  void run(Job job);
  void link_changed(bool is_online);
  /// Stops the camera if a command has moved it, and ends what runs or waits. `done` is called when
  /// nothing is left to do.
  void shut_down(std::function<void()> done);

 private:
  void add(Job job);
  void begin_next();
  void begin(const Order& order);
  void finish(TaskOutcome outcome);
  void stop(Done done);
  void halt(const std::string& reason);
  void end_waiting_motions(const char* code, const char* message);
  void watch();
  void look();
  bool is_moving() const;
  TaskOutcome set_speed(const SpeedOrder& order);

  template <class R>
  auto handler(std::function<TaskOutcome(const Result<R>&)> read);
  template <class R>
  void start(Task<Result<R>> task, std::function<TaskOutcome(const R&)> read);

  Gimbal& gimbal_;
  const Hooks hooks_;
  asio::steady_timer timer_;
  std::deque<Job> waiting_{};
  std::optional<Job> current_{};
  std::unique_ptr<asio::cancellation_signal> cancel_{};
  std::unique_ptr<SpeedControl> speed_{};
  bool is_turning_ = false;                         // speed_ holds a speed
  std::optional<Clock::time_point> moves_until_{};  // because of a command that has ended
  bool must_halt_ = false;                          // as soon as the gimbal is online
  bool is_halting_ = false;
  bool is_online_ = false;
  bool is_watching_ = false;
  bool is_shut_down_ = false;
};

}  // namespace sbgc::tools
