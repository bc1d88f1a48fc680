/// A board that behaves as a test specifies, including behavior that no real board has.
#pragma once

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <map>
#include <mutex>
#include <stdexcept>
#include <thread>
#include <type_traits>
#include <utility>

#include <asio/buffer.hpp>
#include <asio/executor_work_guard.hpp>
#include <asio/io_context.hpp>
#include <asio/ip/tcp.hpp>
#include <asio/ip/udp.hpp>
#include <asio/post.hpp>
#include <asio/steady_timer.hpp>
#include <asio/write.hpp>

#include <sbgc/io/memory.hpp>
#include <sbgc/io/pseudo_terminal.hpp>
#include <sbgc/messages.hpp>
#include <sbgc/visit.hpp>

#include "line.hpp"

namespace sbgc::test {

/// A board on its own thread. It handles only requests for which on() registered an action; it
/// counts other requests without responding. All functions may be called from any thread; actions
/// run on the board's thread.
class ScriptedBoard {
 public:
  ScriptedBoard() : work_(context_.get_executor()), thread_([this] { context_.run(); }) {}
  ScriptedBoard(const ScriptedBoard&) = delete;
  ScriptedBoard& operator=(const ScriptedBoard&) = delete;
  ~ScriptedBoard() {
    asio::post(context_, [this] {
      is_stopping_ = true;
      if (transport_) transport_->close();
      for (const auto& old : old_) old->close();
      timers_.clear();
    });
    work_.reset();
    thread_.join();
  }

  asio::any_io_executor executor() { return context_.get_executor(); }

  /// Uses this transport, on executor(), instead of the previous one.
  void serve(std::unique_ptr<io::Transport> transport) {
    asio::post(
        context_,
        [this, shared = std::make_shared<std::unique_ptr<io::Transport>>(std::move(transport))] {
          if (transport_) old_.push_back(std::move(transport_));
          transport_ = std::move(*shared);
          is_writing_ = false;
          pending_.clear();
          parser_.reset();
          read();
        });
  }

  /// Calls `action(const M&)` for each M from now on; it must not refer to objects that the board
  /// outlives.
  template <Message M, class Action>
  void on(Action action) {
    const std::lock_guard lock(mutex_);
    actions_[{static_cast<std::uint8_t>(M::command), M::form}] =
        [action = std::move(action)](std::span<const std::uint8_t> body) {
          M message{};
          if (decode(body, message)) action(message);
        };
  }
  /// Sends the same response to each M.
  template <Message M, Message Answer>
  void answer(const Answer& answer) {
    on<M>([this, answer](const M&) { send(answer); });
  }
  /// Leaves each M without a response.
  template <Message M>
  void ignore() {
    on<M>([](const M&) {});
  }

  template <Message M>
  void send(const M& message) {
    std::array<std::uint8_t, max_frame_size> frame{};
    const WriteResult written = encode_frame(framing_, message, frame);
    send_bytes(std::span(frame).first(written.size));
  }
  template <Message M>
  void confirm(const M&) {
    msg::Confirm confirmation;
    confirmation.cmd = M::command;
    send(confirmation);
  }
  void send_bytes(std::span<const std::uint8_t> bytes) {
    asio::post(context_, [this, copy = std::vector(bytes.begin(), bytes.end())] {
      pending_.insert(pending_.end(), copy.begin(), copy.end());
      write();
    });
  }

  /// The board ignores frames of later framings. It answers in that of the last request.
  void knows_framings_up_to(Framing newest) { newest_framing_ = newest; }
  /// Returns the framing of the last request.
  Framing framing() const { return framing_; }

  /// Unplugs the cable.
  void unplug() {
    asio::post(context_, [this] { transport_->close(); });
  }

  /// Calls `action` after `delay`.
  void later(std::chrono::milliseconds delay, std::function<void()> action) {
    asio::post(context_, [this, delay, action = std::move(action)]() mutable {
      auto& timer = timers_.emplace_back(std::make_unique<asio::steady_timer>(context_, delay));
      timer->async_wait([action = std::move(action)](std::error_code error) {
        if (!error) action();
      });
    });
  }

  /// Returns the number of requests M received.
  template <Message M>
  std::size_t count() {
    const std::lock_guard lock(mutex_);
    return counts_[key<M>()];
  }
  /// Waits until `n` requests M have arrived; returns false after a minute.
  template <Message M>
  bool wait_for(std::size_t n) {
    std::unique_lock lock(mutex_);
    return came_.wait_for(lock, std::chrono::seconds(60), [&] { return counts_[key<M>()] >= n; });
  }

 private:
  using Key = std::pair<std::uint8_t, Form>;

  template <Message M>
  static constexpr Key key() {
    return {static_cast<std::uint8_t>(M::command), M::form};
  }

  void read() {
    io::Transport* const transport = transport_.get();
    transport->async_read(in_, [this, transport](std::error_code error, std::size_t size) {
      if (error || is_stopping_ || transport != transport_.get()) return;
      parser_.feed(std::span(in_).first(size), [this](const Frame& frame) { take(frame); });
      read();
    });
  }

  void take(const Frame& frame) {
    if (frame.framing > newest_framing_) return;
    framing_ = frame.framing;
    Form form{};
    select(Direction::to_board, frame.id, frame.body.size(),
           [&]<class M>(Type<M>) { form = M::form; });
    std::function<void(std::span<const std::uint8_t>)> action;
    {
      const std::lock_guard lock(mutex_);
      if (const auto place = actions_.find({frame.id, form}); place != actions_.end()) {
        action = place->second;
      }
    }
    if (action) action(frame.body);
    const std::lock_guard lock(mutex_);
    ++counts_[{frame.id, form}];
    came_.notify_all();
  }

  void write() {
    if (is_writing_ || pending_.empty() || !transport_ || is_stopping_) return;
    out_ = std::exchange(pending_, {});
    is_writing_ = true;
    io::Transport* const transport = transport_.get();
    transport->async_write(out_, [this, transport](std::error_code error, std::size_t) {
      if (error || transport != transport_.get()) return;
      is_writing_ = false;
      write();
    });
  }

  asio::io_context context_{1};
  asio::executor_work_guard<asio::io_context::executor_type> work_;

  // On the board's thread only
  std::unique_ptr<io::Transport> transport_;
  std::vector<std::unique_ptr<io::Transport>> old_;
  std::vector<std::unique_ptr<asio::steady_timer>> timers_;
  ParserOfAll parser_;
  std::array<std::uint8_t, 4096> in_{};
  std::vector<std::uint8_t> pending_;
  std::vector<std::uint8_t> out_;
  bool is_writing_ = false;
  bool is_stopping_ = false;

  std::atomic<Framing> framing_ = basic_framing;  // of the last request
  std::atomic<Framing> newest_framing_ = framings.back();

  std::mutex mutex_;
  std::condition_variable came_;
  std::map<Key, std::function<void(std::span<const std::uint8_t>)>> actions_;
  std::map<Key, std::size_t> counts_;

  std::thread thread_;
};

/// Makes the board introduce itself as a board 3.0 with this firmware.
inline void introduce(ScriptedBoard& board, std::uint16_t firmware = 2590,
                      std::uint8_t version = 30) {
  msg::BoardInfo info;
  info.board_ver = msg::BoardVersion(version);
  info.firmware_ver = msg::FirmwareVersion(firmware);
  board.answer<msg::BoardInfoRequest>(info);
  msg::BoardInfo3 details;
  details.device_id = {{0x00, 0x11, 0x22, 0x33, 0x44, 0x55, 0x66, 0x77, 0xAB}};
  board.answer<msg::BoardInfo3Request>(details);
}

/// Returns the factory of a pair in memory with the board at the other end.
inline TransportFactory over_memory(ScriptedBoard& board, const io::MemoryOptions& options = {}) {
  return [&board, options](const asio::any_io_executor& executor) {
    auto pair = io::make_memory_pair(executor, board.executor(), options);
    board.serve(std::move(pair.second));
    return std::move(pair.first);
  };
}

/// Returns the factory of a line of the chosen kind with the board at the other end.
inline TransportFactory over_line(ScriptedBoard& board) {
  const auto serve = [&board](std::unique_ptr<io::Transport> transport) {
    board.serve(std::move(transport));
  };
  if (line_kind() == LineKind::memory) return over_memory(board);
  if (line_kind() == LineKind::tcp) return over(accept_once(board.executor(), serve));
  auto opened = io::open_pseudo_terminal(board.executor(), {.stays_open = true});
  if (!opened) throw std::runtime_error(opened.error.message);
  const std::string path = opened.transport->path();
  serve(std::move(opened.transport));
  return over(path);
}

/// Options for tests: no pause between commands, and enough attempts that a stall of some seconds
/// is no failure. The line settings are searched for only in memory, where a test may need it: a
/// pseudo-terminal has none.
inline ConnectOptions quick() {
  return {.timeout = std::chrono::seconds(60),
          .detect_line = line_kind() == LineKind::memory,
          .retries = 9,
          .pacing = false,
          .queue_timeout = std::chrono::seconds(60)};
}

/// A connected socket, or one that learns its peer from the first datagram.
template <class Socket>
class SocketTransport : public io::Transport {
 public:
  explicit SocketTransport(Socket socket) : socket_(std::move(socket)) {}

  void async_read(std::span<std::uint8_t> into, Handler handler) override {
    const auto buffer = asio::buffer(into.data(), into.size());
    if constexpr (is_datagram) {
      socket_.async_receive_from(buffer, peer_, std::move(handler));
    } else {
      socket_.async_read_some(buffer, std::move(handler));
    }
  }
  void async_write(std::span<const std::uint8_t> bytes, Handler handler) override {
    const auto buffer = asio::buffer(bytes.data(), bytes.size());
    if constexpr (is_datagram) {
      socket_.async_send_to(buffer, peer_, std::move(handler));
    } else {
      asio::async_write(socket_, buffer, std::move(handler));
    }
  }
  void close() override {
    std::error_code ignored;
    socket_.close(ignored);
  }
  asio::any_io_executor executor() override { return socket_.get_executor(); }
  std::string description() const override { return "a socket of the test"; }

 private:
  static constexpr bool is_datagram = std::is_same_v<Socket, asio::ip::udp::socket>;

  Socket socket_;
  typename Socket::protocol_type::endpoint peer_;
};

/// Serves a port of this machine and returns its address.
inline std::string serve_udp(ScriptedBoard& board) {
  asio::ip::udp::socket socket(board.executor(), {asio::ip::address_v4::loopback(), 0});
  const std::uint16_t port = socket.local_endpoint().port();
  board.serve(std::make_unique<SocketTransport<asio::ip::udp::socket>>(std::move(socket)));
  return "udp:127.0.0.1:" + std::to_string(port);
}

}  // namespace sbgc::test
