#include "gateway/probe.hpp"

#include <asio/post.hpp>

#include <sbgc/meta/realtime.hpp>

namespace sbgc::tools {

namespace {

constexpr int intervals_until_old = 3;

// From a frame at the highest baud rate to the timeout of a request over a slow radio link.
const prometheus::Histogram::BucketBoundaries latency_limits{
    0.001, 0.0025, 0.005, 0.01, 0.025, 0.05, 0.1, 0.25, 0.5, 1, 2.5};

/// The newest live data that the board has.
AnyMessage live_data_request(const BoardIdentity& board) {
  const bool has_newest = is_supported<msg::RealtimeData4Request>(board.versions());
  const char* const name = has_newest ? Meta<msg::RealtimeData4Request>::info.name
                                      : Meta<msg::RealtimeData3Request>::info.name;
  return find_message(name)->make();
}

}  // namespace

Probe::Probe(Gimbal& gimbal, std::chrono::milliseconds interval)
    : gimbal_(gimbal), interval_(interval), timer_(gimbal.executor()), latency_(latency_limits) {}

void Probe::start(std::chrono::milliseconds delay) {
  asio::post(gimbal_.executor(), [self = shared_from_this(), delay] { self->wait(delay); });
}

void Probe::close() {
  asio::post(gimbal_.executor(), [self = shared_from_this()] {
    self->is_closing_ = true;
    self->timer_.cancel();
  });
}

void Probe::wait(std::chrono::milliseconds time) {
  timer_.expires_after(time);
  timer_.async_wait([self = shared_from_this()](std::error_code error) {
    if (!error && !self->is_closing_) self->ask();
  });
}

void Probe::ask() {
  if (!gimbal_.client().is_connected()) return wait(interval_);
  const auto start = std::chrono::steady_clock::now();
  const auto done = [self = shared_from_this(), start](const CallResult<AnyMessage>& answer) {
    if (self->is_closing_) return;
    const auto now = std::chrono::steady_clock::now();
    if (answer) self->latency_.Observe(std::chrono::duration<double>(now - start).count());
    {
      const std::lock_guard lock(self->mutex_);
      if (!answer) {
        ++self->failures_[to_string(answer.error().code)];
      } else if (*answer) {
        self->live_data_ = **answer;
        self->received_ = now;
      }
    }
    self->wait(self->interval_);
  };
  // Without a second attempt, the time is that of one answer.
  gimbal_.client().async_call(live_data_request(gimbal_.client().identity()),
                              CallOptions{.retries = 0}, done);
}

std::optional<AnyMessage> Probe::live_data() const {
  const std::lock_guard lock(mutex_);
  const auto age = std::chrono::steady_clock::now() - received_;
  return age < intervals_until_old * interval_ ? live_data_ : std::nullopt;
}

std::map<std::string, std::uint64_t> Probe::failures() const {
  const std::lock_guard lock(mutex_);
  return failures_;
}

}  // namespace sbgc::tools
