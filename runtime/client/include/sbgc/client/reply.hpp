/// What comes from the board, before its type is known.
#pragma once

#include <cstdint>
#include <memory>
#include <span>

#include <sbgc/codec.hpp>
#include <sbgc/frame.hpp>
#include <sbgc/types.hpp>

namespace sbgc {

struct Contexts;

/// One message from the board. A view: valid during the call that hands it out.
struct Received {
  std::uint8_t id{};
  std::span<const std::uint8_t> body{};
  const Contexts* contexts{};  ///< what earlier messages say about how to read it, if it matters
};

/// How a request ended well.
enum class Ending : std::uint8_t {
  answered,     ///< with the message that answers it
  confirmed,    ///< with all its confirmations
  unconfirmed,  ///< a confirmation was hoped for, but none came
  sent,         ///< nothing comes back for it
};

/// What came back for a request.
struct Reply {
  Ending ending{};
  std::uint8_t id{};                   ///< of the answer, or of the last confirmation; else 0
  BoundedBytes<max_body_size> body{};  ///< its body
  std::shared_ptr<const Contexts> contexts{};

  Received received() const noexcept { return {id, {body.data(), body.size()}, contexts.get()}; }
};

namespace detail {

/// Decodes a message that cannot be read without its context. The library has it for each of them.
template <class M>
Status decode_in_context(const Received& received, M& out) noexcept;

template <class M>
Status read(const Received& received, M& out) noexcept {
  if constexpr (requires { typename M::Context; }) {
    return decode_in_context(received, out);
  } else {
    return decode(received.body, out);
  }
}

}  // namespace detail
}  // namespace sbgc
