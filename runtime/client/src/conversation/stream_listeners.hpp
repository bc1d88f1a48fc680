/// Data streams: running as long as somebody is subscribed to them.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <mutex>
#include <optional>
#include <utility>
#include <vector>

#include <sbgc/client/request.hpp>

namespace sbgc::detail {

/// Who listens to which data stream, and which of them the board sends. Thread-safe.
class StreamListeners {
 public:
  /// What makes two streams the same: the id of their messages, and how they are configured.
  using Key = std::pair<std::uint8_t, std::array<std::uint8_t, max_stream_config>>;

  static Key key_of(const Request& start) {
    return {start.policy.stream.command, start.policy.stream.config};
  }

  /// One more listener; `end` is the request that ends the stream.
  void join(const Key& key, Request end);
  /// From now on the board may send it.
  void set_running(const Key& key);
  /// One listener less. If it was the last of a running stream, the result is the request to send;
  /// end_sent() follows when that is over.
  std::optional<Request> leave(const Key& key);
  void end_sent(const Key& key);

  /// The requests that end all streams that are running. Then nothing is left to leave.
  std::vector<Request> take_running();

 private:
  struct Stream {
    std::size_t listeners{};
    bool is_running{};
    Request end{};
  };

  std::mutex mutex_;
  std::map<Key, Stream> streams_;
};

}  // namespace sbgc::detail
