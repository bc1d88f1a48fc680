/// Observes the traffic of a transport.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <system_error>

#include <sbgc/io/line.hpp>
#include <sbgc/io/transport.hpp>

namespace sbgc::io {

/// An observer of the events of a transport, called on its executor.
class Observer {
 public:
  Observer() = default;
  Observer(const Observer&) = delete;
  Observer& operator=(const Observer&) = delete;
  virtual ~Observer() = default;

  /// Called with bytes that have arrived.
  virtual void on_read(std::span<const std::uint8_t> bytes) = 0;
  /// Called when the bytes are passed to the transport.
  virtual void on_written(std::span<const std::uint8_t> bytes) = 0;
  /// Called when a read has failed.
  virtual void on_read_failed([[maybe_unused]] std::error_code error) {}
  /// Called when a write fails after `size` of `all` bytes were passed to the system.
  virtual void on_write_failed([[maybe_unused]] std::error_code error,
                               [[maybe_unused]] std::size_t size,
                               [[maybe_unused]] std::size_t all) {}
  /// Called with the actual settings of the line after an attempt to change them.
  virtual void on_line_set([[maybe_unused]] const LineSettings& settings) {}
};

/// Returns a transport that forwards to `inner` and reports its events to the observer. The
/// observer lives until the last pending operation has ended.
std::unique_ptr<Transport> observe(std::unique_ptr<Transport> inner,
                                   std::shared_ptr<Observer> observer);

}  // namespace sbgc::io
