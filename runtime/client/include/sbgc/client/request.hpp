/// A request on its way to the board.
#pragma once

#include <cstdint>
#include <functional>

#include <sbgc/client/result.hpp>
#include <sbgc/message.hpp>
#include <sbgc/response_policy.hpp>
#include <sbgc/types.hpp>

namespace sbgc {

struct Availability;
struct Contexts;

namespace detail {

/// A request, encoded once, and what the library knows about it.
struct Request {
  std::uint8_t id{};
  BoundedBytes<max_body_size> body{};
  ResponsePolicy policy{};
  const char* command = "";  ///< "CMD_CONTROL"
  /// Takes from the request what later messages need to be read; empty for most.
  std::function<void(Contexts&)> teach{};
};

/// Makes the request for a board with these versions: fails if the board does not have the command
/// or, when `validate`, does not allow a value. If the board takes another form instead, that is
/// the result. The library has this function for every message to the board.
template <Message M>
Result<Request> prepare(const M& message, const Availability& versions, bool validate);

}  // namespace detail
}  // namespace sbgc
