/// Options for connecting and for calls.
#pragma once

#include <chrono>
#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include <sbgc/error.hpp>
#include <sbgc/frame.hpp>

namespace sbgc {

namespace io {
class Transport;
}  // namespace io

/// Options for connecting, and for the client afterwards.
struct ConnectOptions {
  /// The timeout for connecting: opening, detecting the baud rate, reading the board's versions. A
  /// tenth of it, at most 200 ms, is reserved for closing the line if no board is found.
  std::chrono::milliseconds timeout{20'000};
  /// Detect the baud rate and parity of a serial line if its address does not give them.
  bool detect_line = true;
  /// The number of repetitions of a request without a response, if the protocol allows them.
  unsigned retries = 2;
  /// The minimum time that an attempt waits for its response. By default, the timeout that the
  /// protocol specifies for the command, which can be too short for a radio link.
  std::chrono::milliseconds attempt_timeout{0};
  /// Keep the pause of 10 to 20 ms that the protocol requires after a command, until the board
  /// responds.
  bool pacing = true;
  /// Use the newest framing that the board's firmware understands and in which the board answers.
  /// Otherwise use the one that every board understands.
  bool newest_framing = true;
  /// The largest share of a serial line that data streams may use, in percent.
  unsigned stream_share_percent = 80;
  /// The time in which a line that duplicates packets, such as UDP, may deliver a frame again.
  /// Requests wait until no such duplicate can be mistaken for their response. 0 means that frames
  /// are never duplicated.
  std::chrono::milliseconds duplicate_window{0};
  /// The maximum number of queued calls.
  std::size_t queue_limit = 1024;
  /// The maximum time that a call may be queued, unless it has its own timeout.
  std::chrono::milliseconds queue_timeout{10'000};
  /// Unlocks a password-protected port. Sent before anything else, also at each rate that the line
  /// detection tries, and with each new connection; never part of an error or a notice. A capture
  /// does contain it.
  std::optional<std::string> password{};
  /// Records all traffic to this file, unless empty. An optional can be left out in a co_await
  /// expression of g++ 12, a string cannot: see AsyncClient.
  std::optional<std::string> capture{};
  /// Called once if the capture can no longer be written, for example because the disk is full; the
  /// connection goes on. On the connecting thread or the client's.
  std::function<void(const ClientError&)> on_capture_error{};
  /// Returns the transport to use in place of the one that was opened, for example one that
  /// observes it (<sbgc/io/observer.hpp>). Called on the connecting thread.
  std::function<std::unique_ptr<io::Transport>(std::unique_ptr<io::Transport>)> wrap{};
};

/// Options of one call.
struct CallOptions {
  /// The timeout of the whole call, including its time in the queue and all attempts. By default,
  /// each attempt has the timeout that the protocol specifies for the command, and the queue has
  /// ConnectOptions::queue_timeout.
  std::optional<std::chrono::milliseconds> timeout{};
  /// Overrides ConnectOptions::retries. No effect if repeating the request could do harm.
  std::optional<unsigned> retries{};
  /// Wait for the confirmation of a command that the board may leave unconfirmed. If none arrives,
  /// call() fails with ErrorCode::unconfirmed, and the reply of transact() says so.
  bool expect_confirmation = false;
  /// With it: repeat the request as if the confirmation were certain, unless that could do harm.
  bool repeat_unconfirmed = false;
  /// Reject a request with a value that the protocol does not allow on this board.
  bool validate = true;
  /// Called on the client's thread for each confirmation of a command that has several. `number`
  /// counts from 1.
  std::function<void(unsigned number)> on_confirmation{};
  /// Called on the client's thread for each message of a series that precedes the response; the
  /// frame is valid only during the call. The timeout above limits the whole series.
  std::function<void(const Frame&)> on_series{};
};

/// Returns the options of a call that ends when the board has confirmed it.
inline CallOptions confirming(CallOptions options = {}) {
  options.expect_confirmation = options.repeat_unconfirmed = true;
  return options;
}

}  // namespace sbgc
