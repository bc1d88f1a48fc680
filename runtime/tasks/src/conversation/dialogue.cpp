#include "conversation/dialogue.hpp"

#include <algorithm>
#include <memory>
#include <utility>

#include <sbgc/any.hpp>
#include <sbgc/roles.hpp>
#include <sbgc/text/status.hpp>

#include "board_text.hpp"

namespace sbgc::detail {

namespace {

constexpr const char* refused_words = ": the board refused: ";

SessionOptions session_options(const ConnectOptions& options) {
  SessionOptions result;
  if (!options.pacing) result.pacing = {.shortest = {}, .longest = {}};
  result.duplicate_window = milliseconds(options.duplicate_window.count());
  result.stream_percent = static_cast<std::uint8_t>(std::min(options.stream_share_percent, 100U));
  return result;
}

ClientError no_answer(const Call& call) {
  const unsigned attempts = call.send.attempts;
  std::string text = std::string("no response to ") + call.request.command;
  if (attempts > 1) text += ", sent " + std::to_string(attempts) + " times,";
  text += " within " + milliseconds_text(call.send.timeout);
  if (attempts > 1) text += " each";
  return {ErrorCode::timeout, text};
}

/// True if decoding a message requires context.
bool needs_context(const Frame& frame) {
  bool needs = false;
  select(Direction::from_board, frame.id, frame.body.size(), [&]<class M>(Type<M>) {
    needs = requires { typename M::Context; }
    || IsAsked<M>;
  });
  return needs;
}

}  // namespace

Dialogue::Dialogue(const ConnectOptions& options, SharedCalls& calls, Delivery& delivery)
    : calls_(calls), delivery_(delivery), session_(session_options(options)) {}

Output Dialogue::advance(Instant now, bool can_write) {
  Output output;
  do {
    has_room_ = false;
    send_waiting();
    end_overdue(now);
    // No other write can start while one is pending, so the session is not polled.
    if (!can_write) break;
    output = session_.poll(now, [this](const Event& event) { handle(event); });
  } while (has_room_ && output.bytes.empty());
  if (has_room_) send_waiting();
  output.deadline = earlier(output.deadline, calls_->deadline());
  return output;
}

void Dialogue::feed(std::span<const std::uint8_t> bytes, Instant now) {
  session_.feed(bytes, now, [this](const Event& event) { handle(event); });
}

void Dialogue::send_waiting() {
  while (const CallPointer call =
             calls_->next_waiting([this](const Call& next) { return has_room(next); })) {
    const Request& request = call->request;
    const SendResult sent =
        request.tried_framing ? session_.try_framing(*request.tried_framing, request.id,
                                                     request.body, request.policy, call->send)
                              : session_.send(request.id, request.body, request.policy, call->send);
    if (sent) {
      call->handle = sent.handle;
      call->was_sent = true;
      in_session_.push_back(call);
      if (request.policy.changes_stream() && request.teach) request.teach(delivery_.contexts());
    } else if (calls_->take(call->id)) {
      calls_.complete(*call, refusal(*call, sent));
    }
  }
}

bool Dialogue::has_room(const Call& call) const noexcept {
  const ResponsePolicy& policy = call.request.policy;
  const std::size_t most = policy.stops        ? capacity.requests
                           : policy.has_effect ? most_effects
                                               : most_reads;
  return in_session_.size() < most;
}

CallPointer Dialogue::call_of(Handle handle) const {
  const auto place = std::find_if(in_session_.begin(), in_session_.end(),
                                  [&](const CallPointer& one) { return one->handle == handle; });
  return place == in_session_.end() ? nullptr : *place;
}

ClientError Dialogue::refusal(const Call& call, const SendResult& refused) const {
  const std::string command = call.request.command;
  switch (refused.status) {
    case SendStatus::over_budget: {
      const StreamUsage usage = session_.stream_usage();
      return {
          ErrorCode::overload,
          command + ": not enough bandwidth for the data stream: " + std::to_string(usage.limit) +
              " bytes/s are available for streams, " + std::to_string(usage.used) + " are in use"};
    }
    case SendStatus::too_many_streams:
      return {ErrorCode::overload, command + ": the board supports no further data stream"};
    case SendStatus::not_encodable:
      return {ErrorCode::overload, command + ": " + to_string(refused.encoding)};
    case SendStatus::timeout_too_long:
      return {ErrorCode::invalid, command + ": the timeout is longer than an hour"};
    default: return {ErrorCode::overload, command + ": too many requests at once"};
  }
}

void Dialogue::forget(const Call& call) {
  const auto is_call = [&](const CallPointer& one) { return one.get() == &call; };
  if (std::erase_if(in_session_, is_call) == 0) return;
  session_.cancel(call.handle, [](const Event&) {});
}

void Dialogue::end_overdue(Instant now) {
  while (const CallPointer call = calls_->take_overdue(now)) {
    forget(*call);
    calls_.complete(*call, overdue_result(*call));
  }
}

void Dialogue::show(const Event& event) {
  const Frame& frame = event.frame;
  if (frame.id == 0) return;
  // Confirmations and resets have their own events.
  const bool is_repeated = event.kind == EventKind::completed &&
                           (roles::is_confirmation(frame) || roles::is_reset(frame));
  if (is_repeated) return;
  const CallPointer call = call_of(event.handle);
  if (call && call->request.on_frame) call->request.on_frame(frame);
  delivery_.show({frame, call != nullptr, event.is_late, event.sample});
}

void Dialogue::handle(const Event& event) {
  const Frame& frame = event.frame;
  show(event);
  // A frame that is not a sample of a running stream may have other contents than its samples.
  const bool is_for_all = event.sample == Sample::none || event.sample == Sample::yes;
  switch (event.kind) {
    case EventKind::completed: {
      // Confirmations and resets are delivered with their own events.
      const bool is_told = roles::is_confirmation(frame) || roles::is_reset(frame);
      if (is_for_all && !is_told) {
        const CallPointer call = call_of(event.handle);
        const auto known = call ? known_to(*call, frame) : nullptr;
        delivery_.deliver(frame, known.get());
      }
      return handle_completion(event);
    }
    case EventKind::confirmation: {
      delivery_.deliver(frame);
      const CallPointer call = call_of(event.handle);
      if (call && call->on_confirmation) call->on_confirmation(event.confirmation);
      return;
    }
    case EventKind::series: {
      delivery_.deliver(frame);
      const CallPointer call = call_of(event.handle);
      if (call && call->on_series) call->on_series(frame);
      return;
    }
    case EventKind::board_error: {
      delivery_.deliver(frame);
      const std::string what =
          event.command == 0 ? "the board reports an error: "
                             : command_name(event.command, Direction::to_board) + refused_words;
      return delivery_.notify({NoticeKind::board_error, what + describe(frame.id, frame.body),
                               static_cast<int>(roles::failure_code(frame)), event.command});
    }
    case EventKind::reset:
      delivery_.deliver(frame);
      return delivery_.notify({NoticeKind::board_reset, "the board is restarting"});
    case EventKind::stream:
    case EventKind::unsolicited:
      if (is_for_all) delivery_.deliver(frame);
      return;
  }
}

void Dialogue::handle_completion(const Event& event) {
  has_room_ = true;
  const CallPointer call = call_of(event.handle);
  if (!call) return;
  std::erase(in_session_, call);
  if (calls_->take(call->id)) calls_.complete(*call, result_of(*call, event));
}

std::shared_ptr<const Contexts> Dialogue::known_to(const Call& call, const Frame& frame) const {
  if (!needs_context(frame)) return nullptr;
  auto contexts = std::make_shared<Contexts>(delivery_.contexts());
  if (call.request.teach) call.request.teach(*contexts);
  return contexts;
}

Reply Dialogue::reply_to(const Call& call, ReplyKind kind, const Frame& frame) const {
  return {
      kind, frame.id, {frame.body.begin(), frame.body.end()}, known_to(call, frame), frame.framing};
}

Result<Reply> Dialogue::result_of(const Call& call, const Event& event) const {
  const std::string command = call.request.command;
  const Frame& frame = event.frame;
  const auto refused = [&](const char* how) {
    return ClientError{ErrorCode::board_error, command + how + describe(frame.id, frame.body),
                       static_cast<int>(roles::failure_code(frame))};
  };
  switch (event.outcome) {
    case Outcome::answered: return reply_to(call, ReplyKind::answered, frame);
    case Outcome::confirmed: return reply_to(call, ReplyKind::confirmed, frame);
    case Outcome::unconfirmed: return reply_to(call, ReplyKind::unconfirmed, frame);
    case Outcome::sent: return reply_to(call, ReplyKind::sent, frame);
    case Outcome::failed: return refused(" has failed: ");
    case Outcome::board_error: return refused(refused_words);
    case Outcome::timeout: return no_answer(call);
    case Outcome::superseded: return superseded_error(call);
    case Outcome::indistinct:
      return ClientError{ErrorCode::overload,
                         command +
                             ": a data stream of the same message leaves no time to tell its "
                             "answer from the samples"};
    case Outcome::reset:
      return ClientError{ErrorCode::board_reset,
                         "the board restarted before " + command + " was done"};
    case Outcome::link_lost:
      return ClientError{ErrorCode::link_lost, command + ": the connection is lost"};
    case Outcome::cancelled:
    case Outcome::none: break;
  }
  return ClientError{ErrorCode::cancelled, command + " was canceled"};
}

void Delivery::deliver(const Frame& frame, const Contexts* known) {
  const Contexts& contexts = known != nullptr ? *known : contexts_;
  MessageHandlers::call(messages_->with_key({frame.id, {}, true}),
                        [&](const auto& handler) { handler(&frame); });
  const MessageType* const type =
      find_message(Direction::from_board, frame.id, frame.body.size(), contexts);
  if (type == nullptr) {
    const auto subscribers =
        messages_->count([&](const MessageKey& key) { return key.id == frame.id && !key.is_raw; });
    return report_unreadable(frame, {Code::unknown_form}, subscribers);
  }
  const auto handlers = messages_->with_key({frame.id, type->form});
  if (handlers.empty() && type->operations->teach == nullptr) return;
  AnyMessage message = type->make();
  const Status status = message.decode(frame.body, contexts);
  if (!status) return report_unreadable(frame, status, handlers.size());
  message.teach(contexts_);
  MessageHandlers::call(handlers, [&](const auto& handler) { handler(message.address()); });
}

void Delivery::report_unreadable(const Frame& frame, const Status& status,
                                 std::size_t subscribers) {
  if (subscribers == 0) return;
  unreadable_ += subscribers;
  std::string text = undecodable(status, frame.id, frame.body, contexts_);
  if (text == last_unreadable_) return;
  last_unreadable_ = text;
  notify({NoticeKind::unreadable, std::move(text), 0, frame.id});
}

void Delivery::show(const BoardFrame& frame) {
  FrameHandlers::call(frames_->with_key({}), [&](const auto& handler) { handler(frame); });
}

void Delivery::notify(const Notice& notice) {
  NoticeHandlers::call(notices_->with_key({}), [&](const auto& handler) { handler(notice); });
}

Result<msg::BoardInfoRequestExt> opening_request(const std::string& password) {
  msg::BoardInfoRequestExt request;
  auto& text = request.password.emplace();
  if (!text.assign(password) || !is_evident_text(password.data(), password.size())) {
    return ClientError{ErrorCode::invalid, "a password has 1 to " +
                                               std::to_string(text.capacity()) +
                                               " bytes, and no control characters"};
  }
  return request;
}

std::vector<std::uint8_t> opening_frame(const std::optional<std::string>& password) {
  if (!password) return {};
  const auto request = opening_request(*password);
  if (!request) return {};
  std::vector<std::uint8_t> frame(max_frame_size);
  frame.resize(encode_frame(*request, frame).size);
  return frame;
}

}  // namespace sbgc::detail
