#include "tasks/angle_polls.hpp"

#include <chrono>
#include <utility>

#include "tasks/tools.hpp"

namespace sbgc::detail {

Task<Result<bool>> AnglePolls::update(Instant until) {
  TaskMachine& task = co_await tasks::this_task();
  if (!pending_) {
    CallOptions options;
    options.timeout = std::chrono::seconds(1);  // a stop must not wait long
    pending_ = task.begin(msg::GetAnglesRequest{}, options);
  }
  const Result<void> waited = co_await tasks::wait_for_call(*pending_, until);
  const Result<Reply>* const reply = task.reply(*pending_);
  if (reply == nullptr) {
    if (!waited) co_return waited.error();
    co_return false;
  }
  const Result<msg::GetAngles> state = read_response<msg::GetAnglesRequest>(*reply);
  end_request(task);
  if (!state) co_return during("reading the camera angles", state.error());
  last_ = *state;
  time_ = task.now();
  co_return true;
}

void AnglePolls::forget(TaskMachine& task) {
  end_request(task);
  last_.reset();
}

void AnglePolls::end_request(TaskMachine& task) {
  if (pending_) task.end(*std::exchange(pending_, std::nullopt));
}

}  // namespace sbgc::detail
