/// The host side of the conversation with a board, without I/O: the caller passes in time and bytes
/// and gets back events and bytes to write.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>

#include <sbgc/line.hpp>
#include <sbgc/message.hpp>
#include <sbgc/parser.hpp>
#include <sbgc/response_policy.hpp>
#include <sbgc/roles.hpp>
#include <sbgc/session/event.hpp>
#include <sbgc/session/late_replies.hpp>
#include <sbgc/session/pacing.hpp>
#include <sbgc/session/request.hpp>
#include <sbgc/session/streams.hpp>
#include <sbgc/time.hpp>

namespace sbgc {

/// The capacity of a session.
struct SessionCapacity {
  std::size_t requests = 8;       ///< queued and in flight
  std::size_t late_replies = 12;  ///< kinds of requests that are in flight or may get late replies
  std::size_t streams = roles::stream_limit;  ///< data streams
};

/// Sends requests in order, matches responses to them, and reports the outcome of each.
///
///     const auto sent = session.send(msg::ReadParams3Request{.profile_id = 0});
///     const Output output = session.poll(now, sink);    // write output.bytes, if any
///     session.feed(received, now, sink);                // sink(const Event&)
///
/// - Every request that send() accepts completes with exactly one event.
/// - Requests are sent in order, with the pauses that the protocol requires; a response ends the
///   pause. A request waits while its response could be confused with that of a request in flight;
///   unrelated ones overtake it.
/// - If a request has ended but its response may still arrive, a later request that this response
///   would match also waits. So a late reply is never matched to the next request.
/// - The sink may call send(), cancel(), set_line() and the const functions, but not feed(),
///   poll(), written() or abandon(). It must not throw. When the session reports an event, its
///   state is up to date: the event does not affect a request that the sink sends.
/// - Time may jump forward. If it runs backwards, the session keeps its latest time.
///
/// No heap, no clock, no locks. A Session takes about 6 KB. See detail::RequestState for the states
/// of a request.
///
/// `Formats` are the framings that the session can use: AnyFrameFormats, which lets try_framing()
/// change the framing, or one of FrameFormats.
template <SessionCapacity capacity, class Formats = AnyFrameFormats>
class BasicSession {
 public:
  constexpr explicit BasicSession(const SessionOptions& options = {}) noexcept : options_(options) {
    use(Formats::first);
  }

  /// Queues a request; a later poll() returns its frame. Requires the header of its family in
  /// <sbgc/responses/>.
  template <Message M>
  SendResult send(const M& request, const SendOptions& options = {}) noexcept {
    constexpr bool is_request = M::direction != Direction::from_board;
    constexpr bool has_policy = requires { response_policy(request); };
    static_assert(is_request, "only the board sends this message");
    static_assert(has_policy || !is_request,
                  "include <sbgc/responses/all.hpp>, or its header for the family of the message");
    if constexpr (is_request && has_policy) {
      Request* const slot = free_slot();
      if (slot == nullptr) return refuse(SendStatus::queue_full);
      const WriteResult body = encode_body(request, slot->body);
      if (!body) return refuse(SendStatus::not_encodable, body.status);
      constexpr auto id = static_cast<std::uint8_t>(M::command);
      return accept(*slot, id, body.size, response_policy(request), options);
    } else {
      return {};
    }
  }

  /// Queues a request whose body is already encoded; `policy` is the policy of its message.
  SendResult send(std::uint8_t id, std::span<const std::uint8_t> body, const ResponsePolicy& policy,
                  const SendOptions& options = {}) noexcept {
    Request* const slot = free_slot();
    if (slot == nullptr) return refuse(SendStatus::queue_full);
    const Status status = check_frame(id, body.size(), max_frame_size);
    if (!status) return refuse(SendStatus::not_encodable, status);
    if (!body.empty()) __builtin_memcpy(slot->body.data(), body.data(), body.size());
    return accept(*slot, id, body.size(), policy, options);
  }

  /// Queues a request in another framing, which must be one that the board always answers. If the
  /// board answers in that framing, the session uses only that one from then on; else it goes on
  /// with the framing in use. Meanwhile, it accepts all framings, and no other request is in
  /// flight.
  template <Message M>
  SendResult try_framing(Framing framing, const M& request,
                         const SendOptions& options = {}) noexcept {
    return on_trial(framing, send(request, options));
  }
  SendResult try_framing(Framing framing, std::uint8_t id, std::span<const std::uint8_t> body,
                         const ResponsePolicy& policy, const SendOptions& options = {}) noexcept {
    return on_trial(framing, send(id, body, policy, options));
  }

  /// The framing in use.
  Framing framing() const noexcept { return framing_; }

  /// Processes received bytes, which may complete requests.
  template <class Sink>
  void feed(std::span<const std::uint8_t> bytes, Instant now, Sink&& sink) {
    advance(now);
    flush_after_silence(sink);
    if (bytes.empty()) return;
    last_byte_ = now_;
    parser_.feed(bytes, [&](const Frame& frame) { take(frame, sink); });
  }

  /// Reports requests that have ended by `now`, and returns the frame to write, if one is due: at
  /// most one, whose transmission is assumed to start at `now`. If there is none, the deadline is
  /// later than `now`. send(), feed() and cancel() can make the deadline earlier: call poll() after
  /// them.
  template <class Sink>
  [[nodiscard]] Output poll(Instant now, Sink&& sink) {
    advance(now);
    flush_after_silence(sink);
    late_replies_.expire(now_);
    end_overdue(sink);
    std::size_t size = 0;
    if (next_send_ <= now_) {
      if (Request* const next = next_request()) size = transmit(*next, sink);
    }
    const Instant next = deadline();
    return {{out_.data(), size}, size != 0 ? next : later(next, now_ + microseconds(1))};
  }

  /// For links on which a write can take long: states that the frame of the last poll() is written
  /// only now, so that the timeout of its response starts at `now`. Call it before the next poll().
  void written(Instant now) noexcept {
    advance(now);
    next_send_ = later(next_send_, now_ + sent_.pause);
    for (Request& request : requests_) {
      if (!request.handle || request.handle != sent_.handle || request.confirmations != 0) continue;
      const Instant sent_at = later(request.sent_at, now_ + sent_.response_time);
      if (request.attempt_end != Instant::never) request.attempt_end = sent_at + request.timeout;
      request.sent_at = sent_at;
      return;
    }
    late_replies_.extend(sent_.responses,
                         now_ + sent_.response_time + sent_.finish + options_.late);
  }

  /// Completes a request with `cancelled`; returns false if it has already ended. The board may
  /// still respond to frames already sent.
  template <class Sink>
  bool cancel(Handle handle, Sink&& sink) {
    for (Request& request : requests_) {
      if (!handle || request.handle != handle) continue;
      complete(request, Outcome::cancelled, {}, sink);
      return true;
    }
    return false;
  }

  /// To be called when the link is lost: completes every request with `link_lost` and discards the
  /// known state of the board. The session can continue on another link.
  template <class Sink>
  void abandon(Sink&& sink) {
    parser_.flush([](const Frame&) {});
    forget_streams();
    next_send_ = now_;
    complete_all(Outcome::link_lost, sink, Handle{last_handle_});
    use(Formats::first);
    late_replies_.clear();  // including those of the requests that have just ended
  }

  /// Sets the line settings, after a change of the line or its settings.
  void set_line(const LineSettings& line) noexcept { options_.line = line; }

  const SessionOptions& options() const noexcept { return options_; }

  SessionStatistics statistics() const noexcept {
    SessionStatistics result = statistics_;
    result.parser = parser_.counters();
    result.framing = framing_;
    return result;
  }

  /// Returns the bandwidth that the data streams use, including streams being started.
  StreamUsage stream_usage() const noexcept { return {streams_.used(), stream_limit()}; }

  /// Returns the number of requests that are queued or in flight.
  std::size_t open_requests() const noexcept {
    std::size_t count = 0;
    for (const Request& request : requests_) count += request.is_open() ? 1U : 0U;
    return count;
  }

 private:
  using Request = detail::SessionRequest;
  using State = detail::RequestState;

  // Accepting requests

  Request* free_slot() noexcept {
    for (Request& request : requests_) {
      if (!request.is_open()) return &request;
    }
    return nullptr;
  }

  SendResult refuse(SendStatus status, const Status& encoding = {}) noexcept {
    ++statistics_.refused;
    return {{}, status, encoding};
  }

  SendResult accept(Request& slot, std::uint8_t id, std::size_t size, const ResponsePolicy& policy,
                    const SendOptions& options) noexcept {
    const StreamChange& stream = policy.stream;
    if (stream.command != 0) {
      const std::uint32_t limit = options.ignore_budget ? 0 : stream_limit();
      const SendStatus status = streams_.check(stream, limit);
      if (status != SendStatus::ok) return refuse(status);
    }
    const bool is_noted = stream.command != 0 && streams_.ask(stream);
    slot.open({++last_handle_}, id, size, policy, options, options_.attempts);
    if (!is_noted) slot.policy.stream = {};
    return {slot.handle, SendStatus::ok, {}};
  }

  static constexpr bool can_change_framing = requires(Formats & formats) { formats.accept_all(); };

  SendResult on_trial(Framing framing, const SendResult& sent) noexcept {
    static_assert(can_change_framing, "this session has a fixed framing");
    if (sent) trial_ = {sent.handle, framing};
    return sent;
  }

  std::uint32_t stream_limit() const noexcept {
    const std::uint64_t all = bytes_per_second(options_.line);
    return static_cast<std::uint32_t>(all * options_.stream_percent / 100);
  }

  // Sending

  /// Returns the oldest request that may be sent, or null.
  Request* next_request() noexcept {
    Request* next = nullptr;
    for (Request& request : requests_) {
      const bool is_older = next == nullptr || request.handle < next->handle;
      if (request.is_open() && is_older && may_be_sent(request)) next = &request;
    }
    return next;
  }

  bool may_be_sent(const Request& request) const noexcept {
    if (request.state != State::queued) return request.state == State::resend;
    const Responses& responses = request.policy.responses;
    std::size_t in_flight = 0;
    for (const Request& other : requests_) {
      if (!other.is_open()) continue;
      in_flight += other.is_in_flight() ? 1U : 0U;
      // Requests do not pass a trial, in either direction.
      if (trial_.handle == other.handle && other.handle < request.handle) return false;
      if (trial_.handle == request.handle && other.is_in_flight()) return false;
      const bool is_before = other.is_in_flight() || other.handle < request.handle;
      if (is_before && (other.awaits_response || request.awaits_response) &&
          responses.can_be_confused_with(other.policy.responses)) {
        return false;
      }
    }
    if (request.awaits_response && late_replies_.can_be_confused_with(responses)) return false;
    return !responses.are_possible() || late_replies_.has_room(responses, in_flight);
  }

  /// Writes the frame of a request to `out_`; returns its size.
  template <class Sink>
  std::size_t transmit(Request& request, Sink& sink) {
    const bool is_trial = request.handle == trial_.handle;
    if (is_trial) accept_all();
    const Framing framing = is_trial ? trial_.framing : framing_;
    __builtin_memcpy(frame_body(out_.data()), request.body.data(), request.size);
    const std::size_t size =
        Formats::finish(framing, out_.data(), request.id, request.size, request.body.data());
    ++statistics_.sent_frames;
    statistics_.sent_bytes += size;
    statistics_.retries += request.state == State::resend ? 1U : 0U;
    const std::size_t response = response_size(request.policy.responses);
    sent_ = {request.handle, request.policy.responses,
             detail::pause_after(options_, size, response), wire_time(options_.line, response),
             request.finish};
    const Instant left = now_ + wire_time(options_.line, size);
    next_send_ = left + sent_.pause;
    request.state = State::in_flight;
    --request.attempts;
    ++request.transmissions;
    request.sent_at = left + sent_.response_time;
    request.attempt_end = request.sent_at + request.timeout;
    if (!request.awaits_response) complete(request, Outcome::sent, {}, sink);
    return size;
  }

  /// Returns the size of the response frame; the largest one if it varies.
  std::size_t response_size(const Responses& responses) const noexcept {
    std::size_t size = responses.confirmed != Confirmed::never ? roles::confirmation_size : 0;
    for (std::size_t i = 0; i < responses.form_count; ++i) {
      if (size < responses.forms[i].size) size = responses.forms[i].size;
    }
    return responses.are_possible() ? frame_size(framing_, size) : 0;
  }

  // Time

  void advance(Instant now) noexcept { now_ = later(now_, now); }

  /// Flushes the parser after a silence: an incomplete candidate is not a frame, but may contain
  /// one.
  template <class Sink>
  void flush_after_silence(Sink& sink) {
    if (parser_.waiting_bytes() == 0 || now_ < last_byte_ + options_.idle) return;
    parser_.flush([&](const Frame& frame) { take(frame, sink); });
  }

  template <class Sink>
  void end_overdue(Sink& sink) {
    const Handle newest{last_handle_};  // excludes requests that the sink sends in this loop
    for (Request& request : requests_) {
      if (!request.is_open() || newest < request.handle) continue;
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
      request.state = State::resend;
      return;
    }
    complete(request, request.policy.is_certain() ? Outcome::timeout : Outcome::unconfirmed, {},
             sink);
  }

  /// Returns the time at which poll() next has something to do.
  Instant deadline() noexcept {
    Instant next = Instant::never;
    if (parser_.waiting_bytes() != 0) next = last_byte_ + options_.idle;
    bool is_blocked = false;
    for (const Request& request : requests_) {
      if (!request.is_open()) continue;
      next = earlier(next, earlier(request.deadline, request.attempt_end));
      if (request.state == State::in_flight) continue;
      if (may_be_sent(request)) {
        next = earlier(next, later(next_send_, now_));
      } else {
        is_blocked = true;
      }
    }
    return is_blocked ? earlier(next, late_replies_.next_end()) : next;
  }

  // Receiving

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
      const ResponseForm* const form = awaited_form(request, frame);
      if (form == nullptr) continue;
      end_pause(request);
      complete(request, form->is_error ? Outcome::failed : Outcome::answered, frame, sink);
      return;
    }
    const bool is_late = take_late_reply(
        [&](const Responses& responses) { return responses.form_of(frame) != nullptr; });
    const bool is_sample = streams_.has(frame.id);
    statistics_.unsolicited += is_late || is_sample ? 0U : 1U;
    report({.kind = is_sample ? EventKind::stream : EventKind::unsolicited,
            .command = frame.id,
            .is_late = is_late,
            .frame = frame},
           sink);
  }

  /// Returns the response form of `request` that the frame matches. Null if it matches none, if it
  /// is a sample of a stream, or if the request is not in flight.
  const ResponseForm* awaited_form(const Request& request, const Frame& frame) const noexcept {
    if (!request.is_in_flight()) return nullptr;
    const ResponseForm* const form = request.policy.responses.form_of(frame);
    if (form == nullptr) return nullptr;
    const bool is_sample = form->size != frame.body.size() && streams_.has_size_of_sample(frame);
    return is_sample ? nullptr : form;
  }

  template <class Sink>
  void take_confirmation(const Frame& frame, Sink& sink) {
    const std::uint8_t command = roles::confirmed_command(frame);
    for (Request& request : requests_) {
      const ResponsePolicy& policy = request.policy;
      if (!request.is_in_flight()) continue;
      if (!policy.responses.is_confirmed_by(command, frame)) continue;
      if (request.confirmations != 0 && line_repeats_frames() &&
          now_ < request.confirmed_at + options_.duplicate_window) {
        break;  // a duplicate of the last one
      }
      end_pause(request);
      ++request.confirmations;
      request.confirmed_at = now_;
      const Handle handle = request.handle;
      report({.kind = EventKind::confirmation,
              .handle = handle,
              .command = command,
              .confirmation = request.confirmations,
              .confirmations = policy.confirmations,
              .frame = frame},
             sink);
      if (request.handle != handle) return;  // cancelled by the sink
      if (policy.result.is_failure(frame.body)) {
        complete(request, Outcome::failed, frame, sink);
      } else if (policy.response_required) {
        // A response message is still to come.
      } else if (request.confirmations >= policy.confirmations) {
        complete(request, Outcome::confirmed, frame, sink);
      } else {
        request.state = State::in_flight;
        request.attempt_end = request.sent_at + request.finish;
      }
      return;
    }
    const bool is_late = take_late_reply(
        [&](const Responses& responses) { return responses.is_confirmed_by(command, frame); });
    report(
        {.kind = EventKind::confirmation, .command = command, .is_late = is_late, .frame = frame},
        sink);
  }

  /// Matches an error to a request in flight if that is the only one it can refer to.
  template <class Sink>
  void take_error(const Frame& frame, Sink& sink) {
    ++statistics_.board_errors;
    const std::uint8_t command = roles::failed_command(frame);
    Request* meant = nullptr;
    bool is_clear = !late_replies_.has_command(command);
    for (Request& request : requests_) {
      if (!request.is_in_flight()) continue;
      if (command != 0 && request.policy.responses.command != command) continue;
      is_clear = is_clear && meant == nullptr;
      meant = &request;
    }
    if (meant != nullptr && is_clear) {
      end_pause(*meant);
      complete(*meant, Outcome::board_error, frame, sink);
      return;
    }
    const bool is_late = meant == nullptr && take_late_reply([&](const Responses& responses) {
                           return command == 0 || responses.command == command;
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
      if (awaited_form(request, frame) == nullptr) continue;
      complete(request, Outcome::answered, frame, sink);
      break;
    }
    report({.kind = EventKind::reset, .command = frame.id, .frame = frame}, sink);
    complete_all(Outcome::reset, sink, newest);
    // The board may continue to respond until it restarts.
    late_replies_.limit(now_ + milliseconds(roles::reset_delay_ms) + options_.late);
  }

  /// Called when the board responds to `request`. If that was the last frame sent, the board has
  /// read its input buffer empty, which ends the pause. A response to a resent request may be that
  /// to its first transmission.
  void end_pause(const Request& request) noexcept {
    if (!options_.pacing.until_response) return;
    if (request.handle != sent_.handle || request.transmissions != 1) return;
    next_send_ = now_;
    sent_.pause = {};
  }

  /// Returns true if the line may deliver a frame twice.
  bool line_repeats_frames() const noexcept { return options_.duplicate_window > Duration{}; }

  template <class Fits>
  bool take_late_reply(Fits&& fits) noexcept {
    const bool is_late =
        late_replies_.take(fits, line_repeats_frames(), now_ + options_.duplicate_window);
    statistics_.late_replies += is_late ? 1U : 0U;
    return is_late;
  }

  // Completing requests

  /// Forgets all streams and requested changes: no stream runs any more. Must be called before any
  /// event of the same occurrence is reported, because the sink may request another stream.
  void forget_streams() noexcept {
    streams_.clear();
    for (Request& request : requests_) request.policy.stream = {};
  }

  /// Completes the requests up to `newest`, which excludes requests that the sink sends meanwhile.
  template <class Sink>
  void complete_all(Outcome outcome, Sink& sink, Handle newest) {
    for (Request& request : requests_) {
      if (request.is_open() && request.handle <= newest) complete(request, outcome, {}, sink);
    }
  }

  /// Frees a request, expects late replies if more may come, and reports the outcome.
  template <class Sink>
  void complete(Request& request, Outcome outcome, const Frame& frame, Sink& sink) {
    const ResponsePolicy& policy = request.policy;
    if (request.handle == trial_.handle) end_trial(outcome, frame);
    expect_late_reply(request, outcome);
    const bool done =
        outcome == Outcome::answered || outcome == Outcome::confirmed || outcome == Outcome::sent;
    if (policy.stream.command != 0) streams_.settle(policy.stream, done);
    if (policy.restarts_board && done) streams_.stop();
    const Event event{.kind = EventKind::completed,
                      .handle = request.handle,
                      .outcome = outcome,
                      .command = policy.responses.command,
                      .may_be_sample = outcome == Outcome::answered && streams_.has(frame.id),
                      .frame = frame};
    request.close();
    report(event, sink);
  }

  void end_trial(Outcome outcome, const Frame& frame) noexcept {
    const bool is_spoken = outcome == Outcome::answered && frame.framing == trial_.framing;
    use(is_spoken ? trial_.framing : framing_);
    trial_ = {};
  }

  /// Writes and accepts only this framing from now on.
  constexpr void use(Framing framing) noexcept {
    framing_ = framing;
    streams_.set_framing(framing);
    if constexpr (can_change_framing) parser_.formats().accept_only(framing);
  }

  void accept_all() noexcept {
    if constexpr (can_change_framing) parser_.formats().accept_all();
  }

  void expect_late_reply(const Request& request, Outcome outcome) noexcept {
    const ResponsePolicy& policy = request.policy;
    if (request.transmissions == 0 || !policy.responses.are_possible()) return;
    const bool is_answered = outcome == Outcome::answered || outcome == Outcome::failed ||
                             outcome == Outcome::board_error;
    const std::uint32_t each = policy.responses.form_count != 0 ? 1 : policy.confirmations;
    std::uint32_t expected = each * request.transmissions;
    const std::uint32_t seen = is_answered ? each : request.confirmations;
    expected = expected > seen ? expected - seen : 0;
    Instant end{};
    if (expected != 0) end = request.sent_at + request.finish + options_.late;
    if (is_answered || outcome == Outcome::confirmed) {
      if (line_repeats_frames()) {
        ++expected;
        end = later(end, now_ + options_.duplicate_window);
      }
    }
    // Even if `end` has passed: the frame may not have been written yet, see written().
    if (expected != 0) late_replies_.add(policy.responses, expected, end);
  }

  template <class Sink>
  static void report(const Event& event, Sink& sink) {
    sink(event);
  }

  /// The request that tries another framing.
  struct Trial {
    Handle handle{};
    Framing framing{};
  };

  SessionOptions options_;
  BasicParser<Formats> parser_{};
  Framing framing_ = Formats::first;
  Trial trial_{};
  Instant now_{std::numeric_limits<std::int64_t>::min()};
  Instant last_byte_{};
  Instant next_send_{std::numeric_limits<std::int64_t>::min()};
  std::uint64_t last_handle_{};
  detail::Transmission sent_{};
  std::array<Request, capacity.requests> requests_{};
  detail::LateReplies<capacity.late_replies> late_replies_{};
  detail::Streams<capacity.streams> streams_{};
  SessionStatistics statistics_{};
  std::array<std::uint8_t, max_frame_size> out_{};
};

/// A session with a capacity that suits most hosts.
using Session = BasicSession<SessionCapacity{}>;

static_assert(sizeof(Session) <= 6144, "a session must fit into a small microcontroller");

}  // namespace sbgc
