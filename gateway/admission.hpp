/// Decides which commands of the broker are executed, and refuses the others.
#pragma once

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <cstddef>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "gateway/fleet.hpp"
#include "gateway/gimbal.hpp"
#include "gateway/gimbal_tasks.hpp"
#include "gateway/journal.hpp"
#include "gateway/mqtt.hpp"
#include "gateway/outbox.hpp"
#include "gateway/payload.hpp"
#include "gateway/worker.hpp"

namespace sbgc::tools {

/// Allows at most `most` at once, and `per_second` afterwards.
class RateLimiter {
 public:
  using Time = std::chrono::steady_clock::time_point;

  RateLimiter(double per_second, double most) : per_second_(per_second), most_(most), left_(most) {}

  /// Returns false if the limit is exceeded.
  bool take(Time now) {
    const std::chrono::duration<double> since = now - last_;
    left_ = std::min(most_, left_ + since.count() * per_second_);
    last_ = now;
    if (left_ < 1) return false;
    --left_;
    return true;
  }

 private:
  double per_second_;
  double most_;
  double left_;
  Time last_{};
};

/// The executor of the commands for a gimbal.
struct Station {
  Gimbal* gimbal{};
  std::shared_ptr<GimbalTasks> tasks{};
};

/// Stations by the names of their gimbals.
using Stations = std::map<std::string, Station>;

/// Detects messages that were published before a subscription: commands arrive in order, so those
/// that arrive before our own message have waited at the broker.
class SubscriptionBarrier {
 public:
  explicit SubscriptionBarrier(std::string topic) : topic_(std::move(topic)) {}

  const std::string& topic() const noexcept { return topic_; }
  bool is_open() const noexcept { return is_open_; }
  void close(std::string token) {
    token_ = std::move(token);
    is_open_ = false;
  }
  void saw(const std::string& payload) {
    is_open_ = is_open_ || (payload == token_ && !token_.empty());
  }
  const std::string& token() const noexcept { return token_; }

 private:
  std::string topic_;
  std::string token_{};
  bool is_open_ = false;
};

class Admission {
 public:
  /// `stations`, `disk`, which calls settle(), and `mqtt` may be filled and constructed later.
  Admission(const BrokerSettings& settings, const Topics& topics, const Stations& stations,
            Journal& journal, Worker& disk, Outbox& outbox, MqttConnection& mqtt);
  Admission(const Admission&) = delete;
  Admission& operator=(const Admission&) = delete;
  ~Admission() = default;

  // On the thread of the connection, which never waits for the journal.

  /// Processes arrived messages. Stops go to their gimbals at once; the rest waits for settle().
  void take(std::vector<MqttMessage> messages);
  /// True if no arrived message waits for the disk.
  bool is_settled() const;
  void connected();
  void subscribed();
  void lost();
  /// Warns if a user may command but not read the topic of a barrier, which blocks all motion.
  void watch_barriers();

  /// On the thread of the journal: passes commands to their gimbals once they are on disk.
  void settle();

  /// Accepts only stops from now on. May be called from any thread.
  void close() noexcept { is_closing_ = true; }

 private:
  /// A stop that was passed to its gimbal, and is not in the journal yet. It may end before that.
  struct Stop {
    std::string key{};
    ReplyAddress reply{};
    std::mutex mutex{};
    bool is_settled = false;           // it is in the journal, or never will be
    std::optional<std::int64_t> id{};  // there
    std::optional<Json> result{};
  };
  /// A command, or a refused stop, on its way to the disk.
  struct Received {
    std::shared_ptr<Stop> stop{};  // if set, only the topic matters
    MqttMessage message{};
    CommandTopic topic{};
    GimbalTasks::Clock::time_point arrived{};
    std::chrono::system_clock::time_point time{};  // the same
    std::chrono::system_clock::time_point connected_at{};
    const SubscriptionBarrier* barrier{};  // closed barrier: it may be older than the connection
    bool may_be_old{};                     // too old for a speed: something was suspended
    bool is_excess{};                      // too many messages wait for the disk
    std::uint64_t stops{};                 // see GimbalTasks::Job
  };
  /// A command to execute once it is on disk.
  struct Admitted {
    const Station* station{};
    GimbalTasks::Job job{};
  };

  void watch_delays(GimbalTasks::Clock::time_point now);
  bool see_barrier(const MqttMessage& message);
  bool stop_at_once(const CommandTopic& topic, const MqttMessage& message);
  GimbalTasks::Done answer_of_stop(const CommandTopic& topic, const MqttMessage& message);
  void finish_stop(const std::string& gimbal, Stop& stop);
  void record_stop(const Received& received);
  void queue(CommandTopic topic, MqttMessage message, GimbalTasks::Clock::time_point arrived);
  std::optional<Admitted> settle_one(const Received& received);
  CommandPayload addressed_payload(const MqttMessage& message,
                                   std::chrono::system_clock::time_point time) const;
  const Station& station_for(const CommandTopic& topic, bool is_retained) const;
  std::optional<Admitted> admit(const Received& received, const CommandPayload& payload,
                                const Station& station);
  void check_times(const Received& received, const CommandPayload& payload) const;
  void check_freshness(const Received& received, const CommandPayload& payload) const;
  void check_speed(const Received& received, const CommandPayload& payload) const;
  bool may_answer();
  void refuse(const CommandTopic& topic, const CommandPayload& payload, const char* code,
              const std::string& message);

  const BrokerSettings& settings_;
  const Topics& topics_;
  const Stations& stations_;
  Journal& journal_;
  Worker& disk_;
  Outbox& outbox_;
  MqttConnection& mqtt_;
  std::atomic<bool> is_closing_{false};

  // For the thread of the connection:
  std::array<SubscriptionBarrier, 2> barriers_;  // of cmd and raw
  std::optional<MqttConnection::Clock::time_point> barred_{};
  std::chrono::system_clock::time_point connected_at_{};
  GimbalTasks::Clock::time_point last_turn_{};
  GimbalTasks::Clock::time_point speeds_from_{};  // earlier ones may be old
  SubscriptionBarrier echo_;                      // and so may those before our own message
  std::uint64_t echoes_ = 0;

  // Shared:
  mutable std::mutex mutex_{};
  std::vector<Received> received_{};
  std::size_t received_bytes_ = 0;
  bool is_settling_ = false;
  RateLimiter refusals_;
};

}  // namespace sbgc::tools
