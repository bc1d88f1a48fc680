// The thread that connects, and monitors the connection.

#include <utility>

#include "conversation/state.hpp"
#include "reconnecting/reconnection.hpp"

namespace sbgc::detail {

namespace {

/// After a board has announced its restart, no connection is attempted for this time.
constexpr std::chrono::milliseconds restart_time{roles::reset_delay_ms + 500};
/// The interval between checks of the data streams.
constexpr std::chrono::milliseconds look_interval{500};
/// The timeout for checking that a silent board is alive.
constexpr std::chrono::milliseconds sign_of_life_time{1'000};
/// The pause before an unconfirmed stream is started once more.
constexpr std::chrono::milliseconds stream_pause{500};

}  // namespace

void Reconnection::run() {
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

void Reconnection::release_dropped(Lock& lock) {
  for (auto dropped = kept_.take_dropped(); !dropped.empty(); dropped = kept_.take_dropped()) {
    lock.unlock();
    dropped.clear();
    lock.lock();
  }
}

/// Registers a handler with the current connection. On failure, an existing registration remains.
void Reconnection::begin_again(Lock& lock, const Kept& kept, bool is_running) {
  const Pointer client = client_;
  const std::uint64_t connection = connections_;
  lock.unlock();
  Result<Subscription> begun = kept->begin(client->conversation(), passer_to(kept), kept->options);
  if (!begun && !is_running) {
    const ErrorCode code = begun.error().code;
    const bool is_refused = code != ErrorCode::timeout && code != ErrorCode::link_lost &&
                            code != ErrorCode::not_connected && code != ErrorCode::cancelled &&
                            code != ErrorCode::board_reset;
    if (is_refused) {
      deliver([this, notice = Notice{NoticeKind::stream_ended, begun.error().message}] {
        show(notice);
      });
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

/// Checks that the board is alive if a data stream is silent. A short power failure ends the
/// streams, but not the line of an adapter.
void Reconnection::look_after_streams(Lock& lock) {
  const Time now = options_.clock->now();
  next_look_ = now + look_interval;
  if (options_.longest_silence.count() == 0 || !client_) return;
  const Kept silent = kept_.silent_stream(connections_, options_.longest_silence, now);
  if (!silent) return;
  if (shows_life(lock)) begin_again(lock, silent, true);
}

/// Checks that the board is alive. If it is not, the connection counts as lost.
bool Reconnection::shows_life(Lock& lock) {
  is_check_wanted_ = false;
  const Pointer client = client_;
  lock.unlock();
  const auto sign = client->call(
      [](const Conversation& board) { return board.prepare(roles::IntroductionRequest{}, {}); },
      {.timeout = sign_of_life_time});
  lock.lock();
  if (client != client_ || loss_ || is_closing_) return false;
  if (!sign) loss_ = "the board does not respond any more";
  return bool(sign);
}

/// Waits for this time or until the client is closed; returns false if it is closed.
bool Reconnection::pause(Lock& lock, std::chrono::milliseconds time) {
  const Time end = options_.clock->now() + time;
  while (!is_closing_ && options_.clock->now() < end) {
    options_.clock->wait_until(lock, changed_, end);
  }
  return !is_closing_;
}

void Reconnection::recover(Lock& lock) {
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
void Reconnection::disconnect(Lock& lock) {
  std::vector<Subscription> old = kept_.take_all();
  Pointer client = std::move(client_);
  if (client) statistics_ = client->statistics();
  Subscription notices = std::move(client_notices_);
  const std::string loss = loss_.value_or("");
  lock.unlock();
  // Close first: if the line is lost, the board cannot be told that the streams end.
  if (client) client->conversation().state()->close(loss);
  old.clear();
  notices.cancel();
  client.reset();
  lock.lock();
}

bool Reconnection::search(Lock& lock) {
  Search search(options_);
  while (!is_closing_) {
    lock.unlock();
    Result<Pointer> found = dial_same_board(search);
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

Result<Reconnection::Pointer> Reconnection::dial() {
  std::string address = address_;
  if (!make_) {
    const bool is_board_known = connections_ != 0 && board_.details.has_value();
    auto found = adapter_.find(is_board_known);
    if (!found) return std::move(found).error();
    address = *std::move(found);
  }
  const ConnectOptions& options = options_.connection;
  Opener opener = make_ ? opener_of(make_, options) : opener_of(address, options);
  opener.open = [this, open = std::move(opener.open)](const asio::any_io_executor& executor,
                                                      std::chrono::milliseconds timeout) {
    // Once the client is closed, nothing waits for this thread while it opens the line, and no
    // function of the user may be called afterwards.
    const auto set_opening = [this](bool is_opening) {
      const std::lock_guard lock(mutex_);
      is_opening_ = is_opening && !make_ && !strand_ && !is_closing_;
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
  auto client = connect_to(opener);
  const std::lock_guard lock(mutex_);
  dialling_ = {};
  if (client && !make_) adapter_.move_to(address);
  return client;
}

Result<Reconnection::Pointer> Reconnection::connect_to(const Opener& opener) {
  const auto on_begun = [this](const Conversation& conversation) {
    const std::lock_guard lock(mutex_);
    dialling_ = conversation;
    if (is_closing_) conversation.close();
  };
  if (!strand_) return connect_with_thread(opener, options_.connection, on_begun);
  auto conversation = connect(executor_, opener, options_.connection, on_begun);
  if (!conversation) return std::move(conversation).error();
  return std::make_shared<Connection>(nullptr, executor_, *std::move(conversation));
}

Result<Reconnection::Pointer> Reconnection::dial_same_board(Search& search) {
  Result<Pointer> client = dial();
  if (!client) return client;
  const BoardIdentity board = (*client)->identity();
  if (is_same_board(board, board_)) return client;
  const std::string text =
      "found another board, " + words_for(board) + ", instead of " + words_for(board_);
  if (search.is_news(board)) tell({LinkState::other_board, text, board});
  if (options_.other_board == OtherBoard::accept) return client;
  return ClientError{ErrorCode::mismatch, text};
}

void Reconnection::adopt(Lock&, Pointer connection) {
  ++connections_;
  loss_.reset();
  is_check_wanted_ = false;
  is_restarting_ = false;
  problem_.clear();
  client_ = std::move(connection);
  board_ = client_->identity();
  description_ = client_->description();
  next_look_ = options_.clock->now() + look_interval;
  client_notices_ = client_->on_notice(
      [weak = weak_from_this(), connection = connections_](const Notice& notice) {
        if (const auto self = weak.lock()) self->noticed(notice, connection);
      });
  // Before anyone uses the connection, so that no answer is missed; streams follow in run().
  for (const Kept& kept : kept_.without_request()) register_now(kept);
  // The connection may have been lost before there was a handler for it.
  if (const auto ended = client_->conversation().state()->end_reason()) {
    loss_ = ended->message;
  }
}

void Reconnection::enter(Lock& lock, const LinkChange& change) {
  if (is_closing_) return;
  state_ = change.state;
  announce_change();
  lock.unlock();
  tell(change);
  lock.lock();
}

void Reconnection::tell(const LinkChange& change) {
  deliver([this, change] {
    turn_->take([&] {
      KeptHandlers::call(changes_->with_key({}), [&](const auto& handler) { handler(&change); });
    });
  });
}

}  // namespace sbgc::detail
