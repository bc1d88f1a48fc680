#include <array>
#include <cmath>
#include <span>
#include <utility>

#include <sbgc/availability.hpp>
#include <sbgc/client/tuning.hpp>
#include <sbgc/messages/realtime.hpp>

#include "tasks/tools.hpp"

namespace sbgc {

namespace {

/// The last report of the board while it tunes, and the time since then.
class TuningReports {
 public:
  explicit TuningReports(TaskMachine& task)
      : task_(task),
        since_(task.now()),
        overhearing_(
            task, [this](std::uint8_t id, std::span<const std::uint8_t> body) { take(id, body); }) {
  }

  const std::optional<msg::AutoPid>& last() const { return last_; }
  /// Returns the time since the last report, or since the beginning.
  Duration silence() {
    if (std::exchange(is_new_, false)) since_ = task_.now();
    return task_.now() - since_;
  }

 private:
  void take(std::uint8_t id, std::span<const std::uint8_t> body) {
    msg::AutoPid report;
    if (id != static_cast<std::uint8_t>(msg::AutoPid::command) || !decode(body, report)) return;
    last_ = report;
    is_new_ = true;
  }

  TaskMachine& task_;
  Instant since_;
  std::optional<msg::AutoPid> last_{};
  bool is_new_ = false;
  detail::Overhearing overhearing_;
};

}  // namespace

msg::AutoPidRequest tuning_request(const TuningChoice& choice) {
  constexpr std::array flags{msg::AutoPidFlag::roll, msg::AutoPidFlag::pitch,
                             msg::AutoPidFlag::yaw};
  msg::AutoPidRequest request;
  request.profile_id = choice.profile;
  request.cfg_flags = msg::AutoPidFlag::send_gui;
  for (std::size_t axis = 0; axis < flags.size(); ++axis) {
    if (choice.axes[axis]) request.cfg_flags.set(flags[axis]);
  }
  request.cfg_flags.set(msg::AutoPidFlag::keep_current, choice.from_current);
  request.cfg_flags.set(msg::AutoPidFlag::tune_lpf_freq, choice.filters);
  constexpr double most = 255;
  request.gain_vs_stability = static_cast<std::uint8_t>(std::lround(choice.gain / 100 * most));
  return request;
}

namespace tasks {

Task<Result<void>> run_tuning(msg::AutoPidRequest request, TuningOptions options) {
  // Assumption: a board that does not say that it tunes reports its progress more often.
  constexpr Duration longest_silence = seconds(5);
  constexpr Duration longest_start = seconds(20);
  constexpr Duration pause = milliseconds(200);    // between questions to the board
  constexpr Duration patience = milliseconds(50);  // of a user who ends it
  TaskMachine& task = co_await this_task();
  TuningReports reports(task);
  CallOptions call;
  call.expect_confirmation = true;
  // Few boards confirm the request; the reports show that the tuning runs.
  const Result<Reply> started = co_await transact(request, call);
  if (!started) co_return started.error();
  bool has_said_so = false;  // in its live data
  Instant answered = task.now();
  for (;;) {
    for (const Instant next = task.now() + pause; task.now() < next;) {
      const Result<void> waited = co_await wait_until(earlier(task.now() + patience, next));
      if (!waited) co_return waited;
      if (options.progress && !options.progress(reports.last())) {
        co_return detail::cancelled_error("tuning");
      }
    }
    const Result<bool> says_so = co_await is_tuning();
    if (!says_so) {  // which does not mean that it has ended
      if (task.now() - answered > longest_silence) co_return says_so.error();
      continue;
    }
    answered = task.now();
    if (has_said_so && !*says_so) co_return Result<void>();
    has_said_so = has_said_so || *says_so;
    if (*says_so) continue;
    const Duration silence = reports.silence();
    if (reports.last() && silence > longest_silence) co_return Result<void>();
    if (!reports.last() && silence > longest_start) {
      co_return ClientError{ErrorCode::timeout, "the board reports no progress of the tuning"};
    }
  }
}

Task<Result<bool>> is_tuning() {
  const TaskMachine& task = co_await this_task();
  if (!is_supported<msg::RealtimeData4Request>(task.identity().versions())) co_return false;
  const auto data = co_await call(msg::RealtimeData4Request{});
  if (!data) co_return data.error();
  co_return data->calib_mode == msg::CalibMode::auto_pid;
}

Task<Result<void>> end_tuning() {
  const TaskMachine& task = co_await this_task();
  if (!is_supported<msg::AutoPidRequest>(task.identity().versions())) co_return Result<void>();
  msg::AutoPidRequest request;
  request.cfg_flags = msg::AutoPidFlags(msg::AutoPidRequest::stop_tuning);
  constexpr int attempts = 5;
  ClientError problem{ErrorCode::timeout, "the board goes on tuning"};
  for (int i = 0; i < attempts; ++i) {
    const auto sent = co_await call(request);  // which few boards confirm
    if (!sent && sent.error().code != ErrorCode::board_error) {
      problem = sent.error();
      continue;
    }
    const Result<bool> tunes = co_await is_tuning();
    if (tunes && !*tunes) co_return Result<void>();
    if (!tunes) problem = tunes.error();
    constexpr Duration until_it_shows = milliseconds(100);
    const Result<void> waited = co_await wait_until(task.now() + until_it_shows);
    if (!waited) co_return waited;
  }
  co_return problem;
}

}  // namespace tasks
}  // namespace sbgc
