#include "reconnecting/reconnection.hpp"

#include <algorithm>
#include <utility>

#include <asio/error.hpp>
#include <asio/execution/outstanding_work.hpp>
#include <asio/post.hpp>
#include <asio/prefer.hpp>

#include "conversation/state.hpp"

namespace sbgc::detail {

namespace {

template <class T>
std::function<void(const void*)> untyped(std::function<void(const T&)> handler) {
  return
      [handler = std::move(handler)](const void* item) { handler(*static_cast<const T*>(item)); };
}

}  // namespace

/// Keeps a handler registered as long as it lives.
class Reconnection::Hold : public Subscription::Registration {
 public:
  Hold(std::weak_ptr<Reconnection> reconnection, Kept kept)
      : reconnection_(std::move(reconnection)), kept_(std::move(kept)) {}
  Hold(const Hold&) = delete;
  Hold& operator=(const Hold&) = delete;
  ~Hold() override {
    kept_->membership.reset();  // from now on the handler does not run
    if (const auto reconnection = reconnection_.lock()) reconnection->drop(kept_);
  }

 private:
  std::weak_ptr<Reconnection> reconnection_;
  Kept kept_;
};

/// A call of an asynchronous client.
struct Reconnection::PendingCall {
  PendingCall(Prepare prepares, CallOptions with, Time last, Completion<Result<Reply>> completes)
      : prepare(std::move(prepares)),
        options(std::move(with)),
        deadline(last),
        done(std::move(completes)) {}

  Prepare prepare;
  CallOptions options;
  Time deadline;
  Completion<Result<Reply>> done;
  CurrentStop stop{};
};

Reconnection::Reconnection(std::string address, TransportFactory make, ReconnectOptions options,
                           asio::any_io_executor executor)
    : options_(std::move(options)),
      address_(std::move(address)),
      make_(std::move(make)),
      executor_(std::move(executor)),
      adapter_(address_, options_.list_ports) {
  if (executor_) strand_.emplace(executor_);
}

Result<void> Reconnection::start() {
  if (auto connected = connect_first(); !connected) return connected;
  thread_ = std::thread([self = shared_from_this()] { self->run(); });
  return {};
}

void Reconnection::start(std::shared_ptr<Link> previous, const Completion<Result<void>>& done) {
  auto connect_and_run = [self = shared_from_this(), previous = std::move(previous),
                          done = Completion<Result<void>>(done)]() mutable {
    previous.reset();
    Result<void> connected = self->connect_first();
    const bool is_connected = bool(connected);
    done(std::move(connected));
    if (is_connected) self->run();
  };
  // The functions posted by the thread, the closing of a line, and the end of the last owner need
  // the context, whose work guard therefore ends last.
  auto work = asio::prefer(executor_, asio::execution::outstanding_work_t::tracked);
  thread_ = std::thread([work = std::move(work), act = std::move(connect_and_run)]() mutable {
    const auto working = std::move(work);
    auto acting = std::move(act);
    acting();
  });
}

/// Makes the first connection, without a search.
Result<void> Reconnection::connect_first() {
  auto client = dial();
  if (client) adapter_.remember();
  Lock lock(mutex_);
  if (!client || is_closing_) {
    if (!is_closing_) {
      problem_ = client.error().message;
      state_ = LinkState::given_up;
    }
    announce_change();
    if (!client) return std::move(client).error();
    return ClientError{ErrorCode::cancelled, "the client was closed"};
  }
  adopt(lock, *std::move(client));
  state_ = LinkState::connected;
  announce_change();
  return {};
}

void Reconnection::close() noexcept {
  Pointer client;
  Conversation dialling;
  {
    const std::lock_guard lock(mutex_);
    is_closing_ = true;
    state_ = LinkState::closed;
    client = client_;
    dialling = dialling_;
    announce_change();
  }
  dialling.close();
  if (client) client->close();
  tasks_.cancel_all();
}

void Reconnection::finish() noexcept {
  close();
  if (!thread_.joinable()) return;
  const bool is_blocked = [this] {
    const std::lock_guard lock(mutex_);
    return is_opening_;
  }();
  // A handler cannot wait for the thread that may wait for it, and opening cannot be interrupted.
  if (is_blocked || turn_->runs_in_this_thread()) return thread_.detach();
  thread_.join();
}

/// Wakes everyone who waits for a change; requires the lock.
void Reconnection::announce_change() {
  changed_.notify_all();
  std::erase_if(awaited_, [](const auto& weak) {
    const auto awaited = weak.lock();
    if (awaited) awaited->look_again();
    return !awaited;
  });
}

// Calls.

Reconnection::Time Reconnection::call_deadline(const CallOptions& options) const {
  return Clock::TimePoint::clock::now() +
         options.timeout.value_or(options_.connection.queue_timeout);
}

CallOptions Reconnection::with_time_left(CallOptions options, Time deadline) {
  if (options.timeout) {
    const auto left = std::chrono::ceil<std::chrono::milliseconds>(deadline - Time::clock::now());
    options.timeout = std::clamp(left, std::chrono::milliseconds(0), *options.timeout);
  }
  return options;
}

ClientError Reconnection::no_connection() const {
  if (state_ == LinkState::closed) return {ErrorCode::not_connected, "the client is closed"};
  std::string text = "no connection to the board";
  if (!problem_.empty()) text += ": " + problem_;
  return {ErrorCode::not_connected, text};
}

/// Returns the client of the current connection, or the reason why there will be none; nothing if
/// an operation should wait. Requires the lock.
std::optional<Result<Reconnection::Pointer>> Reconnection::decision() const {
  if (client_ && !loss_ && !is_closing_) return client_;
  const bool is_final = is_closing_ || state_ == LinkState::given_up;
  if (is_final || options_.calls == OutagePolicy::fail) return no_connection();
  return std::nullopt;
}

Result<Reconnection::Pointer> Reconnection::connected() {
  const std::lock_guard lock(mutex_);
  if (client_ && !loss_ && !is_closing_) return client_;
  return no_connection();
}

Result<Reconnection::Pointer> Reconnection::wait_for_client(Time deadline) {
  if (turn_->runs_in_this_thread()) return handler_waits_error();
  Lock lock(mutex_);
  std::optional<Result<Pointer>> decided;
  changed_.wait_until(lock, deadline, [&] { return (decided = decision()).has_value(); });
  return decided ? *std::move(decided) : no_connection();
}

/// Like wait_for_client(), but without a waiting thread. `stop` ends the wait.
void Reconnection::await_client(Time deadline, CurrentStop& stop, const AwaitedClient::Use& use) {
  Lock lock(mutex_);
  if (auto decided = decision()) {
    lock.unlock();
    return use(*std::move(decided));
  }
  const auto look = [self = shared_from_this()] {
    const std::lock_guard again(self->mutex_);
    return self->decision();
  };
  const auto too_late = [self = shared_from_this()] {
    const std::lock_guard again(self->mutex_);
    return self->no_connection();
  };
  const auto awaited = std::make_shared<AwaitedClient>(*strand_, look, too_late, use);
  awaited_.push_back(awaited);
  lock.unlock();
  stop.set([weak = std::weak_ptr(awaited)] {
    if (const auto waiting = weak.lock()) waiting->cancel();
  });
  const auto left = std::chrono::ceil<std::chrono::microseconds>(deadline - Time::clock::now());
  awaited->start(Duration{std::max<std::int64_t>(left.count(), 0)});
}

/// True if the line was lost before the request could be sent, so that it may be sent over the next
/// one.
bool Reconnection::may_begin_again(const Result<Reply>& reply, const Pointer& client,
                                   Time deadline) {
  if (reply || reply.error().code != ErrorCode::not_connected) return false;
  if (options_.calls == OutagePolicy::fail || Time::clock::now() >= deadline) return false;
  // The connecting thread may not know of the loss yet.
  const std::lock_guard lock(mutex_);
  if (client_ == client && !loss_) {
    loss_ = reply.error().message;
    announce_change();
  }
  return true;
}

Result<Reply> Reconnection::call(const Prepare& prepare, const CallOptions& options) {
  const Time deadline = call_deadline(options);
  while (true) {
    const Result<Pointer> client = wait_for_client(deadline);
    if (!client) return client.error();
    Result<Reply> reply = (*client)->call(prepare, with_time_left(options, deadline));
    if (!may_begin_again(reply, *client, deadline)) return reply;
  }
}

Stop Reconnection::start(const Prepare& prepare, const CallOptions& options,
                         const Completion<Result<Reply>>& done) {
  const auto call = std::make_shared<PendingCall>(prepare, options, call_deadline(options), done);
  begin(call);
  return [call] { call->stop.stop(); };
}

void Reconnection::begin(const std::shared_ptr<PendingCall>& call) {
  await_client(call->deadline, call->stop, [self = shared_from_this(), call](const auto& client) {
    if (!client) return call->done(client.error());
    const Conversation& conversation = (*client)->conversation();
    const CallId id = next_call_id();
    call->stop.set([conversation, id] { conversation.cancel(id); });
    conversation.state()->start(id, call->prepare(conversation),
                                with_time_left(call->options, call->deadline),
                                [self, call, used = *client](Result<Reply> reply) {
                                  if (self->may_begin_again(reply, used, call->deadline)) {
                                    return self->begin(call);
                                  }
                                  call->done(std::move(reply));
                                });
    call->stop.check();
  });
}

std::optional<ClientError> Reconnection::run(const BeginTask& begin, Clock& clock) {
  const Result<Pointer> client = wait_for_client(call_deadline({}));
  if (!client) return client.error();
  return (*client)->run(begin, clock);
}

Stop Reconnection::start_task(const BeginTask& begin,
                              const Completion<std::optional<ClientError>>& done) {
  const auto stop = std::make_shared<CurrentStop>();
  await_client(
      call_deadline({}), *stop, [self = shared_from_this(), stop, begin, done](const auto& client) {
        if (!client) return done(client.error());
        stop->set(self->tasks_.run(self->executor_, (*client)->conversation(),
                                   begin((*client)->identity()), [done] { done(std::nullopt); }));
      });
  return [stop] { stop->stop(); };
}

// Handlers.

/// Returns the function that a connection calls with each message for this handler.
auto Reconnection::passer_to(const Kept& kept) -> MessageHandler {
  return [turn = turn_, kept](const void* message) {
    ++kept->messages;
    turn->take([&] {
      KeptHandlers::call(kept->handlers->with_key({}),
                         [&](const auto& handler) { handler(message); });
    });
  };
}

Subscription Reconnection::hold(const Kept& kept) {
  return Subscription(std::make_unique<Hold>(weak_from_this(), kept));
}

void Reconnection::drop(const Kept& kept) noexcept {
  const std::lock_guard lock(mutex_);
  kept_.drop(kept);
  announce_change();
}

/// Registers a handler that needs no request with the current connection.
void Reconnection::register_now(const Kept& kept) {
  auto begun = kept->begin(client_->conversation(), passer_to(kept), {});
  if (begun) kept->current = *std::move(begun);
  kept->connection = connections_;
}

Subscription Reconnection::keep(KeptHandler::Begin begin, MessageHandler handler) {
  const auto kept = std::make_shared<KeptHandler>(std::move(begin), std::move(handler));
  const std::lock_guard lock(mutex_);
  if (client_) register_now(kept);
  kept_.add(kept);
  return hold(kept);
}

Subscription Reconnection::subscribe(MessageKey key, MessageHandler handler) {
  return keep([key](const Conversation& conversation, const MessageHandler& pass_on,
                    const CallOptions&) { return conversation.subscribe(key, pass_on); },
              std::move(handler));
}

Subscription Reconnection::on_frame(std::function<void(const BoardFrame&)> handler) {
  return keep(
      [](const Conversation& conversation, const MessageHandler& pass_on, const CallOptions&) {
        return conversation.on_frame([pass_on](const BoardFrame& frame) { pass_on(&frame); });
      },
      untyped(std::move(handler)));
}

Reconnection::Kept Reconnection::kept_stream(const Stream& stream, const CallOptions& options) {
  auto kept = std::make_shared<KeptHandler>(
      [prepare = stream.prepare, key = stream.key](const Conversation& conversation,
                                                   const MessageHandler& pass_on,
                                                   const CallOptions& with) {
        return conversation.stream(prepare(conversation), key, pass_on, with);
      },
      stream.handler);
  kept->interval = stream.interval;
  kept->options = options;
  return kept;
}

Result<Subscription> Reconnection::keep_begun(const Kept& kept, Result<Subscription> begun,
                                              const Pointer& client) {
  if (!begun) return begun;
  const std::lock_guard lock(mutex_);
  // If the connection was lost meanwhile, the stream is restarted with the next one.
  const std::uint64_t connection = client_ == client ? connections_ : 0;
  kept_.set(kept, *std::move(begun), connection, options_.clock->now());
  kept_.add(kept);
  announce_change();
  return hold(kept);
}

Result<Subscription> Reconnection::stream(const Stream& stream, const CallOptions& options) {
  const Kept kept = kept_stream(stream, options);
  const Time deadline = call_deadline(options);
  const Result<Pointer> client = wait_for_client(deadline);
  if (!client) return client.error();
  auto begun =
      kept->begin((*client)->conversation(), passer_to(kept), with_time_left(options, deadline));
  return keep_begun(kept, std::move(begun), *client);
}

Stop Reconnection::start_stream(const Stream& stream, const CallOptions& options,
                                const Completion<Result<Subscription>>& done) {
  const Kept kept = kept_stream(stream, options);
  const Time deadline = call_deadline(options);
  const auto stop = std::make_shared<CurrentStop>();
  await_client(deadline, *stop, [=, self = shared_from_this()](const auto& client) {
    if (!client) return done(client.error());
    const Conversation& conversation = (*client)->conversation();
    const CallId id = next_call_id();
    stop->set([conversation, id] { conversation.cancel(id); });
    conversation.state()->start_stream(
        id, stream.prepare(conversation), stream.key, self->passer_to(kept),
        with_time_left(options, deadline),
        [self, kept, done, used = *client](Result<Subscription> begun) {
          done(self->keep_begun(kept, std::move(begun), used));
        });
    stop->check();
  });
  return [stop] { stop->stop(); };
}

Subscription Reconnection::on_notice(std::function<void(const Notice&)> handler) {
  return Subscription(notices_->add({}, untyped(std::move(handler))));
}

Subscription Reconnection::on_change(std::function<void(const LinkChange&)> handler) {
  return Subscription(changes_->add({}, untyped(std::move(handler))));
}

void Reconnection::check() {
  const std::lock_guard lock(mutex_);
  if (!client_ || loss_) return;
  is_check_wanted_ = true;
  announce_change();
}

// Facts.

LinkState Reconnection::state() const {
  const std::lock_guard lock(mutex_);
  return state_;
}

std::uint64_t Reconnection::connections() const {
  const std::lock_guard lock(mutex_);
  return connections_;
}

BoardIdentity Reconnection::identity() const {
  const std::lock_guard lock(mutex_);
  return board_;
}

std::string Reconnection::description() const {
  const std::lock_guard lock(mutex_);
  return description_;
}

ClientStatistics Reconnection::statistics() const {
  const std::lock_guard lock(mutex_);
  return client_ ? client_->statistics() : statistics_;
}

// Losing the connection.

void Reconnection::noticed(const Notice& notice, std::uint64_t connection) {
  show(notice);
  // After a restart, the board has no streams, and may have other firmware.
  if (notice.kind == NoticeKind::link_lost) lose(notice.message, connection, false);
  if (notice.kind == NoticeKind::board_reset) lose(notice.message, connection, true);
}

void Reconnection::show(const Notice& notice) {
  turn_->take([&] {
    KeptHandlers::call(notices_->with_key({}), [&](const auto& handler) { handler(&notice); });
  });
}

void Reconnection::lose(const std::string& reason, std::uint64_t connection, bool is_restarting) {
  const std::lock_guard lock(mutex_);
  if (connection != connections_ || loss_) return;
  loss_ = reason;
  is_restarting_ = is_restarting;
  announce_change();
}

/// Calls handlers on the proper thread.
void Reconnection::deliver(std::function<void()> call) {
  if (!strand_) return call();
  asio::post(*strand_, [self = shared_from_this(), call = std::move(call)] { call(); });
}

}  // namespace sbgc::detail
