/// A held speed that threads share.
#pragma once

#include <condition_variable>
#include <utility>

#include "mutex.hpp"
#include "tasks/hold_speed.hpp"

namespace sbgc::detail {

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

}  // namespace sbgc::detail
