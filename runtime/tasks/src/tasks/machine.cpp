#include <algorithm>

#include <sbgc/client/task.hpp>

namespace sbgc {

TaskStep TaskMachine::step(Instant now) {
  now_ = later(now_, now);
  while (steps_.empty()) {
    if (!coroutine_) {
      if (calls_.empty()) return {.kind = TaskStep::Kind::done};
      end(calls_.begin()->first);
      continue;
    }
    if (!is_ready()) {
      return {.kind = TaskStep::Kind::wait, .until = wait_.until, .can_be_woken = wait_.for_wake};
    }
    do {
      coroutine_.resume();
    } while (std::exchange(goes_on_, false));
  }
  TaskStep step = std::move(steps_.front());
  steps_.pop_front();
  return step;
}

bool TaskMachine::is_ready() {
  cut_short_.reset();
  if (wait_.until <= now_) return true;
  // Before the cancellation, which would be lost with the reply to the task: it ends the next wait.
  const auto call = calls_.find(wait_.call);
  if (call != calls_.end()) {
    if (call->second.reply) return true;
    if (wait_.start_is_enough && call->second.has_started()) return true;
  }
  // One at a time: a simultaneous cancellation ends the next wait.
  if (std::exchange(is_superseded_, false)) {
    cut_short_ = ErrorCode::superseded;
  } else if (std::exchange(is_cancelled_, false)) {
    cut_short_ = ErrorCode::cancelled;
  }
  if (cut_short_) return true;
  return wait_.for_wake && std::exchange(is_woken_, false);
}

Result<void> TaskMachine::end_of_wait() const {
  if (!cut_short_) return {};
  return ClientError{*cut_short_, *cut_short_ == ErrorCode::superseded
                                      ? "a later command stops the camera or moves it"
                                      : "canceled"};
}

void TaskMachine::replied(CallId id, Result<Reply> reply) {
  if (reply && reply->id != 0) framing_ = reply->framing;
  const auto call = calls_.find(id);
  if (call != calls_.end()) call->second.reply = std::move(reply);
}

void TaskMachine::confirmed(CallId id) {
  const auto call = calls_.find(id);
  if (call != calls_.end()) ++call->second.confirmations;
}

void TaskMachine::received(CallId id, std::vector<std::uint8_t> body) {
  const auto call = calls_.find(id);
  if (call == calls_.end()) return;
  call->second.has_series = true;
  call->second.series.push_back(std::move(body));
}

void TaskMachine::keep(CallId id, Subscription stream) {
  const auto call = calls_.find(id);
  if (call != calls_.end()) call->second.stream = std::move(stream);
}

bool TaskMachine::is_calling() const {
  return std::any_of(calls_.begin(), calls_.end(),
                     [](const auto& one) { return !one.second.reply; });
}

void TaskMachine::notice(const Notice& notice) {
  for (const NoticeHandler& handler : listeners_) handler(notice);
}

void TaskMachine::overheard(std::uint8_t id, std::span<const std::uint8_t> body) {
  if (overhearing_) overhearing_(id, body);
}

CallId TaskMachine::begin_call(Result<detail::Request> request, const CallOptions& options,
                               std::optional<detail::Request> stream_end) {
  const CallId id = detail::next_call_id();
  calls_.emplace(id, Call{});
  steps_.push_back({.kind = TaskStep::Kind::call,
                    .call = id,
                    .request = std::move(request),
                    .stream_end = std::move(stream_end),
                    .options = options});
  return id;
}

bool TaskMachine::has_started(CallId id) const {
  const auto call = calls_.find(id);
  return call != calls_.end() && call->second.has_started();
}

std::vector<std::vector<std::uint8_t>> TaskMachine::take_series(CallId id) {
  const auto call = calls_.find(id);
  if (call == calls_.end()) return {};
  return std::exchange(call->second.series, {});
}

const Result<Reply>* TaskMachine::reply(CallId id) const {
  const auto call = calls_.find(id);
  return call != calls_.end() && call->second.reply ? &*call->second.reply : nullptr;
}

void TaskMachine::end(CallId id) {
  const auto call = calls_.find(id);
  if (call == calls_.end()) return;
  if (!call->second.reply || call->second.stream) {
    steps_.push_back(
        {.kind = TaskStep::Kind::cancel, .call = id, .stream = std::move(call->second.stream)});
  }
  calls_.erase(call);
}

TaskMachine::Listener TaskMachine::listen(NoticeHandler handler) {
  return listeners_.insert(listeners_.end(), std::move(handler));
}

}  // namespace sbgc
