/// The untyped reply to a request.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include <sbgc/codec.hpp>
#include <sbgc/frame.hpp>
#include <sbgc/internal/message_type.hpp>

namespace sbgc {

struct Contexts;

/// How a successful request ended.
enum class ReplyKind : std::uint8_t {
  answered,     ///< with a response message
  confirmed,    ///< with all its confirmations
  unconfirmed,  ///< without a confirmation, although one was possible
  sent,         ///< without a reply, because the protocol has none
};

/// The reply to a request.
struct Reply {
  ReplyKind kind{};                  ///< how the call ended
  std::uint8_t id{};                 ///< of the response, or of the last confirmation; otherwise 0
  std::vector<std::uint8_t> body{};  ///< of that message
  /// The context from earlier messages that decoding needs, if any.
  std::shared_ptr<const Contexts> contexts{};
  Framing framing = basic_framing;  ///< of that message
};

namespace detail {

/// Decodes a message of this type, which requires context.
Status decode_in_context(const Reply& reply, const MessageType& type, void* out) noexcept;

template <class M>
Status read(const Reply& reply, M& out) noexcept {
  if constexpr (requires { typename M::Context; }) {
    return decode_in_context(reply, message_type<M>(), &out);
  } else {
    return decode(reply.body, out);
  }
}

}  // namespace detail
}  // namespace sbgc
