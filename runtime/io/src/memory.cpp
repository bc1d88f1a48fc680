#include <algorithm>
#include <array>
#include <deque>
#include <mutex>
#include <optional>
#include <utility>

#include <asio/error.hpp>
#include <asio/execution/outstanding_work.hpp>
#include <asio/post.hpp>
#include <asio/prefer.hpp>

#include <sbgc/io/memory.hpp>

namespace sbgc::io {

namespace {

/// A pending operation. Its executor has outstanding work until it completes, as with a socket.
class Pending {
 public:
  Pending(const asio::any_io_executor& executor, Transport::Handler handler)
      : executor_(asio::prefer(executor, asio::execution::outstanding_work_t::tracked)),
        handler_(std::move(handler)) {}

  void complete(std::error_code error, std::size_t size) {
    asio::post(executor_, [handler = std::move(handler_), error, size] { handler(error, size); });
  }

 private:
  asio::any_io_executor executor_;
  Transport::Handler handler_;
};

struct PendingRead {
  std::span<std::uint8_t> into;
  Pending pending;
};

struct PendingWrite {
  std::vector<std::uint8_t> bytes;  // as received by the other end
  std::size_t moved;
  std::size_t reported;  // the size reported to the writer when all bytes have been moved
  Pending pending;
};

/// One direction of the link.
class Pipe {
 public:
  explicit Pipe(const MemoryOptions& options)
      : capacity_(std::max<std::size_t>(options.capacity, 1)),
        max_read_(std::max<std::size_t>(options.max_read, 1)) {}

  void read(PendingRead read) {
    read_ = std::move(read);
    pump();
  }

  void write(PendingWrite write) {
    write_ = std::move(write);
    pump();
  }

  void close_reader() {
    if (auto read = std::exchange(read_, std::nullopt)) {
      read->pending.complete(asio::error::operation_aborted, 0);
    }
    reader_closed_ = true;
    bytes_.clear();
    pump();
  }

  void close_writer() {
    if (auto write = std::exchange(write_, std::nullopt)) {
      write->pending.complete(asio::error::operation_aborted, write->moved);
    }
    writer_closed_ = true;
    pump();
  }

  void discard() {
    bytes_.clear();
    pump();
  }

 private:
  void pump() {
    move_written();
    if (read_ && !bytes_.empty()) {
      const std::size_t size = std::min({read_->into.size(), bytes_.size(), max_read_});
      std::copy_n(bytes_.begin(), size, read_->into.begin());
      bytes_.erase(bytes_.begin(), bytes_.begin() + static_cast<std::ptrdiff_t>(size));
      std::exchange(read_, std::nullopt)->pending.complete({}, size);
      move_written();
    } else if (read_ && writer_closed_) {
      std::exchange(read_, std::nullopt)->pending.complete(Errc::end_of_stream, 0);
    }
  }

  void move_written() {
    if (!write_) return;
    if (reader_closed_) {
      const std::size_t moved = write_->moved;
      std::exchange(write_, std::nullopt)->pending.complete(Errc::end_of_stream, moved);
      return;
    }
    const auto from = write_->bytes.begin() + static_cast<std::ptrdiff_t>(write_->moved);
    const std::size_t size =
        std::min(capacity_ - bytes_.size(), write_->bytes.size() - write_->moved);
    bytes_.insert(bytes_.end(), from, from + static_cast<std::ptrdiff_t>(size));
    write_->moved += size;
    if (write_->moved < write_->bytes.size()) return;
    const std::size_t reported = write_->reported;
    std::exchange(write_, std::nullopt)->pending.complete({}, reported);
  }

  std::size_t capacity_;
  std::size_t max_read_;
  std::deque<std::uint8_t> bytes_;
  std::optional<PendingRead> read_;
  std::optional<PendingWrite> write_;
  bool reader_closed_ = false;
  bool writer_closed_ = false;
};

/// The state shared by both ends: end i reads from pipes[i] with the settings lines[i].
struct Link {
  explicit Link(const MemoryOptions& options)
      : pipes{Pipe(options), Pipe(options)}, mismatch(options.mismatch) {}

  /// Returns the bytes that the other end receives if `writer` writes `bytes`.
  std::vector<std::uint8_t> received(std::size_t writer,
                                     std::span<const std::uint8_t> bytes) const {
    const LineSettings& sender = lines[writer];
    const LineSettings& receiver = lines[1 - writer];
    if (sender == receiver) return {bytes.begin(), bytes.end()};
    return mismatch ? mismatch(bytes, sender, receiver) : std::vector<std::uint8_t>{};
  }

  std::mutex mutex;
  std::array<Pipe, 2> pipes;
  std::array<LineSettings, 2> lines{default_line, default_line};
  LineMismatch mismatch;
};

class MemoryLine final : public LineControl {
 public:
  MemoryLine(std::shared_ptr<Link> link, std::size_t end) : link_(std::move(link)), end_(end) {}

  Error set(const LineSettings& settings) override {
    const std::scoped_lock lock(link_->mutex);
    link_->lines[end_] = settings;
    link_->pipes[end_].discard();
    return {};
  }

  LineSettings current() const override {
    const std::scoped_lock lock(link_->mutex);
    return link_->lines[end_];
  }

  Error flush() override {
    const std::scoped_lock lock(link_->mutex);
    link_->pipes[end_].discard();
    return {};
  }

 private:
  std::shared_ptr<Link> link_;
  std::size_t end_;
};

class MemoryTransport final : public Transport {
 public:
  MemoryTransport(asio::any_io_executor executor, const std::shared_ptr<Link>& link,
                  std::size_t end, bool with_line)
      : executor_(std::move(executor)), link_(link), end_(end) {
    if (with_line) line_ = std::make_unique<MemoryLine>(link, end);
  }

  MemoryTransport(const MemoryTransport&) = delete;
  MemoryTransport& operator=(const MemoryTransport&) = delete;
  ~MemoryTransport() override { end_link(); }

  void async_read(std::span<std::uint8_t> into, Handler handler) override {
    Pending pending(executor_, std::move(handler));
    if (closed_) return pending.complete(asio::error::operation_aborted, 0);
    const std::scoped_lock lock(link_->mutex);
    link_->pipes[end_].read({into, std::move(pending)});
  }

  void async_write(std::span<const std::uint8_t> bytes, Handler handler) override {
    Pending pending(executor_, std::move(handler));
    if (closed_) return pending.complete(asio::error::operation_aborted, 0);
    const std::scoped_lock lock(link_->mutex);
    link_->pipes[1 - end_].write(
        {link_->received(end_, bytes), 0, bytes.size(), std::move(pending)});
  }

  void close() override { end_link(); }

  asio::any_io_executor executor() override { return executor_; }

  std::string description() const override {
    return line_ == nullptr ? "memory link" : "memory link, " + to_string(line_->current());
  }

  LineControl* line() override { return line_.get(); }

 private:
  void end_link() {
    if (std::exchange(closed_, true)) return;
    const std::scoped_lock lock(link_->mutex);
    link_->pipes[end_].close_reader();
    link_->pipes[1 - end_].close_writer();
  }

  asio::any_io_executor executor_;
  std::shared_ptr<Link> link_;
  std::size_t end_;
  std::unique_ptr<MemoryLine> line_;
  bool closed_ = false;
};

}  // namespace

MemoryPair make_memory_pair(const asio::any_io_executor& executor, const MemoryOptions& options) {
  return make_memory_pair(executor, executor, options);
}

MemoryPair make_memory_pair(const asio::any_io_executor& first, const asio::any_io_executor& second,
                            const MemoryOptions& options) {
  const auto link = std::make_shared<Link>(options);
  return {std::make_unique<MemoryTransport>(first, link, 0, options.with_line),
          std::make_unique<MemoryTransport>(second, link, 1, options.with_line)};
}

}  // namespace sbgc::io
