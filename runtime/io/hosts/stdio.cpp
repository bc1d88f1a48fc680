// Standard input and output as an endpoint.

#include <cerrno>
#include <stdexcept>
#include <utility>

#include <asio/buffer.hpp>
#include <asio/posix/stream_descriptor.hpp>
#include <asio/post.hpp>
#include <asio/write.hpp>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include "hosts/endpoint.hpp"
#include "hosts/host.hpp"

namespace sbgc::hosts {

namespace {

using Stream = asio::posix::stream_descriptor;

/// Standard input or output. Asio does not support regular files, which never block anyway.
class Descriptor {
 public:
  Descriptor(const asio::any_io_executor& executor, int fd)
      : fd_(fd), flags_(fcntl(fd, F_GETFL)), stream_(executor) {
    struct stat info {};
    const bool is_input = fd == STDIN_FILENO;
    if (flags_ == -1 || (flags_ & O_ACCMODE) == (is_input ? O_WRONLY : O_RDONLY) ||
        fstat(fd, &info) != 0) {
      throw std::runtime_error(is_input ? "the standard input cannot be read"
                                        : "the standard output cannot be written");
    }
    is_file_ = S_ISREG(info.st_mode);
    if (!is_file_) stream_.assign(dup(fd));
  }

  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  /// Restores the flags, because other processes may share the open file.
  ~Descriptor() {
    close();
    fcntl(fd_, F_SETFL, flags_);
  }

  void read(std::span<std::uint8_t> into, io::Transport::Handler handler) {
    if (!is_file_) {
      return stream_.async_read_some(asio::buffer(into.data(), into.size()), std::move(handler));
    }
    const ssize_t size = ::read(fd_, into.data(), into.size());
    if (size == 0) return complete(std::move(handler), asio::error::eof, 0);
    finish(std::move(handler), size);
  }

  void write(std::span<const std::uint8_t> bytes, io::Transport::Handler handler) {
    if (!is_file_) {
      return asio::async_write(stream_, asio::buffer(bytes.data(), bytes.size()),
                               std::move(handler));
    }
    std::size_t done = 0;
    while (done < bytes.size()) {
      const ssize_t size = ::write(fd_, bytes.data() + done, bytes.size() - done);
      if (size < 0) return finish(std::move(handler), size);
      done += static_cast<std::size_t>(size);
    }
    finish(std::move(handler), static_cast<ssize_t>(done));
  }

  void close() {
    std::error_code ignored;
    stream_.close(ignored);
  }

 private:
  void finish(io::Transport::Handler handler, ssize_t size) {
    if (size >= 0) return complete(std::move(handler), {}, static_cast<std::size_t>(size));
    complete(std::move(handler), std::error_code(errno, std::generic_category()), 0);
  }

  void complete(io::Transport::Handler handler, std::error_code error, std::size_t size) {
    asio::post(stream_.get_executor(),
               [handler = std::move(handler), error, size] { handler(error, size); });
  }

  int fd_;
  int flags_;
  Stream stream_;
  bool is_file_ = false;
};

class Stdio final : public io::Transport {
 public:
  explicit Stdio(const asio::any_io_executor& executor)
      : executor_(executor), input_(executor, STDIN_FILENO), output_(executor, STDOUT_FILENO) {}

  void async_read(std::span<std::uint8_t> into, Handler handler) override {
    input_.read(into, std::move(handler));
  }
  void async_write(std::span<const std::uint8_t> bytes, Handler handler) override {
    output_.write(bytes, std::move(handler));
  }
  void close() override {
    input_.close();
    output_.close();
  }
  asio::any_io_executor executor() override { return executor_; }
  std::string description() const override { return "standard input and output"; }

 private:
  asio::any_io_executor executor_;
  Descriptor input_;
  Descriptor output_;
};

class StdioEndpoint final : public Endpoint {
 public:
  explicit StdioEndpoint(std::shared_ptr<Host> host) : host_(std::move(host)) {}
  StdioEndpoint(const StdioEndpoint&) = delete;
  StdioEndpoint& operator=(const StdioEndpoint&) = delete;
  ~StdioEndpoint() override { host_->close(); }

  std::string address() const override { return "standard input and output"; }

 private:
  std::shared_ptr<Host> host_;
};

}  // namespace

std::unique_ptr<Endpoint> use_stdio(const asio::any_io_executor& executor, HostPorts& board,
                                    std::function<void(std::error_code)> on_end) {
  const auto host = Host::connect(board, std::make_unique<Stdio>(executor));
  if (host == nullptr) throw std::runtime_error("the board has no free port");
  host->on_end = std::move(on_end);
  host->start();
  return std::make_unique<StdioEndpoint>(host);
}

}  // namespace sbgc::hosts
