#include <functional>
#include <memory>
#include <thread>
#include <utility>

#include <asio/any_io_executor.hpp>

#include <sbgc/client/async_reconnecting_client.hpp>
#include <sbgc/client/client.hpp>
#include <sbgc/client/reconnecting_client.hpp>
#include <sbgc/client/speed_control.hpp>
#include <sbgc/io/clock.hpp>
#include <sbgc/io/internal/timer.hpp>

#include "connect.hpp"
#include "driving/asio_driver.hpp"
#include "driving/order_of.hpp"
#include "driving/task_driver.hpp"
#include "shared_speed.hpp"

namespace sbgc {

using detail::DeadMansSwitch;

/// Drives the task: on a thread of its own or, with an executor, there.
class SpeedControl::Worker {
 public:
  Worker(Client& client, const SpeedControlOptions& options,
         const asio::any_io_executor& executor = {})
      : speed_(std::make_shared<detail::SharedSpeed>(
            DeadMansSwitch(milliseconds(options.silence.count()),
                           milliseconds(options.repeat.count())),
            detail::order_of(detail::ClientMaker::conversation(client)))),
        task_(std::make_shared<Task<Result<void>>>(
            detail::hold_speed(speed_, detail::BoundedTurn(options.bound, options.lookahead),
                               options.ends_when_stopped))) {
    const detail::Conversation& conversation = detail::ClientMaker::conversation(client);
    TaskMachine& machine = task_->begin(client.identity());
    if (executor) {
      now_ = [clock = io::detail::ExecutorClock(executor)] { return clock.now(); };
      const auto driver =
          std::make_shared<detail::AsioDriver>(executor, conversation, machine, [task = task_] {});
      driver->start();
      driver_ = driver;
    } else {
      now_ = [&clock = options.clock] { return io::from_chrono(clock.now()); };
      driver_ = std::make_shared<detail::TaskDriver>(conversation, machine);
      thread_ = std::thread([this, &clock = options.clock] { driver_->run(clock); });
    }
  }
  Worker(const Worker&) = delete;
  Worker& operator=(const Worker&) = delete;
  Worker(Worker&&) = delete;
  Worker& operator=(Worker&&) = delete;
  ~Worker() {
    speed_->close();
    wake();
    if (thread_.joinable()) thread_.join();
  }

  Result<void> set(const Axes<msg::ControlSpeed>& speed) {
    Result<void> set = speed_->set(speed, now());
    wake();
    return set;
  }
  Result<void> refresh() {
    Result<void> refreshed = speed_->refresh(now());
    wake();
    return refreshed;
  }
  Result<void> stop() {
    Result<void> stopped = speed_->stop();
    wake();
    return stopped;
  }
  Result<void> wait() {
    return speed_->wait([this] { return now(); });
  }
  bool has_settled() const { return speed_->has_settled(now()); }
  State state() const { return speed_->state(); }
  Instant now() const { return now_(); }

 private:
  void wake() {
    driver_->put([](TaskMachine& task) { task.wake(); });
  }

  std::shared_ptr<detail::SharedSpeed> speed_;
  std::shared_ptr<Task<Result<void>>> task_;
  std::function<Instant()> now_;  // the time of the task
  std::shared_ptr<detail::TaskDriver> driver_;
  std::thread thread_;
};

SpeedControl::SpeedControl(Client& client, const SpeedControlOptions& options)
    : options_(options), worker_(std::make_shared<Worker>(client, options)) {}

SpeedControl::SpeedControl(ReconnectingClient& client, const SpeedControlOptions& options)
    : options_(options),
      connected_([&client] { return client.connected(); }),
      make_worker_([this](Client& one) { return std::make_shared<Worker>(one, options_); }) {}

SpeedControl::SpeedControl(AsyncReconnectingClient& client, const SpeedControlOptions& options)
    : options_(options),
      connected_([&client] { return client.connected(); }),
      make_worker_([this, executor = client.executor()](Client& one) {
        return std::make_shared<Worker>(one, options_, executor);
      }) {}

SpeedControl::~SpeedControl() = default;

std::shared_ptr<SpeedControl::Worker> SpeedControl::worker() const {
  const std::scoped_lock lock(mutex_);
  return worker_;
}

Result<void> SpeedControl::renew() {
  if (!connected_) return {};
  auto client = connected_();
  if (!client) return std::move(client).error();
  const std::scoped_lock one_at_a_time(renewing_);
  if (client_ == *client) return {};
  auto renewed = make_worker_(**client);
  const std::scoped_lock lock(mutex_);
  client_ = *std::move(client);
  worker_.swap(renewed);
  return {};
}

Result<void> SpeedControl::set(const Axes<msg::ControlSpeed>& speed) {
  if (auto renewed = renew(); !renewed) return renewed;
  const auto current = worker();
  return current->set(speed);
}

Result<void> SpeedControl::refresh() {
  const auto current = worker();
  if (!current) return ClientError{ErrorCode::cancelled, "the camera does not turn"};
  return current->refresh();
}

Result<void> SpeedControl::stop() {
  const auto current = worker();
  return current ? current->stop() : Result<void>();
}

Result<void> SpeedControl::wait() {
  const auto current = worker();
  return current ? current->wait() : Result<void>();
}

bool SpeedControl::has_settled() const {
  const auto current = worker();
  return !current || current->has_settled();
}

SpeedControl::State SpeedControl::state() const {
  const auto current = worker();
  return current ? current->state() : State::idle;
}

}  // namespace sbgc
