#include <memory>
#include <thread>

#include <sbgc/client/client.hpp>
#include <sbgc/client/speed_control.hpp>
#include <sbgc/io/clock.hpp>

#include "connect.hpp"
#include "driving/task_driver.hpp"
#include "tasks/hold_speed.hpp"

namespace sbgc {

using detail::DeadMansSwitch;

/// Owns the thread that drives the task.
class SpeedControl::Worker {
 public:
  Worker(Client& client, const SpeedControlOptions& options)
      : clock_(options.clock),
        speed_(std::make_shared<detail::HeldSpeed>(DeadMansSwitch(
            milliseconds(options.silence.count()), milliseconds(options.repeat.count())))),
        task_(detail::hold_speed(speed_, detail::BoundedTurn(options.bound, options.lookahead))),
        driver_(std::make_shared<detail::TaskDriver>(detail::ClientMaker::conversation(client),
                                                     task_.begin(client.identity()))),
        thread_([this] { driver_->run(clock_); }) {}
  Worker(const Worker&) = delete;
  Worker& operator=(const Worker&) = delete;
  Worker(Worker&&) = delete;
  Worker& operator=(Worker&&) = delete;
  ~Worker() {
    speed_->close();
    wake();
    thread_.join();
  }

  /// Changes the rules with `change(rules)` and wakes the thread.
  template <class Change>
  Result<void> with(const Change& change) {
    Result<void> changed = speed_->with(change);
    wake();
    return changed;
  }
  Result<void> wait() {
    return speed_->wait([this] { return now(); });
  }
  State state() const { return speed_->state(); }
  Instant now() { return io::from_chrono(clock_.now()); }

 private:
  void wake() {
    driver_->put([](TaskMachine& task) { task.wake(); });
  }

  Clock& clock_;
  std::shared_ptr<detail::HeldSpeed> speed_;
  Task<Result<void>> task_;
  std::shared_ptr<detail::TaskDriver> driver_;
  std::thread thread_;
};

SpeedControl::SpeedControl(Client& client, const SpeedControlOptions& options)
    : io_thread_(std::make_unique<Worker>(client, options)) {}

SpeedControl::~SpeedControl() = default;

Result<void> SpeedControl::set(const Axes<msg::ControlSpeed>& speed) {
  return io_thread_->with([&](DeadMansSwitch& rules) -> Result<void> {
    rules.set(speed, io_thread_->now());
    return {};
  });
}

Result<void> SpeedControl::refresh() {
  return io_thread_->with([&](DeadMansSwitch& rules) -> Result<void> {
    if (rules.state() != State::turning) {
      return ClientError{ErrorCode::cancelled, "the camera has been stopped"};
    }
    rules.refresh(io_thread_->now());
    return {};
  });
}

Result<void> SpeedControl::stop() {
  return io_thread_->with([](DeadMansSwitch& rules) -> Result<void> {
    rules.stop();
    return {};
  });
}

Result<void> SpeedControl::wait() { return io_thread_->wait(); }

SpeedControl::State SpeedControl::state() const { return io_thread_->state(); }

}  // namespace sbgc
