/// The line of a conversation, as Asio sees it: strand, transport and timer.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <system_error>
#include <vector>

#include <asio/any_io_executor.hpp>
#include <asio/steady_timer.hpp>
#include <asio/strand.hpp>

#include <sbgc/frame.hpp>
#include <sbgc/io/transport.hpp>
#include <sbgc/time.hpp>

namespace sbgc::detail {

using Strand = asio::strand<asio::any_io_executor>;

/// What belongs to Asio is given up on the strand when the channel has been closed, because handles
/// and subscriptions may outlive the execution context.
///
/// post() and runs_in_this_thread() may be called from any thread, the rest on the strand.
class Channel {
 public:
  /// Whom the channel belongs to. It is kept alive while something is under way.
  class User {
   public:
    User() = default;
    User(const User&) = delete;
    User& operator=(const User&) = delete;
    virtual ~User() = default;

    virtual void received(std::span<const std::uint8_t> bytes) = 0;
    virtual void written() = 0;
    /// The moment of wake_at() has come.
    virtual void woken() = 0;
    virtual void line_failed(const std::error_code& reason) = 0;
  };

  explicit Channel(Strand strand);

  /// Runs a function on the strand; not at all if the channel has been given up.
  void post(const std::shared_ptr<User>& user, std::function<void()> function);
  bool runs_in_this_thread() const;

  /// Takes a transport whose executor is the strand, and begins to read.
  void open(std::unique_ptr<io::Transport> transport, const std::shared_ptr<User>& user);
  /// Open, and not closing.
  bool is_open() const noexcept { return transport_ && !is_closing_; }
  io::Transport& transport() const noexcept { return *transport_; }

  bool can_write() const noexcept { return !is_writing_; }
  /// Writes at most one frame. Precondition: can_write().
  void write(std::span<const std::uint8_t> bytes);
  /// One moment at a time.
  void wake_at(Instant at);

  using Frame = std::vector<std::uint8_t>;
  /// Writes the last frames, then closes the line; after a short time in any case.
  void close(std::vector<Frame> last_frames);
  /// Closes the line at once.
  void hang_up();

 private:
  void read();
  void write_last_frames();
  void release();

  mutable std::mutex mutex_;
  std::optional<Strand> strand_;

  // On the strand only
  std::weak_ptr<User> user_;
  std::unique_ptr<io::Transport> transport_;
  std::optional<asio::steady_timer> timer_;
  bool is_reading_ = false;
  bool is_writing_ = false;
  bool is_closing_ = false;
  bool is_hung_up_ = false;
  std::vector<Frame> last_frames_;
  std::array<std::uint8_t, 4096> in_{};
  std::array<std::uint8_t, max_frame_size> out_{};
};

}  // namespace sbgc::detail
