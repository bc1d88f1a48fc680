#include "hosts/without_http.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <utility>

#include <asio/error.hpp>
#include <asio/post.hpp>

namespace sbgc::hosts {

namespace {

/// The methods that a web page can use, and the beginning of a TLS handshake for https.
constexpr std::array<std::string_view, 10> beginnings{"GET ",     "POST ",   "PUT ",   "HEAD ",
                                                      "OPTIONS ", "DELETE ", "PATCH ", "CONNECT ",
                                                      "TRACE ",   "\x16\x03"};
constexpr std::size_t longest_beginning = 8;

/// Shared with the handler of a pending read.
class Filter : public std::enable_shared_from_this<Filter> {
 public:
  using Handler = io::Transport::Handler;

  explicit Filter(std::unique_ptr<io::Transport> transport) : inner(std::move(transport)) {}

  void read(std::span<std::uint8_t> into, Handler handler) {
    if (is_decided_ && first_.empty()) return inner->async_read(into, std::move(handler));
    if (is_decided_) {
      return asio::post(inner->executor(), [self = shared_from_this(), into, handler] {
        self->pass_on(into, handler);
      });
    }
    inner->async_read(
        std::span(buffer_).first(longest_beginning - first_.size()),
        [self = shared_from_this(), into, handler](std::error_code error, std::size_t size) {
          const auto* const begin = self->buffer_.data();
          self->first_.append(begin, begin + size);
          self->decide(error, into, handler);
        });
  }

  const std::unique_ptr<io::Transport> inner;

 private:
  void decide(std::error_code error, std::span<std::uint8_t> into, const Handler& handler) {
    const auto is_request = [this](std::string_view one) { return first_.starts_with(one); };
    const auto may_be_request = [this](std::string_view one) { return one.starts_with(first_); };
    if (std::ranges::any_of(beginnings, is_request)) {
      return handler(std::make_error_code(std::errc::wrong_protocol_type), 0);
    }
    const bool is_end = error && error != asio::error::operation_aborted;
    if (!error && std::ranges::any_of(beginnings, may_be_request)) return read(into, handler);
    if (error && (!is_end || first_.empty())) return handler(error, 0);
    is_decided_ = true;  // after the end of the stream, the next read fails in the same way
    pass_on(into, handler);
  }

  void pass_on(std::span<std::uint8_t> into, const Handler& handler) {
    const std::size_t size = std::min(first_.size(), into.size());
    std::copy_n(first_.begin(), size, into.begin());
    first_.erase(0, size);
    handler({}, size);
  }

  std::array<std::uint8_t, longest_beginning> buffer_{};
  std::string first_;
  bool is_decided_ = false;
};

class WithoutHttp final : public io::Transport {
 public:
  explicit WithoutHttp(std::unique_ptr<io::Transport> transport)
      : filter_(std::make_shared<Filter>(std::move(transport))) {}
  WithoutHttp(const WithoutHttp&) = delete;
  WithoutHttp& operator=(const WithoutHttp&) = delete;
  ~WithoutHttp() override { filter_->inner->close(); }

  void async_read(std::span<std::uint8_t> into, Handler handler) override {
    filter_->read(into, std::move(handler));
  }
  void async_write(std::span<const std::uint8_t> bytes, Handler handler) override {
    filter_->inner->async_write(bytes, std::move(handler));
  }
  void close() override { filter_->inner->close(); }
  asio::any_io_executor executor() override { return filter_->inner->executor(); }
  std::string description() const override { return filter_->inner->description(); }

 private:
  std::shared_ptr<Filter> filter_;
};

}  // namespace

std::unique_ptr<io::Transport> without_http(std::unique_ptr<io::Transport> transport) {
  return std::make_unique<WithoutHttp>(std::move(transport));
}

bool is_http_request(std::error_code error) {
  return error == std::make_error_code(std::errc::wrong_protocol_type);
}

}  // namespace sbgc::hosts
