#include "bad_board.hpp"

#include <cstdio>
#include <cstdlib>
#include <future>
#include <utility>

#include <asio/post.hpp>

#include <sbgc/io/clock.hpp>
#include <sbgc/message.hpp>
#include <sbgc/messages.hpp>

namespace sbgc::bench {

namespace {

/// About what a line at 115200 baud carries.
constexpr std::chrono::milliseconds babble_interval{5};
constexpr std::size_t noise_size = 32;

emulator::EmulatorOptions instant_board() {
  emulator::EmulatorOptions options;
  options.line.board = {};  // bytes take no time
  options.board.start_time = {};
  return options;
}

}  // namespace

BadBoard::BadBoard()
    : emulator_(instant_board(), {}, io::now()), port_(emulator_.connect(true, io::now()).value()) {
  auto opened = io::open_pseudo_terminal(context_.get_executor(), {.stays_open = true});
  if (!opened) {
    std::fprintf(stderr, "deadlines: %s\n", opened.error.message.c_str());
    std::exit(1);
  }
  terminal_ = std::move(opened.transport);
  address_ = terminal_->path();
  read();
  thread_ = std::thread([this] { context_.run(); });
}

BadBoard::~BadBoard() {
  context_.stop();
  thread_.join();
}

void BadBoard::behave(Manner manner, unsigned whole) {
  std::promise<void> done;
  asio::post(context_, [&] {
    manner_ = manner;
    whole_ = whole;
    babble_timer_.cancel();
    if (manner == Manner::babbling) babble();
    done.set_value();
  });
  done.get_future().wait();
}

void BadBoard::read() {
  terminal_->async_read(in_, [this](std::error_code error, std::size_t size) {
    if (error) return;
    emulator_.from_host(port_, std::span(in_).first(size), io::now());
    advance();
    read();
  });
}

void BadBoard::advance() {
  emulator_.advance(io::now());
  const auto arrived = emulator_.to_host(port_);
  if (!arrived.empty()) {
    answer(arrived);
    emulator_.take(port_, arrived.size(), io::now());
  }
  const Instant next = emulator_.next();
  if (next == Instant::never) return;
  board_timer_.expires_at(io::to_chrono(next));
  board_timer_.async_wait([this](std::error_code error) {
    if (!error) advance();
  });
}

void BadBoard::answer(std::span<const std::uint8_t> bytes) {
  if (manner_ == Manner::silent || manner_ == Manner::babbling) return;
  if (manner_ == Manner::partly) {
    if (whole_ == 0) bytes = bytes.first(bytes.size() / 2);
    whole_ -= whole_ == 0 ? 0 : 1;
  }
  waiting_.insert(waiting_.end(), bytes.begin(), bytes.end());
  write();
}

void BadBoard::babble() {
  std::array<std::uint8_t, max_frame_size> frame{};
  const std::size_t size = encode_frame(msg::RealtimeData3{}, frame).size;
  waiting_.insert(waiting_.end(), frame.begin(), frame.begin() + static_cast<std::ptrdiff_t>(size));
  waiting_.insert(waiting_.end(), noise_size, '>');  // the start of a frame, again and again
  write();
  babble_timer_.expires_after(babble_interval);
  babble_timer_.async_wait([this](std::error_code error) {
    if (!error && manner_ == Manner::babbling) babble();
  });
}

void BadBoard::write() {
  if (is_writing_ || waiting_.empty()) return;
  out_ = std::exchange(waiting_, {});
  is_writing_ = true;
  terminal_->async_write(out_, [this](std::error_code error, std::size_t) {
    is_writing_ = false;
    if (!error) write();
  });
}

}  // namespace sbgc::bench
