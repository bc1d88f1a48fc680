/// The host side of the conversation with a board, without I/O: the caller passes in time and bytes
/// and gets back events and bytes to write.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <new>
#include <span>
#include <type_traits>
#include <utility>

#include <sbgc/internal/compiler.hpp>
#include <sbgc/line.hpp>
#include <sbgc/message.hpp>
#include <sbgc/parser.hpp>
#include <sbgc/response_policy.hpp>
#include <sbgc/roles.hpp>
#include <sbgc/session/event.hpp>
#include <sbgc/session/late_replies.hpp>
#include <sbgc/session/meaning.hpp>
#include <sbgc/session/pacing.hpp>
#include <sbgc/session/request.hpp>
#include <sbgc/session/streams.hpp>
#include <sbgc/session/ticks.hpp>
#include <sbgc/small_parser.hpp>
#include <sbgc/time.hpp>

namespace sbgc {

/// The capacity of a session.
struct SessionCapacity {
  std::size_t requests = 8;       ///< queued and in flight
  std::size_t late_replies = 12;  ///< kinds of requests that are in flight or may get late replies
  std::size_t streams = roles::stream_limit;  ///< data streams
  std::size_t body = max_body_size;           ///< of the largest request, in bytes
  /// Optimize::size: a small parser, and statistics() has only the parser's counters.
  Optimize optimize = Optimize::speed;
};

/// Sends requests in order, matches responses to them, and reports the outcome of each.
///
///     const auto sent = session.send(msg::ReadParams3Request{.profile_id = 0});
///     const Output output = session.poll(now, sink);    // write output.bytes, if any
///     session.feed(received, now, sink);                // sink(const Event&)
///
/// - Every request that send() accepts completes with exactly one event.
/// - Requests are sent with the pauses that the protocol requires; a response ends the pause.
/// - A request with an effect is never sent, or resent, after a later one of the same host. It does
/// not wait for responses. If several in flight have the same response, the one with the fewest
/// confirmations gets it, then the oldest.
/// - A request that stops all motion is sent next. Motion that any host has requested before and
///   that is still queued is not sent: it completes with `superseded`. Others follow the stop.
/// - A request that only reads waits while its response could be confused with that of an earlier
/// one, in flight or late; unrelated ones overtake it. So a late reply never answers it. Requests
/// of the same host, if it is not 0, do not wait for each other, and reads do not overtake.
/// - While a data stream runs, a request for the same message and content is not sent if a sample
/// is due in time: that is the answer. If only the content differs, it is sent after a sample, and
/// the answer must arrive before the next one can; an ambiguous frame matches no request.
/// - The pause after a request whose response is not awaited begins with its first byte, and a
/// pause that a late poll() has extended shortens the next one: so requests at an even rate stay
/// even.
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
  /// Not constexpr, because a static object that is initialized at compile time occupies flash too.
  SBGC_ALWAYS_INLINE explicit BasicSession(const SessionOptions& options = {}) noexcept
      : settings_(options) {
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
      static_assert(M::min_size <= capacity.body, "the session's capacity for a body is smaller");
      Request* const slot = free_slot();
      if (slot == nullptr) return refuse(SendStatus::queue_full);
      const WriteResult body = encode_body(request, slot->body);
      if (!body) return refuse(SendStatus::not_encodable, body.status);
      // Constructed in place: a copy would cost stack and code.
      ::new (&slot->policy) ResponsePolicy(response_policy(request));
      return accept(*slot, static_cast<std::uint8_t>(M::command), body.size, options);
    } else {
      return {};
    }
  }

  /// Queues a request whose body is already encoded; `policy` is the policy of its message.
  SendResult send(std::uint8_t id, std::span<const std::uint8_t> body, const ResponsePolicy& policy,
                  const SendOptions& options = {}) noexcept {
    Request* const slot = free_slot();
    if (slot == nullptr) return refuse(SendStatus::queue_full);
    const Status status = check_frame(id, body.size(), frame_size<basic_framing>(capacity.body));
    if (!status) return refuse(SendStatus::not_encodable, status);
    if (!body.empty()) detail::copy_memory(slot->body.data(), body.data(), body.size());
    slot->policy = policy;
    return accept(*slot, id, body.size(), options);
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
  Framing framing() const noexcept { return can_change_framing ? framing_ : Formats::first; }

  /// Processes received bytes, which may complete requests.
  template <class Sink>
  void feed(std::span<const std::uint8_t> bytes, Instant now, Sink&& sink) {
    advance_and_flush(now, sink);
    if (bytes.empty()) return;
    silence_left_ = settings_.idle;
    parser_.feed(bytes, taker(sink));
  }

  /// Reports requests that have ended by `now`, and returns the frame to write, if one is due: at
  /// most one, whose transmission is assumed to start at `now`. If there is none, the deadline is
  /// later than `now`. send(), feed() and cancel() can make the deadline earlier: call poll() after
  /// them.
  template <class Sink>
  [[nodiscard]] Output poll(Instant now, Sink&& sink) {
    advance_and_flush(now, sink);
    late_replies_.expire();
    end_overdue(sink);
    if constexpr (has_streams) end_indistinct(sink);
    std::size_t size = 0;
    if (pause_left_ == 0) {
      if (Request* const next = next_request()) size = transmit(*next, sink);
    }
    Ticks left = next_action();
    if constexpr (is_shared) {
      is_due_after_pause_ = pause_left_ != 0 && left == pause_left_;
      if (!is_due_after_pause_) overdue_ = 0;
    }
    if (left == 0 && size == 0) left = 1;
    return {{out_.data(), size},
            left == detail::never ? Instant::never : now_ + microseconds(left)};
  }

  /// For links on which a write can take long: states that the frame of the last poll() is written
  /// only now, so that the timeout of its response starts at `now`. Call it before the next poll().
  void written(Instant now) noexcept {
    advance(now);
    pause_left_ = detail::longer(pause_left_, sent_.pause);
    const Ticks late_left = late_after(sent_.response_time, sent_.finish);
    for (Request& request : requests_) {
      if (!request.handle || request.handle != sent_.handle || request.confirmations != 0) continue;
      if (request.attempt_left != detail::never) {
        request.attempt_left =
            detail::longer(request.attempt_left, sent_.response_time + request.timeout);
      }
      request.late_left = detail::longer(request.late_left, late_left);
      if constexpr (has_streams) streams_.prolong(request.policy, request.late_left);
      return;
    }
    late_replies_.extend(sent_.handle, late_left);
  }

  /// Completes a request with `cancelled`; returns false if it has already ended. The board may
  /// still respond to frames already sent.
  template <class Sink>
  bool cancel(Handle handle, Sink&& sink) {
    for (Request& request : requests_) {
      if (!handle || request.handle != handle) continue;
      complete(request, Outcome::cancelled, no_frame, sink);
      return true;
    }
    return false;
  }

  /// Call this when the link is lost: completes every request with `link_lost` and discards the
  /// known state of the board. The session can continue on another link.
  template <class Sink>
  void abandon(Sink&& sink) {
    parser_.flush([](const Frame&) {});
    forget_streams();
    pause_left_ = 0;
    complete_all(Outcome::link_lost, sink, next_handle());
    use(Formats::first);
    late_replies_.clear();  // including those of the requests that have just ended
  }

  /// Sets the line settings, after a change of the line or its settings.
  void set_line(const LineSettings& line) noexcept { settings_.set_line(line); }

  /// Returns the counters since the session was made.
  SessionStatistics statistics() const noexcept {
    SessionStatistics result;
    if constexpr (has_statistics) result = statistics_;
    result.parser = parser_.counters();
    result.framing = framing();
    return result;
  }

  /// Returns the bandwidth that the data streams use, including streams being started.
  StreamUsage stream_usage() const noexcept { return {streams_.used(), settings_.stream_limit}; }

  /// Returns the number of requests that are queued or in flight.
  std::size_t open_requests() const noexcept {
    std::size_t count = 0;
    for (const Request& request : requests_) count += request.is_open() ? 1U : 0U;
    return count;
  }

 private:
  using Ticks = detail::Ticks;
  using Request = detail::SessionRequest<capacity.body>;
  using State = detail::RequestState;

  /// A session for one request at a time needs no order or hosts, and does not support series.
  static constexpr bool is_shared = capacity.requests > 1;
  static constexpr bool has_streams = capacity.streams != 0;

  // Accepting requests

  Request* free_slot() noexcept {
    for (Request& request : requests_) {
      if (!request.is_open()) return &request;
    }
    return nullptr;
  }

  SBGC_NOINLINE SendResult refuse(SendStatus status, const Status& encoding = {}) noexcept {
    count(&SessionStatistics::refused);
    return {{}, status, encoding};
  }

  /// Accepts the request whose body and policy are in the slot.
  SendResult accept(Request& slot, std::uint8_t id, std::size_t size,
                    const SendOptions& options) noexcept {
    const Ticks timeout = detail::ticks_of(options.timeout, detail::never);
    if (timeout > detail::longest_response) return refuse(SendStatus::timeout_too_long);
    StreamChange& stream = slot.policy.stream;
    if (has_streams ? slot.policy.changes_stream() : stream.command != 0) {
      const std::uint32_t limit = options.ignore_budget ? 0 : settings_.stream_limit;
      const SendStatus status = streams_.check(stream, limit);
      if (status != SendStatus::ok) return refuse(status);
      const bool is_noted = streams_.ask(stream);
      if (has_streams && !is_noted) stream = {};
    }
    slot.open({++last_handle_}, id, size, options, timeout, settings_.attempts);
    return {slot.handle, SendStatus::ok, {}};
  }

  static constexpr bool can_change_framing = requires(Formats & formats) { formats.accept_all(); };

  SendResult on_trial(Framing framing, const SendResult& sent) noexcept {
    static_assert(can_change_framing, "this session has a fixed framing");
    if (sent) trial_ = {sent.handle, framing};
    return sent;
  }

  // Sending

  /// Returns the request that is to be sent next, or null.
  Request* next_request() noexcept {
    Request* next = nullptr;
    for (Request& request : requests_) {
      const bool is_before = next == nullptr || request.precedes(*next);
      if (request.is_open() && is_before && may_be_sent(request)) next = &request;
    }
    return next;
  }

  /// Returns true if the request must wait for another open one.
  bool blocks(const Request& other, const Request& request) const noexcept {
    // Requests do not overtake a trial, or vice versa.
    const bool is_older = other.is_older_than(request.handle);
    if (is_trial(other) && is_older) return true;
    if (is_trial(request) && other.is_in_flight()) return true;
    if (request.policy.has_effect) return false;
    if constexpr (has_streams) {
      // Only when the change is confirmed is it known whether a frame is a sample.
      const bool changes = other.policy.changes_stream() && (other.is_in_flight() || is_older);
      if (changes && other.policy.stream.command == request.policy.responses.forms[0].id)
        return true;
    }
    if (knows_its_own(request, other.host)) return is_older && !other.is_in_flight();
    return (other.is_in_flight() || is_older) &&
           (other.awaits_response || request.awaits_response) &&
           request.policy.responses.can_be_confused_with(other.policy.responses);
  }

  /// Returns true if the request and one of `host` belong to the same host, which distinguishes the
  /// responses to them.
  static bool knows_its_own(const Request& request, std::uint16_t host) noexcept {
    return is_shared && host != 0 && request.host == host;
  }

  bool may_be_sent(const Request& request) const noexcept {
    if constexpr (has_streams) {
      if (gate_for(request) != detail::Gate::open) return false;
    }
    return is_free(request);
  }

  /// Returns whether the samples of running streams allow sending the request.
  detail::Gate gate_for(const Request& request) const noexcept {
    const Responses& responses = request.policy.responses;
    if (request.policy.has_effect || !streams_.has(responses.forms[0].id)) {
      return detail::Gate::open;
    }
    const Ticks request_time = settings_.frame_time(frame_size(framing(), request.size));
    const Ticks response_time = settings_.frame_time(response_size(responses));
    return streams_.gate(request.policy, request_time + response_time + board_time,
                         request.timeout);
  }

  /// Returns true if the request need not wait for others.
  bool is_free(const Request& request) const noexcept {
    if (request.state != State::queued) return request.state == State::resend;
    if (request.policy.stops) return true;
    const Responses& responses = request.policy.responses;
    std::size_t in_flight = 0;
    if constexpr (capacity.requests > 1) {
      for (const Request& other : requests_) {
        if (!other.is_open()) continue;
        in_flight += other.is_in_flight() ? 1U : 0U;
        if (blocks(other, request)) return false;
      }
    }
    if (request.policy.has_effect) return true;
    const auto can_be_confused = [&](const detail::LateRequest& late) {
      return !knows_its_own(request, late.host) && responses.can_be_confused_with(late.responses);
    };
    if (request.awaits_response && late_replies_.has(can_be_confused)) return false;
    return !responses.are_possible() || late_replies_.has_room(in_flight);
  }

  /// Ends, or stops repeating, requests that must not follow one with an effect that was just sent.
  template <class Sink>
  void end_older(Handle sent, std::uint16_t host, const ResponsePolicy& policy, Sink& sink) {
    for (Request& request : requests_) {
      if (!request.is_open() || !request.is_older_than(sent) || !request.policy.has_effect)
        continue;
      const bool is_superseded = request.policy.is_superseded_by(policy);
      if (request.host != host && !is_superseded) continue;
      if (request.state == State::in_flight) {
        request.attempts = 0;
      } else if (request.state == State::resend) {
        complete(request, Outcome::timeout, no_frame, sink);
      } else if (is_superseded) {
        complete(request, Outcome::superseded, no_frame, sink);
      }
    }
  }

  /// Writes the frame of a request to `out_`; returns its size.
  template <class Sink>
  std::size_t transmit(Request& request, Sink& sink) {
    if (is_trial(request)) accept_all();
    const Framing framing = is_trial(request) ? trial_.framing : this->framing();
    detail::copy_memory(frame_body(out_.data()), request.body.data(), request.size);
    const std::size_t size =
        Formats::finish(framing, out_.data(), request.id, request.size, request.body.data());
    count(&SessionStatistics::sent_frames);
    count(&SessionStatistics::sent_bytes, size);
    if (request.state == State::resend) count(&SessionStatistics::retries);
    const std::size_t response = response_size(request.policy.responses);
    const Ticks response_time = settings_.frame_time(response);
    sent_.handle = request.handle;
    sent_.pause = settings_.pause_after(size, response, response_time);
    sent_.response_time = response_time;
    sent_.finish = request.finish;
    const Ticks left = settings_.frame_time(size);
    const Ticks response_left = left + response_time;
    pause_left_ = left + sent_.pause;
    if constexpr (is_shared) {
      if (!request.awaits_response) {
        pause_left_ = detail::longer(left, sent_.pause - detail::shorter(overdue_, sent_.pause));
        sent_.pause /= 2;
      }
      overdue_ = 0;
      is_due_after_pause_ = false;
    }
    request.state = State::in_flight;
    --request.attempts;
    ++request.transmissions;
    request.attempt_left = response_left + request.timeout;
    request.late_left = late_after(response_left, request.finish);
    if constexpr (has_streams) streams_.expect(request.policy, request.late_left);
    const bool is_done = !request.awaits_response;
    if (is_shared && request.policy.has_effect) {
      const Handle sent = request.handle;
      const std::uint16_t host = request.host;
      const ResponsePolicy policy = request.policy;
      if (is_done) complete(request, Outcome::sent, no_frame, sink);
      end_older(sent, host, policy, sink);
    } else if (is_done) {
      complete(request, Outcome::sent, no_frame, sink);
    }
    return size;
  }

  /// Returns the size of the response frame; the largest one if it varies.
  std::size_t response_size(const Responses& responses) const noexcept {
    std::size_t size = responses.confirmed != Confirmed::never ? roles::confirmation_size : 0;
    for (std::size_t i = 0; i < responses.form_count; ++i) {
      if (size < responses.forms[i].size) size = responses.forms[i].size;
    }
    return responses.are_possible() ? frame_size(framing(), size) : 0;
  }

  /// Returns the time after which not even a late response can arrive.
  Ticks late_after(Ticks response_left, Ticks finish) const noexcept {
    return response_left + finish + settings_.late;
  }

  // Time

  void advance(Instant now) noexcept {
    const Ticks elapsed = detail::between(now_, now);
    if (elapsed == 0) return;
    now_ = now;
    if constexpr (is_shared) {
      if (is_due_after_pause_ && elapsed > pause_left_) {
        overdue_ = detail::shorter(overdue_ + elapsed - pause_left_, most_overdue);
      }
    }
    detail::pass(pause_left_, elapsed);
    detail::pass(silence_left_, elapsed);
    for (Request& request : requests_) {
      if (request.is_in_flight()) request.pass(elapsed);  // others have no timers
    }
    late_replies_.pass(elapsed);
    streams_.pass(elapsed);
  }

  /// Advances the time. Flushes the parser after a silence: an incomplete candidate is not a frame,
  /// but may contain one.
  template <class Sink>
  void advance_and_flush(Instant now, Sink& sink) {
    advance(now);
    if (parser_.waiting_bytes() == 0 || silence_left_ != 0) return;
    parser_.flush(taker(sink));
  }

  template <class Sink>
  void end_overdue(Sink& sink) {
    const Handle next = next_handle();  // excludes requests that the sink sends in this loop
    for (Request& request : requests_) {
      if (!request.is_open() || !request.is_older_than(next)) continue;
      if (detail::between(now_, request.deadline) == 0) {
        complete(request, Outcome::timeout, no_frame, sink);
      } else if (request.attempt_left == 0) {
        end_attempt(request, sink);
      }
    }
  }

  /// Ends the requests whose answers would be indistinguishable from samples.
  template <class Sink>
  void end_indistinct(Sink& sink) {
    const Handle next = next_handle();
    for (Request& request : requests_) {
      const bool is_waiting = request.is_open() && request.state != State::in_flight;
      if (!is_waiting || !request.is_older_than(next)) continue;
      if (gate_for(request) == detail::Gate::closed) {
        complete(request, Outcome::indistinct, no_frame, sink);
      }
    }
  }

  template <class Sink>
  void end_attempt(Request& request, Sink& sink) {
    count(&SessionStatistics::timeouts);
    request.attempt_left = detail::never;
    if (request.attempts != 0 && request.confirmations == 0) {
      request.state = State::resend;
      return;
    }
    complete(request, request.policy.is_certain() ? Outcome::timeout : Outcome::unconfirmed,
             no_frame, sink);
  }

  /// Returns the time until poll() has something to do.
  Ticks next_action() const noexcept {
    Ticks left = parser_.waiting_bytes() != 0 ? silence_left_ : detail::never;
    bool is_blocked = false;
    for (const Request& request : requests_) {
      if (!request.is_open()) continue;
      left = detail::shorter(left, detail::between(now_, request.deadline));
      left = detail::shorter(left, request.attempt_left);
      if (request.state == State::in_flight) continue;
      if (may_be_sent(request)) {
        left = detail::shorter(left, pause_left_);
      } else {
        is_blocked = true;
      }
    }
    if (!is_blocked) return left;
    if constexpr (has_streams) left = detail::shorter(left, streams_.next_change());
    return detail::shorter(left, late_replies_.next_end());
  }

  // Receiving

  /// Returns the sink of the parser: of one type, so that its code exists once.
  template <class Sink>
  auto taker(Sink& sink) noexcept {
    return [this, &sink](const Frame& frame) { take(frame, sink); };
  }

  template <class Sink>
  void take(const Frame& frame, Sink& sink) {
    const Handle next = next_handle();
    // The only request is matched by id alone: comparing sizes first would take code.
    const detail::Meaning meaning = detail::meaning_of(frame, streams_.has(frame.id), !is_shared);
    const bool is_reset = meaning.kind == EventKind::reset;
    const bool is_error = meaning.kind == EventKind::board_error;
    if (is_error) count(&SessionStatistics::board_errors);
    if (is_reset) count(&SessionStatistics::resets);
    if (is_reset) forget_streams();
    Event event{.kind = meaning.kind, .command = meaning.command, .frame = frame};
    if constexpr (has_streams) {
      if (meaning.kind == EventKind::stream) {
        event.sample = streams_.take(frame);
        if (event.sample == Sample::yes && answer_with_sample(frame, sink, next)) return;
        if (event.sample != Sample::no) return report(event, sink);
      }
    }
    const auto [late, meant, candidates] = found_for(meaning);
    if constexpr (has_streams) {
      if (event.sample == Sample::no && candidates == 0) event.sample = streams_.adopt(frame);
    }
    const bool is_confirmation = meaning.kind == EventKind::confirmation;
    const bool is_unclear = is_error && candidates > 1 && !has_order(meant, meaning);
    if (meant != nullptr && !is_unclear && !belongs_to_earlier(*meant, is_confirmation, late)) {
      if (!is_reset) end_pause(*meant);
      if (is_confirmation) return confirm(*meant, event, sink);
      complete(*meant, is_error ? Outcome::board_error : outcome_of(*meant, frame), frame, sink);
      if (!is_reset) return;
    } else if (!is_reset && !is_unclear && late.entry != nullptr) {
      event.is_late = true;
      late_replies_.take(*late.entry, settings_.duplicates);
    } else if (is_shared && meaning.kind == EventKind::unsolicited) {
      take_in_series(event);
    }
    if (event.is_late) count(&SessionStatistics::late_replies);
    const bool is_unsolicited = event.kind == EventKind::unsolicited && !event.is_late;
    if (is_unsolicited) count(&SessionStatistics::unsolicited);
    report(event, sink);
    if (!is_reset) return;
    complete_all(Outcome::reset, sink, next);
    // The board may continue to respond until it restarts.
    late_replies_.limit(detail::ticks_of_ms(roles::reset_delay_ms) + settings_.late);
  }

  using Late = typename detail::LateReplies<capacity.late_replies, is_shared>::Match;

  /// The requests that a frame can answer.
  struct Found {
    Late late{};
    Request* meant{};
    std::size_t candidates{};
  };

  SBGC_ALWAYS_INLINE Found found_for(detail::Meaning meaning) noexcept {
    Found found = found_once(meaning);
    if constexpr (is_shared) {
      // A frame whose size fits no answer and no sample is an answer that does not decode.
      meaning.any_size = found.candidates == 0 && (meaning.kind == EventKind::unsolicited ||
                                                   meaning.kind == EventKind::stream);
      if (meaning.any_size) found = found_once(meaning);
    }
    return found;
  }
  SBGC_ALWAYS_INLINE Found found_once(const detail::Meaning& meaning) noexcept {
    Found found{late_replies_.match(meaning), nullptr, 0};
    found.candidates = found.late.count;
    const bool is_error = meaning.kind == EventKind::board_error;
    for (Request& request : requests_) {
      if (!request.is_in_flight() || !meaning(request.policy.responses)) continue;
      ++found.candidates;
      Request*& meant = found.meant;
      if (meant == nullptr || request.is_answered_before(*meant, is_error)) meant = &request;
    }
    return found;
  }

  /// Returns true if a frame answers the oldest of the requests that it can answer.
  static bool has_order(const Request* meant, const detail::Meaning& meaning) noexcept {
    if constexpr (!is_shared) return false;
    return meant != nullptr && meant->policy.has_effect && !meaning.is_anonymous();
  }

  /// Returns true if a frame that can be a response to `request` is one to an earlier request, or
  /// is a duplicate.
  static bool belongs_to_earlier(const Request& request, bool is_confirmation,
                                 const Late& late) noexcept {
    if (is_confirmation && request.duplicate_left != 0) return true;
    if (late.count == 0 || late.entry->frames == 0) return false;
    // Otherwise `late` refers to the end of a long operation.
    return request.policy.confirmations < 2 && (!is_shared || request.policy.has_effect);
  }

  /// Called when the board responds to `request`. If that was the last frame sent, the board has
  /// emptied its input buffer, which ends the pause. A response to a resent request may belong to
  /// its first transmission.
  void end_pause(const Request& request) noexcept {
    if (!settings_.until_response) return;
    if (request.handle != sent_.handle || request.transmissions != 1) return;
    pause_left_ = 0;
    sent_.pause = 0;
  }

  /// Returns the outcome of a request that the frame answers.
  static Outcome outcome_of(const Request& request, const Frame& frame) noexcept {
    const ResponseForm* const form = request.policy.responses.form_of(frame, true);
    return form->is_error ? Outcome::failed : Outcome::answered;
  }

  /// Counts a confirmation of `request`, which may complete it.
  template <class Sink>
  void confirm(Request& request, Event& event, Sink& sink) {
    const ResponsePolicy& policy = request.policy;
    ++request.confirmations;
    request.duplicate_left = settings_.duplicates;
    const Handle handle = request.handle;
    event.handle = handle;
    event.confirmation = request.confirmations;
    event.confirmations = policy.confirmations;
    report(event, sink);
    if (request.handle != handle) return;  // cancelled by the sink
    if (policy.result.is_failure(event.frame.body)) {
      complete(request, Outcome::failed, event.frame, sink);
    } else if (policy.response_required) {
      // A response message is still to come.
      if (is_shared && policy.series != 0) wait_for_more(request);
    } else if (request.confirmations >= policy.confirmations) {
      complete(request, Outcome::confirmed, event.frame, sink);
    } else {
      request.state = State::in_flight;
      request.attempt_left = finish_left(request);
    }
  }

  /// Returns the time until `finish` after the response could have arrived.
  Ticks finish_left(const Request& request) const noexcept {
    const Ticks late = settings_.late;
    return request.late_left > late ? request.late_left - late : 0;
  }

  /// Matches a message to the request whose response is preceded by a series of such messages.
  void take_in_series(Event& event) noexcept {
    for (Request& request : requests_) {
      if (!request.is_in_flight() || request.policy.series != event.frame.id) continue;
      event.kind = EventKind::series;
      event.handle = request.handle;
      request.attempts = 0;
      end_pause(request);
      return wait_for_more(request);
    }
  }

  /// The board has begun to respond: waits for the next message of a series, or the response.
  void wait_for_more(Request& request) noexcept {
    request.attempt_left = detail::shorter(request.timeout, finish_left(request));
  }

  /// Completes the requests older than `next` that have waited for a sample with this one. Returns
  /// true if there were any. The first event marks it as a sample.
  template <class Sink>
  bool answer_with_sample(const Frame& frame, Sink& sink, Handle next) {
    Sample sample = Sample::yes;
    for (Request& request : requests_) {
      if (!request.is_open() || !request.is_older_than(next)) continue;
      if (!streams_.has_taken(request.policy.stream) || !is_free(request)) continue;
      if (gate_for(request) != detail::Gate::sample) continue;
      complete(request, Outcome::answered, frame, sink, std::exchange(sample, Sample::no));
    }
    return sample == Sample::no;
  }

  // Completing requests

  /// Forgets all streams and requested changes: no stream runs any more. Must be called before any
  /// event of the same occurrence is reported, because the sink may request another stream.
  void forget_streams() noexcept {
    streams_.clear();
    for (Request& request : requests_) request.policy.stream = {};
  }

  /// The handle of the next accepted request: all others are older.
  Handle next_handle() const noexcept { return {last_handle_ + 1}; }

  /// Completes the requests older than `next`, excluding any that the sink sends meanwhile.
  template <class Sink>
  void complete_all(Outcome outcome, Sink& sink, Handle next) {
    for (Request& request : requests_) {
      if (request.is_open() && request.is_older_than(next)) {
        complete(request, outcome, no_frame, sink);
      }
    }
  }

  /// Frees a request, expects late replies if more may come, and reports the outcome.
  template <class Sink>
  void complete(Request& request, Outcome outcome, const Frame& frame, Sink& sink,
                Sample sample = Sample::no) {
    const ResponsePolicy& policy = request.policy;
    if (is_trial(request)) end_trial(outcome, frame);
    expect_late_reply(request, outcome);
    const bool done =
        outcome == Outcome::answered || outcome == Outcome::confirmed || outcome == Outcome::sent;
    if constexpr (has_streams) {
      if (policy.changes_stream()) streams_.settle(policy.stream, done);
      const bool is_over = outcome == Outcome::answered || outcome == Outcome::failed ||
                           outcome == Outcome::board_error;
      if (is_over && request.is_in_flight()) streams_.expect_none(policy);
    }
    if (policy.restarts_board && done) streams_.stop();
    const Event event{.kind = EventKind::completed,
                      .handle = request.handle,
                      .outcome = outcome,
                      .command = policy.responses.command,
                      .sample = streams_.has(frame.id) ? sample : Sample::none,
                      .frame = frame};
    request.close();
    report(event, sink);
  }

  bool is_trial(const Request& request) const noexcept {
    return can_change_framing && request.handle == trial_.handle;
  }

  void end_trial(Outcome outcome, const Frame& frame) noexcept {
    const bool is_spoken = outcome == Outcome::answered && frame.framing == trial_.framing;
    use(is_spoken ? trial_.framing : framing_);
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
    // The end of a request that was only sent is not awaited, and must not delay others.
    const bool is_one = policy.responses.form_count != 0 || (is_shared && outcome == Outcome::sent);
    const std::uint32_t each = is_one ? 1 : policy.confirmations;
    std::uint32_t expected = each * request.transmissions;
    const std::uint32_t seen = is_answered ? each : request.confirmations;
    expected = expected > seen ? expected - seen : 0;
    Ticks left = expected != 0 ? request.late_left : 0;
    const bool may_be_repeated =
        (is_answered || outcome == Outcome::confirmed) && settings_.duplicates != 0;
    if (may_be_repeated) left = detail::longer(left, settings_.duplicates);
    // Even if no time is left: the frame may not have been written yet, see written().
    if (expected != 0 || may_be_repeated) {
      late_replies_.add(request.handle, request.host, policy.responses, expected, left);
    }
  }

  /// Not inlined, because it is called in many places.
  template <class Sink>
  SBGC_NOINLINE static void report(const Event& event, Sink& sink) {
    sink(event);
  }

  /// The request that tries another framing.
  struct Trial {
    Handle handle{};
    Framing framing{};
  };

  static constexpr Frame no_frame{};
  /// A board answers a request for live data within this time. Assumption.
  static constexpr Ticks board_time = 10'000;
  /// The maximum amount by which a pause is shortened.
  static constexpr Ticks most_overdue = 5000;

  struct NoStatistics {};
  static constexpr bool has_statistics = capacity.optimize == Optimize::speed;
  using Statistics = std::conditional_t<has_statistics, SessionStatistics, NoStatistics>;

  void count(std::uint64_t SessionStatistics::*counter, std::uint64_t by = 1) noexcept {
    if constexpr (has_statistics) statistics_.*counter += by;
  }

  // The members that are used most come first, where short instructions reach them.
  Instant now_{std::numeric_limits<std::int64_t>::min()};
  std::uint64_t last_handle_{};
  Ticks pause_left_{};    // until the next request may be sent
  Ticks overdue_{};       // how late the next request is
  Ticks silence_left_{};  // until an incomplete frame is discarded
  detail::Transmission sent_{};
  bool is_due_after_pause_{};  // a request waits for nothing but the pause
  Trial trial_{};
  Framing framing_ = Formats::first;
  detail::Settings settings_;
  [[no_unique_address]] Statistics statistics_{};
  std::array<Request, capacity.requests> requests_{};
  detail::LateReplies<capacity.late_replies, is_shared> late_replies_;
  [[no_unique_address]] detail::Streams<capacity.streams> streams_{};
  BasicParser<Formats, capacity.optimize> parser_{};
  std::array<std::uint8_t, capacity.body + max_frame_size - max_body_size> out_{};
};

/// A session with a capacity that suits most hosts.
using Session = BasicSession<SessionCapacity{}>;

static_assert(sizeof(Session) <= 6144, "a session must fit into a small microcontroller");

}  // namespace sbgc
