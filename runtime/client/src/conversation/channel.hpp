/// The line of a conversation: strand, transport and timer.
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
#include <asio/strand.hpp>

#include <sbgc/frame.hpp>
#include <sbgc/io/internal/timer.hpp>
#include <sbgc/io/transport.hpp>
#include <sbgc/time.hpp>

namespace sbgc::detail {

using Strand = asio::strand<asio::any_io_executor>;

/// After the channel has closed, it releases the Asio objects on the strand, because handles and
/// subscriptions may outlive the execution context.
///
/// post() and runs_in_this_thread() may be called from any thread, the other functions only on the
/// strand.
class Channel {
 public:
  /// The owner of the channel. It is kept alive while an operation is pending.
  class User {
   public:
    User() = default;
    User(const User&) = delete;
    User& operator=(const User&) = delete;
    virtual ~User() = default;

    virtual void received(std::span<const std::uint8_t> bytes) = 0;
    virtual void written() = 0;
    /// Called at the time of wake_at().
    virtual void woken() = 0;
    virtual void line_failed(const std::error_code& reason) = 0;
  };

  explicit Channel(Strand strand);

  /// Runs a function on the strand; drops it if the strand has been released.
  void post(const std::shared_ptr<User>& user, std::function<void()> function);
  bool runs_in_this_thread() const;

  /// Takes a transport whose executor is the strand, and starts reading.
  void open(std::unique_ptr<io::Transport> transport, const std::shared_ptr<User>& user);
  /// True if the channel is open and not closing.
  bool is_open() const noexcept { return transport_ && !is_closing_; }
  io::Transport& transport() const noexcept { return *transport_; }

  bool can_write() const noexcept { return !is_writing_; }
  /// Writes at most one frame. Precondition: can_write().
  void write(std::span<const std::uint8_t> bytes);
  /// Calls User::woken() at `at`; replaces an earlier time.
  void wake_at(Instant at);

  using Frame = std::vector<std::uint8_t>;
  /// Writes the last frames, then closes the line; closes it after a short timeout in any case.
  void close(std::vector<Frame> last_frames);
  /// Closes the line at once.
  void close_now();

 private:
  void read();
  void write_last_frames();
  void release();

  mutable std::mutex mutex_;
  std::optional<Strand> strand_;

  // Only on the strand.
  std::weak_ptr<User> user_;
  std::unique_ptr<io::Transport> transport_;
  std::optional<io::detail::Timer> timer_;
  bool is_reading_ = false;
  bool is_writing_ = false;
  bool is_closing_ = false;
  bool is_hung_up_ = false;
  std::vector<Frame> last_frames_;
  std::array<std::uint8_t, 4096> in_{};
  std::array<std::uint8_t, max_frame_size> out_{};
};

}  // namespace sbgc::detail
