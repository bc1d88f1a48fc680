// What happens on the strand: bytes and events come and go.

#include <algorithm>
#include <utility>
#include <vector>

#include <asio/error.hpp>

#include <sbgc/io/clock.hpp>
#include <sbgc/text/status.hpp>

#include "conversation_state.hpp"

namespace sbgc::detail {

namespace {

constexpr const char* refused_words = ": the board refused: ";

/// In whole milliseconds, rounded up.
std::string milliseconds_text(Duration duration) {
  return std::to_string((duration.us + 999) / 1000) + " ms";
}

}  // namespace

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
    const SendResult sent = session_.send(request.id, request.body, request.policy, call->send);
    if (sent) {
      call->handle = sent.handle;
      in_session_.emplace(sent.handle.number, call);
      if (request.policy.stream.command != 0) learn_from_request(request, contexts_);
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
    case SendStatus::not_encodable: return command + ": " + to_string(refused.encoding);
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
      const std::string what =
          event.command == 0 ? "the board reports an error: "
                             : command_name(event.command, Direction::to_board) + refused_words;
      return notify({NoticeKind::board_error, what + describe(event.frame.id, event.frame.body),
                     static_cast<int>(roles::failure_code(event.frame)), event.command});
    }
    case EventKind::reset:
      deliver(event.frame);
      return notify({NoticeKind::board_reset, "the board is restarting"});
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
                       static_cast<int>(roles::failure_code(frame))};
  };
  switch (event.outcome) {
    case Outcome::answered: return reply(Ending::answered);
    case Outcome::confirmed: return reply(Ending::confirmed);
    case Outcome::unconfirmed: return reply(Ending::unconfirmed);
    case Outcome::sent: return reply(Ending::sent);
    case Outcome::failed: return refused(" has failed: ");
    case Outcome::board_error: return refused(refused_words);
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

}  // namespace sbgc::detail
