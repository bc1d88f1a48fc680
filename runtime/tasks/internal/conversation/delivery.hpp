/// Delivery of the board's messages to subscribers.
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <utility>

#include <sbgc/client/message_key.hpp>
#include <sbgc/client/notice.hpp>
#include <sbgc/client/raw_request.hpp>
#include <sbgc/client/subscription.hpp>
#include <sbgc/dispatch.hpp>
#include <sbgc/frame.hpp>

#include "handlers.hpp"

namespace sbgc::detail {

/// With locks, subscribing is thread-safe. Everything else belongs to the owner's thread or strand.
class Delivery {
 public:
  explicit Delivery(MakeLock make_lock = no_lock)
      : messages_(std::make_shared<MessageHandlers>(make_lock)),
        frames_(std::make_shared<FrameHandlers>(make_lock)),
        notices_(std::make_shared<NoticeHandlers>(make_lock)) {}

  using Registration = std::unique_ptr<Subscription::Registration>;
  Registration subscribe(MessageKey key, MessageHandler handler) {
    return messages_->add(key, std::move(handler));
  }
  Registration on_notice(std::function<void(const Notice&)> handler) {
    return notices_->add({}, std::move(handler));
  }
  Registration on_frame(std::function<void(const BoardFrame&)> handler) {
    return frames_->add({}, std::move(handler));
  }

  /// Decodes a message once, if a subscriber or a context needs it; `known` are the facts for an
  /// answer, if they are not those of the conversation.
  void deliver(const Frame& frame, const Contexts* known = nullptr);
  void notify(const Notice& notice);
  /// Passes on a frame as it is.
  void show(const BoardFrame& frame);

  /// Facts from earlier messages that decoding later ones needs.
  Contexts& contexts() noexcept { return contexts_; }
  /// The number of messages for a subscriber that could not be decoded.
  std::uint64_t unreadable() const noexcept { return unreadable_; }

 private:
  /// Notifies of a message that does not decode, unless the last one was the same to the user: a
  /// stream of them has one notice.
  void report_unreadable(const Frame& frame, const Status& status, std::size_t subscribers);

  using MessageHandlers = Handlers<MessageKey, void(const void*)>;
  using FrameHandlers = Handlers<int, void(const BoardFrame&)>;
  using NoticeHandlers = Handlers<int, void(const Notice&)>;

  std::shared_ptr<MessageHandlers> messages_;
  std::shared_ptr<FrameHandlers> frames_;
  std::shared_ptr<NoticeHandlers> notices_;
  Contexts contexts_;
  std::atomic<std::uint64_t> unreadable_{};
  std::string last_unreadable_;  // its notice
};

}  // namespace sbgc::detail
