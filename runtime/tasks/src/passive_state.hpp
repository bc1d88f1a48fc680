/// The implementation of PassiveClient.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <vector>

#include <sbgc/client/passive_client.hpp>
#include <sbgc/detector.hpp>

#include "calls/pending_calls.hpp"
#include "calls/stream_listeners.hpp"
#include "conversation/dialogue.hpp"

namespace sbgc {

class PassiveClient::State {
 public:
  State(const ConnectOptions& options, bool line_may_repeat)
      : options_(options),
        line_may_repeat_(line_may_repeat || options.duplicate_window.count() != 0),
        calls_(options.queue_limit) {}

  void detect_line(SetLine set_line, std::function<void(const Result<void>&)> done);
  void set_line(const LineSettings& line) { dialogue_.set_line(line); }
  /// Changes to the newest framing of the board, if the board answers in it.
  void change_framing(const std::function<void()>& done);
  TaskMachine& start(TaskMachine& task, std::function<void()> finish);
  void receive(std::span<const std::uint8_t> bytes, Instant now);
  std::span<const std::uint8_t> advance(Instant now);
  void written(Instant now);
  Instant deadline() const noexcept { return has_news_ ? now_ : deadline_; }

  const ConnectOptions& options() const noexcept { return options_; }
  BoardIdentity& identity() noexcept { return identity_; }
  detail::Delivery& delivery() noexcept { return delivery_; }
  SessionStatistics statistics() const noexcept { return dialogue_.statistics(); }
  /// Returns the order of the tasks, for a held speed.
  detail::MotionOrder& order() const { return calls_->order(); }
  /// Returns the number of calls that have not ended.
  std::size_t pending() const { return calls_->size(); }

 private:
  class Stream;
  struct Search {
    std::vector<std::uint8_t> question{};
    Detector detector;
    SetLine set_line{};
    std::function<void(const Result<void>&)> done{};
  };
  struct Running {
    TaskMachine* machine{};
    std::function<void()> finish{};
    detail::Delivery::Registration notices{};
    detail::Delivery::Registration strays{};
    TaskNumber joined{};  // the number of the task in the order of motion; or 0
    bool is_over = false;
  };

  /// Continues the search; returns the bytes to send.
  std::span<const std::uint8_t> search();
  void end_search(const Result<void>& result);
  /// Runs a task until it waits or ends; returns the end of its wait.
  Instant step(Running& running);
  void end(Running& running);
  void begin(Running& running, TaskStep step);
  Subscription begin_stream(Running& running, TaskStep& step);
  void join_order(Running& running);
  void cancel(TaskStep step);
  void leave_stream(const detail::StreamListeners::Key& key,
                    detail::StreamListeners::Listener listener);
  void change_stream(const detail::StreamListeners::Key& key, detail::Request request);

  const ConnectOptions options_;
  const bool line_may_repeat_;
  BoardIdentity identity_{};
  Instant now_{};
  Instant deadline_ = Instant::never;
  bool has_news_ = false;  // for a task
  bool is_writing_ = false;
  detail::SharedCalls calls_;
  detail::Delivery delivery_{};
  detail::StreamListeners streams_{};
  detail::Dialogue dialogue_{options_, calls_, delivery_};
  std::unique_ptr<Search> search_{};
  std::vector<std::shared_ptr<Running>> running_{};
};

}  // namespace sbgc
