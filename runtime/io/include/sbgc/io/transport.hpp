/// The interface of all transports.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <system_error>

#include <asio/any_io_executor.hpp>

#include <sbgc/io/error.hpp>
#include <sbgc/io/line.hpp>

namespace sbgc::io {

/// A bidirectional byte stream.
///
/// All calls must come from the executor's thread or strand (before it runs, from any one thread).
/// Each handler is called exactly once, through the executor and never from inside a call. One read
/// and one write may be pending at a time. Buffers must stay valid until the handler is called.
///
/// A transport must not outlive the execution context of its executor. Destroying it closes it.
class Transport {
 public:
  /// A callback with the error and the number of bytes.
  using Handler = std::function<void(std::error_code, std::size_t)>;

  Transport() = default;
  Transport(const Transport&) = delete;
  Transport& operator=(const Transport&) = delete;
  virtual ~Transport() = default;

  /// Completes as soon as bytes are available, with at least 1 byte, or with an error and 0. `into`
  /// must not be empty. The end of the stream is an error: Errc::end_of_stream, or
  /// Errc::device_lost for an unplugged device. Every error except a cancellation is final.
  virtual void async_read(std::span<std::uint8_t> into, Handler handler) = 0;

  /// Completes when all of `bytes` have been passed to the system, or with an error and the number
  /// of bytes passed before it.
  virtual void async_write(std::span<const std::uint8_t> bytes, Handler handler) = 0;

  /// Ends pending and later operations with asio::error::operation_aborted. May be called more than
  /// once.
  virtual void close() = 0;

  /// Returns the executor of its handlers.
  virtual asio::any_io_executor executor() = 0;

  /// Returns a description for the user: "serial port /dev/ttyUSB0, 115200 8N1".
  virtual std::string description() const = 0;

  /// Returns the control of the line; null if the transport has none. Valid as long as the
  /// transport.
  virtual LineControl* line() { return nullptr; }

  /// Returns the file descriptor of the line, which remains the transport's; -1 if there is none,
  /// or if it alone does not carry the bytes. See adopt().
  virtual int native_handle() { return -1; }

  /// Returns true if bytes may arrive twice, or in a different order.
  virtual bool may_repeat() const { return false; }
};

/// A transport, or the error that prevented opening it.
struct OpenResult {
  std::unique_ptr<Transport> transport{};  ///< null after an error
  Error error{};

  /// True if it was opened.
  explicit operator bool() const noexcept { return transport != nullptr; }
};

}  // namespace sbgc::io
