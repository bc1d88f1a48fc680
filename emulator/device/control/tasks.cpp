#include "device/control/tasks.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "device/calibration/auto_tuning.hpp"
#include "device/control/menu.hpp"
#include "device/control/quaternion_control.hpp"
#include "device/request_context.hpp"
#include "device/scripting/scripts.hpp"

namespace sbgc::emulator {
namespace {

/// Assumption: the interval for checking tasks.
constexpr Duration check_period = milliseconds(20);
/// Assumption: the longest safe stop.
constexpr Duration longest_stop = seconds(3);
/// An axis has arrived if it is nearer to its target than this, in degrees.
constexpr double arrival_tolerance = 1;

/// The timeout of a task.
Duration longest(Tasks::Kind kind) {
  return kind == Tasks::Kind::action ? seconds(59) : seconds(10);
}

bool has_arrived(Gimbal& gimbal, Instant now) {
  const Sample sample = gimbal.sample(now);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (sample.target_speeds[axis] != 0) return false;
    if (std::abs(sample.angles[axis] - sample.targets[axis]) > arrival_tolerance) return false;
  }
  return true;
}

bool has_stopped(Gimbal& gimbal, Instant now) {
  const Axes<double> speeds = gimbal.sample(now).target_speeds;
  return speeds == Axes<double>{};
}

bool has_ended(MenuParts& parts, Tasks::Kind kind, Instant now) {
  switch (kind) {
    case Tasks::Kind::motion: return has_arrived(parts.gimbal, now);
    case Tasks::Kind::attitude:
      return parts.quaternions.has_arrived(parts.gimbal, parts.tuning, now);
    case Tasks::Kind::action: break;
  }
  return !parts.calibrations.under_way() && !parts.auto_tuning.is_running() &&
         !parts.scripts.running() && !parts.tasks.is_stopping() && has_arrived(parts.gimbal, now);
}

void report_end(MenuParts& parts, std::size_t port, std::uint8_t command, bool is_success,
                Instant now) {
  RequestContext context(parts.ports, parts.options, port, command, Confirmed::always, now);
  constexpr std::array<std::uint8_t, 1> complete{1};
  if (is_success) {
    context.confirm(complete);
  } else {
    context.refuse(msg::BoardErrorCode::operation_failed);
  }
}

}  // namespace

void Tasks::plan(Instant now) {
  const bool has_work = !tasks_.empty() || stop_ != Instant::never || off_ != Instant::never;
  next_ = has_work ? earlier(now + check_period, off_) : Instant::never;
}

void Tasks::confirm_end(std::size_t port, std::uint8_t command, Kind kind, Instant now) {
  std::erase_if(tasks_,
                [&](const Task& task) { return task.port == port && task.command == command; });
  tasks_.push_back({port, command, kind, now + longest(kind)});
  plan(now);
}

void Tasks::set_motors(Gimbal& gimbal, bool on, Instant now) {
  stop_ = off_ = Instant::never;
  gimbal.set_motors(on, now);
}

void Tasks::stop_safely(Gimbal& gimbal, Instant now) {
  if (!gimbal.motors_on()) return;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    gimbal.command(axis, {.mode = AxisMode::speed}, now);
  }
  stop_ = now + longest_stop;
  plan(now);
  if (has_stopped(gimbal, now)) set_motors(gimbal, false, now);
}

void Tasks::synchronize(Gimbal& gimbal, std::size_t axis, double degrees, Duration time,
                        Instant now) {
  set_motors(gimbal, true, now);
  const double angle = gimbal.sample(now).angles[axis] + degrees;
  const double seconds = std::max(static_cast<double>(time.us) * 1e-6, 1e-3);
  gimbal.command(axis, {.mode = AxisMode::angle, .speed = degrees / seconds, .angle = angle}, now);
  off_ = now + time;
  plan(now);
}

void Tasks::advance(Instant now, MenuParts& parts) {
  if (off_ <= now || stop_ <= now || (is_stopping() && has_stopped(parts.gimbal, now))) {
    set_motors(parts.gimbal, false, now);
  }
  const std::vector<Task> before = std::move(tasks_);
  tasks_.clear();
  for (const Task& task : before) {
    if (has_ended(parts, task.kind, now)) {
      report_end(parts, task.port, task.command, true, now);
    } else if (task.deadline <= now) {
      if (task.kind == Kind::attitude) parts.quaternions.end();
      report_end(parts, task.port, task.command, false, now);
    } else {
      tasks_.push_back(task);
    }
  }
  plan(now);
}

void Tasks::drop_port(std::size_t port) {
  std::erase_if(tasks_, [port](const Task& task) { return task.port == port; });
}

}  // namespace sbgc::emulator
