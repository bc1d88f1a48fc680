#include <memory>
#include <optional>
#include <utility>

#include <sbgc/io/clock.hpp>

#include "state.hpp"
#include "threads.hpp"

namespace sbgc::detail {

ClientError handler_waits_error() {
  return {ErrorCode::invalid, "a handler must not wait for its own client"};
}

namespace {

constexpr const char* raw_name = "the request";

/// Returns nothing if no value arrives in time. Virtual time passes meanwhile.
template <class T>
std::optional<T> wait_until(const Conversation::State& state, Waiter<T>& waiter, Instant deadline) {
  io::detail::VirtualTime* const time = state.clock().virtual_time();
  if (time == nullptr) return waiter.wait_until(io::to_chrono(deadline));
  time->run([&] { return waiter.is_ready(); }, deadline);
  return waiter.wait_until(io::Clock::time_point::min());
}

/// Starts an operation with `begin(handler)` and waits for its result.
template <class T, class Begin>
Result<T> wait_for(Conversation::State& state, const Begin& begin) {
  if (state.runs_in_this_thread()) {
    return handler_waits_error();
  }
  const auto waiter = std::make_shared<Waiter<Result<T>>>();
  const CallId id = next_call_id();
  const Instant deadline =
      begin(id, [waiter](Result<T> result) { waiter->put(std::move(result)); });
  if (auto result = wait_until(state, *waiter, deadline)) return *std::move(result);
  state.end_overdue(deadline);
  // A result is being delivered by some thread: this one, or another one that came first.
  return waiter->wait();
}

}  // namespace

Request Conversation::prepare(RawRequest request) {
  return {.id = request.id,
          .body = std::move(request.body),
          .policy = request.policy,
          .host = request.host,
          .is_motion = request.policy.moves,
          .command = raw_name,
          .on_frame = std::move(request.on_frame)};
}

CallId Conversation::start(Result<Request> request, const CallOptions& options,
                           ReplyHandler handler) const {
  const CallId id = next_call_id();
  state_->start(id, std::move(request), options, std::move(handler));
  return id;
}

void Conversation::cancel(CallId id) const {
  state_->end(id, {ErrorCode::cancelled, "the call was canceled"});
}

Result<Reply> Conversation::call(Result<Request> request, const CallOptions& options) const {
  return wait_for<Reply>(*state_, [&](CallId id, ReplyHandler handler) {
    return state_->start(id, std::move(request), options, std::move(handler));
  });
}

Subscription Conversation::subscribe(MessageKey key, MessageHandler handler) const {
  return Subscription(state_->delivery().subscribe(key, std::move(handler)));
}

Subscription Conversation::on_notice(std::function<void(const Notice&)> handler) const {
  return Subscription(state_->delivery().on_notice(std::move(handler)));
}

Subscription Conversation::on_frame(std::function<void(const BoardFrame&)> handler) const {
  return Subscription(state_->delivery().on_frame(std::move(handler)));
}

CallId Conversation::start_stream(StreamRequests requests, MessageKey key, MessageHandler handler,
                                  const CallOptions& options, StreamHandler done) const {
  const CallId id = next_call_id();
  state_->start_stream(id, std::move(requests), key, std::move(handler), options, std::move(done));
  return id;
}

Result<Subscription> Conversation::stream(StreamRequests requests, MessageKey key,
                                          MessageHandler handler,
                                          const CallOptions& options) const {
  return wait_for<Subscription>(*state_, [&](CallId id, StreamHandler done) {
    return state_->start_stream(id, std::move(requests), key, std::move(handler), options,
                                std::move(done));
  });
}

Availability Conversation::versions() const noexcept { return identity().versions(); }

const BoardIdentity& Conversation::identity() const noexcept { return state_->identity(); }

std::string Conversation::description() const { return state_->description(); }

ClientStatistics Conversation::statistics() const { return state_->statistics(); }

void Conversation::close() const noexcept {
  if (state_) state_->close();
}

}  // namespace sbgc::detail
