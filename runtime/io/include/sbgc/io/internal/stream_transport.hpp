/// A Transport over any Asio stream.
#pragma once

#include <memory>
#include <span>
#include <utility>

#include <asio/buffer.hpp>
#include <asio/error.hpp>
#include <asio/post.hpp>
#include <asio/write.hpp>

#include <sbgc/io/transport.hpp>

namespace sbgc::io::detail {

/// `translate` maps system errors to those that Transport specifies. `Interface` is Transport or
/// derived from it.
template <class Stream, class Interface = Transport>
class StreamTransport : public Interface {
 public:
  using Handler = Transport::Handler;
  using Translate = std::error_code (*)(std::error_code);

  StreamTransport(Stream stream, Translate translate)
      : state_(std::make_shared<State>(std::move(stream), translate)) {}

  StreamTransport(const StreamTransport&) = delete;
  StreamTransport& operator=(const StreamTransport&) = delete;
  ~StreamTransport() override { state_->close(); }

  void async_read(std::span<std::uint8_t> into, Handler handler) override {
    if (refuse(handler)) return;
    state_->stream.async_read_some(asio::buffer(into.data(), into.size()),
                                   state_->finisher(std::move(handler)));
  }

  void async_write(std::span<const std::uint8_t> bytes, Handler handler) override {
    if (refuse(handler)) return;
    asio::async_write(state_->stream, asio::buffer(bytes.data(), bytes.size()),
                      state_->finisher(std::move(handler)));
  }

  void close() override { state_->close(); }

  asio::any_io_executor executor() override { return state_->stream.get_executor(); }

 protected:
  /// Outlives the transport while an operation is pending.
  struct State : std::enable_shared_from_this<State> {
    State(Stream s, Translate t) : stream(std::move(s)), translate(t) {}

    void close() {
      closed = true;
      std::error_code ignored;
      stream.close(ignored);
    }

    auto finisher(Handler handler) {
      return [self = this->shared_from_this(), handler = std::move(handler)](std::error_code error,
                                                                             std::size_t size) {
        // After a partial write, the closed stream fails with another error.
        if (error && self->closed) {
          error = asio::error::operation_aborted;
        } else if (error) {
          error = self->translate(error);
        }
        handler(error, size);
      };
    }

    Stream stream;
    Translate translate;
    bool closed = false;
  };

  /// Returns true if the transport is closed; the handler has then been moved from.
  bool refuse(Handler& handler) {
    if (!state_->closed) return false;
    asio::post(state_->stream.get_executor(),
               [handler = std::move(handler)] { handler(asio::error::operation_aborted, 0); });
    return true;
  }

  const std::shared_ptr<State>& state() const { return state_; }
  Stream& stream() { return state_->stream; }

 private:
  std::shared_ptr<State> state_;
};

/// Translates errors of terminals: the other side of a pseudo-terminal is closed, or the device is
/// unplugged.
inline std::error_code translate_device(std::error_code error) {
  const int value = error.value();
  const bool system = error.category() == asio::error::get_system_category();
  if (error == asio::error::eof ||
      (system && (value == EIO || value == ENXIO || value == ENODEV))) {
    return Errc::device_lost;
  }
  return error;
}

}  // namespace sbgc::io::detail
