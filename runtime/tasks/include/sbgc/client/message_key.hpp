/// Keys with which subscribers select messages of the board.
#pragma once

#include <cstdint>
#include <functional>
#include <utility>

#include <sbgc/message.hpp>

namespace sbgc::detail {

/// Identifies the messages that a subscriber receives.
struct MessageKey {
  std::uint8_t id{};
  Form form{};
  bool is_raw{};  ///< the subscriber gets each Frame with this id, also of unknown messages

  bool operator==(const MessageKey&) const = default;
};

template <Message M>
inline constexpr MessageKey key_of{static_cast<std::uint8_t>(M::command), M::form};

/// A callback with the decoded message of the subscribed key.
using MessageHandler = std::function<void(const void* message)>;

/// Wraps a typed handler.
template <class M>
MessageHandler typed_handler(std::function<void(const M&)> handler) {
  return [handler = std::move(handler)](const void* message) {
    handler(*static_cast<const M*>(message));
  };
}

}  // namespace sbgc::detail
