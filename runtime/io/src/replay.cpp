#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <optional>
#include <span>
#include <utility>
#include <variant>
#include <vector>

#include <asio/error.hpp>
#include <asio/post.hpp>
#include <asio/steady_timer.hpp>
#include <fcntl.h>
#include <sys/stat.h>

#include <sbgc/io/capture.hpp>
#include <sbgc/io/internal/descriptor.hpp>
#include <sbgc/io/replay.hpp>

namespace sbgc::io {

namespace {

/// Bytes from the board, and their time since the start of the file.
struct Piece {
  CaptureTime time{};
  std::vector<std::uint8_t> bytes{};
  std::size_t writes{};      ///< recorded before it
  CaptureTime last_write{};  ///< the time of the last of these
};

/// The pieces of a file, read on demand.
class Source {
 public:
  explicit Source(detail::Descriptor file)
      : file_(std::move(file)), block_(read_block()), raw_(!is_capture(block_)) {
    parser_.feed(raw_ ? std::span<const std::uint8_t>() : block_);
  }

  /// Returns the next piece; nullopt at the end.
  std::optional<Piece> next() { return raw_ ? next_raw() : next_record(); }

 private:
  std::optional<Piece> next_raw() {
    if (block_.empty()) return std::nullopt;
    Piece result{{}, std::move(block_)};
    block_ = read_block();
    return result;
  }

  std::optional<Piece> next_record() {
    for (;;) {
      while (const auto item = parser_.next()) {
        if (auto piece = take(*item)) return piece;
      }
      if (over_) return std::nullopt;
      const auto block = read_block();
      over_ = block.empty();
      if (over_) parser_.finish();
      parser_.feed(block);
    }
  }

  std::optional<Piece> take(const CaptureItem& item) {
    if (std::holds_alternative<CaptureSession>(item)) session_begin_ = last_;
    const auto* const record = std::get_if<CaptureRecord>(&item);
    if (record == nullptr) return std::nullopt;
    // Times in a file are untrusted: they must not run backwards or exceed all bounds.
    constexpr CaptureTime bound = std::chrono::years(1);
    last_ = std::max(last_, std::min(session_begin_ + std::min(record->time, bound), bound));
    if (record->kind == CaptureKind::to_board && !record->bytes.empty()) {
      ++writes_;
      last_write_ = last_;
    }
    if (record->kind != CaptureKind::from_board || record->bytes.empty()) return std::nullopt;
    return Piece{last_, {record->bytes.begin(), record->bytes.end()}, writes_, last_write_};
  }

  std::vector<std::uint8_t> read_block() {
    std::vector<std::uint8_t> block(65536);
    ssize_t size = 0;
    do {
      size = ::read(file_.get(), block.data(), block.size());
    } while (size < 0 && errno == EINTR);
    block.resize(static_cast<std::size_t>(std::max<ssize_t>(size, 0)));
    return block;
  }

  detail::Descriptor file_;
  std::vector<std::uint8_t> block_;
  bool raw_;
  bool over_ = false;
  CaptureParser parser_;
  CaptureTime session_begin_{};
  CaptureTime last_{};
  std::size_t writes_ = 0;  // so far
  CaptureTime last_write_{};
};

/// Outlives the transport while a read waits until it is due.
class Player : public std::enable_shared_from_this<Player> {
 public:
  using Handler = Transport::Handler;
  using Clock = std::chrono::steady_clock;

  Player(const asio::any_io_executor& executor, ReplayTiming timing, double speed,
         detail::Descriptor file)
      : timing_(timing),
        speed_(speed),
        waits_(timing == ReplayTiming::answers),
        source_(std::move(file)),
        timer_(executor) {}

  void read(std::span<std::uint8_t> into, Handler handler) {
    if (closed_) return complete(std::move(handler), asio::error::operation_aborted, 0);
    if (given_ == piece_.bytes.size() && !advance()) {
      return complete(std::move(handler), Errc::end_of_stream, 0);
    }
    if (!start_) start_ = Clock::now();
    if (timing_ == ReplayTiming::fast || (is_asked() && due() <= Clock::now())) {
      return complete(std::move(handler), {}, take(into));
    }
    wait(into, std::move(handler));
  }

  void write(std::span<const std::uint8_t> bytes, Handler handler) {
    if (closed_) return complete(std::move(handler), asio::error::operation_aborted, 0);
    ++writes_;
    if (!start_) start_ = Clock::now();
    if (waits_ && writes_ == piece_.writes) be_asked();
    timer_.cancel();  // a waiting piece may be due now
    complete(std::move(handler), {}, bytes.size());
  }

  void close() {
    closed_ = true;
    timer_.cancel();
  }

  asio::any_io_executor executor() { return timer_.get_executor(); }

 private:
  void complete(Handler handler, std::error_code error, std::size_t size) {
    asio::post(timer_.get_executor(),
               [handler = std::move(handler), error, size] { handler(error, size); });
  }

  Clock::duration played(CaptureTime time) const {
    return std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(time) /
                                                       speed_);
  }

  bool is_asked() const { return !waits_ || writes_ >= piece_.writes; }

  /// A late write delays the following pieces.
  void be_asked() { start_ = std::max(*start_, Clock::now() - played(piece_.last_write)); }

  /// Returns when the piece is due, or without a request for it, when it no longer waits for one.
  Clock::time_point due() const {
    if (is_asked()) return *start_ + played(piece_.time);
    return *start_ + played(piece_.last_write) + longest_wait;
  }

  void wait(std::span<std::uint8_t> into, Handler handler) {
    timer_.expires_at(due());
    timer_.async_wait(
        [self = shared_from_this(), into, handler = std::move(handler)](std::error_code) mutable {
          if (self->closed_) return handler(asio::error::operation_aborted, 0);
          if (!self->is_asked() && self->due() <= Clock::now()) {
            self->waits_ = false;  // this program sends something else
            self->be_asked();
          }
          if (self->due() > Clock::now()) return self->wait(into, std::move(handler));
          handler({}, self->take(into));
        });
  }

  bool advance() {
    auto next = source_.next();
    if (!next) return false;
    piece_ = std::move(*next);
    given_ = 0;
    return true;
  }

  std::size_t take(std::span<std::uint8_t> into) {
    const std::size_t size = std::min(into.size(), piece_.bytes.size() - given_);
    std::copy_n(piece_.bytes.begin() + static_cast<std::ptrdiff_t>(given_), size, into.begin());
    given_ += size;
    return size;
  }

  static constexpr std::chrono::seconds longest_wait{1};

  ReplayTiming timing_;
  double speed_;
  bool waits_;  // for writes of the program
  std::size_t writes_ = 0;
  Source source_;
  Piece piece_;
  std::size_t given_ = 0;  // of the piece
  std::optional<Clock::time_point> start_;
  asio::steady_timer timer_;
  bool closed_ = false;
};

class ReplayTransport final : public Transport {
 public:
  ReplayTransport(std::shared_ptr<Player> player, std::string path)
      : player_(std::move(player)), path_(std::move(path)) {}

  ReplayTransport(const ReplayTransport&) = delete;
  ReplayTransport& operator=(const ReplayTransport&) = delete;
  ~ReplayTransport() override { player_->close(); }

  void async_read(std::span<std::uint8_t> into, Handler handler) override {
    player_->read(into, std::move(handler));
  }
  void async_write(std::span<const std::uint8_t> bytes, Handler handler) override {
    player_->write(bytes, std::move(handler));
  }
  void close() override { player_->close(); }
  asio::any_io_executor executor() override { return player_->executor(); }
  std::string description() const override { return "capture " + path_; }

 private:
  std::shared_ptr<Player> player_;
  std::string path_;
};

}  // namespace

OpenResult open_replay(const asio::any_io_executor& executor, const std::string& path,
                       ReplayTiming timing, double speed) {
  detail::Descriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
  struct stat status {};
  if (!file || fstat(file.get(), &status) != 0) {
    const std::error_code reason(errno, std::generic_category());
    if (reason == std::errc::no_such_file_or_directory) {
      return {nullptr, {Errc::no_such_port, "There is no file " + path + "."}};
    }
    return {nullptr, {reason, path + " cannot be read: " + reason.message() + "."}};
  }
  if (!S_ISREG(status.st_mode)) {
    return {nullptr, {Errc::not_a_capture, path + " is not a file that can be replayed."}};
  }
  auto player = std::make_shared<Player>(executor, timing, speed, std::move(file));
  return {std::make_unique<ReplayTransport>(std::move(player), path), {}};
}

}  // namespace sbgc::io
