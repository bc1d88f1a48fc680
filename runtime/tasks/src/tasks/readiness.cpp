#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <memory>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include <sbgc/availability.hpp>
#include <sbgc/client/question.hpp>
#include <sbgc/client/readiness.hpp>
#include <sbgc/client/sensor_motion.hpp>
#include <sbgc/internal/words.hpp>
#include <sbgc/messages/control.hpp>
#include <sbgc/messages/parameters.hpp>
#include <sbgc/messages/realtime.hpp>
#include <sbgc/meta/enums.hpp>

namespace sbgc {

namespace {

// All limits are assumptions.

/// More than the noise of a gyroscope, less than the motion of a hand, in deg/s.
constexpr double most_motion = 1;
/// More than the error of an accelerometer that was never calibrated, in degrees.
constexpr double most_tilt = 10;
/// The motor power for holding the camera, in percent; the same limit as in `sbgc doctor`.
constexpr double most_imbalance = 10;
/// The relative error of the measured voltage with an uncalibrated sensor.
constexpr double most_wrong = 0.25;

/// Errors with which the motors do not turn.
constexpr std::array stopping_errors{
    msg::SystemError::no_sensor, msg::SystemError::low_bat2,       msg::SystemError::protection,
    msg::SystemError::set_power, msg::SystemError::emergency_stop, msg::SystemError::system,
};

/// Checks one condition after the other, until there is a problem.
class ReadinessCheck {
 public:
  explicit ReadinessCheck(const ReadinessOptions& options) : options_(options) {}

  Task<Result<Readiness>> run() {
    const CalibrationConditions& conditions = options_.conditions;
    const std::array<std::pair<bool, Task<Result<void>> (ReadinessCheck::*)()>, 5> checks{{
        {conditions.motors_off, &ReadinessCheck::require_motors_off},
        {conditions.motors_can_turn, &ReadinessCheck::require_motors_that_turn},
        {conditions.near_voltage, &ReadinessCheck::require_voltage},
        {conditions.level, &ReadinessCheck::require_level},
        {conditions.still || conditions.one_side_up, &ReadinessCheck::require_sensor},
    }};
    for (const auto& [is_wanted, check] : checks) {
      if (!is_wanted) continue;
      const Result<void> checked = co_await (this->*check)();
      if (!checked) co_return checked.error();
      if (!found_.problem.empty()) break;
    }
    co_return std::move(found_);
  }

 private:
  /// Asks; if the answer is no, the reason of the question becomes the problem.
  Task<Result<void>> require_yes(Question question) {
    const std::string reason = question.reason;
    const Result<bool> agreed = co_await tasks::ask(options_.ask, std::move(question));
    if (!agreed) co_return agreed.error();
    if (!*agreed) found_.problem = reason;
    co_return Result<void>();
  }

  Task<Result<void>> require_motors_off() {
    const auto data = co_await tasks::call(msg::RealtimeData3Request{});
    if (!data) co_return data.error();
    if (!data->other_flags.has(msg::OtherFlag::motors_on)) co_return Result<void>();
    Question question{Question::Kind::turn_motors_off, "the motors are on"};
    const Result<void> agreed = co_await require_yes(std::move(question));
    if (!agreed || !found_.problem.empty()) co_return agreed;
    const CallOptions options = confirming();
    const auto turned_off = co_await tasks::call(msg::MotorsOff{}, options);
    if (!turned_off) co_return turned_off.error();
    co_return Result<void>();
  }

  Task<Result<void>> require_sensor() {
    // A camera that was just turned on, or released, comes to rest.
    constexpr int attempts = 5;
    Result<SensorMotion> motion = co_await tasks::watch_sensor(options_.of_frame);
    for (int i = 1; i < attempts && motion && !is_at_rest(*motion); ++i) {
      motion = co_await tasks::watch_sensor(options_.of_frame);
    }
    if (!motion) co_return motion.error();
    found_.is_motion_known = motion->is_known;
    if (!motion->is_known) co_return Result<void>();
    const char* const what = options_.of_frame ? "frame" : "camera";
    if (options_.conditions.still && motion->shaking > most_motion) {
      found_.problem = fmt::format("the {} is not still: it turns by {:.1f} deg/s; leave it alone",
                                   what, motion->shaking + motion->turning);
      co_return Result<void>();
    }
    if (options_.conditions.still && motion->turning > most_motion) {
      // Only a person can see the difference.
      Question question{
          Question::Kind::is_still,
          fmt::format("the {} turns evenly by {:.1f} deg/s, or its gyroscope has this offset", what,
                      motion->turning)};
      const Result<void> agreed = co_await require_yes(std::move(question));
      if (!agreed || !found_.problem.empty()) co_return agreed;
    }
    if (options_.conditions.one_side_up && motion->up) judge_side(*motion->up);
    co_return Result<void>();
  }
  static bool is_at_rest(const SensorMotion& motion) {
    return std::max(motion.shaking, motion.turning) <= most_motion;
  }
  void judge_side(const Axes<double>& up) {
    const double angle = angle_to_side(up);
    const std::size_t side = side_of(up);
    const auto& before = options_.sides;
    if (!(angle <= most_tilt)) {
      found_.problem = fmt::format(
          "no side of the sensor points up: the nearest one is {:.0f} deg off; level it", angle);
    } else if (std::find(before.begin(), before.end(), side) != before.end()) {
      found_.problem = "this side of the sensor was up before; turn another one upwards";
    } else {
      found_.side = side;
    }
  }

  Task<Result<void>> require_level() {
    const auto data = co_await tasks::call(msg::RealtimeData3Request{});
    if (!data) co_return data.error();
    for (const std::size_t axis : {0U, 1U}) {
      const double angle = std::remainder(data->angle[axis].degrees(), 360);
      if (std::abs(angle) <= most_tilt) continue;
      found_.problem = fmt::format("the camera is not level: its {} angle is {:.0f} deg; level it",
                                   detail::axis_names[axis], angle);
      break;
    }
    co_return Result<void>();
  }

  Task<Result<void>> require_motors_that_turn() {
    const auto data = co_await tasks::call(msg::RealtimeData3Request{});
    if (!data) co_return data.error();
    for (const msg::SystemError error : stopping_errors) {
      if (!data->system_error.has(error)) continue;
      for (const ValueInfo& one : EnumMeta<msg::SystemError>::info.values) {
        if (one.value != static_cast<std::int64_t>(error)) continue;
        found_.problem = fmt::format(
            "the board reports {}, with which the motors do not turn; `sbgc doctor` says what "
            "helps",
            one.name);
        co_return Result<void>();
      }
    }
    msg::ReadParams3Request request;
    request.profile_id = msg::ReadParams3Request::active_profile;
    const auto parameters = co_await tasks::call(request);
    if (!parameters) co_return parameters.error();
    const auto& motors = parameters->axes;
    if (motors.roll.power == 0 && motors.pitch.power == 0 && motors.yaw.power == 0) {
      found_.problem = "the power of all motors is 0; set it with `sbgc params set power=...`";
      co_return Result<void>();
    }
    // The balance can only be measured while the motors hold the camera.
    const bool is_on = data->other_flags.has(msg::OtherFlag::motors_on);
    const TaskMachine& task = co_await tasks::this_task();
    if (!is_on || !is_supported<msg::RealtimeData4Request>(task.identity().versions())) {
      co_return Result<void>();
    }
    const auto more = co_await tasks::call(msg::RealtimeData4Request{});
    if (!more) co_return more.error();
    for (std::size_t axis = 0; axis < detail::axis_names.size(); ++axis) {
      const double share = std::abs(more->balance_error[axis].percent());
      if (share <= most_imbalance) continue;
      found_.problem = fmt::format(
          "the {} axis is out of balance: {:.0f} % of the motor's power holds it; balance the "
          "camera",
          detail::axis_names[axis], share);
      break;
    }
    co_return Result<void>();
  }

  Task<Result<void>> require_voltage() {
    const auto data = co_await tasks::call(msg::RealtimeData3Request{});
    if (!data) co_return data.error();
    const double measured = data->bat_level.volts();
    const bool is_wrong = options_.voltage && measured > 0 &&
                          std::abs(*options_.voltage - measured) > most_wrong * measured;
    if (is_wrong) {
      found_.problem =
          fmt::format("the board measures {:.2f} V, which is far from {:.2f} V; measure again",
                      measured, *options_.voltage);
    }
    co_return Result<void>();
  }

  const ReadinessOptions& options_;
  Readiness found_{};
};

}  // namespace

namespace tasks {

Task<Result<bool>> ask(AskHandler handler, Question question) {
  TaskMachine& task = co_await this_task();
  if (!handler) co_return false;
  const auto answer = std::make_shared<std::optional<bool>>();
  handler(question, [&task, answer](bool is_yes) {
    *answer = is_yes;
    task.wake();
  });
  while (!*answer) {
    const Result<void> waited = co_await wait_for_wake(Instant::never);
    if (!waited) co_return waited.error();
  }
  co_return **answer;
}

Task<Result<Readiness>> check_readiness(ReadinessOptions options) {
  ReadinessCheck check(options);
  co_return co_await check.run();
}

}  // namespace tasks
}  // namespace sbgc
