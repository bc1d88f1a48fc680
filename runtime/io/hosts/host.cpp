#include "hosts/host.hpp"

#include <algorithm>
#include <chrono>
#include <utility>

#include <asio/error.hpp>

namespace sbgc::hosts {

namespace {

constexpr std::size_t most_per_write = 4096;

/// After its last byte, a host may still wait for responses: the interval for checking whether it
/// has received them all.
constexpr auto linger_for = std::chrono::milliseconds(100);
/// A host that reads nothing for this long is disconnected.
constexpr auto patience = std::chrono::seconds(5);

}  // namespace

Host::Host(HostPorts& board, std::unique_ptr<io::Transport> transport)
    : board_(board), transport_(std::move(transport)), linger_(transport_->executor()) {}

std::shared_ptr<Host> Host::connect(HostPorts& board, std::unique_ptr<io::Transport> transport) {
  if (board.between) transport = board.between(std::move(transport));
  std::shared_ptr<Host> host(new Host(board, std::move(transport)));
  const auto port = board.connect(false, [weak = std::weak_ptr(host)] {
    if (const auto self = weak.lock()) self->wake();
  });
  if (!port) return nullptr;
  host->port_ = *port;
  host->is_closed_ = false;
  return host;
}

void Host::start() { wake(); }

void Host::wake() {
  if (!is_closed_ && !has_read_all_ && board_.must_leave(port_)) {
    has_read_all_ = true;
    written_at_ = io::Clock::now();
    linger();  // deferred, because this may be a call from the board
  }
  read();
  write();
}

void Host::read() {
  if (is_closed_ || is_reading_ || has_read_all_) return;
  const std::size_t room = std::min(board_.room(port_), input_.size());
  if (room == 0) return;
  is_reading_ = true;
  transport_->async_read(std::span(input_).first(room),
                         [self = shared_from_this()](std::error_code error, std::size_t size) {
                           self->is_reading_ = false;
                           if (self->is_closed_) return;
                           if (error) return self->finish_reading(error);
                           if (self->before_bytes) self->before_bytes(self->port_);
                           self->board_.receive(self->port_, std::span(self->input_).first(size));
                           self->wake();
                         });
}

void Host::write() {
  if (is_closed_ || is_writing_) return;
  const std::span<const std::uint8_t> waiting = board_.output(port_);
  if (waiting.empty()) return;
  const std::size_t size = std::min(waiting.size(), most_per_write);
  output_.assign(waiting.begin(), waiting.begin() + static_cast<std::ptrdiff_t>(size));
  is_writing_ = true;
  written_at_ = io::Clock::now();
  board_.take(port_, size);
  if (before_bytes) before_bytes(port_);
  transport_->async_write(output_, [self = shared_from_this()](std::error_code error, std::size_t) {
    self->is_writing_ = false;
    self->written_at_ = io::Clock::now();
    if (self->is_closed_) return;
    if (error) return self->end(error);
    self->wake();
  });
}

void Host::finish_reading(std::error_code error) {
  if (error != asio::error::eof && error != io::Errc::end_of_stream) return end(error);
  has_read_all_ = true;
  written_at_ = io::Clock::now();
  board_.end_input(port_);
  end_or_linger();
}

void Host::end_or_linger() {
  if (!is_writing_ && board_.is_quiet(port_)) return end({});
  if (is_writing_ && io::Clock::now() - written_at_ > patience) {
    return end(asio::error::timed_out);
  }
  linger();
}

void Host::linger() {
  linger_.expires_after(linger_for);
  linger_.async_wait([self = shared_from_this()](std::error_code aborted) {
    if (!aborted && !self->is_closed_) self->end_or_linger();
  });
}

void Host::end(std::error_code error) {
  if (is_closed_) return;
  close();
  if (const auto handler = std::exchange(on_end, nullptr)) handler(error);
}

void Host::close() {
  if (std::exchange(is_closed_, true)) return;
  linger_.cancel();
  transport_->close();
  board_.disconnect(port_);
}

}  // namespace sbgc::hosts
