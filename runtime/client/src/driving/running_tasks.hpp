/// The tasks that an asynchronous client drives.
#pragma once

#include <functional>
#include <memory>
#include <mutex>
#include <utility>
#include <vector>

#include <asio/any_io_executor.hpp>

#include <sbgc/client/link.hpp>

#include "driving/asio_driver.hpp"

namespace sbgc::detail {

/// Thread-safe.
class RunningTasks {
 public:
  /// Drives a task to its end; `done` owns it.
  Stop run(const asio::any_io_executor& executor, const Conversation& conversation,
           TaskMachine& task, std::function<void()> done) {
    const auto driver = std::make_shared<AsioDriver>(executor, conversation, task, std::move(done));
    {
      const std::lock_guard lock(mutex_);
      std::erase_if(drivers_, [](const auto& one) { return one.expired(); });
      drivers_.push_back(driver);
    }
    driver->start();
    return [weak = std::weak_ptr(driver)] { cancel(weak); };
  }

  void cancel_all() {
    std::vector<std::weak_ptr<AsioDriver>> drivers;
    {
      const std::lock_guard lock(mutex_);
      drivers.swap(drivers_);
    }
    for (const auto& driver : drivers) cancel(driver);
  }

 private:
  static void cancel(const std::weak_ptr<AsioDriver>& weak) {
    if (const auto driver = weak.lock()) driver->put([](TaskMachine& task) { task.cancel(); });
  }

  std::mutex mutex_;
  std::vector<std::weak_ptr<AsioDriver>> drivers_;
};

}  // namespace sbgc::detail
