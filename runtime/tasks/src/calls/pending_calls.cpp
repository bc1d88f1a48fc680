#include "calls/pending_calls.hpp"

#include <algorithm>
#include <atomic>
#include <string>

namespace sbgc::detail {

CallId next_call_id() noexcept {
  static std::atomic<CallId> last = 0;
  return ++last;
}

std::string milliseconds_text(Duration duration) {
  return std::to_string((duration.us + 999) / 1000) + " ms";
}

CallPointer make_call(CallId id, Request request, const CallOptions& options,
                      const ConnectOptions& defaults, Instant now, ReplyHandler handler) {
  const ResponsePolicy& policy = request.policy;
  const unsigned retries = options.retries.value_or(defaults.retries);
  const unsigned attempts = policy.retry_is_safe ? std::min(retries, 99U) + 1 : 1;
  Duration attempt =
      std::max(milliseconds(policy.timeout_ms), milliseconds(defaults.attempt_timeout.count()));
  Duration allowed = attempt * static_cast<std::int32_t>(attempts);
  if (options.timeout) {
    allowed = milliseconds(options.timeout->count());
    // In a series, this is the longest silence between two messages.
    attempt = policy.series != 0 ? std::min(attempt, allowed) : Duration{allowed.us / attempts};
  } else {
    allowed = std::max(allowed, milliseconds(policy.finish_ms)) +
              milliseconds(defaults.queue_timeout.count());
  }
  auto call = std::make_shared<Call>();
  call->id = id;
  call->request = std::move(request);
  call->send = {.host = call->request.host,
                .expect_confirmation = options.expect_confirmation,
                .repeat_unconfirmed = options.repeat_unconfirmed,
                .attempts = static_cast<std::uint8_t>(attempts),
                .timeout = attempt};
  call->allowed = allowed;
  call->deadline = now + allowed;
  call->on_confirmation = options.on_confirmation;
  call->on_series = options.on_series;
  call->handler = std::move(handler);
  return call;
}

ClientError superseded_error(const Call& call) {
  return {ErrorCode::superseded,
          std::string(call.request.command) +
              " was not sent, because a later command stops the camera or moves it"};
}

Result<Reply> overdue_result(const Call& call) {
  const ResponsePolicy& policy = call.request.policy;
  const bool may_be_missing = !policy.is_certain() && call.send.expect_confirmation &&
                              policy.responses.confirmed != Confirmed::never;
  if (call.was_sent && may_be_missing) return Reply{.kind = ReplyKind::unconfirmed};
  const std::string within = " within " + milliseconds_text(call.allowed);
  const std::string command = call.request.command;
  return ClientError{ErrorCode::timeout, call.was_sent ? "no response to " + command + within
                                                       : command + " could not be sent" + within};
}

std::optional<ClientError> PendingCalls::add(const CallPointer& call, Superseded& superseded) {
  if (refusal_) return refusal_;
  const ResponsePolicy& policy = call->request.policy;
  const std::size_t waiting = waiting_effects_.size() + waiting_reads_.size();
  if (waiting >= most_waiting_ && !policy.stops) {
    return ClientError{ErrorCode::overload, std::to_string(waiting) + " calls are already waiting"};
  }
  if (call->request.is_motion) {
    if (call->task == 0) call->task = order_.begin();
    if (!order_.admit(call->task, policy.stops, superseded.tasks)) return superseded_error(*call);
  }
  take_superseded(*call, superseded.calls);
  calls_.emplace(call->id, call);
  deadlines_.emplace(call->deadline, call->id);
  std::deque<CallPointer>& queue = policy.has_effect ? waiting_effects_ : waiting_reads_;
  const auto is_stop = [](const CallPointer& one) { return one->request.policy.stops; };
  queue.insert(policy.stops ? std::find_if_not(queue.begin(), queue.end(), is_stop) : queue.end(),
               call);
  return std::nullopt;
}

CallPointer PendingCalls::take(CallId id) {
  const auto place = calls_.find(id);
  if (place == calls_.end()) return nullptr;
  CallPointer call = std::move(place->second);
  calls_.erase(place);
  deadlines_.erase({call->deadline, id});
  return call;
}

CallPointer PendingCalls::take_overdue(Instant at) {
  if (deadlines_.empty() || at < deadlines_.begin()->first) return nullptr;
  const auto place = calls_.find(deadlines_.begin()->second);
  CallPointer call = std::move(place->second);
  calls_.erase(place);
  deadlines_.erase(deadlines_.begin());
  return call;
}

std::vector<CallPointer> PendingCalls::take_all(ClientError refusal) {
  refusal_ = std::move(refusal);
  std::vector<CallPointer> all;
  for (auto& [id, call] : calls_) all.push_back(std::move(call));
  calls_.clear();
  waiting_effects_.clear();
  waiting_reads_.clear();
  deadlines_.clear();
  return all;
}

void PendingCalls::take_superseded(const Call& later, std::vector<CallPointer>& superseded) {
  for (const CallPointer& call : waiting_effects_) {
    const Request& request = call->request;
    if (!request.policy.is_superseded_by(later.request.policy) || calls_.erase(call->id) == 0)
      continue;
    deadlines_.erase({call->deadline, call->id});
    superseded.push_back(call);
  }
}

CallPointer PendingCalls::next_waiting(const std::function<bool(const Call&)>& has_room) {
  std::deque<CallPointer>* next = nullptr;
  for (std::deque<CallPointer>* const queue : {&waiting_effects_, &waiting_reads_}) {
    while (!queue->empty() && !calls_.contains(queue->front()->id)) queue->pop_front();
    if (queue->empty() || !has_room(*queue->front())) continue;
    const bool is_before = next == nullptr || (!next->front()->request.policy.stops &&
                                               queue->front()->id < next->front()->id);
    if (is_before) next = queue;
  }
  if (next == nullptr) return nullptr;
  CallPointer call = std::move(next->front());
  next->pop_front();
  return call;
}

Instant PendingCalls::deadline() const {
  return deadlines_.empty() ? Instant::never : deadlines_.begin()->first;
}

}  // namespace sbgc::detail
