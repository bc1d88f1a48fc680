#include <algorithm>
#include <condition_variable>
#include <memory>
#include <mutex>
#include <utility>

#include <fmt/format.h>

#include <sbgc/client/calibration.hpp>
#include <sbgc/client/client.hpp>

#include "connect.hpp"
#include "task.hpp"

namespace sbgc {
namespace {

using Time = std::chrono::steady_clock;

/// A call that goes on while others are made.
class PendingCall {
 public:
  template <Message M>
  PendingCall(Client& client, const M& request) : client_(client) {
    CallOptions options;
    options.on_confirmation = [state = state_](unsigned) { state->note(true, {}); };
    const detail::EncodedRequest encoded(request);
    if (!encoded) {
      state_->note(false, encoded.error());
      return;
    }
    ticket_ = detail::ClientMaker::conversation(client_).start(
        encoded.frame(), options, [state = state_](const Result<Reply>& reply) {
          state->note(false, reply ? Result<void>() : reply.error());
        });
  }

  /// Ends it with ErrorCode::cancelled if it goes on.
  void cancel() {
    if (!result()) detail::ClientMaker::conversation(client_).cancel(ticket_);
  }
  /// Waits until it has begun, has ended, or `until`.
  void wait_for_start(Time::time_point until) {
    std::unique_lock lock(state_->mutex);
    state_->changed.wait_until(lock, until, [&] { return state_->has_started || state_->result; });
  }
  void wait_for_end(Time::time_point until) {
    std::unique_lock lock(state_->mutex);
    state_->changed.wait_until(lock, until, [&] { return state_->result.has_value(); });
  }
  [[nodiscard]] bool has_started() const {
    const std::scoped_lock lock(state_->mutex);
    return state_->has_started;
  }
  [[nodiscard]] std::optional<Result<void>> result() const {
    const std::scoped_lock lock(state_->mutex);
    return state_->result;
  }

 private:
  /// Shared with the handlers, which may run after the end of this.
  struct State {
    std::mutex mutex;
    std::condition_variable changed;
    bool has_started = false;
    std::optional<Result<void>> result{};

    void note(bool started, std::optional<Result<void>> ended) {
      {
        const std::scoped_lock lock(mutex);
        has_started = has_started || started;
        if (!started) result = std::move(ended);
      }
      changed.notify_all();
    }
  };

  Client& client_;
  std::shared_ptr<State> state_ = std::make_shared<State>();
  detail::Conversation::Ticket ticket_{};
};

/// The IMU by the name that the request for the state has for it.
msg::SelectedImu selected(msg::CalibImu imu) noexcept {
  return imu == msg::CalibImu::frame ? msg::SelectedImu::frame : msg::SelectedImu::main;
}

ClientError calibration_error(const PendingCall& call, ClientError error) {
  return detail::during(
      call.has_started() ? "the calibration has begun, but its end is not known" : "calibrating",
      std::move(error));
}

Result<void> wait_for(Client& client, PendingCall& call, const CalibrationOptions& options) {
  const Time::time_point start = Time::now();
  const Time::time_point end = options.timeout ? start + *options.timeout : Time::time_point::max();
  call.wait_for_start(end);
  while (true) {
    if (const auto result = call.result()) {
      return *result ? *result : calibration_error(call, result->error());
    }
    if (Time::now() >= end) {
      call.cancel();
      return calibration_error(call, {ErrorCode::timeout, fmt::format("it took more than {} ms",
                                                                      options.timeout->count())});
    }
    CalibrationProgress seen{call.has_started(), std::nullopt, {}};
    if (options.progress && is_supported<msg::CalibInfoRequest>(client.board().versions())) {
      msg::CalibInfoRequest request;
      request.imu_type = selected(options.imu);
      // A board that calibrates may be too busy to answer; that is for its end to tell.
      if (const Result<msg::CalibInfo> state = client.call(request)) seen.state = *state;
    }
    const Time::time_point now = Time::now();
    seen.elapsed = std::chrono::duration_cast<std::chrono::milliseconds>(now - start);
    if (options.progress && !options.progress(seen)) {
      call.cancel();
      return detail::cancelled_error("the calibration, which the board goes on with,");
    }
    call.wait_for_end(std::min(end, options.progress ? now + options.interval : end));
  }
}

template <class Simple, class Extended>
Result<void> calibrate_with(Client& client, const CalibrationOptions& options) {
  if (options.imu == msg::CalibImu::active && options.action == msg::CalibAction::regular) {
    PendingCall call(client, Simple{});
    return wait_for(client, call, options);
  }
  Extended request;
  request.imu_idx = options.imu;
  request.action = options.action;
  PendingCall call(client, request);
  return wait_for(client, call, options);
}

}  // namespace

Result<void> calibrate(Client& client, Sensor sensor, const CalibrationOptions& options) {
  return sensor == Sensor::accelerometer
             ? calibrate_with<msg::CalibAcc, msg::CalibAccExt>(client, options)
             : calibrate_with<msg::CalibGyro, msg::CalibGyroExt>(client, options);
}

}  // namespace sbgc
