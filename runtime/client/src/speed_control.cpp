#include <memory>
#include <thread>

#include <sbgc/client/client.hpp>
#include <sbgc/client/reconnecting_client.hpp>
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
    : options_(options), worker_(std::make_shared<Worker>(client, options)) {}

SpeedControl::SpeedControl(ReconnectingClient& client, const SpeedControlOptions& options)
    : options_(options), reconnecting_(&client) {}

SpeedControl::~SpeedControl() = default;

std::shared_ptr<SpeedControl::Worker> SpeedControl::worker() const {
  const std::scoped_lock lock(mutex_);
  return worker_;
}

Result<void> SpeedControl::renew() {
  if (reconnecting_ == nullptr) return {};
  auto client = reconnecting_->current({.timeout = std::chrono::milliseconds(0)});
  if (!client) return std::move(client).error();
  const std::scoped_lock one_at_a_time(renewing_);
  if (client_ == *client) return {};
  auto renewed = std::make_shared<Worker>(**client, options_);
  const std::scoped_lock lock(mutex_);
  client_ = *std::move(client);
  worker_.swap(renewed);
  return {};
}

Result<void> SpeedControl::set(const Axes<msg::ControlSpeed>& speed) {
  if (auto renewed = renew(); !renewed) return renewed;
  const auto current = worker();
  return current->with([&](DeadMansSwitch& rules) -> Result<void> {
    rules.set(speed, current->now());
    return {};
  });
}

Result<void> SpeedControl::refresh() {
  const ClientError stopped{ErrorCode::cancelled, "the camera has been stopped"};
  const auto current = worker();
  if (!current) return stopped;
  return current->with([&](DeadMansSwitch& rules) -> Result<void> {
    if (rules.state() != State::turning) return stopped;
    rules.refresh(current->now());
    return {};
  });
}

Result<void> SpeedControl::stop() {
  const auto current = worker();
  if (!current) return {};
  return current->with([](DeadMansSwitch& rules) -> Result<void> {
    rules.stop();
    return {};
  });
}

Result<void> SpeedControl::wait() {
  const auto current = worker();
  return current ? current->wait() : Result<void>();
}

SpeedControl::State SpeedControl::state() const {
  const auto current = worker();
  return current ? current->state() : State::idle;
}

}  // namespace sbgc
