#include <array>
#include <optional>
#include <string>
#include <utility>

#include <fmt/format.h>

#include <sbgc/client/calibration.hpp>

#include "tasks/tools.hpp"

namespace sbgc {
namespace {

/// Converts the IMU to the enum of the state request.
msg::SelectedImu selected(msg::CalibImu imu) noexcept {
  return imu == msg::CalibImu::frame ? msg::SelectedImu::frame : msg::SelectedImu::main;
}

/// The call of a calibration, which runs while the board is polled.
class CalibrationCall {
 public:
  CalibrationCall(TaskMachine& task, const detail::StartCalibration& start)
      : task_(task), id_(start(task)) {}
  CalibrationCall(const CalibrationCall&) = delete;
  CalibrationCall& operator=(const CalibrationCall&) = delete;
  ~CalibrationCall() { task_.end(id_); }

  bool has_started() const { return task_.has_started(id_); }
  const Result<Reply>* end() const { return task_.reply(id_); }

  detail::Waiting wait_for_start(Instant until) const { return tasks::wait_for_start(id_, until); }
  detail::Waiting wait_for_end(Instant until) const { return tasks::wait_for_call(id_, until); }

  ClientError error(ClientError reason) const {
    return detail::during(
        has_started() ? "the calibration has started, but its result is unknown" : "calibrating",
        std::move(reason));
  }

 private:
  TaskMachine& task_;
  CallId id_;
};

template <class Simple, class Extended>
Task<Result<void>> calibrate_as(CalibrationOptions options) {
  Result<CalibrationEnd> ended = ClientError{};
  if (options.imu == msg::CalibImu::active && options.action == msg::CalibAction::regular) {
    ended = co_await tasks::run_calibration(Simple{}, options);
  } else {
    Extended request;
    request.imu_idx = options.imu;
    request.action = options.action;
    ended = co_await tasks::run_calibration(request, options);
  }
  if (!ended) co_return ended.error();
  co_return Result<void>();
}

}  // namespace

namespace detail {

Task<Result<CalibrationEnd>> run_calibration(StartCalibration start_call, bool reports_end,
                                             CalibrationOptions options) {
  TaskMachine& task = co_await tasks::this_task();
  const CalibrationCall call(task, start_call);
  const Instant start = task.now();
  const Deadline deadline(task, options.timeout.value_or(std::chrono::hours(24)));
  const Instant end = options.timeout ? deadline.end() : Instant::never;
  const bool can_look =
      options.progress && is_supported<msg::CalibInfoRequest>(task.identity().versions());
  Result<void> waited = co_await call.wait_for_start(end);
  while (waited) {
    if (const Result<Reply>* const reply = call.end()) {
      if (!*reply) co_return call.error(reply->error());
      if ((*reply)->kind == ReplyKind::unconfirmed) co_return call.error(unconfirmed_error());
      co_return reports_end ? CalibrationEnd::finished : CalibrationEnd::accepted;
    }
    if (task.now() >= end) {
      co_return call.error(
          {ErrorCode::timeout, fmt::format("it took more than {} ms", options.timeout->count())});
    }
    CalibrationProgress seen{call.has_started(), std::nullopt, {}};
    if (can_look) {
      msg::CalibInfoRequest look;
      look.imu_type = selected(options.imu);
      // A calibrating board may be too busy to respond; only the result of the call matters.
      const Result<msg::CalibInfo> state = co_await tasks::call(look, options_within(deadline));
      if (state) seen.state = *state;
      if (!state && state.error().code == ErrorCode::cancelled) break;
    }
    const Instant now = task.now();
    seen.elapsed = whole_milliseconds(now - start);
    if (options.progress && !options.progress(seen)) break;
    const Instant next = options.progress ? now + duration_of(options.interval) : Instant::never;
    waited = co_await call.wait_for_end(earlier(end, next));
  }
  co_return cancelled_error("the wait for the calibration, which continues on the board");
}

}  // namespace detail

namespace tasks {

Task<Result<void>> calibrate(Sensor sensor, CalibrationOptions options) {
  return sensor == Sensor::accelerometer
             ? calibrate_as<msg::CalibAcc, msg::CalibAccExt>(std::move(options))
             : calibrate_as<msg::CalibGyro, msg::CalibGyroExt>(std::move(options));
}

}  // namespace tasks

namespace {

constexpr std::array directions{
    std::pair{msg::CalibratedLimit::plus_x, "+X"}, std::pair{msg::CalibratedLimit::minus_x, "-X"},
    std::pair{msg::CalibratedLimit::plus_y, "+Y"}, std::pair{msg::CalibratedLimit::minus_y, "-Y"},
    std::pair{msg::CalibratedLimit::plus_z, "+Z"}, std::pair{msg::CalibratedLimit::minus_z, "-Z"}};

std::string positions(const msg::CalibInfo& state, bool are_done) {
  std::string names;
  for (const auto& [limit, name] : directions) {
    if (state.acc_limits_info.has(limit) != are_done) continue;
    names += (names.empty() ? "" : ", ") + std::string(name);
  }
  return names;
}

}  // namespace

std::string calibrated_positions(const msg::CalibInfo& state) {
  const std::string done = positions(state, true);
  return done.empty() ? "none" : done;
}

std::string missing_positions(const msg::CalibInfo& state) { return positions(state, false); }

}  // namespace sbgc
