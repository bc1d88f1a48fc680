#include "delivery.hpp"

#include <utility>

#include "board_text.hpp"

namespace sbgc::detail {

void Delivery::deliver(const Frame& frame) {
  MessageHandlers::call(messages_->with_key({frame.id, {}, true}),
                        [&](const auto& handler) { handler(&frame); });
  const auto use = [&]<class M>(Type<M>) {
    const MessageKey key{frame.id, M::form};
    const auto handlers = messages_->with_key(key);
    if (handlers.empty() && !Contexts::learns_from<M>) return;
    M message{};
    Status status{};
    if constexpr (requires { contexts_.of(message); }) {
      status = decode(frame.body, message, contexts_.of(message));
    } else {
      status = decode(frame.body, message);
    }
    if (!status) return report_unreadable(frame, status, handlers.size());
    contexts_.learn(message);
    MessageHandlers::call(handlers, [&](const auto& handler) { handler(&message); });
  };
  const Code code = select(Direction::from_board, frame.id, frame.body.size(), use);
  if (code != Code::unknown_form) return;
  const auto subscribers =
      messages_->count([&](const MessageKey& key) { return key.id == frame.id && !key.is_raw; });
  report_unreadable(frame, {code}, subscribers);
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

}  // namespace sbgc::detail
