#include "delivery.hpp"

#include <utility>

namespace sbgc::detail {

std::unique_ptr<Subscription::Registration> Delivery::subscribe(
    MessageKey key, Conversation::MessageHandler handler) {
  return messages_->add(key, std::move(handler));
}

std::unique_ptr<Subscription::Registration> Delivery::on_notice(
    std::function<void(const Notice&)> handler) {
  return notices_->add({}, std::move(handler));
}

std::unique_ptr<Subscription::Registration> Delivery::on_frame(
    std::function<void(const BoardFrame&)> handler) {
  return frames_->add({}, std::move(handler));
}

void Delivery::deliver(const Frame& frame) {
  select(Direction::from_board, frame.id, frame.body.size(), [&]<class M>(Type<M>) {
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
    if (!status) {
      unreadable_ += handlers.size();
      return;
    }
    contexts_.learn(message);
    MessageHandlers::call(handlers, [&](const auto& handler) { handler(&message); });
  });
}

void Delivery::show(const BoardFrame& frame) {
  FrameHandlers::call(frames_->with_key({}), [&](const auto& handler) { handler(frame); });
}

void Delivery::notify(const Notice& notice) {
  NoticeHandlers::call(notices_->with_key({}), [&](const auto& handler) { handler(notice); });
}

}  // namespace sbgc::detail
