// Data streams: running as long as somebody is subscribed to them.

#include <memory>
#include <utility>
#include <vector>

#include "conversation_state.hpp"

namespace sbgc::detail {

/// A data stream as long as someone listens to it.
class Conversation::State::StreamHold : public Subscription::Hold {
 public:
  StreamHold(std::unique_ptr<Hold> membership, std::weak_ptr<State> state, StreamKey key)
      : membership_(std::move(membership)), state_(std::move(state)), key_(std::move(key)) {}
  StreamHold(const StreamHold&) = delete;
  StreamHold& operator=(const StreamHold&) = delete;
  // NOLINTNEXTLINE(bugprone-exception-escape): only if there is no memory left
  ~StreamHold() override {
    membership_.reset();
    if (const auto state = state_.lock()) state->leave_stream(key_);
  }

 private:
  std::unique_ptr<Hold> membership_;
  std::weak_ptr<State> state_;
  StreamKey key_;
};

auto Conversation::State::start_stream(FrameBytes frame, MessageKey key, MessageHandler handler,
                                       const CallOptions& options, StreamHandler done) -> Begun {
  auto request = inspect(frame, board_.versions(), options.validate);
  if (request && request->policy.stream.command == 0) {
    request = ClientError{ErrorCode::invalid,
                          std::string(request->info->command) + " starts no data stream"};
  }
  if (!request) {
    done(std::move(request).error());
    return {};
  }
  const StreamChange& change = request->policy.stream;
  const StreamKey stream{change.command, change.config};
  {
    const std::lock_guard lock(mutex_);
    Stream& entry = streams_[stream];
    ++entry.subscriptions;
    entry.end = frame_that_ends_stream(*request);
  }
  // Subscribed before the first sample can come.
  auto hold = std::make_unique<StreamHold>(messages_->add(key, std::move(handler)),
                                           weak_from_this(), stream);
  return begin(*std::move(request), options,
               [this, stream, hold = std::make_shared<std::unique_ptr<StreamHold>>(std::move(hold)),
                done = std::move(done)](Result<Reply> reply) {
                 if (!reply) {
                   const ErrorCode code = reply.error().code;
                   if (code == ErrorCode::timeout || code == ErrorCode::cancelled) {
                     // The board may have heard the request: its end has to be asked for, too.
                     const std::lock_guard lock(mutex_);
                     streams_[stream].is_running = true;
                   }
                   hold->reset();
                   return done(std::move(reply).error());
                 }
                 {
                   const std::lock_guard lock(mutex_);
                   streams_[stream].is_running = true;
                 }
                 done(Subscription(std::move(*hold)));
               });
}

void Conversation::State::leave_stream(const StreamKey& key) {
  std::vector<std::uint8_t> end;
  {
    const std::lock_guard lock(mutex_);
    const auto place = streams_.find(key);
    if (place == streams_.end() || --place->second.subscriptions != 0) return;
    if (phase_ == Phase::closed) return;  // shut() ends it
    if (!place->second.is_running || phase_ == Phase::lost) {
      streams_.erase(place);
      return;
    }
    end = place->second.end;
  }
  start(end, {}, [this, key](const Result<Reply>&) {
    const std::lock_guard lock(mutex_);
    if (phase_ == Phase::closed) return;
    const auto place = streams_.find(key);
    if (place != streams_.end() && place->second.subscriptions == 0) streams_.erase(place);
  });
}

}  // namespace sbgc::detail
