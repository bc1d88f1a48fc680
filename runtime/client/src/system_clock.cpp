#include <thread>

#include <sbgc/client/clock.hpp>

namespace sbgc {
namespace {

class SystemClock final : public Clock {
 public:
  TimePoint now() override { return std::chrono::steady_clock::now(); }
  void sleep_until(TimePoint until) override { std::this_thread::sleep_until(until); }
  void wait_until(std::unique_lock<std::mutex>& lock, std::condition_variable& changed,
                  TimePoint until) override {
    changed.wait_until(lock, until);
  }
};

}  // namespace

Clock& Clock::system() noexcept {
  static SystemClock clock;
  return clock;
}

}  // namespace sbgc
