/// Decides which commands of the broker are carried out, and refuses the others.
#pragma once

#include <array>
#include <atomic>
#include <chrono>
#include <cstddef>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "gateway/allowance.hpp"
#include "gateway/fleet.hpp"
#include "gateway/gimbal.hpp"
#include "gateway/gimbal_tasks.hpp"
#include "gateway/journal.hpp"
#include "gateway/mqtt.hpp"
#include "gateway/outbox.hpp"
#include "gateway/payload.hpp"

namespace sbgc::tools {

/// Who carries out the commands for a gimbal.
struct Station {
  Gimbal* gimbal{};
  std::shared_ptr<GimbalTasks> tasks{};
};

/// By the names of gimbals.
using Stations = std::map<std::string, Station>;

/// Detects what was published before a subscription: commands come in their order, so those that
/// come before our own message have waited at the broker.
class Fence {
 public:
  explicit Fence(std::string topic) : topic_(std::move(topic)) {}

  const std::string& topic() const noexcept { return topic_; }
  bool is_open() const noexcept { return is_open_; }
  void close(std::string token) {
    token_ = std::move(token);
    is_open_ = false;
  }
  void saw(const std::string& payload) { is_open_ = is_open_ || payload == token_; }
  const std::string& token() const noexcept { return token_; }

 private:
  std::string topic_;
  std::string token_{};
  bool is_open_ = false;
};

/// On the thread of the connection, but for close().
class Admission {
 public:
  /// `stations` and `mqtt` can be filled and constructed later.
  Admission(const BrokerSettings& settings, const Topics& topics, const Stations& stations,
            Journal& journal, Outbox& outbox, MqttConnection& mqtt);
  Admission(const Admission&) = delete;
  Admission& operator=(const Admission&) = delete;
  ~Admission() = default;

  /// What has arrived together. Commands go to their gimbals when they are on the disk.
  void take(const std::vector<MqttMessage>& messages);
  void connected();
  void subscribed();
  void lost();
  /// Who may command, but not read the topic of a fence, would wonder why nothing moves.
  void watch_fences();
  /// Nothing but stops from now on. Any thread.
  void close() noexcept { is_closing_ = true; }

 private:
  /// A command that is to be carried out once it is on the disk.
  struct Admitted {
    const Station* station{};
    GimbalTasks::Job job{};
  };

  /// True if a later `stop` for the gimbal has come with a command.
  using IsOvertaken = std::function<bool(const Station&)>;

  const Station* stop_at_once(const MqttMessage& message);
  GimbalTasks::Done answer_of_stop(const CommandTopic& topic, const MqttMessage& message);
  std::optional<Admitted> take_one(const MqttMessage& message, const IsOvertaken& is_overtaken);
  CommandPayload addressed_payload(const MqttMessage& message) const;
  const Station& station_for(const CommandTopic& topic, bool is_retained) const;
  std::optional<Admitted> admit(const CommandTopic& topic, const CommandPayload& payload,
                                const Station& station, bool is_overtaken);
  void check_times(const CommandPayload& payload) const;
  void check_freshness(const CommandTopic& topic, const CommandPayload& payload) const;
  void refuse(const CommandTopic& topic, const CommandPayload& payload, const char* code,
              const std::string& message);

  const BrokerSettings& settings_;
  const Topics& topics_;
  const Stations& stations_;
  Journal& journal_;
  Outbox& outbox_;
  MqttConnection& mqtt_;
  std::atomic<bool> is_closing_{false};
  std::array<Fence, 2> fences_;  // of cmd and raw
  std::optional<MqttConnection::Clock::time_point> fenced_{};
  std::chrono::system_clock::time_point connected_at_{};
  Allowance refusals_;
};

}  // namespace sbgc::tools
