#include "share/line_gate.hpp"

#include <chrono>
#include <deque>
#include <utility>

#include <asio/post.hpp>
#include <asio/steady_timer.hpp>

namespace sbgc::tools {

namespace {

/// A device that accepts no more bytes does not keep the line.
constexpr std::chrono::seconds longest_end{2};

}  // namespace

/// One transport and its user. All functions run on its executor.
class LineGate::State : public std::enable_shared_from_this<LineGate::State> {
 public:
  using Handler = io::Transport::Handler;

  State(std::unique_ptr<io::Transport> transport, std::function<void(Bytes)> on_bytes,
        std::function<void()> on_sent, std::shared_ptr<std::atomic<std::size_t>> waiting)
      : inner(std::move(transport)),
        on_bytes_(std::move(on_bytes)),
        on_sent_(std::move(on_sent)),
        waiting_(std::move(waiting)),
        end_(inner->executor()) {}
  State(const State&) = delete;
  State& operator=(const State&) = delete;
  ~State() { *waiting_ -= own_; }

  void read(std::span<std::uint8_t> into, const Handler& handler) {
    inner->async_read(
        into, [self = shared_from_this(), into, handler](std::error_code error, std::size_t size) {
          if (error) return handler(self->is_given_back_ ? io::Errc::device_lost : error, size);
          if (!self->is_taken_) return handler(error, size);
          const auto bytes = into.first(size);
          self->on_bytes_({bytes.begin(), bytes.end()});
          self->read(into, handler);
        });
  }

  void write(std::span<const std::uint8_t> bytes, const Handler& handler) {
    if (is_taken_) {
      return asio::post(inner->executor(), [handler, size = bytes.size()] { handler({}, size); });
    }
    is_writing_ = true;
    inner->async_write(
        bytes, [self = shared_from_this(), handler](std::error_code error, std::size_t size) {
          self->is_writing_ = false;
          self->write_next();
          handler(error, size);
        });
  }

  void take() { is_taken_ = true; }

  void write_raw(Bytes bytes) {
    if (!is_taken_ || is_given_back_ || bytes.empty()) {
      *waiting_ -= bytes.size();
      return;
    }
    own_ += bytes.size();
    raw_.push_back(std::move(bytes));
    write_next();
  }

  void give_back() {
    if (!is_taken_ || std::exchange(is_given_back_, true)) return;
    end_.expires_after(longest_end);
    end_.async_wait([weak = weak_from_this()](std::error_code aborted) {
      const auto self = weak.lock();
      if (self && !aborted) self->inner->close();
    });
    write_next();
  }

  void release() {
    if (raw_.empty() && !is_given_back_) is_taken_ = false;
  }

  void close() {
    end_.cancel();
    inner->close();
  }

  const std::unique_ptr<io::Transport> inner;

 private:
  void write_next() {
    if (is_writing_) return;
    if (raw_.empty()) {
      if (is_given_back_) close();
      return;
    }
    is_writing_ = true;
    out_ = std::move(raw_.front());
    raw_.pop_front();
    inner->async_write(out_, [self = shared_from_this()](std::error_code error, std::size_t) {
      self->is_writing_ = false;
      self->own_ -= self->out_.size();
      *self->waiting_ -= self->out_.size();
      self->on_sent_();
      if (!error) self->write_next();
    });
  }

  std::function<void(Bytes)> on_bytes_;
  std::function<void()> on_sent_;
  std::shared_ptr<std::atomic<std::size_t>> waiting_;  // of all transports
  std::size_t own_ = 0;                                // the part of this transport
  asio::steady_timer end_;
  std::deque<Bytes> raw_;
  Bytes out_;
  bool is_writing_ = false;
  bool is_taken_ = false;
  bool is_given_back_ = false;
};

class LineGate::Gated final : public io::Transport {
 public:
  Gated(std::shared_ptr<Current> current, std::shared_ptr<State> state)
      : current_(std::move(current)), state_(std::move(state)) {
    const std::lock_guard lock(current_->mutex);
    current_->state = state_;
  }
  Gated(const Gated&) = delete;
  Gated& operator=(const Gated&) = delete;
  ~Gated() override {
    {
      const std::lock_guard lock(current_->mutex);
      if (current_->state == state_) current_->state.reset();
    }
    state_->close();
  }

  void async_read(std::span<std::uint8_t> into, Handler handler) override {
    state_->read(into, handler);
  }
  void async_write(std::span<const std::uint8_t> bytes, Handler handler) override {
    state_->write(bytes, handler);
  }
  void close() override { state_->close(); }
  asio::any_io_executor executor() override { return state_->inner->executor(); }
  std::string description() const override { return state_->inner->description(); }
  io::LineControl* line() override { return state_->inner->line(); }

 private:
  std::shared_ptr<Current> current_;
  std::shared_ptr<State> state_;
};

LineGate::LineGate(std::function<void(Bytes)> on_bytes, std::function<void()> on_sent)
    : on_bytes_(std::move(on_bytes)), on_sent_(std::move(on_sent)) {}

std::unique_ptr<io::Transport> LineGate::pass(std::unique_ptr<io::Transport> transport) {
  return std::make_unique<Gated>(
      current_, std::make_shared<State>(std::move(transport), on_bytes_, on_sent_, waiting_));
}

template <class Use>
bool LineGate::post(Use use) {
  // Under the lock, because the executor exists only as long as the transport.
  const std::lock_guard lock(current_->mutex);
  if (!current_->state) return false;
  asio::post(current_->state->inner->executor(),
             [state = current_->state, use = std::move(use)]() mutable { use(*state); });
  return true;
}

void LineGate::take() {
  post([](State& state) { state.take(); });
}

void LineGate::write(Bytes bytes) {
  // Counted before they are passed on, because the caller sends no more than there is room for.
  const std::size_t size = bytes.size();
  *waiting_ += size;
  const bool is_posted =
      post([bytes = std::move(bytes)](State& state) mutable { state.write_raw(std::move(bytes)); });
  if (!is_posted) *waiting_ -= size;
}

void LineGate::give_back() {
  post([](State& state) { state.give_back(); });
}

void LineGate::release() {
  post([](State& state) { state.release(); });
}

}  // namespace sbgc::tools
