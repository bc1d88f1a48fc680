#include "pending_calls.hpp"

#include <algorithm>
#include <string>

#include <sbgc/io/clock.hpp>

namespace sbgc::detail {

std::string milliseconds_text(Duration duration) {
  return std::to_string((duration.us + 999) / 1000) + " ms";
}

CallPointer make_call(Request request, const CallOptions& options, const ConnectOptions& defaults,
                      Instant now, Conversation::ReplyHandler handler) {
  const ResponsePolicy& policy = request.policy;
  const unsigned retries = options.retries.value_or(defaults.retries);
  const unsigned attempts = policy.retry_is_safe ? std::min(retries, 99U) + 1 : 1;
  Duration attempt =
      std::max(milliseconds(policy.timeout_ms), io::from_chrono(defaults.attempt_timeout));
  Duration allowed = attempt * static_cast<std::int32_t>(attempts);
  if (options.timeout) {
    allowed = io::from_chrono(*options.timeout);
    attempt = Duration{allowed.us / attempts};
  } else {
    allowed =
        std::max(allowed, milliseconds(policy.finish_ms)) + io::from_chrono(defaults.queue_timeout);
  }
  auto call = std::make_shared<Call>();
  call->request = std::move(request);
  call->send = {.expect_confirmation = options.expect_confirmation,
                .attempts = static_cast<std::uint8_t>(attempts),
                .timeout = attempt};
  call->allowed = allowed;
  call->deadline = now + allowed;
  call->on_confirmation = options.on_confirmation;
  call->handler = std::move(handler);
  return call;
}

ClientError overdue_error(const Call& call) {
  const std::string within = " within " + milliseconds_text(call.allowed);
  const std::string command = call.request.command;
  return {ErrorCode::timeout, call.was_sent ? "no response to " + command + within
                                            : command + " could not be sent" + within};
}

std::optional<ClientError> PendingCalls::add(const CallPointer& call) {
  ++begun_;
  const std::lock_guard lock(mutex_);
  if (refusal_) return refusal_;
  if (waiting_.size() >= most_waiting_) {
    return ClientError{ErrorCode::overload,
                       std::to_string(waiting_.size()) + " calls are already waiting"};
  }
  call->ticket = ++last_ticket_;
  calls_.emplace(call->ticket, call);
  deadlines_.emplace(call->deadline, call->ticket);
  waiting_.push_back(call);
  return std::nullopt;
}

CallPointer PendingCalls::take(Ticket ticket) {
  const std::lock_guard lock(mutex_);
  const auto place = calls_.find(ticket);
  if (place == calls_.end()) return nullptr;
  CallPointer call = std::move(place->second);
  calls_.erase(place);
  deadlines_.erase({call->deadline, ticket});
  return call;
}

CallPointer PendingCalls::take_overdue(Instant at) {
  const std::lock_guard lock(mutex_);
  if (deadlines_.empty() || at < deadlines_.begin()->first) return nullptr;
  const auto place = calls_.find(deadlines_.begin()->second);
  CallPointer call = std::move(place->second);
  calls_.erase(place);
  deadlines_.erase(deadlines_.begin());
  return call;
}

std::vector<CallPointer> PendingCalls::take_all(ClientError refusal) {
  const std::lock_guard lock(mutex_);
  refusal_ = std::move(refusal);
  std::vector<CallPointer> all;
  for (auto& [ticket, call] : calls_) all.push_back(std::move(call));
  calls_.clear();
  waiting_.clear();
  deadlines_.clear();
  return all;
}

CallPointer PendingCalls::next_waiting() {
  const std::lock_guard lock(mutex_);
  while (!waiting_.empty()) {
    CallPointer call = std::move(waiting_.front());
    waiting_.pop_front();
    if (calls_.contains(call->ticket)) return call;
  }
  return nullptr;
}

Instant PendingCalls::deadline() const {
  const std::lock_guard lock(mutex_);
  return deadlines_.empty() ? Instant::never : deadlines_.begin()->first;
}

void PendingCalls::complete(const Call& call, Result<Reply> result) {
  if (!result) ++failed_;
  call.handler(std::move(result));
}

void PendingCalls::count_failure() {
  ++begun_;
  ++failed_;
}

}  // namespace sbgc::detail
