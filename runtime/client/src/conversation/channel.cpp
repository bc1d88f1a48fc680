#include "channel.hpp"

#include <algorithm>
#include <utility>

#include <asio/post.hpp>

namespace sbgc::detail {

namespace {

/// The maximum time that close() waits for the last frames to be written.
constexpr Duration longest_closing = milliseconds(200);

}  // namespace

Channel::Channel(Strand strand) : strand_(std::move(strand)), timer_(std::in_place, *strand_) {}

void Channel::post(const std::shared_ptr<User>& user, std::function<void()> function) {
  const std::lock_guard lock(mutex_);
  if (!strand_) return;
  asio::post(*strand_, [user, function = std::move(function)] { function(); });
}

bool Channel::runs_in_this_thread() const {
  const std::lock_guard lock(mutex_);
  return strand_ && strand_->running_in_this_thread();
}

void Channel::open(std::unique_ptr<io::Transport> transport, const std::shared_ptr<User>& user) {
  user_ = user;
  transport_ = std::move(transport);
  if (!is_closing_) read();
}

void Channel::read() {
  is_reading_ = true;
  transport_->async_read(
      in_, [this, user = user_.lock()](const std::error_code& error, std::size_t size) {
        is_reading_ = false;
        if (error) return user->line_failed(error);
        if (is_closing_) return release();
        // Process the bytes first: the next read reuses the buffer.
        user->received(std::span(in_).first(size));
        if (is_closing_) return release();
        read();
        user->woken();
      });
}

void Channel::write(std::span<const std::uint8_t> bytes) {
  std::copy(bytes.begin(), bytes.end(), out_.begin());
  is_writing_ = true;
  transport_->async_write(std::span(out_).first(bytes.size()),
                          [this, user = user_.lock()](const std::error_code& error, std::size_t) {
                            is_writing_ = false;
                            if (error) return user->line_failed(error);
                            if (is_closing_) return write_last_frames();
                            user->written();
                          });
}

void Channel::wake_at(Instant at) {
  if (at == Instant::never) {
    timer_->cancel();
    return;
  }
  timer_->start(at, [user = user_.lock()] { user->woken(); });
}

void Channel::close(std::vector<Frame> last_frames) {
  if (std::exchange(is_closing_, true)) return;
  if (!transport_) return close_now();
  last_frames_ = std::move(last_frames);
  // Do not wait forever for a line that blocks.
  timer_->start(timer_->now() + longest_closing, [this, user = user_.lock()] { close_now(); });
  write_last_frames();
}

void Channel::write_last_frames() {
  if (is_hung_up_) return release();
  if (last_frames_.empty()) return close_now();
  if (is_writing_) return;
  const Frame frame = std::move(last_frames_.back());
  last_frames_.pop_back();
  write(frame);
}

void Channel::close_now() {
  is_closing_ = true;
  if (!std::exchange(is_hung_up_, true)) {
    if (timer_) timer_->cancel();
    if (transport_) transport_->close();
  }
  release();
}

/// Releases the Asio objects once no operation is pending.
void Channel::release() {
  if (!is_hung_up_ || is_reading_ || is_writing_) return;
  timer_.reset();
  const std::lock_guard lock(mutex_);
  if (!strand_) return;
  // Post, because a transport must not be destroyed inside its own handler.
  asio::post(*strand_, [transport = std::move(transport_)]() mutable { transport.reset(); });
  strand_.reset();
}

}  // namespace sbgc::detail
