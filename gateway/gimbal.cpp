#include "gateway/gimbal.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <future>
#include <mutex>
#include <optional>
#include <utility>

#include <asio/bind_executor.hpp>
#include <asio/post.hpp>
#include <asio/steady_timer.hpp>
#include <fmt/format.h>

#include <sbgc/client/statistics.hpp>
#include <sbgc/meta/control.hpp>
#include <sbgc/meta/enums.hpp>
#include <sbgc/roles.hpp>
#include <sbgc/text.hpp>

#include "board/connection.hpp"
#include "board/listed_ports.hpp"

namespace sbgc::tools {

namespace {

/// Adds the counters of two connections.
ClientStatistics sum_of(const ClientStatistics& a, const ClientStatistics& b) {
  ClientStatistics sum = b;
  sum.calls += a.calls;
  sum.failures += a.failures;
  sum.unreadable += a.unreadable;
  SessionStatistics& session = sum.session;
  session.parser = a.session.parser + b.session.parser;
  session.sent_frames += a.session.sent_frames;
  session.sent_bytes += a.session.sent_bytes;
  session.retries += a.session.retries;
  session.timeouts += a.session.timeouts;
  session.late_replies += a.session.late_replies;
  session.unsolicited += a.session.unsolicited;
  session.board_errors += a.session.board_errors;
  session.resets += a.session.resets;
  session.refused += a.session.refused;
  return sum;
}

/// The client reconnects by itself, including the first connection.
ReconnectOptions options_of(const NamedGimbal& line) {
  GimbalOptions options;
  options.port = line.port;
  options.timeout = line.timeout;
  options.attempts = line.attempts;
  options.attempt_timeout = line.attempt_timeout;
  options.password_file = line.password_file;
  ReconnectOptions result;
  result.connection = connect_options(options);
  result.list_ports = listed_ports;
  return result;
}

std::string event_kind(NoticeKind kind) {
  switch (kind) {
    case NoticeKind::board_reset: return board_reset_event;
    case NoticeKind::board_error: return "board_error";
    case NoticeKind::link_lost: break;
    case NoticeKind::unreadable: return "unreadable";
    case NoticeKind::polling: return "polling";
    case NoticeKind::stream_ended: return "telemetry_failed";
  }
  return "notice";
}

}  // namespace

/// A client restarts its counters with each connection; this adds them up, so that none decreases.
class CountedLine {
 public:
  /// Adds the counters of the connection with this number, and returns the sum.
  ClientStatistics total(std::uint64_t connection, const ClientStatistics& counters) {
    if (connection != connection_) {
      earlier_ = sum_of(earlier_, current_);
      connection_ = connection;
    }
    current_ = counters;
    return sum_of(earlier_, current_);
  }

 private:
  std::uint64_t connection_ = 0;
  ClientStatistics earlier_{};
  ClientStatistics current_{};
};

constexpr std::chrono::milliseconds first_pause_between_attempts{1'000};
constexpr std::chrono::milliseconds longest_pause_between_attempts{30'000};
/// The pause before a stream that could not be started is tried again.
constexpr std::chrono::milliseconds pause_before_telemetry{5'000};

Io::Io(unsigned threads)
    : context_(static_cast<int>(threads)), work_(asio::make_work_guard(context_)) {
  for (unsigned i = 0; i < threads; ++i) threads_.emplace_back([this] { context_.run(); });
}

void Io::finish() {
  work_.reset();
  for (std::thread& thread : threads_) thread.join();
  threads_.clear();
}

/// Everything but the functions for any thread runs on the strand.
class Gimbal::Impl : public std::enable_shared_from_this<Impl> {
 public:
  using Strand = asio::strand<asio::any_io_executor>;

  Impl(Io& io, const FleetGimbal& settings)
      : settings_(settings),
        options_(options_of(settings.line)),
        strand_(io.executor()),
        client_(std::make_unique<AsyncClient>(strand_)),
        timer_(strand_) {
    for (const Telemetry& one : settings_.telemetry) {
      telemetry_.push_back(std::make_unique<RunningTelemetry>(one, strand_));
    }
  }

  void start() {
    asio::post(strand_, [self = shared_from_this()] { self->connect(); });
  }

  /// Waits until all handlers have ended.
  void close() {
    if (std::exchange(is_closed_, true)) return;
    std::promise<void> done;
    asio::post(strand_, [this, &done] {
      is_closing_ = true;
      timer_.cancel();
      for (const auto& one : telemetry_) one->end();
      changes_.cancel();
      notices_.cancel();
      client_->close();
      done.set_value();
    });
    done.get_future().wait();
  }

  /// Waits for a line that is being opened. Not on a thread of Io, which may have to finish it.
  void end() { client_.reset(); }

  GimbalStatus status() const {
    const std::lock_guard lock(mutex_);
    return status_;
  }

  void set_stopping(bool is_stopping) {
    GimbalStatus status = this->status();
    status.is_stopping = is_stopping;
    enter(status);
  }

  GimbalCounters counters() {
    const std::lock_guard lock(mutex_);
    GimbalCounters result = counters_;
    result.line = line_.total(client_->connections(), client_->statistics());
    return result;
  }

 private:
  friend class Gimbal;

  using Clock = std::chrono::system_clock;

  /// A message at a rate. It is started as soon as the gimbal is online; a stream continues by
  /// itself with the next connection.
  struct RunningTelemetry {
    RunningTelemetry(const Telemetry& from, const Strand& strand)
        : source(from.source),
          interval(std::max<std::int64_t>(1, std::llround(1000 / from.rate))),
          timer(strand) {}

    void end() {
      subscription.cancel();
      timer.cancel();
    }

    TelemetrySource source;
    std::chrono::milliseconds interval;
    Subscription subscription{};
    bool is_running = false;
    asio::steady_timer timer;
  };

  void connect() {
    if (is_closing_) return;
    client_->async_connect(
        settings_.line.port, options_,
        [self = shared_from_this()](const Result<void>& connected) { self->has_tried(connected); });
  }

  void has_tried(const Result<void>& connected) {
    if (is_closing_) return;
    if (!connected) {
      enter_offline(connected.error().message);
      timer_.expires_after(pause_);
      pause_ = std::min(2 * pause_, longest_pause_between_attempts);
      timer_.async_wait([self = shared_from_this()](std::error_code error) {
        if (!error) self->connect();
      });
      return;
    }
    changes_ = client_->on_change([this](const LinkChange& change) { has_changed(change); });
    notices_ = client_->on_notice([this](const Notice& notice) { has_noticed(notice); });
    // Reports events from before the handlers were registered.
    if (client_->is_connected()) {
      enter_online(client_->identity());
    } else {
      enter_offline("the line was lost");
    }
  }

  void has_changed(const LinkChange& change) {
    if (is_closing_) return;
    switch (change.state) {
      case LinkState::connected: return enter_online(change.board);
      case LinkState::lost:
      case LinkState::other_board:
      case LinkState::given_up: return enter_offline(change.message);
      case LinkState::searching:
      case LinkState::closed: return;
    }
  }

  void enter_online(const BoardIdentity& board) {
    GimbalStatus status = this->status();
    status.link = GimbalLink::online;
    status.reason.clear();
    status.firmware = board.firmware_version();
    status.board = board.board_version();
    status.serial_number = board.serial_number();
    status.connections = client_->connections();
    enter(status);
    for (const auto& one : telemetry_) begin(*one);
  }

  void enter_offline(const std::string& reason) {
    GimbalStatus status = this->status();
    status.link = GimbalLink::offline;
    status.reason = reason;
    enter(status);
  }

  void enter(const GimbalStatus& status) {
    {
      const std::lock_guard lock(mutex_);
      line_.total(client_->connections(), client_->statistics());
      if (status_ == status) return;
      status_ = status;
    }
    for (const OnStatus& handler : on_status_) handler(status);
  }

  void has_noticed(const Notice& notice) {
    // A change of the state reports a lost line, too.
    if (is_closing_ || notice.kind == NoticeKind::link_lost) return;
    if (notice.kind == NoticeKind::board_error) {
      const auto reason = static_cast<roles::ErrorReason>(notice.detail);
      const std::lock_guard lock(mutex_);
      ++counters_.board_errors[to_string(reason)];
    }
    tell({event_kind(notice.kind), notice.message});
  }

  void tell(const GimbalEvent& event) const {
    const Time now = Clock::now();
    for (const OnEvent& handler : on_event_) handler(event, now);
  }

  // Telemetry.

  void begin(RunningTelemetry& one) {
    if (is_closing_ || one.is_running || !client_->is_connected()) return;
    one.is_running = true;
    if (const StreamType* const stream = one.source.stream()) {
      stream->async_start(
          *client_, one.interval, [this](const AnyMessage& message) { take(message); },
          [self = shared_from_this(), &one](Result<Subscription> begun) {
            if (self->is_closing_) return;
            if (begun) {
              one.subscription = *std::move(begun);
            } else {
              self->has_failed(one, begun.error());
            }
          });
    } else {
      poll(one);
    }
  }

  /// The next request follows the answer, so that a slow line only has one at a time.
  void poll(RunningTelemetry& one) {
    if (is_closing_) return;
    one.timer.expires_after(one.interval);
    client_->async_call(*one.source.request(), CallOptions{},
                        [self = shared_from_this(), &one](const CallResult<AnyMessage>& answer) {
                          if (self->is_closing_) return;
                          if (!answer) return self->has_failed(one, answer.error());
                          if (*answer) self->take(**answer);
                          one.timer.async_wait([self, &one](std::error_code error) {
                            if (!error) self->poll(one);
                          });
                        });
  }

  void has_failed(RunningTelemetry& one, const ClientError& error) {
    one.is_running = false;
    // It starts again with the next connection.
    if (!client_->is_connected()) return;
    if (error.code != ErrorCode::timeout) {
      tell({"telemetry_failed", fmt::format("{}: {}", one.source.info().name, error.message)});
    }
    one.timer.expires_after(pause_before_telemetry);
    one.timer.async_wait([self = shared_from_this(), &one](std::error_code cancelled) {
      if (!cancelled) self->begin(one);
    });
  }

  void take(const AnyMessage& message) {
    if (is_closing_) return;
    {
      const std::lock_guard lock(mutex_);
      ++counters_.telemetry[message.type().info->name];
    }
    // Messages that a board sends by itself must not be thinned.
    if (message.get_if<msg::Event>() != nullptr) {
      return tell({"event", to_string(message), &message});
    }
    const Time now = Clock::now();
    for (const OnTelemetry& handler : on_telemetry_) handler(message, now);
  }

  const FleetGimbal settings_;
  const ReconnectOptions options_;
  std::vector<OnStatus> on_status_{};
  std::vector<OnTelemetry> on_telemetry_{};
  std::vector<OnEvent> on_event_{};

  Strand strand_;
  /// Null after end().
  std::unique_ptr<AsyncClient> client_;

  asio::steady_timer timer_;
  std::chrono::milliseconds pause_ = first_pause_between_attempts;
  Subscription changes_{};
  Subscription notices_{};
  std::vector<std::unique_ptr<RunningTelemetry>> telemetry_{};
  bool is_closing_ = false;
  bool is_closed_ = false;  // of the thread that closes

  mutable std::mutex mutex_;
  GimbalStatus status_{};
  GimbalCounters counters_{};
  CountedLine line_{};
};

Gimbal::Gimbal(Io& io, const FleetGimbal& settings) : impl_(std::make_shared<Impl>(io, settings)) {}

Gimbal::~Gimbal() {
  close();
  impl_->end();
}

const std::string& Gimbal::name() const noexcept { return impl_->settings_.line.name; }
const FleetGimbal& Gimbal::settings() const noexcept { return impl_->settings_; }
asio::any_io_executor Gimbal::executor() const { return impl_->strand_; }

void Gimbal::on_status(OnStatus handler) { impl_->on_status_.push_back(std::move(handler)); }
void Gimbal::on_telemetry(OnTelemetry handler) {
  impl_->on_telemetry_.push_back(std::move(handler));
}
void Gimbal::on_event(OnEvent handler) { impl_->on_event_.push_back(std::move(handler)); }

void Gimbal::start() { impl_->start(); }
void Gimbal::close() { impl_->close(); }

GimbalStatus Gimbal::status() const { return impl_->status(); }
GimbalCounters Gimbal::counters() const { return impl_->counters(); }
void Gimbal::set_stopping(bool is_stopping) { impl_->set_stopping(is_stopping); }
AsyncClient& Gimbal::client() noexcept { return *impl_->client_; }

}  // namespace sbgc::tools
