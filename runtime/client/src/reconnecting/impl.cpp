#include "reconnecting/impl.hpp"

#include <algorithm>
#include <utility>

#include <asio/error.hpp>

#include "conversation/state.hpp"

namespace sbgc {

namespace {

/// A board that announces its restart is not connected to before it has restarted.
constexpr std::chrono::milliseconds restart_time{roles::reset_delay_ms + 500};
/// How often the data streams are looked at.
constexpr std::chrono::milliseconds look_interval{500};
/// How long a silent board has to give a sign of life.
constexpr std::chrono::milliseconds sign_of_life_time{1'000};
/// The pause before a stream that was not confirmed is started once more.
constexpr std::chrono::milliseconds stream_pause{500};

template <class T>
std::function<void(const void*)> untyped(std::function<void(const T&)> handler) {
  return
      [handler = std::move(handler)](const void* item) { handler(*static_cast<const T*>(item)); };
}

}  // namespace

/// Keeps a handler registered as long as it lives.
class ReconnectingClient::Impl::Hold : public Subscription::Registration {
 public:
  Hold(std::weak_ptr<Impl> impl, Kept kept, std::unique_ptr<Registration> membership)
      : impl_(std::move(impl)), kept_(std::move(kept)), membership_(std::move(membership)) {}
  Hold(const Hold&) = delete;
  Hold& operator=(const Hold&) = delete;
  ~Hold() override {
    membership_.reset();  // from now on the handler does not run
    if (const auto impl = impl_.lock()) impl->drop(kept_);
  }

 private:
  std::weak_ptr<Impl> impl_;
  Kept kept_;
  std::unique_ptr<Registration> membership_;
};

ReconnectingClient::Impl::Impl(std::string address, TransportFactory make, ReconnectOptions options)
    : options_(std::move(options)),
      address_(std::move(address)),
      make_(std::move(make)),
      adapter_(address_, options_.list_ports) {}

Result<void> ReconnectingClient::Impl::start() {
  auto client = dial();
  if (!client) return std::move(client).error();
  adapter_.remember();
  {
    Lock lock(mutex_);
    adopt(lock, *std::move(client));
    state_ = LinkState::connected;
  }
  thread_ = std::thread([self = shared_from_this()] { self->run(); });
  return {};
}

void ReconnectingClient::Impl::close() noexcept {
  ClientPointer client;
  detail::Conversation dialling;
  {
    const std::lock_guard lock(mutex_);
    is_closing_ = true;
    state_ = LinkState::closed;
    client = client_;
    dialling = dialling_;
    changed_.notify_all();
  }
  dialling.close();
  if (client) client->close();
}

void ReconnectingClient::Impl::finish() noexcept {
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

// Calls.

ReconnectingClient::Impl::Time ReconnectingClient::Impl::call_deadline(
    const CallOptions& options) const {
  return Clock::TimePoint::clock::now() +
         options.timeout.value_or(options_.connection.queue_timeout);
}

CallOptions ReconnectingClient::Impl::with_time_left(CallOptions options, Time deadline) {
  if (options.timeout) {
    const auto left = std::chrono::ceil<std::chrono::milliseconds>(deadline - Time::clock::now());
    options.timeout = std::clamp(left, std::chrono::milliseconds(0), *options.timeout);
  }
  return options;
}

ClientError ReconnectingClient::Impl::no_connection() const {
  if (state_ == LinkState::closed) return {ErrorCode::not_connected, "the client is closed"};
  std::string text = "no connection to the board";
  if (!problem_.empty()) text += ": " + problem_;
  return {ErrorCode::not_connected, text};
}

Result<ReconnectingClient::Impl::ClientPointer> ReconnectingClient::Impl::wait_for_client(
    Time deadline) {
  if (turn_->runs_in_this_thread()) return detail::handler_waits_error();
  Lock lock(mutex_);
  const auto is_decided = [this] {
    return (client_ && !loss_) || is_closing_ || state_ == LinkState::given_up;
  };
  if (options_.calls == OutagePolicy::wait) changed_.wait_until(lock, deadline, is_decided);
  if (client_ && !loss_ && !is_closing_) return client_;
  return no_connection();
}

Result<ReconnectingClient::Impl::ClientPointer> ReconnectingClient::Impl::current(
    const CallOptions& options) {
  return wait_for_client(call_deadline(options));
}

Result<Reply> ReconnectingClient::Impl::use(
    const CallOptions& options,
    const std::function<Result<Reply>(Client&, const CallOptions&)>& call) {
  const Time deadline = call_deadline(options);
  while (true) {
    const Result<ClientPointer> client = wait_for_client(deadline);
    if (!client) return client.error();
    Result<Reply> reply = call(**client, with_time_left(options, deadline));
    // The line was lost before the request could be sent.
    const bool is_too_late = !reply && reply.error().code == ErrorCode::not_connected;
    if (!is_too_late || options_.calls == OutagePolicy::fail || Time::clock::now() >= deadline) {
      return reply;
    }
    // The thread that connects may not know of the loss yet.
    Lock lock(mutex_);
    changed_.wait_until(lock, deadline, [&] { return client_ != *client || loss_ || is_closing_; });
  }
}

void ReconnectingClient::Impl::start_raw(RawRequest request, const CallOptions& options,
                                         std::function<void(const Result<Reply>&)> handler) {
  ClientPointer client;
  Result<Reply> refusal = ClientError{};
  {
    const std::lock_guard lock(mutex_);
    if (!loss_ && !is_closing_) client = client_;
    if (!client) refusal = no_connection();
  }
  if (!client) return handler(refusal);
  client->start_raw(std::move(request), options, std::move(handler));
}

// Handlers.

/// Returns the function that a connection calls with each message for this handler.
auto ReconnectingClient::Impl::passer_to(const Kept& kept) -> MessageHandler {
  return [turn = turn_, kept](const void* message) {
    ++kept->messages;
    turn->take([&] {
      detail::KeptHandlers::call(kept->handlers->with_key({}),
                                 [&](const auto& handler) { handler(message); });
    });
  };
}

Subscription ReconnectingClient::Impl::hold(
    const Kept& kept, std::unique_ptr<Subscription::Registration> membership) {
  return Subscription(std::make_unique<Hold>(weak_from_this(), kept, std::move(membership)));
}

void ReconnectingClient::Impl::drop(const Kept& kept) noexcept {
  const std::lock_guard lock(mutex_);
  kept_.drop(kept);
  changed_.notify_all();
}

/// Registers a handler that needs no request with the current connection.
void ReconnectingClient::Impl::subscribe(const Kept& kept) {
  if (auto begun = kept->begin(*client_, passer_to(kept), {})) kept->current = *std::move(begun);
  kept->connection = connections_;
}

Subscription ReconnectingClient::Impl::keep(Begin begin, MessageHandler handler) {
  const auto kept = std::make_shared<detail::KeptHandler>();
  kept->begin = std::move(begin);
  auto membership = kept->handlers->add({}, std::move(handler));
  const std::lock_guard lock(mutex_);
  if (client_) subscribe(kept);
  kept_.add(kept);
  return hold(kept, std::move(membership));
}

Result<Subscription> ReconnectingClient::Impl::keep_stream(Begin begin, MessageHandler handler,
                                                           std::chrono::microseconds interval,
                                                           const CallOptions& options) {
  const auto kept = std::make_shared<detail::KeptHandler>();
  kept->begin = std::move(begin);
  kept->interval = interval;
  auto membership = kept->handlers->add({}, std::move(handler));
  kept->options = options;
  const Time deadline = call_deadline(options);
  const Result<ClientPointer> client = wait_for_client(deadline);
  if (!client) return client.error();
  auto begun = kept->begin(**client, passer_to(kept), with_time_left(options, deadline));
  if (!begun) return std::move(begun).error();
  const std::lock_guard lock(mutex_);
  // If the connection was lost meanwhile, the stream is started again with the next one.
  const std::uint64_t connection = client_ == *client ? connections_ : 0;
  kept_.set(kept, *std::move(begun), connection, options_.clock->now());
  kept_.add(kept);
  changed_.notify_all();
  return hold(kept, std::move(membership));
}

Subscription ReconnectingClient::Impl::on_notice(std::function<void(const Notice&)> handler) {
  return Subscription(notices_->add({}, untyped(std::move(handler))));
}

Subscription ReconnectingClient::Impl::on_change(std::function<void(const LinkChange&)> handler) {
  return Subscription(changes_->add({}, untyped(std::move(handler))));
}

void ReconnectingClient::Impl::check() {
  const std::lock_guard lock(mutex_);
  if (!client_ || loss_) return;
  is_check_wanted_ = true;
  changed_.notify_all();
}

// Facts.

LinkState ReconnectingClient::Impl::state() const {
  const std::lock_guard lock(mutex_);
  return state_;
}

std::uint64_t ReconnectingClient::Impl::connections() const {
  const std::lock_guard lock(mutex_);
  return connections_;
}

BoardIdentity ReconnectingClient::Impl::identity() const {
  const std::lock_guard lock(mutex_);
  return board_;
}

std::string ReconnectingClient::Impl::description() const {
  const std::lock_guard lock(mutex_);
  return description_;
}

ClientStatistics ReconnectingClient::Impl::statistics() const {
  const std::lock_guard lock(mutex_);
  return client_ ? client_->statistics() : statistics_;
}

// Losing the connection.

void ReconnectingClient::Impl::noticed(const Notice& notice, std::uint64_t connection) {
  turn_->take([&] {
    detail::KeptHandlers::call(notices_->with_key({}),
                               [&](const auto& handler) { handler(&notice); });
  });
  // After a restart, the board has no streams, and may have other firmware.
  if (notice.kind == NoticeKind::link_lost) lose(notice.message, connection, false);
  if (notice.kind == NoticeKind::board_reset) lose(notice.message, connection, true);
}

void ReconnectingClient::Impl::lose(const std::string& reason, std::uint64_t connection,
                                    bool is_restarting) {
  const std::lock_guard lock(mutex_);
  if (connection != connections_ || loss_) return;
  loss_ = reason;
  is_restarting_ = is_restarting;
  changed_.notify_all();
}

// The thread that connects.

void ReconnectingClient::Impl::run() {
  Lock lock(mutex_);
  while (!is_closing_ && state_ != LinkState::given_up) {
    release_dropped(lock);
    if (is_closing_) break;
    if (loss_) {
      recover(lock);
    } else if (const Kept kept = kept_.next_to_restore(connections_)) {
      begin_again(lock, kept, false);
    } else if (is_check_wanted_) {
      shows_life(lock);
    } else if (options_.clock->now() >= next_look_) {
      look_after_streams(lock);
    } else if (options_.longest_silence.count() != 0 && !kept_.empty()) {
      options_.clock->wait_until(lock, changed_, next_look_);
    } else {
      changed_.wait(lock);
    }
  }
  const bool is_given_up = state_ == LinkState::given_up;
  disconnect(lock);
  lock.unlock();
  if (!is_given_up) tell({LinkState::closed, "the client is closed", {}});
}

void ReconnectingClient::Impl::release_dropped(Lock& lock) {
  for (auto dropped = kept_.take_dropped(); !dropped.empty(); dropped = kept_.take_dropped()) {
    lock.unlock();
    dropped.clear();
    lock.lock();
  }
}

/// Registers a handler with the current connection. If it is registered already, it stays so if
/// that fails.
void ReconnectingClient::Impl::begin_again(Lock& lock, const Kept& kept, bool is_running) {
  const ClientPointer client = client_;
  const std::uint64_t connection = connections_;
  lock.unlock();
  Result<Subscription> begun = kept->begin(*client, passer_to(kept), kept->options);
  if (!begun && !is_running) {
    const ErrorCode code = begun.error().code;
    const bool is_refused = code != ErrorCode::timeout && code != ErrorCode::link_lost &&
                            code != ErrorCode::not_connected && code != ErrorCode::cancelled &&
                            code != ErrorCode::board_reset;
    if (is_refused) {
      noticed({NoticeKind::stream_ended, begun.error().message}, connection);
    }
    lock.lock();
    if (is_refused) {
      kept->refused = connection;
    } else if (code == ErrorCode::timeout) {
      pause(lock, stream_pause);
    } else if (connection == connections_ && !loss_) {
      loss_ = begun.error().message;
    }
    return;
  }
  lock.lock();
  kept->changed = options_.clock->now();
  // Both exist for a moment, so that the board does not end a running stream.
  if (begun) kept_.set(kept, *std::move(begun), connection, kept->changed);
}

/// Asks for a sign of life if a data stream is silent. Power that fails for a moment ends the
/// streams, but not the line of an adapter.
void ReconnectingClient::Impl::look_after_streams(Lock& lock) {
  const Time now = options_.clock->now();
  next_look_ = now + look_interval;
  if (options_.longest_silence.count() == 0 || !client_) return;
  const Kept silent = kept_.silent_stream(connections_, options_.longest_silence, now);
  if (!silent) return;
  if (shows_life(lock)) begin_again(lock, silent, true);
}

/// Asks for a sign of life. Without one, the connection counts as lost.
bool ReconnectingClient::Impl::shows_life(Lock& lock) {
  is_check_wanted_ = false;
  const ClientPointer client = client_;
  lock.unlock();
  const auto sign = client->call(roles::IntroductionRequest{}, {.timeout = sign_of_life_time});
  lock.lock();
  if (client != client_ || loss_ || is_closing_) return false;
  if (!sign) loss_ = "the board does not respond any more";
  return bool(sign);
}

/// Waits until the time has come or the client is closed; returns false if it is closed.
bool ReconnectingClient::Impl::pause(Lock& lock, std::chrono::milliseconds time) {
  const Time end = options_.clock->now() + time;
  while (!is_closing_ && options_.clock->now() < end) {
    options_.clock->wait_until(lock, changed_, end);
  }
  return !is_closing_;
}

void ReconnectingClient::Impl::recover(Lock& lock) {
  problem_ = *loss_;
  const bool is_restarting = is_restarting_;
  enter(lock, {LinkState::lost, problem_, {}});
  disconnect(lock);
  if (is_restarting && !pause(lock, restart_time)) return;
  enter(lock, {LinkState::searching, "searching for the board", {}});
  if (is_closing_ || search(lock) || is_closing_) return;
  enter(lock, {LinkState::given_up,
               "gave up after " + std::to_string(options_.attempts) + " attempts: " + problem_,
               {}});
}

/// Releases the current connection and everything that belongs to it.
void ReconnectingClient::Impl::disconnect(Lock& lock) {
  std::vector<Subscription> old = kept_.take_all();
  ClientPointer client = std::move(client_);
  if (client) statistics_ = client->statistics();
  Subscription notices = std::move(client_notices_);
  lock.unlock();
  // Close first: there is nobody to tell that the streams end, if the line is lost.
  if (client) client->close();
  old.clear();
  notices.cancel();
  client.reset();
  lock.lock();
}

bool ReconnectingClient::Impl::search(Lock& lock) {
  detail::Search search(options_);
  while (!is_closing_) {
    lock.unlock();
    Result<Client> found = dial_same_board(search);
    lock.lock();
    if (is_closing_) return false;
    if (found) {
      adopt(lock, *std::move(found));
      enter(lock, {LinkState::connected, description_, board_});
      return true;
    }
    problem_ = found.error().message;
    const auto wait = search.failed();
    if (!wait || !pause(lock, *wait)) return false;
  }
  return false;
}

Result<Client> ReconnectingClient::Impl::dial() {
  std::string address = address_;
  if (!make_) {
    const bool is_board_known = connections_ != 0 && board_.details.has_value();
    auto found = adapter_.find(is_board_known);
    if (!found) return std::move(found).error();
    address = *std::move(found);
  }
  const ConnectOptions& options = options_.connection;
  detail::Opener opener =
      make_ ? detail::opener_of(make_, options) : detail::opener_of(address, options);
  opener.open = [this, open = std::move(opener.open)](const asio::any_io_executor& executor,
                                                      std::chrono::milliseconds timeout) {
    // Once the client is closed, nobody waits for this thread while it opens the line, and nothing
    // of the user may be called afterwards.
    const auto set_opening = [this](bool is_opening) {
      const std::lock_guard lock(mutex_);
      is_opening_ = is_opening && !make_ && !is_closing_;
      return !is_closing_;
    };
    const auto closed = [] {
      return io::OpenResult{nullptr, {asio::error::operation_aborted, "The client is closed."}};
    };
    if (!set_opening(true)) return closed();
    io::OpenResult opened = open(executor, timeout);
    if (!set_opening(false)) return closed();
    if (!opened && !opened.error) {
      opened.error = {io::Errc::no_such_port, "There is no line to the board now."};
    }
    return opened;
  };
  auto client =
      detail::connect_client(opener, options, [this](const detail::Conversation& conversation) {
        const std::lock_guard lock(mutex_);
        dialling_ = conversation;
        if (is_closing_) conversation.close();
      });
  const std::lock_guard lock(mutex_);
  dialling_ = {};
  if (client && !make_) adapter_.move_to(address);
  return client;
}

Result<Client> ReconnectingClient::Impl::dial_same_board(detail::Search& search) {
  Result<Client> client = dial();
  if (!client) return client;
  const BoardIdentity& board = client->identity();
  if (detail::is_same_board(board, board_)) return client;
  const std::string text = "found another board, " + detail::words_for(board) + ", instead of " +
                           detail::words_for(board_);
  if (search.is_news(board)) tell({LinkState::other_board, text, board});
  if (options_.other_board == OtherBoard::accept) return client;
  return ClientError{ErrorCode::mismatch, text};
}

void ReconnectingClient::Impl::adopt(Lock&, Client client) {
  ++connections_;
  loss_.reset();
  is_check_wanted_ = false;
  is_restarting_ = false;
  problem_.clear();
  board_ = client.identity();
  description_ = client.description();
  client_ = std::make_shared<Client>(std::move(client));
  next_look_ = options_.clock->now() + look_interval;
  client_notices_ = client_->on_notice(
      [weak = weak_from_this(), connection = connections_](const Notice& notice) {
        if (const auto self = weak.lock()) self->noticed(notice, connection);
      });
  // Before anyone knows of the connection, so that they miss no answer; streams follow in run().
  for (const Kept& kept : kept_.without_request()) subscribe(kept);
  // A loss before there was a handler for it.
  if (const auto ended = detail::ClientMaker::conversation(*client_).state()->end_reason()) {
    loss_ = ended->message;
  }
}

void ReconnectingClient::Impl::enter(Lock& lock, const LinkChange& change) {
  if (is_closing_) return;
  state_ = change.state;
  changed_.notify_all();
  lock.unlock();
  tell(change);
  lock.lock();
}

void ReconnectingClient::Impl::tell(const LinkChange& change) {
  turn_->take([&] {
    detail::KeptHandlers::call(changes_->with_key({}),
                               [&](const auto& handler) { handler(&change); });
  });
}

}  // namespace sbgc
