/// Typed wrappers of requests and replies, for all clients.
#pragma once

#include <chrono>
#include <concepts>
#include <cstdint>
#include <limits>
#include <optional>
#include <type_traits>
#include <utility>
#include <variant>

#include <sbgc/client/call_result.hpp>
#include <sbgc/client/message_key.hpp>
#include <sbgc/client/reply.hpp>
#include <sbgc/message.hpp>
#include <sbgc/result.hpp>
#include <sbgc/roles.hpp>

namespace sbgc::detail {

ClientError decode_error(Status status, const Reply& reply);
ClientError missing_response(const Reply& reply);
/// The error of a call whose required confirmation did not arrive.
ClientError unconfirmed_error();
/// Decodes a reply as a message whose type is known only at run time. A template, because
/// AnyMessage is not complete here.
template <std::same_as<AnyMessage> Any>
Result<std::optional<Any>> read_any(const Result<Reply>& reply);
/// Converts the interval of a data stream to the counts of the protocol, at most `most`.
Result<std::int64_t> stream_interval_count(std::chrono::milliseconds interval, std::int64_t most);

template <class T>
struct IsOptional : std::false_type {};
template <class T>
struct IsOptional<std::optional<T>> : std::true_type {};

/// Decodes the reply as the first of several message types that fits.
template <class... Ms>
Status read(const Reply& reply, std::variant<Ms...>& out) noexcept {
  Status status{Code::unknown_form};
  const auto try_one = [&](auto message) {
    if (static_cast<std::uint8_t>(message.command) != reply.id) return false;
    status = read(reply, message);
    if (status) out = message;
    return static_cast<bool>(status);
  };
  static_cast<void>((try_one(Ms{}) || ...));
  return status;
}

/// Decodes the response to an M from its reply.
template <class M>
Result<CallResponse<M>> read_response(const Result<Reply>& reply) {
  using Answer = CallResponse<M>;
  if (!reply) return reply.error();
  if (reply->kind == ReplyKind::unconfirmed) return unconfirmed_error();
  if constexpr (std::same_as<M, AnyMessage>) {
    return read_any<M>(reply);
  } else if constexpr (std::is_void_v<Answer>) {
    return {};
  } else {
    const bool is_answered = reply->kind == ReplyKind::answered;
    Answer answer{};
    Status status{};
    if constexpr (IsOptional<Answer>::value) {
      if (!is_answered) return answer;
      status = read(*reply, answer.emplace());
    } else {
      if (!is_answered) return missing_response(*reply);
      status = read(*reply, answer);
    }
    if (!status) return decode_error(status, *reply);
    return answer;
  }
}

/// Returns the request for a data stream with this interval, or an error if it cannot be expressed.
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

/// Makes `request` select the stream of M.
template <class M, class Request>
void choose_stream(Request& request) noexcept {
  constexpr bool is_streamed = roles::StreamMessages::contains<M>;
  static_assert(is_streamed,
                "the board has no data stream of this message; see sbgc::roles::StreamMessages");
  if constexpr (is_streamed) {
    auto& command = roles::stream_command(request);
    command = static_cast<std::remove_reference_t<decltype(command)>>(M::command);
  }
}

/// Returns the request that ends the data stream that `request` starts.
template <Message Request>
Request stream_end(Request request) noexcept {
  auto& interval = roles::stream_interval(request);
  interval = std::remove_reference_t<decltype(interval)>(roles::stream_end);
  return request;
}

/// Returns the interval of the data stream that `request` starts.
template <Message Request>
std::chrono::microseconds stream_interval(Request request) noexcept {
  return std::chrono::microseconds(std::int64_t{roles::stream_interval_us} *
                                   roles::stream_interval(request).raw());
}

/// Returns the key of the frames of the data stream that `request` selects.
template <Message Request>
MessageKey raw_key(Request request) noexcept {
  return {.id = static_cast<std::uint8_t>(roles::stream_command(request)), .is_raw = true};
}

}  // namespace sbgc::detail
