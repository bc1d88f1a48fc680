/// The newest payload of each topic, for a reader that may be slower than the writers.
#pragma once

#include <cstdint>
#include <deque>
#include <mutex>
#include <optional>
#include <string>
#include <unordered_map>
#include <utility>

namespace sbgc::tools {

/// Thread-safe. Topics are taken in the order in which they became new, so that none starves.
class LatestByTopic {
 public:
  struct Entry {
    std::string topic{};
    std::string payload{};
  };

  /// Replaces the payload of the topic. Returns true if there was nothing to take before.
  bool put(std::string topic, std::string payload) {
    const std::scoped_lock lock(mutex_);
    const auto [at, is_new] = payloads_.insert_or_assign(topic, std::move(payload));
    if (!is_new) {
      ++thinned_;
      return false;
    }
    order_.push_back(std::move(topic));
    return order_.size() == 1;
  }

  std::optional<Entry> take() {
    const std::scoped_lock lock(mutex_);
    if (order_.empty()) return {};
    auto node = payloads_.extract(order_.front());
    order_.pop_front();
    return Entry{std::move(node.key()), std::move(node.mapped())};
  }

  /// Payloads that newer ones have replaced.
  std::uint64_t thinned() const {
    const std::scoped_lock lock(mutex_);
    return thinned_;
  }

 private:
  mutable std::mutex mutex_{};
  std::unordered_map<std::string, std::string> payloads_{};
  std::deque<std::string> order_{};
  std::uint64_t thinned_ = 0;
};

}  // namespace sbgc::tools
