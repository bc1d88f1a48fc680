#include "connection.hpp"

#include <algorithm>
#include <array>
#include <cerrno>
#include <optional>
#include <span>
#include <utility>

#include <asio/strand.hpp>

#include <sbgc/internal/words.hpp>
#include <sbgc/io/capture.hpp>
#include <sbgc/io/clock.hpp>
#include <sbgc/io/line.hpp>
#include <sbgc/io/open.hpp>
#include <sbgc/io/recorder.hpp>
#include <sbgc/roles.hpp>

#include "conversation/state.hpp"
#include "driving/task_driver.hpp"
#include "threads.hpp"

namespace sbgc::detail {

namespace {

Stop canceller(const Conversation& conversation, CallId id) {
  return [conversation, id] { conversation.cancel(id); };
}

}  // namespace

Connection::Connection(std::shared_ptr<const void> keeper, asio::any_io_executor executor,
                       Conversation conversation)
    : keeper_(std::move(keeper)),
      executor_(std::move(executor)),
      conversation_(std::move(conversation)) {}

Connection::~Connection() { close(); }

Result<Reply> Connection::call(const Prepare& prepare, const CallOptions& options) {
  return conversation_.call(prepare(conversation_), options);
}

Stop Connection::start(const Prepare& prepare, const CallOptions& options,
                       const Completion<Result<Reply>>& done) {
  return canceller(conversation_, conversation_.start(prepare(conversation_), options, done));
}

Result<Subscription> Connection::stream(const Stream& stream, const CallOptions& options) {
  return conversation_.stream(stream.prepare(conversation_), stream.key, stream.handler, options);
}

Stop Connection::start_stream(const Stream& stream, const CallOptions& options,
                              const Completion<Result<Subscription>>& done) {
  return canceller(conversation_,
                   conversation_.start_stream(stream.prepare(conversation_), stream.key,
                                              stream.handler, options, done));
}

std::optional<ClientError> Connection::run(const BeginTask& begin, Clock& clock) {
  drive(conversation_, begin(conversation_.identity()), clock);
  return std::nullopt;
}

Stop Connection::start_task(const BeginTask& begin,
                            const Completion<std::optional<ClientError>>& done) {
  return tasks_.run(executor_, conversation_, begin(conversation_.identity()),
                    [done] { done(std::nullopt); });
}

Subscription Connection::subscribe(MessageKey key, MessageHandler handler) {
  return conversation_.subscribe(key, std::move(handler));
}

Subscription Connection::on_frame(std::function<void(const BoardFrame&)> handler) {
  return conversation_.on_frame(std::move(handler));
}

Subscription Connection::on_notice(std::function<void(const Notice&)> handler) {
  return conversation_.on_notice(std::move(handler));
}

Subscription Connection::on_change(std::function<void(const LinkChange&)> handler) {
  return on_notice([handler = std::move(handler)](const Notice& notice) {
    if (notice.kind == NoticeKind::link_lost) handler({LinkState::lost, notice.message, {}});
  });
}

LinkState Connection::state() const {
  const auto ended = conversation_.state()->end_reason();
  if (!ended) return LinkState::connected;
  return ended->code == ErrorCode::link_lost ? LinkState::lost : LinkState::closed;
}

void Connection::close() noexcept {
  conversation_.close();
  tasks_.cancel_all();
}

namespace {

ClientError to_client_error(const io::Error& error) {
  ErrorCode code = ErrorCode::io;
  if (error.code == io::Errc::bad_address || error.code == io::Errc::line_refused) {
    code = ErrorCode::invalid;
  } else if (error.code == io::Errc::no_such_port || error.code == io::Errc::not_a_port ||
             error.code == io::Errc::host_not_found) {
    code = ErrorCode::not_found;
  } else if (error.code == io::Errc::timed_out) {
    code = ErrorCode::timeout;
  } else if (error.code == io::Errc::not_a_capture) {
    code = ErrorCode::bad_file;
  }
  const bool is_from_system = error.code.category() == std::system_category();
  if (code == ErrorCode::not_found) return {code, without_period(error.message), ENOENT};
  return {code, without_period(error.message), is_from_system ? error.code.value() : 0};
}

/// Returns, for example, "115200 8N1: 312 bytes, no valid frames".
std::string text_of(const Trial& trial) {
  std::string text = io::to_string(trial.line) + ": " + std::to_string(trial.bytes) + " bytes, ";
  if (trial.good_frames == 0) return text + "no valid frames";
  return text + std::to_string(trial.good_frames) + " messages, but no response";
}

std::string tried(std::span<const Trial> trials) {
  std::string lines;
  std::string refused;
  std::string heard;
  unsigned probes = 0;
  for (const Trial& trial : trials) {
    if (trial.is_refused) {
      refused += (refused.empty() ? "" : ", ") + io::to_string(trial.line);
    } else if (trial.probes != 0) {
      lines += (lines.empty() ? "" : ", ") + io::to_string(trial.line);
    }
    if (trial.bytes != 0) heard += (heard.empty() ? "" : "; ") + text_of(trial);
    probes += trial.probes;
  }
  std::string text = "sent " + std::to_string(probes) + " probes";
  if (!lines.empty()) text += " at " + lines;
  if (!refused.empty()) text += "; the port refuses " + refused;
  return text + (heard.empty() ? "; received nothing" : "; received at " + heard);
}

/// The part of the connection timeout that is reserved for closing the line again: the thread of
/// the line closes it, and both threads may have to wait for a processor.
constexpr std::chrono::milliseconds closing_time(std::chrono::milliseconds timeout) {
  return std::min(timeout / 10, std::chrono::milliseconds(200));
}

/// The steps of connecting.
class Connector {
 public:
  Connector(const asio::any_io_executor& executor, const ConnectOptions& options)
      : options_(options),
        strand_(asio::make_strand(executor)),
        deadline_(io::now() + io::from_chrono(options.timeout - closing_time(options.timeout))),
        state_(std::make_shared<Conversation::State>(strand_, options)) {}
  Connector(const Connector&) = delete;
  Connector& operator=(const Connector&) = delete;
  ~Connector() {
    if (!is_done_) state_->abandon();
  }

  Conversation conversation() const { return Conversation(state_); }

  Result<void> open(const Opener& opener) {
    io::OpenResult opened = opener.open(strand_, left());
    if (!opened) return to_client_error(opened.error);
    has_line_to_find_ = opener.detect_line && opened.transport->line() != nullptr;
    if (const std::string name = options_.capture.value_or(""); !name.empty()) {
      io::CaptureWriter file;
      const auto now = [clock = state_->clock()] { return io::to_chrono(clock.now()); };
      if (const io::Error error = file.open(name, now())) return to_client_error(error);
      const auto on_error = [tell = options_.on_capture_error](const io::Error& error) {
        if (tell) tell(to_client_error(error));
      };
      opened.transport = io::record(std::move(opened.transport), std::move(file),
                                    {.on_error = on_error, .now = now});
    }
    if (options_.wrap) opened.transport = options_.wrap(std::move(opened.transport));
    state_->attach(std::move(opened.transport));
    return {};
  }

  Result<void> detect_line() {
    if (!has_line_to_find_) return {};
    const auto waiter = std::make_shared<Waiter<bool>>();
    state_->detect_line([waiter](bool is_found) { waiter->put(is_found); });
    if (waiter->wait_until(io::to_chrono(deadline_)).value_or(false)) return {};
    const std::string description = state_->description();
    if (auto reason = state_->end_reason()) return *std::move(reason);
    return ClientError{ErrorCode::not_found, "no board found on " + description + ": " +
                                                 tried(state_->trials()) + password_hint()};
  }

  Result<void> introduce() {
    BoardIdentity board;
    auto info = open_port();
    if (!info) return no_introduction(std::move(info).error());
    board.info = *std::move(info);
    state_->set_identity(board);
    change_framing(board.versions());
    if (is_supported<roles::DetailsRequest>(board.versions())) {
      if (auto details = ask(roles::DetailsRequest{})) {
        board.details = *std::move(details);
      } else if (const auto again = ask(roles::IntroductionRequest{}); !again) {
        return ClientError{again.error().code, "the board on " + state_->description() +
                                                   " identified itself, then stopped responding: " +
                                                   details.error().message};
      }
    }
    state_->set_identity(board);
    return {};
  }

  void finish() { is_done_ = true; }

 private:
  std::chrono::milliseconds left() const {
    const Duration duration = deadline_ - io::now();
    return std::chrono::milliseconds(std::max<std::int64_t>(duration.us / 1000, 1));
  }

  /// Requests the board's introduction, with the password if there is one.
  Result<roles::Introduction> open_port() {
    if (!options_.password) return ask(roles::IntroductionRequest{});
    const auto request = opening_request(*options_.password);
    if (!request) return request.error();
    return ask(*request);
  }

  /// Changes to the newest framing of the board, if the board answers in it.
  void change_framing(const Availability& versions) {
    const Framing newest = newest_framing(versions);
    if (!options_.newest_framing || newest == basic_framing) return;
    static_cast<void>(ask(roles::IntroductionRequest{}, newest));
  }

  template <Message M>
  Result<CallResponse<M>> ask(const M& request, std::optional<Framing> tried_framing = {}) {
    Result<Request> prepared = conversation().prepare(request, {});
    if (!prepared) return std::move(prepared).error();
    if (io::now() >= deadline_) return out_of_time(*prepared);
    prepared->tried_framing = tried_framing;
    const auto usual =
        std::max(std::chrono::milliseconds(prepared->policy.timeout_ms), options_.attempt_timeout);
    const auto all = usual * (options_.retries + 1);
    return read_response<M>(
        conversation().call(std::move(prepared), {.timeout = std::min(left(), all)}));
  }

  static ClientError out_of_time(const Request& request) {
    return {ErrorCode::timeout, std::string("no time left for ") + request.command};
  }

  std::string password_hint() const {
    return options_.password ? "; a port that wants another password does not answer" : "";
  }

  ClientError no_introduction(ClientError error) const {
    if (error.code == ErrorCode::board_error &&
        error.detail == static_cast<int>(roles::ErrorReason::temporary)) {
      error.message = "all places of the bridge are in use, or its board restarts";
    }
    if (error.code != ErrorCode::timeout) return error;
    const SessionStatistics seen = state_->statistics().session;
    const std::uint64_t noise = seen.parser.skipped_bytes;
    std::string heard = "nothing";
    if (seen.parser.frames != 0) {
      heard = std::to_string(seen.parser.frames) + " messages, but no response";
    } else if (noise != 0) {
      heard = std::to_string(noise) + " bytes, no valid frames";
    }
    return {ErrorCode::not_found, "no board found on " + state_->description() + ": sent " +
                                      std::to_string(seen.sent_frames) +
                                      (seen.sent_frames == 1 ? " request" : " requests") +
                                      "; received " + heard + password_hint()};
  }

  const ConnectOptions& options_;
  Strand strand_;
  Instant deadline_;
  std::shared_ptr<Conversation::State> state_;
  bool has_line_to_find_ = false;
  bool is_done_ = false;
};

}  // namespace

Opener opener_of(const std::string& address, const ConnectOptions& options) {
  // A baud rate in the address disables the search.
  const bool says_line = address.find("baud=") != std::string::npos;
  return {[address](const asio::any_io_executor& executor, std::chrono::milliseconds timeout) {
            return io::open(executor, address, {.timeout = timeout});
          },
          options.detect_line && !says_line};
}

Opener opener_of(const TransportFactory& make, const ConnectOptions& options) {
  return {[make](const asio::any_io_executor& executor, std::chrono::milliseconds) {
            return io::OpenResult{make(executor), {}};
          },
          options.detect_line};
}

Result<Conversation> connect(const asio::any_io_executor& executor, const Opener& opener,
                             const ConnectOptions& options, const OnStarted& on_begun) {
  if (options.password) {
    if (const auto possible = opening_request(*options.password); !possible) {
      return possible.error();
    }
  }
  Connector connector(executor, options);
  if (on_begun) on_begun(connector.conversation());
  if (auto opened = connector.open(opener); !opened) return std::move(opened).error();
  if (auto found = connector.detect_line(); !found) return std::move(found).error();
  if (auto known = connector.introduce(); !known) return std::move(known).error();
  connector.finish();
  return connector.conversation();
}

}  // namespace sbgc::detail
