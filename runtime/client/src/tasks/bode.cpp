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

/// The call of a recording, cancelled if the task ends before it.
class BodeCall {
 public:
  BodeCall(TaskMachine& task, const msg::BodeTestStartStopRequest& request) : task_(task) {
    // Twice as long as it takes: what is late by more does not come.
    const auto length = static_cast<std::int64_t>(request.samples_num * 2000.0 / bode_sample_rate);
    CallOptions options;
    options.timeout = std::chrono::milliseconds(length + 10'000);
    id_ = task.begin(request, options);
  }
  BodeCall(const BodeCall&) = delete;
  BodeCall& operator=(const BodeCall&) = delete;
  ~BodeCall() { task_.end(id_); }

  CallId id() const noexcept { return id_; }
  bool has_started() const { return task_.has_started(id_); }

  ClientError error(ClientError reason) const {
    return detail::during(
        has_started() ? "the recording has started, but it failed" : "starting the recording",
        std::move(reason));
  }

 private:
  TaskMachine& task_;
  CallId id_{};
};

/// Passes what has arrived to the collector.
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
      if (!end) co_return call.error(end.error());
      co_return std::move(collector).finish(*end);
    }
    const bool goes_on =
        waited && (!options.progress || options.progress({call.has_started(), collector.samples(),
                                                          request.samples_num, collector.lost()}));
    if (!goes_on) {
      co_return detail::cancelled_error(
          "the recording, which continues on the board until its end");
    }
  }
}

}  // namespace sbgc::tasks
