/// The one interface behind which every way to a gimbal stands.
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

/// A stream of bytes in both directions.
///
/// All calls must come from the executor's thread or strand (before it runs, from any one thread).
/// Handlers are called through the executor, never from inside a call, exactly once. One read and
/// one write may be under way at a time, independently of each other. Buffers must stay valid until
/// the handler is called.
///
/// A transport must not outlive the execution context of its executor. Destroying it closes it.
class Transport {
 public:
  using Handler = std::function<void(std::error_code, std::size_t)>;

  Transport() = default;
  Transport(const Transport&) = delete;
  Transport& operator=(const Transport&) = delete;
  virtual ~Transport() = default;

  /// Completes as soon as there is something, with at least 1 byte, or with an error and 0. `into`
  /// must not be empty. The end of the stream is an error: Errc::end_of_stream, or
  /// Errc::device_lost for a device that went away. Any error but a cancellation is final.
  virtual void async_read(std::span<std::uint8_t> into, Handler handler) = 0;

  /// Completes when all of `bytes` have been handed to the system, or with an error and the number
  /// of bytes handed over before it.
  virtual void async_write(std::span<const std::uint8_t> bytes, Handler handler) = 0;

  /// Ends what is under way, and whatever is begun later, with asio::error::operation_aborted. May
  /// be called twice.
  virtual void close() = 0;

  virtual asio::any_io_executor executor() = 0;

  /// What this is, for people: "serial port /dev/ttyUSB0, 115200 8N1".
  virtual std::string description() const = 0;

  /// The control of the line, null if there is no such thing. Lives as long as the transport.
  virtual LineControl* line() { return nullptr; }
};

/// A transport, or why there is none.
struct OpenResult {
  std::unique_ptr<Transport> transport{};
  Error error{};

  explicit operator bool() const noexcept { return transport != nullptr; }
};

}  // namespace sbgc::io
