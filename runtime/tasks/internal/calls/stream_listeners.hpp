/// Data streams, which run as long as they have subscribers.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include <sbgc/client/request.hpp>

namespace sbgc::detail {

/// Counts the listeners of each data stream and tracks which streams the board sends. The board
/// gets the shortest interval that a listener wants; each listener gets every sample that is due at
/// its own.
class StreamListeners {
 public:
  /// Identifies a stream by the id of its messages and its configuration.
  using Key = std::pair<std::uint8_t, std::array<std::uint8_t, max_stream_config>>;
  using Listener = std::uint64_t;

  static Key key_of(const Request& start) {
    return {start.policy.stream.command, start.policy.stream.config};
  }

  /// Adds a listener; `start` has its interval, `end` is the request that ends the stream.
  Listener join(const Key& key, const Request& start, Request end);
  /// Returns the request for the shortest interval.
  Request fastest(const Key& key) const;
  /// Counts a sample for a listener; returns true if it is due.
  bool is_due(const Key& key, Listener listener);
  /// Records that the board may send the stream at this interval. Returns the request to send if
  /// the listeners want another one; call it again when that request has ended.
  std::optional<Request> set_running(const Key& key, std::uint32_t interval_us);
  /// Removes a listener. Returns the request to send if the stream has to end or to become slower;
  /// when it has ended, call set_running() or, for that of a stream without listeners, end_sent().
  std::optional<Request> leave(const Key& key, Listener listener);
  void end_sent(const Key& key);

  /// Returns the requests that end all running streams, and forgets all streams.
  std::vector<Request> take_running();

 private:
  struct Share {
    Request start{};
    std::int64_t credit_us{};  // what has passed since its last sample

    std::int64_t interval_us() const { return start.policy.stream.interval_us; }
  };
  struct Stream {
    std::map<Listener, Share> shares{};
    bool is_running{};
    std::int64_t interval_us{};  // that of the board
    Request end{};

    const Request& fastest() const;
  };

  Listener last_ = 0;
  std::map<Key, Stream> streams_;
};

}  // namespace sbgc::detail
