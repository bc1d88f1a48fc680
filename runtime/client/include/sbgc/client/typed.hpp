/// From messages to bytes and back, for the calls of Client and AsyncClient.
#pragma once

#include <array>
#include <chrono>
#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <span>
#include <type_traits>
#include <utility>
#include <variant>

#include <sbgc/client/call_result.hpp>
#include <sbgc/client/conversation.hpp>
#include <sbgc/client/reply.hpp>
#include <sbgc/client/result.hpp>
#include <sbgc/message.hpp>
#include <sbgc/roles.hpp>

namespace sbgc {

namespace detail {

ClientError encode_error(Status status);
ClientError decode_error(Status status, const Reply& reply);
ClientError missing_answer(const Reply& reply);
/// The interval of a data stream in the counts of the protocol, of which the largest is `most`.
Result<std::int64_t> stream_interval_count(std::chrono::milliseconds interval, std::int64_t most);

/// A request in its frame, or why it has none.
class EncodedRequest {
 public:
  template <Message M>
  explicit EncodedRequest(const M& request) noexcept : written_(encode_frame(request, bytes_)) {
    static_assert(M::direction != Direction::from_board, "only the board sends this message");
  }

  explicit operator bool() const noexcept { return static_cast<bool>(written_); }
  FrameBytes frame() const noexcept { return {bytes_.data(), written_.size}; }
  ClientError error() const { return encode_error(written_.status); }

 private:
  std::array<std::uint8_t, max_frame_size> bytes_{};
  WriteResult written_;
};

template <class T>
struct IsOptional : std::false_type {};
template <class T>
struct IsOptional<std::optional<T>> : std::true_type {};

/// One of several messages that may answer: the first that the body is.
template <class... Ms>
Status read(const Received& received, std::variant<Ms...>& out) noexcept {
  Status status{Code::unknown_form};
  const auto try_one = [&](auto message) {
    if (static_cast<std::uint8_t>(message.command) != received.id) return false;
    status = read(received, message);
    if (status) out = message;
    return static_cast<bool>(status);
  };
  static_cast<void>((try_one(Ms{}) || ...));
  return status;
}

/// The answer to an M in what came back for it.
template <class M>
Result<CallAnswer<M>> read_answer(const Result<Reply>& reply) {
  using Answer = CallAnswer<M>;
  if (!reply) return reply.error();
  if constexpr (std::is_void_v<Answer>) {
    return {};
  } else {
    const bool is_answered = reply->ending == Ending::answered;
    Answer answer{};
    Status status{};
    if constexpr (IsOptional<Answer>::value) {
      if (!is_answered) return answer;
      status = read(reply->received(), answer.emplace());
    } else {
      if (!is_answered) return missing_answer(*reply);
      status = read(reply->received(), answer);
    }
    if (!status) return decode_error(status, *reply);
    return answer;
  }
}

/// The registration of a data stream with an interval, or why there is no such interval.
template <class Request>
Result<Request> stream_request(std::chrono::milliseconds interval) {
  Request request{};
  auto& chosen = roles::stream_interval(request);
  using Interval = std::remove_reference_t<decltype(chosen)>;
  const auto count =
      stream_interval_count(interval, std::numeric_limits<typename Interval::raw_type>::max());
  if (!count) return count.error();
  chosen = Interval(static_cast<typename Interval::raw_type>(*count));
  return request;
}

/// Makes `request` be about the stream of M.
template <class M, class Request>
void choose_stream(Request& request) noexcept {
  constexpr bool is_streamed = roles::StreamMessages::contains<M>;
  static_assert(
      is_streamed,
      "the board has no stream of this message: sbgc::roles::StreamMessages are possible");
  if constexpr (is_streamed) {
    auto& command = roles::stream_command(request);
    command = static_cast<std::remove_reference_t<decltype(command)>>(M::command);
  }
}

/// Decodes messages for a handler that takes them typed.
template <class M>
Conversation::MessageHandler typed_handler(std::function<void(const M&)> handler) {
  return [handler = std::move(handler)](const Received& received) {
    M message{};
    const bool readable = static_cast<bool>(read(received, message));
    if (readable) handler(message);
    return readable;
  };
}

}  // namespace detail

}  // namespace sbgc
