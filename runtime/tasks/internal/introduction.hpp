/// The first request of a connection.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <sbgc/message.hpp>
#include <sbgc/messages/system.hpp>
#include <sbgc/result.hpp>

namespace sbgc::detail {

/// Returns the request for the introduction of a board whose port wants this password. Fails if it
/// cannot be a password. The error does not tell it.
inline Result<msg::BoardInfoRequestExt> opening_request(const std::string& password) {
  msg::BoardInfoRequestExt request;
  auto& text = request.password.emplace();
  if (!text.assign(password) || !is_evident_text(password.data(), password.size())) {
    return ClientError{ErrorCode::invalid, "a password has 1 to " +
                                               std::to_string(text.capacity()) +
                                               " bytes, and no control characters"};
  }
  return request;
}

/// Returns the frame of the first request, which a search for the line sends; empty for the usual
/// one.
inline std::vector<std::uint8_t> opening_frame(const std::optional<std::string>& password) {
  if (!password) return {};
  const auto request = opening_request(*password);
  if (!request) return {};
  std::vector<std::uint8_t> frame(max_frame_size);
  frame.resize(encode_frame(*request, frame).size);
  return frame;
}

}  // namespace sbgc::detail
