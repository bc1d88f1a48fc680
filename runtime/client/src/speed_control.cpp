#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>
#include <vector>

#include <asio/any_io_executor.hpp>

#include <sbgc/client/async_client.hpp>
#include <sbgc/client/client.hpp>
#include <sbgc/client/speed_control.hpp>
#include <sbgc/io/clock.hpp>
#include <sbgc/io/internal/timer.hpp>

#include "connection.hpp"
#include "conversation/state.hpp"
#include "driving/task_driver.hpp"
#include "tasks/hold_speed.hpp"
#include "threads.hpp"

namespace sbgc::detail {

/// A held speed that is shared between threads.
class SharedSpeed final : public HeldSpeed {
 public:
  SharedSpeed(const DeadMansSwitch& rules, Order order)
      : HeldSpeed(rules, std::move(order), make_mutex()) {}

  /// Waits until there is nothing to send; `now()` is the time of the task.
  template <class Now>
  Result<void> wait(const Now& now) {
    const Holding holding(lock());
    idle_.wait(*lock(), [&] { return has_settled(now()); });
    return outcome();
  }

 private:
  void idle() override { idle_.notify_all(); }

  std::condition_variable_any idle_;
};

namespace {

/// The order of a conversation's tasks.
HeldSpeed::Order order_of(const Conversation& conversation) {
  return {.begin = [conversation] { return conversation.state()->calls()->order().begin(); },
          .is_superseded =
              [conversation](TaskNumber task) {
                return conversation.state()->calls()->order().is_superseded(task);
              }};
}

}  // namespace
}  // namespace sbgc::detail

namespace sbgc {

using detail::DeadMansSwitch;

/// The result of the task, and the functions that wait for it.
class SpeedControl::End {
 public:
  using Done = std::function<void(const Result<void>&)>;

  void reach(const Result<void>& result) {
    std::vector<Done> waiting;
    {
      const std::scoped_lock lock(mutex_);
      result_ = result;
      waiting.swap(waiting_);
    }
    for (const Done& done : waiting) done(result);
  }
  void on_reached(Done done) {
    {
      const std::scoped_lock lock(mutex_);
      if (!result_) return waiting_.push_back(std::move(done));
    }
    done(*result_);  // no longer changes
  }

 private:
  std::mutex mutex_;
  std::optional<Result<void>> result_{};
  std::vector<Done> waiting_{};
};

/// Drives the task: on its own thread or, with an executor, there.
class SpeedControl::Worker {
 public:
  Worker(detail::Connection& connection, const SpeedControlOptions& options,
         const asio::any_io_executor& executor)
      : speed_(std::make_shared<detail::SharedSpeed>(
            DeadMansSwitch(milliseconds(options.silence.count()),
                           milliseconds(options.repeat.count())),
            detail::order_of(connection.conversation()))),
        task_(std::make_shared<Task<Result<void>>>(
            detail::hold_speed(speed_, detail::BoundedTurn(options.bound, options.lookahead),
                               options.ends_when_stopped))) {
    const detail::Conversation& conversation = connection.conversation();
    TaskMachine& machine = task_->begin(conversation.identity());
    if (executor) {
      now_ = [clock = io::detail::ExecutorClock(executor)] { return clock.now(); };
      const auto driver = std::make_shared<detail::AsioDriver>(
          executor, conversation, machine,
          [task = task_, end = end_] { end->reach(std::move(*task).result()); });
      driver->start();
      driver_ = driver;
    } else {
      now_ = [&clock = options.clock] { return io::from_chrono(clock.now()); };
      driver_ = std::make_shared<detail::TaskDriver>(conversation, machine);
      thread_ = std::thread([this, &clock = options.clock] {
        driver_->run(clock);
        end_->reach(std::move(*task_).result());
      });
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
  void close(End::Done done) {
    end_->on_reached(std::move(done));
    speed_->close();
    wake();
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
  const std::shared_ptr<End> end_ = std::make_shared<End>();
  std::function<Instant()> now_;  // the time of the task
  std::shared_ptr<detail::TaskDriver> driver_;
  std::thread thread_;
};

SpeedControl::SpeedControl(Client& client, const SpeedControlOptions& options)
    : options_(options),
      connected_([&client] { return client.link_->connected(); }),
      make_worker_([this](detail::Connection& one) {
        return std::make_shared<Worker>(one, options_, asio::any_io_executor());
      }) {}

SpeedControl::SpeedControl(AsyncClient& client, const SpeedControlOptions& options)
    : options_(options),
      connected_([&client]() -> Result<ConnectionPointer> {
        const auto link = AsyncClient::current(*client.links_);
        if (!link) return ClientError{ErrorCode::not_connected, "the client is not connected"};
        return link->connected();
      }),
      make_worker_([this, executor = client.executor()](detail::Connection& one) {
        return std::make_shared<Worker>(one, options_, executor);
      }) {}

SpeedControl::~SpeedControl() = default;

std::shared_ptr<SpeedControl::Worker> SpeedControl::worker() const {
  const std::scoped_lock lock(mutex_);
  return worker_;
}

Result<void> SpeedControl::renew() {
  auto connected = connected_();
  if (!connected) return std::move(connected).error();
  const std::scoped_lock one_at_a_time(renewing_);
  if (connection_ == *connected) return {};
  auto renewed = make_worker_(**connected);
  const std::scoped_lock lock(mutex_);
  if (is_closed_) return ClientError{ErrorCode::cancelled, "the speed control is closed"};
  connection_ = *std::move(connected);
  worker_.swap(renewed);
  return {};
}

Result<void> SpeedControl::set(const Axes<msg::ControlSpeed>& speed) {
  if (options_.silence.count() <= 0) {
    return ClientError{ErrorCode::invalid, "the silence of a speed control must be 1 ms or more"};
  }
  const detail::BoundedTurn motion(options_.bound, options_.lookahead);
  if (auto possible = motion.check(); !possible) return possible;
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

void SpeedControl::close(std::function<void(const Result<void>&)> done) {
  {
    const std::scoped_lock lock(mutex_);
    is_closed_ = true;
  }
  if (const auto current = worker()) return current->close(std::move(done));
  done({});
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
