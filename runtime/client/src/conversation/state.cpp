#include "state.hpp"

#include <algorithm>
#include <utility>

#include <sbgc/internal/words.hpp>
#include <sbgc/io/clock.hpp>

namespace sbgc::detail {

namespace {

/// The strand is only busy for longer if a handler blocks it.
constexpr Duration longest_handler = milliseconds(100);

ClientError stuck_error() { return {ErrorCode::timeout, "a handler blocks the client"}; }
ClientError closed_error() { return {ErrorCode::cancelled, "the client was closed"}; }
ClientError loss_error(const Call& call, const std::string& loss) {
  return {ErrorCode::link_lost, std::string(call.request.command) + ": " + loss};
}

std::vector<std::uint8_t> frame_of(const Request& request, Framing framing) {
  std::vector<std::uint8_t> frame(max_frame_size);
  frame.resize(write_frame(framing, request.id, request.body, frame).size);
  return frame;
}

}  // namespace

class Conversation::State::Busy {
 public:
  explicit Busy(State& state) : since_(state.busy_since_us_) { since_ = io::now().us; }
  Busy(const Busy&) = delete;
  Busy& operator=(const Busy&) = delete;
  ~Busy() { since_ = Instant::never.us; }

 private:
  std::atomic<std::int64_t>& since_;
};

Conversation::State::State(Strand strand, const ConnectOptions& options)
    : options_(options),
      clock_(strand),
      calls_(options.queue_limit, make_mutex()),
      question_(opening_frame(options.password)),
      detector_(make_mutex(), DetectorOptions{.question = question_}),
      dialogue_(options, calls_, delivery_),
      channel_(std::move(strand)) {}

void Conversation::State::attach(std::unique_ptr<io::Transport> transport) {
  {
    const std::lock_guard lock(mutex_);
    description_ = transport->description();
  }
  may_repeat_ = transport->may_repeat() || options_.duplicate_window.count() != 0;
  // Shared, because Asio requires a copyable function.
  post([this, shared = std::make_shared<std::unique_ptr<io::Transport>>(std::move(transport))] {
    if (const io::LineControl* const line = (*shared)->line()) {
      dialogue_.set_line(line->current());
    }
    channel_.open(std::move(*shared), shared_from_this());
    if (!is_open()) return begin_close();
    advance();
  });
}

void Conversation::State::post(std::function<void()> function) {
  channel_.post(shared_from_this(), std::move(function));
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

// Calls and subscriptions.

Instant Conversation::State::start(CallId id, Result<Request> request, const CallOptions& options,
                                   ReplyHandler handler, TaskNumber task) {
  calls_->count_begun();
  if (!request) {
    calls_->count_failed();
    handler(std::move(request).error());
    return Instant::never;
  }
  const CallPointer call =
      make_call(id, *std::move(request), options, options_, clock_.now(), std::move(handler));
  call->task = task;
  if (auto refusal = calls_.begin(call)) {
    calls_.complete(*call, *std::move(refusal));
    return Instant::never;
  }
  wake();
  return call->deadline;
}

void Conversation::State::end(CallId id, ClientError error) {
  if (const CallPointer call = calls_->take(id)) complete(call, std::move(error));
}

void Conversation::State::end_overdue(Instant at) {
  while (const CallPointer call = calls_->take_overdue(at)) {
    complete(call, is_stuck() ? Result<Reply>(stuck_error()) : overdue_result(*call));
  }
}

/// Completes a call that was removed from the pending ones.
void Conversation::State::complete(const CallPointer& call, Result<Reply> result) {
  post([this, call] {
    dialogue_.forget(*call);
    advance();
  });
  calls_.complete(*call, std::move(result));
}

bool Conversation::State::is_stuck() const {
  const Instant since{busy_since_us_.load()};
  return since != Instant::never && io::now() - since > longest_handler;
}

/// Keeps a data stream running as long as it lives.
class Conversation::State::StreamHold : public Subscription::Registration {
 public:
  StreamHold(std::unique_ptr<Registration> membership, std::weak_ptr<State> state,
             StreamListeners::Key key, StreamListeners::Listener listener)
      : membership_(std::move(membership)),
        state_(std::move(state)),
        key_(std::move(key)),
        listener_(listener) {}
  StreamHold(const StreamHold&) = delete;
  StreamHold& operator=(const StreamHold&) = delete;
  ~StreamHold() override {
    membership_.reset();
    if (const auto state = state_.lock()) state->leave_stream(key_, listener_);
  }

 private:
  std::unique_ptr<Registration> membership_;
  std::weak_ptr<State> state_;
  StreamListeners::Key key_;
  StreamListeners::Listener listener_;
};

Instant Conversation::State::start_stream(CallId id, StreamRequests requests, MessageKey key,
                                          MessageHandler handler, const CallOptions& options,
                                          StreamHandler done) {
  Result<Request>& start = requests.start;
  if (start && requests.polling) {
    return start_polling(id, std::move(requests), key, std::move(handler), options,
                         std::move(done));
  }
  if (start && !start->policy.changes_stream()) {
    start = ClientError{ErrorCode::invalid,
                        std::string(start->command) + " does not start a data stream"};
  }
  if (start && !requests.end) start = requests.end.error();
  if (!start) {
    done(std::move(start).error());
    return Instant::never;
  }
  const StreamListeners::Key stream = StreamListeners::key_of(*start);
  const auto listener = streams_->join(stream, *start, *std::move(requests.end));
  auto paced = [this, stream, listener, handler = std::move(handler)](const void* sample) {
    if (streams_->is_due(stream, listener)) handler(sample);
  };
  // Subscribe before the first sample can arrive.
  auto hold = std::make_unique<StreamHold>(delivery_.subscribe(key, std::move(paced)),
                                           weak_from_this(), stream, listener);
  Request fastest = streams_->fastest(stream);
  const std::uint32_t interval = fastest.policy.stream.interval_us;
  return this->start(id, std::move(fastest), options,
                     [this, stream, interval,
                      hold = std::make_shared<std::unique_ptr<StreamHold>>(std::move(hold)),
                      done = std::move(done)](Result<Reply> reply) {
                       const bool is_unheard = !reply && reply.error().code != ErrorCode::timeout &&
                                               reply.error().code != ErrorCode::cancelled;
                       // The board may have received the request, so the stream must be ended as
                       // well.
                       if (!is_unheard) set_running(stream, interval, static_cast<bool>(reply));
                       if (reply) return done(Subscription(std::move(*hold)));
                       hold->reset();
                       done(std::move(reply).error());
                     });
}

/// Keeps repeating a request as long as it lives.
class Conversation::State::PollHold : public Subscription::Registration {
 public:
  PollHold(std::unique_ptr<Registration> membership, std::weak_ptr<State> state, std::uint8_t id,
           Duration interval)
      : membership_(std::move(membership)),
        state_(std::move(state)),
        id_(id),
        interval_(interval) {}
  PollHold(const PollHold&) = delete;
  PollHold& operator=(const PollHold&) = delete;
  ~PollHold() override {
    membership_.reset();
    if (const auto state = state_.lock()) state->polls_->leave(id_, interval_);
  }

 private:
  std::unique_ptr<Registration> membership_;
  std::weak_ptr<State> state_;
  std::uint8_t id_;
  Duration interval_;
};

Instant Conversation::State::start_polling(CallId id, StreamRequests requests, MessageKey key,
                                           MessageHandler handler, const CallOptions& options,
                                           StreamHandler done) {
  Request request = *std::move(requests.start);
  // A stream's interval of 0 would end it; polling takes at least the time of an answer.
  const Duration interval = std::max(Duration{requests.polling->interval.count()}, milliseconds(1));
  polls_->join(request, options, interval, io::now());
  auto hold = std::make_unique<PollHold>(delivery_.subscribe(key, std::move(handler)),
                                         weak_from_this(), request.id, interval);
  post([this, text = std::string(request.command) +
                     " is repeated instead of a data stream: " + requests.polling->reason] {
    delivery_.notify({NoticeKind::polling, text});
  });
  return this->start(id, std::move(request), options,
                     [hold = std::make_shared<std::unique_ptr<PollHold>>(std::move(hold)),
                      done = std::move(done)](Result<Reply> reply) {
                       if (reply) return done(Subscription(std::move(*hold)));
                       hold->reset();
                       done(std::move(reply).error());
                     });
}

/// Records the board's interval, and requests another one if the listeners have changed.
void Conversation::State::set_running(const StreamListeners::Key& key, std::uint32_t interval,
                                      bool may_change) {
  const std::optional<Request> wanted = streams_->set_running(key, interval);
  if (wanted && may_change) change_stream(key, *wanted);
}

void Conversation::State::change_stream(const StreamListeners::Key& key, Request request) {
  const std::uint32_t interval = request.policy.stream.interval_us;
  start(next_call_id(), std::move(request), {}, [this, key, interval](const Result<Reply>& reply) {
    // A conversation that has ended also ends its streams.
    const bool is_over = !reply && (reply.error().code == ErrorCode::cancelled ||
                                    reply.error().code == ErrorCode::not_connected);
    if (is_over) return;
    if (interval == 0) return streams_->end_sent(key);
    if (reply) set_running(key, interval, true);
  });
}

void Conversation::State::leave_stream(const StreamListeners::Key& key,
                                       StreamListeners::Listener listener) {
  if (std::optional<Request> change = streams_->leave(key, listener)) {
    change_stream(key, *std::move(change));
  }
}

// On the strand.

/// Repeats the requests that are due.
void Conversation::State::poll() {
  for (const Polls::Poll& due : polls_->take_due(io::now())) {
    start(next_call_id(), due.request, due.options, [this, id = due.request.id](const auto&) {
      polls_->end_pending(id);
      wake();
    });
  }
}

void Conversation::State::advance() {
  if (!channel_.is_open()) return;
  if (is_searching_) return search();
  poll();
  const Busy busy(*this);
  const Output output = dialogue_.advance(clock_.now(), channel_.can_write());
  if (!output.bytes.empty()) channel_.write(output.bytes);
  {
    const std::lock_guard lock(mutex_);
    statistics_.session = dialogue_.statistics();
    statistics_.streams = dialogue_.stream_usage();
  }
  channel_.wake_at(std::min(output.deadline, polls_->next()));
}

void Conversation::State::received(std::span<const std::uint8_t> bytes) {
  if (is_searching_) return detector_->feed(bytes);
  const Busy busy(*this);
  dialogue_.feed(bytes, clock_.now());
}

void Conversation::State::written() {
  dialogue_.written(clock_.now());
  advance();
}

// The search for the line.

void Conversation::State::detect_line(std::function<void(bool is_found)> done) {
  {
    const std::lock_guard lock(mutex_);
    on_search_end_ = std::move(done);
  }
  if (!is_open()) return report_search(false);
  post([this] {
    if (!channel_.is_open() || channel_.transport().line() == nullptr) return report_search(false);
    is_searching_ = true;
    advance();
  });
}

auto Conversation::State::trials() const -> Trials {
  Trials trials;
  const auto detector = detector_.lock();
  std::ranges::copy(detector->trials(), trials.begin());
  return trials;
}

void Conversation::State::search() {
  while (channel_.can_write()) {
    const DetectorStep step = detector_->next(clock_.now());
    switch (step.kind) {
      case DetectorStep::Kind::set_line:
        if (channel_.transport().line()->set(step.line)) detector_->refuse();
        break;
      case DetectorStep::Kind::write: channel_.write(step.bytes); break;
      case DetectorStep::Kind::wait: return channel_.wake_at(step.until);
      case DetectorStep::Kind::found: dialogue_.set_line(step.line); return end_search(true);
      case DetectorStep::Kind::failed: return end_search(false);
    }
  }
}

void Conversation::State::end_search(bool is_found) {
  is_searching_ = false;
  {
    const std::lock_guard lock(mutex_);
    description_ = channel_.transport().description();
  }
  report_search(is_found);
}

void Conversation::State::report_search(bool is_found) {
  std::function<void(bool)> done;
  {
    const std::lock_guard lock(mutex_);
    done = std::exchange(on_search_end_, nullptr);
  }
  if (done) done(is_found);
}

// The end.

bool Conversation::State::is_open() const {
  const std::lock_guard lock(mutex_);
  return phase_ == Phase::open;
}

void Conversation::State::line_failed(const std::error_code& reason) {
  std::string loss;
  {
    const std::lock_guard lock(mutex_);
    if (phase_ == Phase::open) {
      phase_ = Phase::lost;
      loss_ = "the connection is lost: " + description_ + ": " + without_period(reason.message());
      loss = loss_;
    }
  }
  if (!loss.empty()) {
    for (const CallPointer& call : calls_->take_all({ErrorCode::not_connected, loss})) {
      calls_.complete(*call, loss_error(*call, loss));
    }
  }
  begin_close();
  channel_.close_now();
  if (!loss.empty()) delivery_.notify({NoticeKind::link_lost, loss});
}

void Conversation::State::close(std::string loss) {
  {
    const std::lock_guard lock(mutex_);
    if (phase_ == Phase::closed) return;
    // A client that connects again closes a lost conversation, whose tasks may still run.
    if (phase_ == Phase::lost) loss = loss_;
    phase_ = Phase::closed;
  }
  const auto ended =
      calls_->take_all({ErrorCode::not_connected, loss.empty() ? "the client is closed" : loss});
  // Also report here: the caller may be the thread that runs the strand.
  report_search(false);
  for (const CallPointer& call : ended) {
    calls_.complete(*call, loss.empty() ? closed_error() : loss_error(*call, loss));
  }
  post([this] { begin_close(); });
}

void Conversation::State::abandon() {
  {
    const std::lock_guard lock(mutex_);
    is_abandoned_ = true;
  }
  close();
}

/// Begins to end all Asio operations of this conversation.
void Conversation::State::begin_close() {
  if (is_searching_) end_search(false);
  dialogue_.forget_all();
  const auto [is_closed, is_abandoned] = [&] {
    const std::lock_guard lock(mutex_);
    return std::pair(phase_ == Phase::closed, is_abandoned_);
  }();
  if (is_abandoned && channel_.is_open()) {
    // When a serial port is closed, the system waits for unsent data, up to 30 s.
    if (io::LineControl* const line = channel_.transport().line()) line->flush();
  }
  std::vector<Channel::Frame> last_frames;
  if (is_closed && !is_abandoned) {
    for (const Request& end : streams_->take_running()) {
      last_frames.push_back(frame_of(end, dialogue_.framing()));
    }
  }
  channel_.close(std::move(last_frames));
}

std::string Conversation::State::description() const {
  const std::lock_guard lock(mutex_);
  return description_;
}

ClientStatistics Conversation::State::statistics() const {
  ClientStatistics result;
  {
    const std::lock_guard lock(mutex_);
    result = statistics_;
  }
  result.calls = calls_->begun();
  result.failures = calls_->failed();
  result.unreadable = delivery_.unreadable();
  return result;
}

std::optional<ClientError> Conversation::State::end_reason() const {
  const std::lock_guard lock(mutex_);
  if (phase_ == Phase::open) return std::nullopt;
  if (phase_ == Phase::lost) return ClientError{ErrorCode::link_lost, loss_};
  return closed_error();
}

}  // namespace sbgc::detail
