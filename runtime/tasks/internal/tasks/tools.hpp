/// Helpers shared by the tasks.
#pragma once

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <utility>

#include <fmt/format.h>

#include <sbgc/client/options.hpp>
#include <sbgc/client/progress.hpp>
#include <sbgc/client/task.hpp>
#include <sbgc/enums.hpp>
#include <sbgc/result.hpp>
#include <sbgc/units.hpp>

namespace sbgc::detail {

constexpr Duration duration_of(std::chrono::milliseconds time) noexcept {
  return milliseconds(time.count());
}

constexpr std::chrono::milliseconds whole_milliseconds(Duration duration) noexcept {
  return std::chrono::milliseconds(duration.us / 1000);
}

/// Returns the signed difference of two angles in degrees. They wrap around after two turns in each
/// direction.
constexpr double degrees_between(msg::Angle14 from, msg::Angle14 to) noexcept {
  const auto raw = static_cast<std::uint16_t>(to.raw() - from.raw());
  return msg::Angle14(static_cast<std::int16_t>(raw)).degrees();
}

/// The deadline of a task, in milliseconds like the timeouts of its calls.
class Deadline {
 public:
  Deadline(const TaskMachine& task, std::chrono::milliseconds timeout) noexcept
      : task_(task), end_(task.now() + duration_of(timeout)) {}

  /// True if no time is left.
  bool is_over() const noexcept { return left().count() == 0; }
  Instant end() const noexcept { return end_; }
  /// The remaining time, rounded down, so that a call with this timeout ends in time.
  std::chrono::milliseconds left() const noexcept {
    return whole_milliseconds({std::max<std::int64_t>((end_ - task_.now()).us, 0)});
  }

 private:
  const TaskMachine& task_;
  Instant end_;
};

/// Returns the options of a call inside a task. By default a call ends long before the task, so it
/// can be repeated. Only near the end of a task is its timeout limited to the remaining time.
inline CallOptions options_within(const Deadline& deadline) {
  constexpr std::chrono::seconds enough{10};
  CallOptions options;
  if (deadline.left() < enough) options.timeout = deadline.left();
  return options;
}

/// Prefixes an error with the operation: "reading file 5: timeout".
inline ClientError during(const std::string& what, ClientError error) {
  error.message = fmt::format("{}: {}", what, error.message);
  return error;
}

inline ClientError cancelled_error(const std::string& what) {
  return {ErrorCode::cancelled, "interrupted: " + what};
}

inline ClientError late_error(const std::string& what) {
  return {ErrorCode::timeout, fmt::format("{} timed out", what)};
}

/// Reports the progress of a task. Fails if the task was cancelled or its time is over.
inline Result<void> go_on(const std::string& task, const ProgressHandler& progress,
                          const Progress& state, const Deadline& deadline) {
  if (progress && !progress(state)) return cancelled_error(task);
  if (state.done < state.total && deadline.is_over()) return late_error(task);
  return {};
}

/// Calls a handler with the messages that belong to no call, as long as it lives. One at a
/// time.
class Overhearing {
 public:
  Overhearing(TaskMachine& task, TaskMachine::OverhearingHandler handler) : task_(task) {
    task_.overhear(std::move(handler));
  }
  Overhearing(const Overhearing&) = delete;
  Overhearing& operator=(const Overhearing&) = delete;
  ~Overhearing() { task_.overhear({}); }

 private:
  TaskMachine& task_;
};

/// Collects the errors that the board reports about a command. A call of such a command ends once
/// it is sent, so only a later take() returns the error.
class Refusals {
 public:
  Refusals(TaskMachine& task, msg::CommandToBoard command)
      : task_(task), listener_(task.listen([this, command](const Notice& notice) {
          const bool is_about_it = notice.kind == NoticeKind::board_error &&
                                   notice.command == static_cast<std::uint8_t>(command);
          if (is_about_it) last_ = {ErrorCode::board_error, notice.message, notice.detail};
        })) {}
  Refusals(const Refusals&) = delete;
  Refusals& operator=(const Refusals&) = delete;
  ~Refusals() { task_.stop_listening(listener_); }

  /// Returns, once, the last error since the previous call: "CMD_CONTROL: the board refused:
  /// WRONG_STATE".
  std::optional<ClientError> take() { return std::exchange(last_, std::nullopt); }

 private:
  TaskMachine& task_;
  std::optional<ClientError> last_{};
  TaskMachine::Listener listener_;
};

}  // namespace sbgc::detail
