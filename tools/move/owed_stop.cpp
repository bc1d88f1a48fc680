#include "move/owed_stop.hpp"

#include <algorithm>

namespace sbgc::tools {

namespace {

Task<Result<void>> turn_motors_off(AnyMessage request) {
  const auto confirmed = co_await tasks::call(request);
  if (!confirmed) co_return confirmed.error();
  co_return Result<void>();
}

/// True if the board has answered, but the camera keeps turning.
bool is_refusal(ErrorCode code) {
  return code == ErrorCode::interrupted || code == ErrorCode::board_error;
}

/// True if no attempt can succeed, or if something else moves the camera later.
bool ends_attempts(ErrorCode code) {
  return code == ErrorCode::unsupported || code == ErrorCode::invalid ||
         code == ErrorCode::superseded;
}

}  // namespace

Task<Result<void>> OwedStop::attempt(Time now) {
  if (now >= end_of_motors_off_) motors_off_.reset();
  if (motors_off_) return turn_motors_off(*motors_off_);
  StopOptions options;
  options.timeout = patience;
  options.reads_first = reads_first_;
  return tasks::stop(options);
}

OwedStop::State OwedStop::take(const Result<void>& ended, Time began, Time now) {
  if (ended) return State::done;
  const ErrorCode code = ended.error().code;
  if (ends_attempts(code)) return State::failed;
  if (code == ErrorCode::board_reset) board_restarted();
  if (code == ErrorCode::link_lost || code == ErrorCode::not_connected) line_lost();
  if (!is_refusal(code)) {
    refused_since_ = Time::max();
    return State::owed;
  }
  refused_since_ = std::min(refused_since_, began);
  return now - refused_since_ < patience ? State::owed : State::failed;
}

}  // namespace sbgc::tools
