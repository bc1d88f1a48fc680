// What callers ask for, from any thread.

#include "conversation_state.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include <asio/post.hpp>

#include <sbgc/io/clock.hpp>

namespace sbgc::detail {

namespace {

SessionOptions session_options(const ConnectOptions& options) {
  SessionOptions result;
  if (!options.pacing) result.pacing = {Duration{}, Duration{}};
  result.duplicates = milliseconds(options.duplicates.count());
  result.stream_percent = static_cast<std::uint8_t>(std::min(options.stream_share, 100U));
  return result;
}

}  // namespace

Conversation::State::State(Strand strand, const ConnectOptions& options)
    : options_(options),
      strand_(std::move(strand)),
      session_(session_options(options)),
      timer_(std::in_place, *strand_),
      messages_(std::make_shared<Handlers<MessageKey, bool(const Received&)>>()),
      notices_(std::make_shared<Handlers<int, void(const Notice&)>>()) {}

Conversation::State::~State() = default;

void Conversation::State::attach(std::unique_ptr<io::Transport> transport) {
  {
    const std::lock_guard lock(mutex_);
    description_ = transport->description();
  }
  // A function that Asio can copy.
  post([this, shared = std::make_shared<std::unique_ptr<io::Transport>>(std::move(transport))] {
    transport_ = std::move(*shared);
    if (const io::LineControl* const line = transport_->line()) {
      session_.set_line(line->current());
    }
    const bool is_open = [&] {
      const std::lock_guard lock(mutex_);
      return phase_ == Phase::open;
    }();
    if (!is_open) return shut();
    read();
    advance();
  });
}

void Conversation::State::post(std::function<void()> function) {
  const std::lock_guard lock(mutex_);
  if (!strand_) return;
  asio::post(*strand_, [self = shared_from_this(), function = std::move(function)] { function(); });
}

void Conversation::State::wake() {
  {
    const std::lock_guard lock(mutex_);
    if (std::exchange(is_woken_, true)) return;
  }
  post([this] {
    {
      const std::lock_guard lock(mutex_);
      is_woken_ = false;
    }
    advance();
  });
}

ClientError Conversation::State::no_line() const {
  if (phase_ == Phase::closed) return {ErrorCode::not_connected, "the client is closed"};
  return {ErrorCode::not_connected, loss_};
}

auto Conversation::State::start(FrameBytes frame, const CallOptions& options, ReplyHandler handler)
    -> Begun {
  auto request = inspect(frame, board_.versions(), options.validate);
  if (!request) {
    {
      const std::lock_guard lock(mutex_);
      ++statistics_.calls;
      ++statistics_.failures;
    }
    handler(std::move(request).error());
    return {};
  }
  return begin(*std::move(request), options, std::move(handler));
}

auto Conversation::State::begin(Request request, const CallOptions& options, ReplyHandler handler)
    -> Begun {
  const ResponsePolicy& policy = request.policy;
  const unsigned retries = options.retries.value_or(options_.retries);
  const unsigned attempts = policy.retry_is_safe ? std::min(retries, 99U) + 1 : 1;
  Duration attempt = milliseconds(policy.timeout_ms);
  Duration allowed = attempt * static_cast<std::int32_t>(attempts);
  if (options.timeout) {
    allowed = io::from_chrono(*options.timeout);
    attempt = Duration{allowed.us / attempts};
  } else {
    allowed =
        std::max(allowed, milliseconds(policy.finish_ms)) + io::from_chrono(options_.patience);
  }

  const auto call = std::make_shared<Call>();
  call->request = std::move(request);
  call->send = {.expect_confirmation = options.expect_confirmation,
                .attempts = static_cast<std::uint8_t>(attempts),
                .timeout = attempt};
  call->allowed = allowed;
  call->deadline = io::now() + allowed;
  call->on_confirmation = options.on_confirmation;
  call->handler = std::move(handler);
  std::optional<ClientError> refusal;
  {
    const std::lock_guard lock(mutex_);
    ++statistics_.calls;
    if (phase_ != Phase::open) {
      refusal = no_line();
    } else if (waiting_.size() >= options_.queue) {
      refusal = {ErrorCode::overload,
                 std::to_string(waiting_.size()) + " calls are waiting already"};
    } else {
      call->ticket = ++last_ticket_;
      calls_.emplace(call->ticket, call);
      deadlines_.emplace(call->deadline, call->ticket);
      waiting_.push_back(call);
    }
  }
  if (refusal) {
    complete(*call, *std::move(refusal));
    return {};
  }
  wake();
  return {call->ticket, call->deadline};
}

auto Conversation::State::take(Ticket ticket) -> CallPointer {
  const std::lock_guard lock(mutex_);
  const auto place = calls_.find(ticket);
  if (place == calls_.end()) return nullptr;
  CallPointer call = std::move(place->second);
  calls_.erase(place);
  deadlines_.erase({call->deadline, ticket});
  return call;
}

void Conversation::State::complete(const Call& call, Result<Reply> result) {
  if (!result) {
    const std::lock_guard lock(mutex_);
    ++statistics_.failures;
  }
  call.handler(std::move(result));
}

void Conversation::State::end(Ticket ticket, ClientError error) {
  const CallPointer call = take(ticket);
  if (!call) return;
  post([this, call] {
    forget(*call);
    advance();
  });
  complete(*call, std::move(error));
}

Subscription Conversation::State::subscribe(MessageKey key, MessageHandler handler) {
  return Subscription(messages_->add(key, std::move(handler)));
}

Subscription Conversation::State::on_notice(std::function<void(const Notice&)> handler) {
  return Subscription(notices_->add({}, std::move(handler)));
}

std::string Conversation::State::description() const {
  const std::lock_guard lock(mutex_);
  return description_;
}

ClientStatistics Conversation::State::statistics() const {
  const std::lock_guard lock(mutex_);
  return statistics_;
}

bool Conversation::State::runs_in_this_thread() const {
  const std::lock_guard lock(mutex_);
  return strand_ && strand_->running_in_this_thread();
}

std::optional<ClientError> Conversation::State::end_reason() const {
  const std::lock_guard lock(mutex_);
  if (phase_ == Phase::open) return std::nullopt;
  if (phase_ == Phase::lost) return ClientError{ErrorCode::link_lost, loss_};
  return ClientError{ErrorCode::cancelled, "the client was closed"};
}

void Conversation::State::close() {
  std::vector<CallPointer> ended;
  std::function<void(Detection)> detected;
  {
    const std::lock_guard lock(mutex_);
    if (phase_ == Phase::closed) return;
    phase_ = Phase::closed;
    waiting_.clear();
    deadlines_.clear();
    for (auto& [ticket, call] : calls_) ended.push_back(std::move(call));
    calls_.clear();
    detected = std::exchange(detected_, nullptr);
  }
  // Here, too: who closes may be the one that runs the strand.
  if (detected) detected({});
  for (const CallPointer& call : ended) {
    complete(*call, ClientError{ErrorCode::cancelled, "the client was closed"});
  }
  post([this] { shut(); });
}

}  // namespace sbgc::detail
