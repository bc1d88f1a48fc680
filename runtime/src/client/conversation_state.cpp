#include "conversation_state.hpp"

#include <algorithm>
#include <chrono>
#include <utility>
#include <vector>

#include <asio/error.hpp>
#include <asio/post.hpp>

#include <sbgc/io/clock.hpp>

#include "text.hpp"

namespace sbgc::detail {

namespace {

SessionOptions session_options(const ConnectOptions& options) {
  SessionOptions result;
  if (!options.pacing) result.pacing = {Duration{}, Duration{}};
  result.duplicates = milliseconds(options.duplicates.count());
  result.stream_percent = static_cast<std::uint8_t>(std::min(options.stream_share, 100U));
  return result;
}

/// How long close() waits for the end of what is still to be written.
constexpr std::chrono::milliseconds longest_farewell{200};

/// In whole milliseconds, rounded up.
std::string milliseconds_text(Duration duration) {
  return std::to_string((duration.us + 999) / 1000) + " ms";
}

}  // namespace

/// A data stream as long as someone listens to it.
class Conversation::State::StreamHold : public Subscription::Hold {
 public:
  StreamHold(std::unique_ptr<Hold> membership, std::weak_ptr<State> state, StreamKey key)
      : membership_(std::move(membership)), state_(std::move(state)), key_(std::move(key)) {}
  StreamHold(const StreamHold&) = delete;
  StreamHold& operator=(const StreamHold&) = delete;
  // NOLINTNEXTLINE(bugprone-exception-escape): only if there is no memory left
  ~StreamHold() override {
    membership_.reset();
    if (const auto state = state_.lock()) state->leave_stream(key_);
  }

 private:
  std::unique_ptr<Hold> membership_;
  std::weak_ptr<State> state_;
  StreamKey key_;
};

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

// Any thread

template <class Function>
void Conversation::State::post(Function function) {
  const std::lock_guard lock(mutex_);
  if (!strand_) return;
  asio::post(*strand_,
             [self = shared_from_this(), function = std::move(function)]() mutable { function(); });
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
  const Exchange& exchange = request.exchange;
  const unsigned retries = options.retries.value_or(options_.retries);
  const unsigned attempts = exchange.retry_is_safe ? std::min(retries, 99U) + 1 : 1;
  Duration attempt = milliseconds(exchange.timeout_ms);
  Duration allowed = attempt * static_cast<std::int32_t>(attempts);
  if (options.timeout) {
    allowed = io::from_chrono(*options.timeout);
    attempt = Duration{allowed.us / attempts};
  } else {
    allowed =
        std::max(allowed, milliseconds(exchange.finish_ms)) + io::from_chrono(options_.patience);
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

auto Conversation::State::start_stream(FrameBytes frame, MessageKey key, MessageHandler handler,
                                       const CallOptions& options, StreamHandler done) -> Begun {
  auto request = inspect(frame, board_.versions(), options.validate);
  if (request && request->exchange.stream.command == 0) {
    request = ClientError{ErrorCode::invalid,
                          std::string(request->info->command) + " starts no data stream"};
  }
  if (!request) {
    done(std::move(request).error());
    return {};
  }
  const StreamChange& change = request->exchange.stream;
  const StreamKey stream{change.command, change.config};
  {
    const std::lock_guard lock(mutex_);
    Stream& entry = streams_[stream];
    ++entry.subscriptions;
    entry.end = frame_that_ends_stream(*request);
  }
  // Subscribed before the first sample can come.
  auto hold = std::make_unique<StreamHold>(messages_->add(key, std::move(handler)),
                                           weak_from_this(), stream);
  return begin(*std::move(request), options,
               [this, stream, hold = std::make_shared<std::unique_ptr<StreamHold>>(std::move(hold)),
                done = std::move(done)](Result<Reply> reply) {
                 if (!reply) {
                   const ErrorCode code = reply.error().code;
                   if (code == ErrorCode::timeout || code == ErrorCode::cancelled) {
                     // The board may have heard the request: its end has to be asked for, too.
                     const std::lock_guard lock(mutex_);
                     streams_[stream].is_running = true;
                   }
                   hold->reset();
                   return done(std::move(reply).error());
                 }
                 {
                   const std::lock_guard lock(mutex_);
                   streams_[stream].is_running = true;
                 }
                 done(Subscription(std::move(*hold)));
               });
}

void Conversation::State::leave_stream(const StreamKey& key) {
  std::vector<std::uint8_t> end;
  {
    const std::lock_guard lock(mutex_);
    const auto place = streams_.find(key);
    if (place == streams_.end() || --place->second.subscriptions != 0) return;
    if (phase_ == Phase::closed) return;  // shut() ends it
    if (!place->second.is_running || phase_ == Phase::lost) {
      streams_.erase(place);
      return;
    }
    end = place->second.end;
  }
  start(end, {}, [this, key](const Result<Reply>&) {
    const std::lock_guard lock(mutex_);
    if (phase_ == Phase::closed) return;
    const auto place = streams_.find(key);
    if (place != streams_.end() && place->second.subscriptions == 0) streams_.erase(place);
  });
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

// On the strand

void Conversation::State::advance() {
  if (!transport_ || is_shut_) return;
  if (detector_) return advance_detection();
  Instant next = Instant::never;
  do {
    has_room_ = false;
    hand_over();
    const Instant at = io::now();
    end_overdue(at);
    // While a write is under way no other can begin, so nothing is to be had from the session.
    if (is_writing_) break;
    const Output output = session_.poll(at, [this](const Event& event) { handle_event(event); });
    next = output.deadline;
    if (!output.bytes.empty()) write(output.bytes);
  } while (has_room_);
  const std::lock_guard lock(mutex_);
  statistics_.session = session_.statistics();
  statistics_.streams = session_.stream_usage();
  if (!deadlines_.empty()) next = earlier(next, deadlines_.begin()->first);
  arm(next);
}

void Conversation::State::detect(const std::function<void(Detection)>& done) {
  bool is_open = false;
  {
    const std::lock_guard lock(mutex_);
    is_open = phase_ == Phase::open;
    if (is_open) detected_ = done;
  }
  if (!is_open) return done({});
  post([this] {
    if (!transport_ || is_shut_ || transport_->line() == nullptr) return report({});
    detector_.emplace();
    advance();
  });
}

void Conversation::State::stop_detecting() {
  post([this] {
    if (detector_) end_detection(false);
  });
}

void Conversation::State::advance_detection() {
  while (!is_writing_) {
    const DetectorStep step = detector_->next(io::now());
    switch (step.kind) {
      case DetectorStep::Kind::set_line:
        if (transport_->line()->set(step.line)) detector_->refuse();
        break;
      case DetectorStep::Kind::write: write(step.bytes); break;
      case DetectorStep::Kind::wait: return arm(step.until);
      case DetectorStep::Kind::found: session_.set_line(step.line); return end_detection(true);
      case DetectorStep::Kind::failed: return end_detection(false);
    }
  }
}

void Conversation::State::end_detection(bool found) {
  Detection detection{found, {}};
  std::copy(detector_->trials().begin(), detector_->trials().end(), detection.trials.begin());
  detector_.reset();
  {
    const std::lock_guard lock(mutex_);
    description_ = transport_->description();
  }
  report(detection);
}

void Conversation::State::report(const Detection& detection) {
  std::function<void(Detection)> detected;
  {
    const std::lock_guard lock(mutex_);
    detected = std::exchange(detected_, nullptr);
  }
  if (detected) detected(detection);  // else the conversation has been closed
}

void Conversation::State::hand_over() {
  while (in_session_.size() < capacity.requests) {
    CallPointer call;
    {
      const std::lock_guard lock(mutex_);
      while (!waiting_.empty() && !calls_.contains(waiting_.front()->ticket)) waiting_.pop_front();
      if (waiting_.empty()) return;
      call = std::move(waiting_.front());
      waiting_.pop_front();
    }
    const Request& request = call->request;
    const SendResult sent = session_.send(request.id, request.body, request.exchange, call->send);
    if (sent) {
      call->handle = sent.handle;
      in_session_.emplace(sent.handle.number, call);
      if (request.exchange.stream.command != 0) learn_from_request(request, contexts_);
    } else if (take(call->ticket)) {
      complete(*call, ClientError{ErrorCode::overload, refusal_text(request, sent)});
    }
  }
}

std::string Conversation::State::refusal_text(const Request& request,
                                              const SendResult& refused) const {
  const std::string command = request.info->command;
  switch (refused.status) {
    case SendStatus::over_budget: {
      const StreamUsage usage = session_.stream_usage();
      return command +
             ": the data stream does not fit through the line: " + std::to_string(usage.limit) +
             " bytes/s are for streams, " + std::to_string(usage.used) + " of them are taken";
    }
    case SendStatus::too_many_streams:
      return command + ": the board can not have another data stream";
    case SendStatus::not_encodable: return command + ": " + status_text(refused.encoding);
    default: return command + ": too many requests at once";
  }
}

/// Takes a call that has ended out of the session.
void Conversation::State::forget(const Call& call) {
  if (in_session_.erase(call.handle.number) == 0) return;
  session_.cancel(call.handle, [](const Event&) {});
}

void Conversation::State::end_overdue(Instant at) {
  for (;;) {
    Ticket ticket{};
    {
      const std::lock_guard lock(mutex_);
      if (deadlines_.empty() || at < deadlines_.begin()->first) return;
      ticket = deadlines_.begin()->second;
    }
    const CallPointer call = take(ticket);
    if (!call) return;
    const bool was_sent = static_cast<bool>(call->handle);
    forget(*call);
    complete(*call, overdue(*call, was_sent));
  }
}

ClientError Conversation::State::overdue(const Call& call, bool was_sent) {
  const std::string within = " within " + milliseconds_text(call.allowed);
  const std::string command = call.request.info->command;
  return {ErrorCode::timeout,
          was_sent ? "no answer to " + command + within : command + " could not be sent" + within};
}

void Conversation::State::arm(Instant at) {
  if (at == Instant::never) {
    timer_->cancel();
    return;
  }
  timer_->expires_at(io::to_chrono(at));
  timer_->async_wait([self = shared_from_this()](const std::error_code& error) {
    if (!error) self->advance();
  });
}

void Conversation::State::read() {
  is_reading_ = true;
  transport_->async_read(
      in_, [self = shared_from_this()](const std::error_code& error, std::size_t size) {
        self->is_reading_ = false;
        if (error) return self->lose(error);
        if (self->is_shut_) return self->release();
        self->take_bytes(std::span(self->in_).first(size));
        self->read();
        self->advance();
      });
}

void Conversation::State::take_bytes(std::span<const std::uint8_t> bytes) {
  if (detector_) return detector_->feed(bytes);
  session_.feed(bytes, io::now(), [this](const Event& event) { handle_event(event); });
}

void Conversation::State::write(std::span<const std::uint8_t> bytes) {
  std::copy(bytes.begin(), bytes.end(), out_.begin());
  is_writing_ = true;
  transport_->async_write(std::span(out_).first(bytes.size()),
                          [self = shared_from_this()](const std::error_code& error, std::size_t) {
                            self->is_writing_ = false;
                            if (error) return self->lose(error);
                            self->session_.written(io::now());
                            if (self->is_shut_) return self->say_farewell();
                            self->advance();
                          });
}

void Conversation::State::handle_event(const Event& event) {
  switch (event.kind) {
    case EventKind::completed:
      // Confirmations and resets have an event of their own.
      if (!roles::is_confirmation(event.frame) && !roles::is_reset(event.frame)) {
        deliver(event.frame);
      }
      return handle_completion(event);
    case EventKind::confirmation: {
      deliver(event.frame);
      const auto place = in_session_.find(event.handle.number);
      if (place == in_session_.end()) return;
      const CallPointer call = place->second;
      if (call->on_confirmation) call->on_confirmation(event.confirmation);
      return;
    }
    case EventKind::board_error: {
      deliver(event.frame);
      const std::string about =
          event.command != 0 ? " about " + command_name(event.command) : std::string();
      return notify(
          {NoticeKind::board_error,
           "the board reports an error" + about + ": " + describe(event.frame.id, event.frame.body),
           error_code_in(event.frame.id, event.frame.body)});
    }
    case EventKind::reset:
      deliver(event.frame);
      return notify({NoticeKind::board_reset, "the board is restarting", 0});
    case EventKind::stream:
    case EventKind::unsolicited: return deliver(event.frame);
  }
}

void Conversation::State::handle_completion(const Event& event) {
  has_room_ = true;
  const auto place = in_session_.find(event.handle.number);
  if (place == in_session_.end()) return;
  const CallPointer call = std::move(place->second);
  in_session_.erase(place);
  if (take(call->ticket)) complete(*call, result_of(*call, event));
}

Result<Reply> Conversation::State::result_of(const Call& call, const Event& event) const {
  const std::string command = call.request.info->command;
  const Frame& frame = event.frame;
  const auto reply = [&](Ending ending) {
    Reply result{ending, frame.id, {}, nullptr};
    for (const std::uint8_t byte : frame.body) result.body.push_back(byte);
    if (needs_context(frame.id, frame.body)) {
      const auto contexts = std::make_shared<Contexts>(contexts_);
      learn_from_request(call.request, *contexts);
      result.contexts = contexts;
    }
    return result;
  };
  const auto refused = [&](const char* how) {
    return ClientError{ErrorCode::board_error, command + how + describe(frame.id, frame.body),
                       error_code_in(frame.id, frame.body)};
  };
  switch (event.outcome) {
    case Outcome::answered: return reply(Ending::answered);
    case Outcome::confirmed: return reply(Ending::confirmed);
    case Outcome::unconfirmed: return reply(Ending::unconfirmed);
    case Outcome::sent: return reply(Ending::sent);
    case Outcome::failed: return refused(" has failed: ");
    case Outcome::board_error: return refused(" was refused by the board: ");
    case Outcome::timeout: {
      const unsigned attempts = call.send.attempts;
      std::string text = "no answer to " + command;
      if (attempts > 1) text += ", sent " + std::to_string(attempts) + " times,";
      return ClientError{
          ErrorCode::timeout,
          text + " within " + milliseconds_text(call.send.timeout) + (attempts > 1 ? " each" : "")};
    }
    case Outcome::reset:
      return ClientError{ErrorCode::board_reset,
                         "the board restarted before " + command + " was done"};
    case Outcome::link_lost: return ClientError{ErrorCode::link_lost, command + ": " + loss_};
    case Outcome::cancelled:
    case Outcome::none: break;
  }
  return ClientError{ErrorCode::cancelled, command + " was cancelled"};
}

void Conversation::State::deliver(const Frame& frame) {
  if (frame.id == 0) return;
  learn_from_board(frame.id, frame.body, contexts_);
  const auto key = key_of_received(frame.id, frame.body);
  if (!key) return;
  const Received received{frame.id, frame.body, &contexts_};
  std::uint64_t unreadable = 0;
  messages_->for_each(*key, [&](const MessageHandler& handler) {
    if (!handler(received)) ++unreadable;
  });
  if (unreadable == 0) return;
  const std::lock_guard lock(mutex_);
  statistics_.unreadable += unreadable;
}

void Conversation::State::notify(const Notice& notice) {
  notices_->for_each({}, [&](const auto& handler) { handler(notice); });
}

void Conversation::State::lose(const std::error_code& reason) {
  bool is_news = false;
  std::vector<CallPointer> ended;
  {
    const std::lock_guard lock(mutex_);
    is_news = phase_ == Phase::open;
    if (is_news) {
      phase_ = Phase::lost;
      loss_ = "the connection is lost: " + description_ + ": " + without_stop(reason.message());
      waiting_.clear();
      deadlines_.clear();
      for (auto& [ticket, call] : calls_) ended.push_back(std::move(call));
      calls_.clear();
    }
  }
  for (const CallPointer& call : ended) {
    complete(*call, ClientError{ErrorCode::link_lost,
                                std::string(call->request.info->command) + ": " + loss_});
  }
  shut();
  hang_up();
  if (is_news) notify({NoticeKind::link_lost, loss_, 0});
}

/// Begins to end all that Asio does for this conversation.
void Conversation::State::shut() {
  if (std::exchange(is_shut_, true)) return;
  if (detector_) end_detection(false);
  in_session_.clear();
  if (!transport_) return hang_up();
  {
    const std::lock_guard lock(mutex_);
    for (auto& [key, stream] : streams_) {
      if (stream.is_running && phase_ == Phase::closed) farewell_.push_back(stream.end);
    }
  }
  // A line on which nothing can be written is not waited for.
  timer_->expires_after(longest_farewell);
  timer_->async_wait([self = shared_from_this()](const std::error_code& error) {
    if (!error) self->hang_up();
  });
  say_farewell();
}

/// Ends the data streams that are still running, then hangs up.
void Conversation::State::say_farewell() {
  if (is_writing_ || is_hung_up_) return release();
  if (farewell_.empty()) return hang_up();
  const std::vector<std::uint8_t> frame = std::move(farewell_.back());
  farewell_.pop_back();
  write(frame);
}

void Conversation::State::hang_up() {
  if (!std::exchange(is_hung_up_, true)) {
    if (timer_) timer_->cancel();
    if (transport_) transport_->close();
  }
  release();
}

/// Gives up Asio's objects as soon as nothing is under way.
void Conversation::State::release() {
  if (!is_hung_up_ || is_reading_ || is_writing_) return;
  timer_.reset();
  const std::lock_guard lock(mutex_);
  if (!strand_) return;
  // Not from inside one of its own handlers.
  asio::post(*strand_, [transport = std::move(transport_)]() mutable { transport.reset(); });
  strand_.reset();
}

}  // namespace sbgc::detail
