/// The messages to the broker: results and events stay on disk until it has acknowledged them,
/// states and samples stay in memory until newer ones replace them.
#pragma once

#include <atomic>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <map>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <unordered_map>
#include <utility>
#include <variant>
#include <vector>

#include <sbgc/json_dom.hpp>

#include "gateway/duplicate_gateway_detector.hpp"
#include "gateway/fleet.hpp"
#include "gateway/gimbal_tasks.hpp"
#include "gateway/journal.hpp"
#include "gateway/mqtt.hpp"
#include "gateway/payload.hpp"
#include "gateway/worker.hpp"

namespace sbgc::tools {

/// The newest payload of each topic, for a reader that may be slower than the writers. Thread-safe.
/// Topics are read in the order of their updates, so that none starves.
class LatestByTopic {
 public:
  struct Entry {
    std::string topic{};
    std::string payload{};
  };

  /// Replaces the payload of the topic. Returns true if nothing was pending before.
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

  /// The number of payloads that newer ones have replaced.
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

struct OutboxStatistics {
  std::uint64_t thinned{};       ///< samples of telemetry that newer ones replaced
  std::uint64_t dropped{};       ///< events and refusals for which there was no room
  std::uint64_t ignored{};       ///< stops with ignored errors
  std::uint64_t acknowledged{};  ///< results, events and refusals
  std::size_t waiting{};         ///< results, events and refusals on the disk
  std::size_t most_waiting{};
  std::uint64_t done{};  ///< commands, by their results
  std::uint64_t failed{};
  std::uint64_t refused{};
  std::uint64_t unknown{};
};

class Outbox {
 public:
  /// `disk`, which calls record(), and `mqtt` may be constructed later.
  Outbox(const BrokerSettings& settings, const Topics& topics,
         const DuplicateGatewayDetector& duplicates, Journal& journal, Worker& disk,
         MqttConnection& mqtt);
  Outbox(const Outbox&) = delete;
  Outbox& operator=(const Outbox&) = delete;
  ~Outbox() = default;

  // Any thread.

  /// Publishes an event, or the result of a command that is not in the journal.
  void notify(WaitingMessage notice);
  /// Records the end of a command of the journal.
  void finish(std::int64_t command, const std::string& gimbal, const Json& result);
  /// Records that no command up to this one has left the gimbal in motion.
  void set_at_rest(const std::string& gimbal, std::int64_t command);
  void put_sample(std::string topic, std::string payload);
  /// Publishes a retained state, again with each connection.
  void set_state(const std::string& topic, std::string payload);
  /// Returns the payload of the gateway's own topics.
  std::string gateway_state(const char* state) const;
  void count(const std::string& status);
  void count_dropped() noexcept { ++overflowed_; }
  void count_ignored() noexcept { ++ignored_; }
  OutboxStatistics statistics() const;
  /// The number of commands of the journal that have not ended.
  std::size_t running() const noexcept { return running_; }

  // On the thread of the journal.

  void has_begun() noexcept { ++running_; }
  /// Writes a result to the journal.
  void answer(WaitingKind kind, const std::string& gimbal, const ReplyAddress& address,
              Json result);
  /// Commits all ended commands, events and acknowledgments; then publish() gets more.
  void record();

  // On the thread of the connection, which never waits for the journal.

  void connected();
  void acknowledged(int id, const std::string& refused);
  /// True if the acknowledgment of a heartbeat is late, or was late since the last call.
  bool was_late(MqttConnection::Clock::time_point now);
  /// Returns true if publishable messages are left.
  bool publish();

 private:
  /// The end of a command, or of its motion, on its way to the disk.
  struct Ended {
    std::int64_t command{};
    std::string gimbal{};
    std::string result{};
  };
  struct AtRest {
    std::int64_t command{};
    std::string gimbal{};
  };
  /// A message that is too large for the broker.
  struct Oversized {
    WaitingMessage message{};
  };
  using Happening = std::variant<WaitingMessage, Ended, AtRest, Oversized>;
  /// A message of the journal that the broker has refused.
  struct RefusedMessage {
    MqttConnection::Clock::time_point again{};
    std::int64_t id{};
  };

  void settle_unfinished();
  void happen(Happening happening);
  void load();
  void write(const Happening& happening);
  void shorten(const WaitingMessage& message);
  void publish_waiting();
  void publish_states();
  bool publish_telemetry();
  void beat();

  const BrokerSettings& settings_;
  const Topics& topics_;
  const DuplicateGatewayDetector& duplicates_;
  Journal& journal_;
  Worker& disk_;
  MqttConnection& mqtt_;

  // Shared:
  LatestByTopic telemetry_{};
  mutable std::mutex mutex_{};
  std::deque<Happening> happenings_{};
  std::vector<std::int64_t> delivered_{};            // messages of the journal, acknowledged
  std::deque<RefusedMessage> refused_{};             // the others
  std::deque<WaitingMessage> loaded_{};              // messages of the journal to publish
  std::size_t in_flight_ = 0;                        // these, and the unacknowledged ones
  std::map<std::string, std::string> states_{};      // by topic
  std::map<std::string, std::string> new_states_{};  // states to publish
  std::map<std::string, std::uint64_t> ended_{};     // commands by status
  std::atomic<std::uint64_t> acknowledged_{0};
  std::atomic<std::size_t> waiting_{0};
  std::atomic<std::uint64_t> gave_way_{0};    // notices on the disk
  std::atomic<std::uint64_t> overflowed_{0};  // notices that were never stored
  std::atomic<std::uint64_t> ignored_{0};
  std::atomic<std::size_t> running_{0};

  // For the thread of the connection:
  std::unordered_map<int, std::int64_t> on_the_way_{};  // messages of the journal by their MQTT id
  std::set<std::string> refusals_{};                    // already reported for this connection
  std::optional<int> heartbeat_{};
  MqttConnection::Clock::time_point last_beat_{};
  bool was_late_ = false;

  std::int64_t last_loaded_ = 0;  // of the thread of the journal
};

}  // namespace sbgc::tools
