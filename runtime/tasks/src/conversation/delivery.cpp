#include "conversation/delivery.hpp"

#include <utility>

#include <sbgc/any.hpp>

#include "board_text.hpp"

namespace sbgc::detail {

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

}  // namespace sbgc::detail
