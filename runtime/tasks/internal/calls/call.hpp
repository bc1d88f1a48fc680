/// A call and its deadline.
#pragma once

#include <atomic>
#include <functional>
#include <memory>
#include <string>

#include <sbgc/client/options.hpp>
#include <sbgc/client/reply.hpp>
#include <sbgc/client/request.hpp>
#include <sbgc/session.hpp>

namespace sbgc::detail {

using ReplyHandler = std::function<void(Result<Reply>)>;

struct Call {
  CallId id{};
  TaskNumber task{};  ///< that makes it; 0: none
  Request request{};
  SendOptions send{};
  Instant deadline = Instant::never;
  Duration allowed{};  ///< from its start to the deadline
  std::function<void(unsigned)> on_confirmation{};
  std::function<void(const Frame&)> on_series{};
  ReplyHandler handler{};
  Handle handle{};  ///< in the session, once sent; only Dialogue uses it
  std::atomic<bool> was_sent = false;
};

using CallPointer = std::shared_ptr<Call>;

/// Creates a call that starts at `now`. `options` override `defaults`.
CallPointer make_call(CallId id, Request request, const CallOptions& options,
                      const ConnectOptions& defaults, Instant now, ReplyHandler handler);
/// Returns whole milliseconds, rounded up: "150 ms".
std::string milliseconds_text(Duration duration);
/// The error of a call that was not sent because of a stop, or of a later motion.
ClientError superseded_error(const Call& call);
/// How a call ends whose deadline has passed: with an error, unless only a confirmation is missing
/// that the board may leave out.
Result<Reply> overdue_result(const Call& call);

}  // namespace sbgc::detail
