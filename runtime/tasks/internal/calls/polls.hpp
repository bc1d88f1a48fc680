/// Requests that are repeated, for firmware without data streams.
#pragma once

#include <algorithm>
#include <cstdint>
#include <map>
#include <set>
#include <vector>

#include <sbgc/client/options.hpp>
#include <sbgc/client/request.hpp>
#include <sbgc/time.hpp>

namespace sbgc::detail {

/// A schedule of requests. One is not repeated before it has been answered, so that a slow
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

  /// Returns what is due, which is pending from now on.
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
  /// When the next one is due.
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
