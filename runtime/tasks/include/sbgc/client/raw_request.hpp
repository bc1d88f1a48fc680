/// Requests and frames whose types are not known to the program, for gateways.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include <sbgc/frame.hpp>
#include <sbgc/response_policy.hpp>
#include <sbgc/result.hpp>
#include <sbgc/session/event.hpp>

namespace sbgc {

/// A request whose body is already encoded.
struct RawRequest {
  std::uint8_t id{};
  std::vector<std::uint8_t> body{};  ///< at most max_body_size bytes
  ResponsePolicy policy{};           ///< its response, and the timeout for it
  std::uint16_t host{};              ///< whose request it is; see SendOptions::host
  /// Called on the client's thread with each frame from the board that belongs to this request: its
  /// response, its confirmations, and errors.
  std::function<void(const Frame&)> on_frame{};
};

/// Returns a request with the policy of its message, also if it has more bytes than boards know,
/// which they ignore (see <sbgc/surplus.hpp>). A request that no message describes is sent once,
/// and any body with the same id, or a confirmation, is its response. Errors: `invalid` if the body
/// is too long or the id is 0.
Result<RawRequest> raw_request(std::uint8_t id, std::span<const std::uint8_t> body);

/// A frame from the board.
struct BoardFrame {
  Frame frame{};           ///< a view, valid during the call
  bool belongs_to_call{};  ///< it belongs to a call of this client
  bool is_late{};          ///< the response to a call that has ended
  Sample sample{};         ///< whether it is a sample of a data stream
};

}  // namespace sbgc
