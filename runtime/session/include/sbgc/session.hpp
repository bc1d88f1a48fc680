/// The host's side of the conversation with a board, without I/O: time and bytes are handed in,
/// events and bytes to write come out.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>

#include <sbgc/exchange.hpp>
#include <sbgc/line.hpp>
#include <sbgc/message.hpp>
#include <sbgc/parser.hpp>
#include <sbgc/roles.hpp>
#include <sbgc/session/event.hpp>
#include <sbgc/session/ghosts.hpp>
#include <sbgc/session/pacing.hpp>
#include <sbgc/session/streams.hpp>
#include <sbgc/time.hpp>

namespace sbgc {

/// What a session can hold.
struct SessionCapacity {
  std::size_t requests = 8;  ///< waiting and in flight
  std::size_t ghosts = 12;   ///< kinds of requests in flight, or over with late answers possible
  std::size_t streams = roles::stream_limit;  ///< data streams
};

/// Sends requests one behind the other, finds out what answers which, and reports each end.
///
///     const auto sent = session.send(ReadParams3Request{.profile_id = 0});
///     const Output output = session.poll(now, sink);    // write output.bytes, if any
///     session.feed(received, now, sink);                // sink(const Event&)
///
/// - Every request that send() takes completes with exactly one event, whatever happens.
/// - Requests go out in order, with the break between them that the protocol asks for. One whose
///   answer could be taken for that of another in flight waits; unrelated ones overtake it.
/// - When a request is over and its answer may still come, a later request that this answer would
///   fit waits, too. So a late answer is never taken for the answer of the next request.
/// - The sink may call send(), cancel(), set_line(), statistics() and the like, but not feed(),
///   poll(), written() or abandon(). It must not throw. An event comes when the session has taken
///   in what it tells: a request that the sink sends belongs to what comes after.
/// - Time may jump forward; if it runs backwards it counts as standing still.
///
/// No heap, no clock, no locks. A Session takes about 6 KB.
template <SessionCapacity capacity>
class BasicSession {
 public:
  constexpr explicit BasicSession(const SessionOptions& options = {}) noexcept
      : options_(options) {}

  /// Takes a request; needs its family of <sbgc/exchanges/>. A later poll() writes its frame.
  template <Message M>
  SendResult send(const M& request, const SendOptions& options = {}) noexcept {
    Request* const slot = free_slot();
    if (slot == nullptr) return refuse(SendStatus::queue_full);
    const WriteResult written = encode_frame(request, slot->frame);
    if (!written) return refuse(SendStatus::not_encodable, written.status);
    return accept(*slot, written.size, exchange_of(request), options);
  }

  /// Takes a request whose body is already encoded; `exchange` is that of the message it is.
  SendResult send(std::uint8_t id, std::span<const std::uint8_t> body, const Exchange& exchange,
                  const SendOptions& options = {}) noexcept {
    Request* const slot = free_slot();
    if (slot == nullptr) return refuse(SendStatus::queue_full);
    const WriteResult written = write_frame(id, body, slot->frame);
    if (!written) return refuse(SendStatus::not_encodable, written.status);
    return accept(*slot, written.size, exchange, options);
  }

  /// Takes bytes that have come over the line.
  template <class Sink>
  void feed(std::span<const std::uint8_t> bytes, Instant now, Sink&& sink) {
    advance(now);
    end_silence(sink);
    if (bytes.empty()) return;
    last_byte_ = now_;
    parser_.feed(bytes, [&](const Frame& frame) { take(frame, sink); });
  }

  /// Reports what is over by now, and returns the frame to write, if one is due: at most one, which
  /// counts as being written from `now` on. When nothing is to be written, the deadline lies behind
  /// `now`. send(), feed() and cancel() can make it earlier: call poll() behind them.
  template <class Sink>
  [[nodiscard]] Output poll(Instant now, Sink&& sink) {
    advance(now);
    end_silence(sink);
    ghosts_.expire(now_);
    end_overdue(sink);
    std::size_t size = 0;
    if (next_send_ <= now_) {
      if (Request* const next = next_request()) size = transmit(*next, sink);
    }
    const Instant next = deadline();
    return {{out_.data(), size}, size != 0 ? next : later(next, now_ + microseconds(1))};
  }

  /// For links on which a write can take long: the frame of the last poll() has left only now, and
  /// the time for its answer begins here. To be called before the next poll().
  void written(Instant now) noexcept {
    advance(now);
    next_send_ = later(next_send_, now_ + sent_.pause);
    for (Request& request : requests_) {
      if (!request.handle || request.handle != sent_.handle || request.confirmations != 0) continue;
      const Instant sent_at = later(request.sent_at, now_ + sent_.answer_time);
      if (request.attempt_end != Instant::never) request.attempt_end = sent_at + request.timeout;
      request.sent_at = sent_at;
      return;
    }
    ghosts_.prolong(sent_.replies, now_ + sent_.answer_time + sent_.finish + options_.late);
  }

  /// Ends a request with the outcome `cancelled`; false if it is already over. What is sent can not
  /// be called back: its answer still has its time.
  template <class Sink>
  bool cancel(Handle handle, Sink&& sink) {
    for (Request& request : requests_) {
      if (!handle || request.handle != handle) continue;
      complete(request, Outcome::cancelled, {}, sink);
      return true;
    }
    return false;
  }

  /// The link is gone: every request completes with `link_lost`, and all that was known about the
  /// board's state is forgotten. The session can be used on with another link.
  template <class Sink>
  void abandon(Sink&& sink) {
    parser_.flush([](const Frame&) {});
    forget_streams();
    next_send_ = now_;
    complete_all(Outcome::link_lost, sink, Handle{last_handle_});
    ghosts_.clear();  // those of the requests that have just ended, too
  }

  /// The line is another one, or has other settings.
  void set_line(const LineSettings& line) noexcept { options_.line = line; }

  const SessionOptions& options() const noexcept { return options_; }

  SessionStatistics statistics() const noexcept {
    SessionStatistics result = statistics_;
    result.parser = parser_.counters();
    return result;
  }

  /// What the data streams take of the line, those included that are being started.
  StreamUsage stream_usage() const noexcept { return {streams_.used(), stream_limit()}; }

  /// Requests that are waiting or in flight.
  std::size_t open_requests() const noexcept {
    std::size_t count = 0;
    for (const Request& request : requests_) count += request.handle ? 1U : 0U;
    return count;
  }

 private:
  struct Request {
    Handle handle{};      // none: the slot is free
    Exchange exchange{};  // its `stream` is a change that `streams_` has noted, or none
    bool waits{};         // for something that the board says
    bool is_in_flight{};
    bool is_due{};            // to be sent again
    std::uint8_t attempts{};  // transmissions left
    std::uint8_t transmissions{};
    std::uint8_t confirmations{};
    std::uint16_t size{};
    Duration timeout{};
    Duration finish{};       // for the last confirmation
    Instant sent_at{};       // when its answer could have come over the line
    Instant confirmed_at{};  // last
    Instant attempt_end = Instant::never;
    Instant deadline = Instant::never;
    std::array<std::uint8_t, max_frame_size> frame{};
  };

  /// The last transmission.
  struct Transmission {
    Handle handle{};
    Replies replies{};
    Duration pause{};        // behind it
    Duration answer_time{};  // of the answer on the line
    Duration finish{};
  };

  // Taking requests

  Request* free_slot() noexcept {
    for (Request& request : requests_) {
      if (!request.handle) return &request;
    }
    return nullptr;
  }

  SendResult refuse(SendStatus status, const Status& encoding = {}) noexcept {
    ++statistics_.refused;
    return {{}, status, encoding};
  }

  SendResult accept(Request& slot, std::size_t size, const Exchange& exchange,
                    const SendOptions& options) noexcept {
    const StreamChange& stream = exchange.stream;
    if (stream.command != 0) {
      const std::uint32_t limit = options.ignore_budget ? 0 : stream_limit();
      const SendStatus status = streams_.check(stream, limit);
      if (status != SendStatus::ok) return refuse(status);
    }
    const bool certain = is_certain(exchange);
    const std::uint8_t attempts = options.attempts != 0 ? options.attempts : options_.attempts;
    slot.handle = {++last_handle_};
    slot.exchange = exchange;
    if (stream.command != 0 && !streams_.ask(stream)) slot.exchange.stream = {};
    const bool may_be_confirmed = exchange.replies.confirmed != Confirmed::never;
    slot.waits = certain || (options.expect_confirmation && may_be_confirmed);
    slot.is_in_flight = slot.is_due = false;
    // That a possible confirmation does not come is no reason to send again.
    slot.attempts = certain && exchange.retry_is_safe && attempts != 0 ? attempts : 1;
    slot.transmissions = slot.confirmations = 0;
    slot.size = static_cast<std::uint16_t>(size);
    const Duration timeout = milliseconds(exchange.timeout_ms);
    const Duration finish = milliseconds(exchange.finish_ms);
    slot.timeout = options.timeout > Duration{} ? options.timeout : timeout;
    slot.finish = finish < slot.timeout ? slot.timeout : finish;
    slot.attempt_end = Instant::never;
    slot.deadline = options.deadline;
    return {slot.handle, SendStatus::ok, {}};
  }

  std::uint32_t stream_limit() const noexcept {
    const std::uint64_t all = bytes_per_second(options_.line);
    return static_cast<std::uint32_t>(all * options_.stream_percent / 100);
  }

  // Sending

  /// The oldest request that may be sent, or null.
  Request* next_request() noexcept {
    Request* next = nullptr;
    for (Request& request : requests_) {
      const bool is_older = next == nullptr || request.handle < next->handle;
      if (request.handle && is_older && may_be_sent(request)) next = &request;
    }
    return next;
  }

  bool may_be_sent(const Request& request) const noexcept {
    if (request.is_in_flight) return request.is_due;
    const Replies& replies = request.exchange.replies;
    std::size_t in_flight = 0;
    for (const Request& other : requests_) {
      if (!other.handle) continue;
      in_flight += other.is_in_flight ? 1U : 0U;
      const bool is_before = other.is_in_flight || other.handle < request.handle;
      if (is_before && (other.waits || request.waits) &&
          replies.can_be_confused_with(other.exchange.replies)) {
        return false;
      }
    }
    if (request.waits && ghosts_.can_be_confused_with(replies)) return false;
    return !has_replies(replies) || ghosts_.has_room(replies, in_flight);
  }

  /// Whether something comes back unless it is lost or the request fails.
  static bool is_certain(const Exchange& exchange) noexcept {
    return exchange.answer_required || exchange.replies.confirmed == Confirmed::always;
  }

  static bool has_replies(const Replies& replies) noexcept {
    return replies.answer_count != 0 || replies.confirmed != Confirmed::never;
  }

  /// Puts the frame of a request into `out_`; returns its size.
  template <class Sink>
  std::size_t transmit(Request& request, Sink& sink) {
    const std::size_t size = request.size;
    __builtin_memcpy(out_.data(), request.frame.data(), size);
    ++statistics_.sent_frames;
    statistics_.sent_bytes += size;
    statistics_.retries += request.is_in_flight ? 1U : 0U;
    const std::size_t answer = answer_size(request.exchange);
    sent_ = {request.handle, request.exchange.replies, detail::pause_behind(options_, size, answer),
             wire_time(options_.line, answer), request.finish};
    const Instant left = now_ + wire_time(options_.line, size);
    next_send_ = left + sent_.pause;
    request.is_in_flight = true;
    request.is_due = false;
    --request.attempts;
    ++request.transmissions;
    request.sent_at = left + sent_.answer_time;
    request.attempt_end = request.sent_at + request.timeout;
    if (!request.waits) complete(request, Outcome::sent, {}, sink);
    return size;
  }

  /// The size of the frame that answers, the largest if it varies.
  static std::size_t answer_size(const Exchange& exchange) noexcept {
    const Replies& replies = exchange.replies;
    std::size_t size = replies.confirmed != Confirmed::never ? roles::confirmation_size : 0;
    for (std::size_t i = 0; i < replies.answer_count; ++i) {
      if (size < replies.answers[i].size) size = replies.answers[i].size;
    }
    return has_replies(replies) ? Framing::frame_size(size) : 0;
  }

  // Time

  void advance(Instant now) noexcept { now_ = later(now_, now); }

  /// A candidate that the line has left incomplete is false; a frame may be hidden behind it.
  template <class Sink>
  void end_silence(Sink& sink) {
    if (parser_.waiting_bytes() == 0 || now_ < last_byte_ + options_.idle) return;
    parser_.flush([&](const Frame& frame) { take(frame, sink); });
  }

  template <class Sink>
  void end_overdue(Sink& sink) {
    const Handle newest{last_handle_};  // what the sink sends from here on is not looked at
    for (Request& request : requests_) {
      if (!request.handle || newest < request.handle) continue;
      if (request.deadline <= now_) {
        complete(request, Outcome::timeout, {}, sink);
      } else if (request.attempt_end <= now_) {
        end_attempt(request, sink);
      }
    }
  }

  template <class Sink>
  void end_attempt(Request& request, Sink& sink) {
    ++statistics_.timeouts;
    request.attempt_end = Instant::never;
    if (request.attempts != 0 && request.confirmations == 0) {
      request.is_due = true;
      return;
    }
    complete(request, is_certain(request.exchange) ? Outcome::timeout : Outcome::unconfirmed, {},
             sink);
  }

  /// When poll() has something to do next.
  Instant deadline() noexcept {
    Instant next = Instant::never;
    if (parser_.waiting_bytes() != 0) next = last_byte_ + options_.idle;
    bool is_blocked = false;
    for (const Request& request : requests_) {
      if (!request.handle) continue;
      next = earlier(next, earlier(request.deadline, request.attempt_end));
      if (request.is_in_flight && !request.is_due) continue;
      if (may_be_sent(request)) {
        next = earlier(next, later(next_send_, now_));
      } else {
        is_blocked = true;
      }
    }
    return is_blocked ? earlier(next, ghosts_.next_end()) : next;
  }

  // What the board says

  template <class Sink>
  void take(const Frame& frame, Sink& sink) {
    if (roles::is_reset(frame)) {
      take_reset(frame, sink);
    } else if (roles::is_confirmation(frame)) {
      take_confirmation(frame, sink);
    } else if (roles::is_error(frame)) {
      take_error(frame, sink);
    } else {
      take_message(frame, sink);
    }
  }

  template <class Sink>
  void take_message(const Frame& frame, Sink& sink) {
    for (Request& request : requests_) {
      const AnswerForm* const form = waiting_form(request, frame);
      if (form == nullptr) continue;
      complete(request, form->is_error ? Outcome::failed : Outcome::answered, frame, sink);
      return;
    }
    const bool is_late =
        take_late([&](const Replies& replies) { return replies.answer(frame) != nullptr; });
    const bool is_sample = streams_.has(frame.id);
    statistics_.unsolicited += is_late || is_sample ? 0U : 1U;
    report({.kind = is_sample ? EventKind::stream : EventKind::unsolicited,
            .command = frame.id,
            .is_late = is_late,
            .frame = frame},
           sink);
  }

  /// The form in which the frame answers a request in flight, or null.
  const AnswerForm* waiting_form(const Request& request, const Frame& frame) const noexcept {
    if (!request.handle || !request.is_in_flight) return nullptr;
    const AnswerForm* const form = request.exchange.replies.answer(frame);
    if (form == nullptr) return nullptr;
    const bool is_sample = form->size != frame.body.size() && streams_.has_size_of_sample(frame);
    return is_sample ? nullptr : form;
  }

  template <class Sink>
  void take_confirmation(const Frame& frame, Sink& sink) {
    const std::uint8_t command = roles::confirmed_command(frame);
    for (Request& request : requests_) {
      const Exchange& exchange = request.exchange;
      if (!request.handle || !request.is_in_flight) continue;
      if (!exchange.replies.is_confirmed_by(command, frame)) continue;
      if (request.confirmations != 0 && repeats() &&
          now_ < request.confirmed_at + options_.duplicates) {
        break;  // the last one again
      }
      ++request.confirmations;
      request.confirmed_at = now_;
      const Handle handle = request.handle;
      report({.kind = EventKind::confirmation,
              .handle = handle,
              .command = command,
              .confirmation = request.confirmations,
              .confirmations = exchange.confirmations,
              .frame = frame},
             sink);
      if (request.handle != handle) return;  // cancelled by the sink
      if (exchange.result.is_failure(frame.body)) {
        complete(request, Outcome::failed, frame, sink);
      } else if (exchange.answer_required) {
        // The answer comes, too.
      } else if (request.confirmations >= exchange.confirmations) {
        complete(request, Outcome::confirmed, frame, sink);
      } else {
        request.is_due = false;
        request.attempt_end = request.sent_at + request.finish;
      }
      return;
    }
    const bool is_late =
        take_late([&](const Replies& replies) { return replies.is_confirmed_by(command, frame); });
    report(
        {.kind = EventKind::confirmation, .command = command, .is_late = is_late, .frame = frame},
        sink);
  }

  /// An error belongs to a request in flight if no other can be meant.
  template <class Sink>
  void take_error(const Frame& frame, Sink& sink) {
    ++statistics_.board_errors;
    const std::uint8_t command = roles::failed_command(frame);
    Request* meant = nullptr;
    bool is_clear = !ghosts_.has_command(command);
    for (Request& request : requests_) {
      if (!request.handle || !request.is_in_flight) continue;
      if (command != 0 && request.exchange.replies.command != command) continue;
      is_clear = is_clear && meant == nullptr;
      meant = &request;
    }
    if (meant != nullptr && is_clear) {
      complete(*meant, Outcome::board_error, frame, sink);
      return;
    }
    const bool is_late = meant == nullptr && take_late([&](const Replies& replies) {
                           return command == 0 || replies.command == command;
                         });
    report({.kind = EventKind::board_error, .command = command, .is_late = is_late, .frame = frame},
           sink);
  }

  template <class Sink>
  void take_reset(const Frame& frame, Sink& sink) {
    ++statistics_.resets;
    const Handle newest{last_handle_};
    forget_streams();
    for (Request& request : requests_) {
      if (waiting_form(request, frame) == nullptr) continue;
      complete(request, Outcome::answered, frame, sink);
      break;
    }
    report({.kind = EventKind::reset, .command = frame.id, .frame = frame}, sink);
    complete_all(Outcome::reset, sink, newest);
    // Until it restarts, the board may go on answering.
    ghosts_.limit(now_ + milliseconds(roles::reset_delay_ms) + options_.late);
  }

  /// Whether a frame may come twice.
  bool repeats() const noexcept { return options_.duplicates > Duration{}; }

  template <class Fits>
  bool take_late(Fits&& fits) noexcept {
    const bool is_late = ghosts_.take(fits, repeats(), now_ + options_.duplicates);
    statistics_.late_answers += is_late ? 1U : 0U;
    return is_late;
  }

  // Ends

  /// No stream runs any more, and no change that has been asked for will be made. Not behind an
  /// event of the same occurrence: the sink may have asked for another stream.
  void forget_streams() noexcept {
    streams_.clear();
    for (Request& request : requests_) request.exchange.stream = {};
  }

  /// Completes the requests up to `newest`: not what the sink sends meanwhile.
  template <class Sink>
  void complete_all(Outcome outcome, Sink& sink, Handle newest) {
    for (Request& request : requests_) {
      if (request.handle && request.handle <= newest) complete(request, outcome, {}, sink);
    }
  }

  /// Frees the slot of a request, leaves a ghost if more may come, and reports the end.
  template <class Sink>
  void complete(Request& request, Outcome outcome, const Frame& frame, Sink& sink) {
    const Exchange& exchange = request.exchange;
    leave_ghost(request, outcome);
    const bool done =
        outcome == Outcome::answered || outcome == Outcome::confirmed || outcome == Outcome::sent;
    if (exchange.stream.command != 0) streams_.settle(exchange.stream, done);
    if (exchange.restarts_board && done) streams_.stop();
    const Event event{.kind = EventKind::completed,
                      .handle = request.handle,
                      .outcome = outcome,
                      .command = exchange.replies.command,
                      .may_be_sample = outcome == Outcome::answered && streams_.has(frame.id),
                      .frame = frame};
    request.handle = {};
    report(event, sink);
  }

  void leave_ghost(const Request& request, Outcome outcome) noexcept {
    const Exchange& exchange = request.exchange;
    if (request.transmissions == 0 || !has_replies(exchange.replies)) return;
    const bool is_answered = outcome == Outcome::answered || outcome == Outcome::failed ||
                             outcome == Outcome::board_error;
    const std::uint32_t each = exchange.replies.answer_count != 0 ? 1 : exchange.confirmations;
    std::uint32_t expected = each * request.transmissions;
    const std::uint32_t seen = is_answered ? each : request.confirmations;
    expected = expected > seen ? expected - seen : 0;
    Instant end{};
    if (expected != 0) end = request.sent_at + request.finish + options_.late;
    if (is_answered || outcome == Outcome::confirmed) {
      if (repeats()) {
        ++expected;
        end = later(end, now_ + options_.duplicates);
      }
    }
    // Even if it is over by now: the frame may still be stuck, see written().
    if (expected != 0) ghosts_.add(exchange.replies, expected, end);
  }

  template <class Sink>
  static void report(const Event& event, Sink& sink) {
    sink(event);
  }

  SessionOptions options_;
  Parser parser_{};
  Instant now_{std::numeric_limits<std::int64_t>::min()};
  Instant last_byte_{};
  Instant next_send_{std::numeric_limits<std::int64_t>::min()};
  std::uint64_t last_handle_{};
  Transmission sent_{};
  std::array<Request, capacity.requests> requests_{};
  detail::Ghosts<capacity.ghosts> ghosts_{};
  detail::Streams<capacity.streams> streams_{};
  SessionStatistics statistics_{};
  std::array<std::uint8_t, max_frame_size> out_{};
};

/// A session with room for what a host usually does.
using Session = BasicSession<SessionCapacity{}>;

static_assert(sizeof(Session) <= 6144, "a session must fit into a small microcontroller");

}  // namespace sbgc
