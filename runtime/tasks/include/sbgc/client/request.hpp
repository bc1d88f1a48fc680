/// A request to the board.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include <sbgc/frame.hpp>
#include <sbgc/internal/message_type.hpp>
#include <sbgc/message.hpp>
#include <sbgc/response_policy.hpp>
#include <sbgc/result.hpp>

namespace sbgc {

class AnyMessage;
struct Availability;
struct Contexts;

/// Identifies a call, from the task that begins it to its end. Unique in the process, from 1.
using CallId = std::uint64_t;

/// The place of a task in the order in which the tasks of a client began, from 1. A later motion
/// supersedes an earlier one.
using TaskNumber = std::uint64_t;

namespace detail {

CallId next_call_id() noexcept;

/// An encoded request and its metadata.
struct Request {
  std::uint8_t id{};
  std::vector<std::uint8_t> body{};
  ResponsePolicy policy{};
  std::uint16_t host{};
  bool is_motion{};          ///< it commands motion and does nothing else, or stops all
  const char* command = "";  ///< for example "CMD_CONTROL"
  /// Stores the facts of the request that decoding later messages needs; empty for most requests.
  std::function<void(Contexts&)> teach{};
  /// If set, the request tries this framing; see BasicSession::try_framing().
  std::optional<Framing> tried_framing{};
  /// Called on the strand with each frame that belongs to the request.
  std::function<void(const Frame&)> on_frame{};
};

/// Returns the policy of a request; an empty one for a message that only the board sends.
ResponsePolicy policy_of(const AnyMessage& message);

/// Encodes a request, with its surplus, for a board with these versions. Fails if the board does
/// not have the command, if `validate` is set and the board does not allow a value, and for a
/// message that only boards send. If the board takes another form of the message, encodes that one.
Result<Request> prepare(const AnyMessage& message, const Availability& versions, bool validate);

/// The same for a message of this type, without surplus.
Result<Request> prepare(const MessageType& type, const void* message, const Availability& versions,
                        bool validate);

template <Message M>
Result<Request> prepare(const M& message, const Availability& versions, bool validate) {
  return prepare(message_type<M>(), &message, versions, validate);
}

/// Returns the error if a board with these versions does not have this message, and so cannot send
/// a data stream of it.
std::optional<ClientError> stream_refusal(const MessageType& type, const Availability& versions);

}  // namespace detail
}  // namespace sbgc
