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

/// Counts the listeners of each data stream and tracks which streams the board sends.
class StreamListeners {
 public:
  /// Identifies a stream by the id of its messages and its configuration.
  using Key = std::pair<std::uint8_t, std::array<std::uint8_t, max_stream_config>>;

  static Key key_of(const Request& start) {
    return {start.policy.stream.command, start.policy.stream.config};
  }

  /// Adds a listener; `end` is the request that ends the stream.
  void join(const Key& key, Request end);
  /// Records that the board may send the stream.
  void set_running(const Key& key);
  /// Removes a listener. If it was the last one of a running stream, returns the request to send;
  /// call end_sent() when that request has ended.
  std::optional<Request> leave(const Key& key);
  void end_sent(const Key& key);

  /// Returns the requests that end all running streams, and forgets all streams.
  std::vector<Request> take_running();

 private:
  struct Stream {
    std::size_t listeners{};
    bool is_running{};
    Request end{};
  };

  std::map<Key, Stream> streams_;
};

}  // namespace sbgc::detail
