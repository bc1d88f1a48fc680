/// Data streams with listeners, and for firmware without data streams, repeated requests.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include <sbgc/client/options.hpp>
#include <sbgc/client/request.hpp>
#include <sbgc/time.hpp>

namespace sbgc::detail {

/// Counts the listeners of each data stream and tracks the streams of the board. The board gets the
/// shortest interval that a listener wants; each listener gets every sample that is due at its own
/// interval.
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
    std::int64_t credit_us{};  // the time since its last sample

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

/// A schedule of requests. A request is not repeated before it has been answered, so that a slow
/// line or board is not flooded.
class Polls {
 public:
  struct Poll {
    Request request{};
    CallOptions options{};
    std::multiset<Duration> intervals{};  // of the listeners
    Instant next{};
    bool is_pending{};
  };

  /// Adds a listener; the shortest interval counts, as with streams.
  void join(const Request& request, const CallOptions& options, Duration interval, Instant now) {
    Poll& poll = polls_[request.id];
    poll.request = request;
    poll.options = options;
    poll.intervals.insert(interval);
    poll.next = now + *poll.intervals.begin();
  }
  /// Removes a listener with this interval.
  void leave(std::uint8_t id, Duration interval) {
    const auto at = polls_.find(id);
    if (at == polls_.end()) return;
    std::multiset<Duration>& intervals = at->second.intervals;
    const Duration before = *intervals.begin();
    intervals.erase(intervals.find(interval));
    if (intervals.empty()) {
      polls_.erase(at);
    } else {
      at->second.next = at->second.next - before + *intervals.begin();
    }
  }

  /// Returns the due requests, which are pending from now on.
  std::vector<Poll> take_due(Instant now) {
    std::vector<Poll> due;
    for (auto& [id, poll] : polls_) {
      if (poll.is_pending || now < poll.next) continue;
      poll.is_pending = true;
      poll.next = std::max(poll.next + *poll.intervals.begin(), now);
      due.push_back(poll);
    }
    return due;
  }
  void end_pending(std::uint8_t id) {
    const auto at = polls_.find(id);
    if (at != polls_.end()) at->second.is_pending = false;
  }
  /// Returns when the next one is due.
  Instant next() const {
    Instant result = Instant::never;
    for (const auto& [id, poll] : polls_) {
      if (!poll.is_pending) result = std::min(result, poll.next);
    }
    return result;
  }

 private:
  std::map<std::uint8_t, Poll> polls_;  // by the id of the request
};

}  // namespace sbgc::detail
