/// What the library knows about a request from its bytes.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include <sbgc/client/conversation.hpp>
#include <sbgc/client/result.hpp>
#include <sbgc/dispatch.hpp>
#include <sbgc/meta.hpp>
#include <sbgc/response_policy.hpp>

namespace sbgc::detail {

/// A request that may be sent.
struct Request {
  std::uint8_t id{};
  std::vector<std::uint8_t> body;
  ResponsePolicy policy{};
  const MessageInfo* info{};
};

/// Looks at the frame of a request: whether a board with these versions has the command, and, if
/// wanted, whether it allows the values. If it takes another form instead, that is the result.
Result<Request> inspect(FrameBytes frame, const Availability& versions, bool validate);

/// Takes from a message to the board what later messages from it need to be read.
void learn_from_request(const Request& request, Contexts& contexts);
/// The same from a message from the board.
void learn_from_board(std::uint8_t id, std::span<const std::uint8_t> body, Contexts& contexts);

/// Which message a body from the board is, if it is any.
std::optional<MessageKey> key_of_received(std::uint8_t id, std::span<const std::uint8_t> body);
/// Whether that message can be read only with a context.
bool needs_context(std::uint8_t id, std::span<const std::uint8_t> body);

/// The request that ends the data stream that `request` starts.
std::vector<std::uint8_t> frame_that_ends_stream(const Request& request);

/// "CMD_BEEP_SOUND", or "command 89" if no message in this direction has the id.
std::string command_name(std::uint8_t id, Direction direction);
/// What the board says in a message that tells of a failure: "WRONG_STATE" in an error, or
/// "err_code ERR_FILE_NOT_FOUND (2)".
std::string describe(std::uint8_t id, std::span<const std::uint8_t> body);

}  // namespace sbgc::detail
