#include <array>
#include <cerrno>
#include <cstdlib>
#include <tuple>
#include <utility>

#include <asio/posix/stream_descriptor.hpp>
#include <fcntl.h>

#include <sbgc/io/internal/descriptor.hpp>
#include <sbgc/io/internal/stream_transport.hpp>
#include <sbgc/io/pseudo_terminal.hpp>

#include "termios.hpp"

namespace sbgc::io {

namespace {

using Stream = asio::posix::stream_descriptor;
using Base = detail::StreamTransport<Stream, PseudoTerminal>;

class Master final : public Base {
 public:
  Master(Stream stream, std::string path, detail::Descriptor slave)
      : Base(std::move(stream), detail::translate_device),
        path_(std::move(path)),
        slave_(std::move(slave)) {}

  void async_write(std::span<const std::uint8_t> bytes, Handler handler) override {
    if (!slave_ || state()->closed) return Base::async_write(bytes, std::move(handler));
    // The terminal stays open. Bytes that do not fit are dropped, because the writer could
    // otherwise wait for a reader forever.
    std::error_code error;
    stream().non_blocking(true, error);
    for (auto rest = bytes; !rest.empty() && !error;) {
      rest = rest.subspan(stream().write_some(asio::buffer(rest.data(), rest.size()), error));
    }
    if (error == asio::error::would_block) error = {};
    const std::size_t size = error ? 0 : bytes.size();
    asio::post(executor(), [finish = state()->finisher(std::move(handler)), error, size] {
      finish(error, size);
    });
  }

  void close() override {
    Base::close();
    slave_ = detail::Descriptor();
  }

  std::string description() const override { return "pseudo-terminal " + path_; }
  std::string path() const override { return path_; }

  std::optional<LineSettings> other_line() const override {
    if (state()->closed) return std::nullopt;
    return detail::line_of(state()->stream.native_handle());
  }

 private:
  std::string path_;
  detail::Descriptor slave_;
};

PseudoTerminalResult failure() {
  const int reason = errno;
  return {nullptr,
          {std::error_code(reason, std::generic_category()),
           "Cannot create a pseudo-terminal: " + std::generic_category().message(reason) + "."}};
}

}  // namespace

PseudoTerminalResult open_pseudo_terminal(const asio::any_io_executor& executor,
                                          const PseudoTerminalOptions& options) {
  detail::Descriptor master(posix_openpt(O_RDWR | O_NOCTTY | O_CLOEXEC));
  std::array<char, 64> path{};
  if (!master || grantpt(master.get()) != 0 || unlockpt(master.get()) != 0 ||
      ptsname_r(master.get(), path.data(), path.size()) != 0) {
    return failure();
  }
  if (Error error = detail::make_raw(master.get(), default_line, path.data()))
    return {nullptr, error};
  detail::Descriptor slave;
  if (options.stays_open) {
    slave = detail::Descriptor(::open(path.data(), O_RDWR | O_NOCTTY | O_CLOEXEC));
    if (!slave) return failure();
  }
  Stream stream(executor);
  std::error_code error;
  stream.assign(master.get(), error);
  if (error) return failure();
  std::ignore = master.release();
  return {std::make_unique<Master>(std::move(stream), path.data(), std::move(slave)), {}};
}

}  // namespace sbgc::io
