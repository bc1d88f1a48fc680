// The end of a conversation: the line is lost, or the client closes it.

#include <chrono>
#include <utility>
#include <vector>

#include <asio/post.hpp>

#include "conversation_state.hpp"
#include "text.hpp"

namespace sbgc::detail {

namespace {

/// How long close() waits for the end of what is still to be written.
constexpr std::chrono::milliseconds longest_farewell{200};

}  // namespace

void Conversation::State::lose(const std::error_code& reason) {
  bool is_news = false;
  std::vector<CallPointer> ended;
  {
    const std::lock_guard lock(mutex_);
    is_news = phase_ == Phase::open;
    if (is_news) {
      phase_ = Phase::lost;
      loss_ = "the connection is lost: " + description_ + ": " + without_stop(reason.message());
      waiting_.clear();
      deadlines_.clear();
      for (auto& [ticket, call] : calls_) ended.push_back(std::move(call));
      calls_.clear();
    }
  }
  for (const CallPointer& call : ended) {
    complete(*call, ClientError{ErrorCode::link_lost,
                                std::string(call->request.info->command) + ": " + loss_});
  }
  shut();
  hang_up();
  if (is_news) notify({NoticeKind::link_lost, loss_});
}

/// Begins to end all that Asio does for this conversation.
void Conversation::State::shut() {
  if (std::exchange(is_shut_, true)) return;
  if (detector_) end_detection(false);
  in_session_.clear();
  if (!transport_) return hang_up();
  {
    const std::lock_guard lock(mutex_);
    for (auto& [key, stream] : streams_) {
      if (stream.is_running && phase_ == Phase::closed) farewell_.push_back(stream.end);
    }
  }
  // A line on which nothing can be written is not waited for.
  timer_->expires_after(longest_farewell);
  timer_->async_wait([self = shared_from_this()](const std::error_code& error) {
    if (!error) self->hang_up();
  });
  say_farewell();
}

/// Ends the data streams that are still running, then hangs up.
void Conversation::State::say_farewell() {
  if (is_writing_ || is_hung_up_) return release();
  if (farewell_.empty()) return hang_up();
  const std::vector<std::uint8_t> frame = std::move(farewell_.back());
  farewell_.pop_back();
  write(frame);
}

void Conversation::State::hang_up() {
  if (!std::exchange(is_hung_up_, true)) {
    if (timer_) timer_->cancel();
    if (transport_) transport_->close();
  }
  release();
}

/// Gives up Asio's objects as soon as nothing is under way.
void Conversation::State::release() {
  if (!is_hung_up_ || is_reading_ || is_writing_) return;
  timer_.reset();
  const std::lock_guard lock(mutex_);
  if (!strand_) return;
  // Not from inside one of its own handlers.
  asio::post(*strand_, [transport = std::move(transport_)]() mutable { transport.reset(); });
  strand_.reset();
}

}  // namespace sbgc::detail
