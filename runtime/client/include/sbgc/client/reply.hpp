/// What comes back for a request, before its type is known.
#pragma once

#include <cstdint>
#include <memory>
#include <span>

#include <sbgc/codec.hpp>
#include <sbgc/frame.hpp>
#include <sbgc/types.hpp>

namespace sbgc {

struct Contexts;

/// How a request ended well.
enum class ReplyKind : std::uint8_t {
  answered,     ///< with the message that answers it
  confirmed,    ///< with all its confirmations
  unconfirmed,  ///< a confirmation was possible, but none came
  sent,         ///< nothing comes back for it
};

/// What came back for a request.
struct Reply {
  ReplyKind kind{};
  std::uint8_t id{};                   ///< of the answer, or of the last confirmation; else 0
  BoundedBytes<max_body_size> body{};  ///< its body
  /// What earlier messages say about how to read it, if it matters.
  std::shared_ptr<const Contexts> contexts{};
};

namespace detail {

/// Decodes a message that cannot be read without its context. The library has it for each of them.
template <class M>
Status decode_in_context(const Reply& reply, M& out) noexcept;

template <class M>
Status read(const Reply& reply, M& out) noexcept {
  if constexpr (requires { typename M::Context; }) {
    return decode_in_context(reply, out);
  } else {
    return decode(std::span<const std::uint8_t>(reply.body.data(), reply.body.size()), out);
  }
}

}  // namespace detail
}  // namespace sbgc
