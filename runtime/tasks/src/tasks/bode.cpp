#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <utility>

#include <fmt/format.h>

#include <sbgc/client/bode.hpp>
#include <sbgc/text/status.hpp>

#include "tasks/bode_collector.hpp"
#include "tasks/tools.hpp"

namespace sbgc::tasks {
namespace {

/// A recording sends 20 samples every 16 ms: if none arrive for this long, none is running.
constexpr Duration silence = milliseconds(250);
/// The maximum time in which the rest of a finished recording may arrive.
constexpr Duration longest_rest = seconds(1);

constexpr Duration length_of(const msg::BodeTestStartStopRequest& request) noexcept {
  return microseconds(static_cast<std::int64_t>(request.samples_num * 1e6 / bode_sample_rate));
}

constexpr bool is_of_recording(std::uint8_t id) noexcept {
  return id == static_cast<std::uint8_t>(msg::BodeTestData::command) ||
         id == static_cast<std::uint8_t>(msg::BodeTestStartStop::command);
}

/// Waits until no message of an earlier recording arrives: it would be indistinguishable from those
/// of the next one. `goes_on()` is called meanwhile.
Task<Result<void>> wait_for_silence(std::function<bool()> goes_on) {
  constexpr Duration step = milliseconds(50);
  TaskMachine& task = co_await this_task();
  bool is_heard = false;
  const detail::Overhearing overhearing(task, [&](std::uint8_t id, std::span<const std::uint8_t>) {
    is_heard = is_heard || is_of_recording(id);
  });
  const Instant end = task.now() + longest_rest;
  for (Duration quiet; quiet < silence;) {
    if (is_heard && task.now() >= end) {
      co_return ClientError{ErrorCode::board_error,
                            "the board sends an earlier recording, which no command ends: wait "
                            "until it is over",
                            static_cast<int>(msg::BoardErrorCode::wrong_state)};
    }
    is_heard = false;
    const Result<void> waited = co_await wait_until(task.now() + step);
    if (!waited || !goes_on()) co_return detail::cancelled_error("no recording has started");
    quiet = is_heard ? Duration{} : quiet + step;
  }
  co_return Result<void>();
}

/// The call of a recording, canceled if the task ends before it.
class BodeCall {
 public:
  BodeCall(TaskMachine& task, const msg::BodeTestStartStopRequest& request) : task_(task) {
    // Twice the duration: anything later does not arrive at all.
    CallOptions options;
    options.timeout = detail::whole_milliseconds({2 * length_of(request).us}) + longest_lateness;
    id_ = task.begin(request, options);
  }
  BodeCall(const BodeCall&) = delete;
  BodeCall& operator=(const BodeCall&) = delete;
  ~BodeCall() { task_.end(id_); }

  CallId id() const noexcept { return id_; }
  bool has_started() const { return task_.has_started(id_); }

  /// Returns the reason for a failure. A refused request starts no recording, whatever arrives.
  ClientError error(ClientError reason, bool is_refused = false) const {
    return detail::during(has_started() && !is_refused ? "the recording has started, but it failed"
                                                       : "starting the recording",
                          std::move(reason));
  }

 private:
  static constexpr std::chrono::seconds longest_lateness{10};

  TaskMachine& task_;
  CallId id_{};
};

/// Passes received samples to the collector.
Result<void> take_samples(TaskMachine& task, CallId id, detail::BodeCollector& collector) {
  for (const auto& body : task.take_series(id)) {
    msg::BodeTestData data;
    if (const Status status = decode(std::span<const std::uint8_t>(body), data); !status) {
      return ClientError{ErrorCode::bad_response, "CMD_BODE_TEST_DATA: " + to_string(status)};
    }
    collector.add(data);
    if (collector.has_too_many()) {
      return ClientError{ErrorCode::bad_response, "the board sends more samples than requested"};
    }
  }
  return {};
}

}  // namespace

Task<Result<BodeRecording>> record_bode(msg::BodeTestStartStopRequest request,
                                        BodeOptions options) {
  TaskMachine& task = co_await this_task();
  if (request.samples_num == 0) {
    co_return ClientError{ErrorCode::invalid, "a recording needs at least one sample"};
  }
  const auto goes_on = [&](const BodeProgress& seen) {
    return !options.progress || options.progress(seen);
  };
  // A variable, because g++ 12 may copy the bytes of a temporary.
  const std::function<bool()> goes_on_silently = [&] {
    return goes_on({.total = request.samples_num});
  };
  const Result<void> is_silent = co_await wait_for_silence(goes_on_silently);
  if (!is_silent) co_return is_silent.error();
  const Instant start = task.now();
  const BodeCall call(task, request);
  detail::BodeCollector collector(request);
  while (true) {
    const Instant next =
        options.progress ? task.now() + detail::duration_of(options.interval) : Instant::never;
    const Result<void> waited = co_await wait_for_call(call.id(), next);
    if (const Result<void> taken = take_samples(task, call.id(), collector); !taken) {
      co_return call.error(taken.error());
    }
    if (const Result<Reply>* const reply = task.reply(call.id())) {
      const Result<msg::BodeTestStartStop> end =
          detail::read_response<msg::BodeTestStartStopRequest>(*reply);
      const bool is_lost = !end && end.error().code == ErrorCode::timeout;
      if (!end && !is_lost) {
        co_return call.error(end.error(), end.error().code == ErrorCode::board_error);
      }
      const bool is_over = task.now() - start >= length_of(request);
      Result<BodeRecording> recorded =
          is_lost ? std::move(collector).finish_without_end(end.error(), is_over)
                  : std::move(collector).finish(*end);
      if (!recorded) co_return call.error(recorded.error());
      co_return recorded;
    }
    if (!waited || !goes_on({true, call.has_started(), collector.samples(), request.samples_num,
                             collector.lost()})) {
      co_return detail::cancelled_error(
          "the recording, which continues on the board until its end");
    }
  }
}

}  // namespace sbgc::tasks
