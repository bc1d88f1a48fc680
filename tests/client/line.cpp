

#include <cstdlib>

#include <asio/error.hpp>

#include <sbgc/io/open.hpp>

#include "scripted_board.hpp"

namespace sbgc::test {

Tap::Tap(std::unique_ptr<io::Transport> inner, TapHooks& hooks)
    : inner_(std::move(inner)), hooks_(hooks) {
  hooks_.tap = this;
}

Tap::~Tap() {
  if (hooks_.tap == this) hooks_.tap = nullptr;
}

void Tap::async_read(std::span<std::uint8_t> into, Handler handler) {
  if (is_busy_ && !is_closed_) {
    reading_ = {into, std::move(handler)};
    return;
  }
  if (is_closed_ || prepare()) {
    asio::post(executor(),
               [this, into, handler = std::move(handler)]() mutable { deliver(into, handler); });
    return;
  }
  inner_->async_read(in_, [this, into, handler = std::move(handler)](std::error_code error,
                                                                     std::size_t size) mutable {
    if (error) return handler(error, 0);
    requests_.feed(std::span(in_).first(size), [this](const Frame& frame) {
      arrived_.push_back({frame.id, {frame.body.begin(), frame.body.end()}, frame.framing});
    });
    async_read(into, std::move(handler));
  });
}

bool Tap::prepare() {
  while (ready_.empty() && !arrived_.empty()) {
    request_ = std::move(arrived_.front());
    arrived_.pop_front();
    hooks_.log.push_back(*request_);
    if (!hooks_.is_lost || !hooks_.is_lost(*request_)) ready_ = to_frame(*request_);
  }
  return !ready_.empty();
}

void Tap::deliver(std::span<std::uint8_t> into, Handler& handler) {
  if (is_closed_) return handler(asio::error::operation_aborted, 0);
  const std::size_t size = std::min(into.size(), ready_.size());
  const auto end = ready_.begin() + static_cast<std::ptrdiff_t>(size);
  std::copy(ready_.begin(), end, into.begin());
  ready_.erase(ready_.begin(), end);
  is_busy_ = ready_.empty();
  handler({}, size);
}

void Tap::request_executed() {
  if (!is_busy_) return;
  is_busy_ = false;
  if (hooks_.after) hooks_.after(*request_);
  if (writing_) send(*std::exchange(writing_, {}));
  if (reading_) {
    Reading reading = *std::exchange(reading_, {});
    async_read(reading.into, std::move(reading.handler));
  }
}

void Tap::async_write(std::span<const std::uint8_t> bytes, Handler handler) {
  answers_.feed(bytes, [this](const Frame& frame) {
    leaving_.push_back({frame.id, {frame.body.begin(), frame.body.end()}, frame.framing});
  });
  Writing writing{bytes.size(), std::move(handler)};
  if (is_busy_ && !is_closed_) {
    writing_ = std::move(writing);
  } else {
    send(std::move(writing));
  }
}

void Tap::send(Writing writing) {
  Packets packets = std::exchange(leaving_, {});
  if (hooks_.tamper) hooks_.tamper(packets);
  if (request_ && hooks_.is_answer_lost && hooks_.is_answer_lost(*request_)) packets.clear();
  out_.clear();
  for (const Packet& one : packets) {
    const auto frame = to_frame(one);
    out_.insert(out_.end(), frame.begin(), frame.end());
  }
  if (out_.empty()) {
    asio::post(executor(), [writing = std::move(writing)] { writing.handler({}, writing.size); });
    return;
  }
  inner_->async_write(out_, [writing = std::move(writing)](std::error_code error, std::size_t) {
    writing.handler(error, error ? 0 : writing.size);
  });
}

void Tap::close() {
  is_closed_ = true;
  inner_->close();
  const auto abort = [this](Handler handler) {
    asio::post(executor(),
               [handler = std::move(handler)] { handler(asio::error::operation_aborted, 0); });
  };
  if (reading_) abort(std::exchange(reading_, {})->handler);
  if (writing_) abort(std::exchange(writing_, {})->handler);
}

LineKind line_kind() {
  static const LineKind kind = [] {
    const char* const given = std::getenv("SBGC_TEST_LINE");  // NOLINT(concurrency-mt-unsafe)
    const std::string name = given == nullptr ? "memory" : given;
    if (name == "memory") return LineKind::memory;
    if (name == "pty") return LineKind::terminal;
    if (name == "tcp") return LineKind::tcp;
    throw std::runtime_error("SBGC_TEST_LINE is memory, pty or tcp, not " + name);
  }();
  return kind;
}

TransportFactory over(std::string address) {
  return [address = std::move(address)](const asio::any_io_executor& executor) {
    io::OpenResult opened = io::open(executor, address);
    if (!opened) throw std::runtime_error(opened.error.message);
    return std::move(opened.transport);
  };
}

std::string accept_once(const asio::any_io_executor& executor,
                        std::function<void(std::unique_ptr<io::Transport>)> serve) {
  using asio::ip::tcp;
  const auto acceptor =
      std::make_shared<tcp::acceptor>(executor, tcp::endpoint(asio::ip::address_v4::loopback(), 0));
  acceptor->async_accept(
      [acceptor, serve = std::move(serve)](std::error_code error, tcp::socket socket) {
        if (!error) serve(std::make_unique<SocketTransport<tcp::socket>>(std::move(socket)));
      });
  return "tcp:127.0.0.1:" + std::to_string(acceptor->local_endpoint().port());
}

}  // namespace sbgc::test
