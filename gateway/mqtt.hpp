/// A connection to an MQTT broker that is restored when it breaks.
#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <thread>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include <sbgc/io/internal/descriptor.hpp>

#include "gateway/fleet.hpp"
#include "gateway/tls.hpp"

struct mosquitto;

namespace sbgc::tools {

/// A received message. The members after is_retained are only set with MQTT 5.
struct MqttMessage {
  std::string topic{};
  std::string payload{};  ///< at most longest_payload + 1 bytes of it
  bool is_retained = false;
  std::string reply{};
  std::string correlation{};
  std::string key{};  ///< the idempotency key: the user property "key"
  std::optional<std::chrono::seconds> expiry{};
};

/// A message to publish. MQTT 3.1.1 does not support the last two members.
struct MqttPublication {
  std::string topic{};
  std::string payload{};
  int quality = 1;  ///< of service, 0 or 1
  bool is_retained = false;
  std::string correlation{};
  std::optional<std::chrono::seconds> expiry{};
};

/// Its thread talks to the broker; handlers run on it. It tries the addresses in turn. An
/// unresponsive name server, or with MQTT 5 an unresponsive host, blocks the thread for a while.
class MqttConnection {
 public:
  using Clock = std::chrono::steady_clock;

  struct Handlers {
    /// Receives the messages since the last call, in order; called several times per second,
    /// possibly without messages. It must not block.
    std::function<void(std::vector<MqttMessage>)> on_messages{};
    /// True if received messages may be acknowledged. Nothing at all is sent before, because the
    /// library mixes acknowledgments with other data; call wake() when this changes.
    std::function<bool()> is_settled{};
    std::function<void()> on_connected{};
    /// Called with a reason for people; also if an attempt to connect has failed.
    std::function<void(const std::string& reason)> on_lost{};
    /// Called when the broker has answered the last subscribe().
    std::function<void()> on_subscribed{};
    /// Called when a message with quality 1 is acknowledged. `refused` gives the topic and the
    /// reason if the broker has rejected it, or is "". The library does not send it again.
    std::function<void(int id, const std::string& refused)> on_acknowledged{};
    /// Called when there is time: after everything else, and several times per second. Returns true
    /// if there is more to do as soon as the socket has accepted the published data.
    std::function<bool()> on_idle{};
    /// Called when a handler has thrown. The thread ends: it acknowledges nothing more, and breaks
    /// the connection, so that the broker publishes the will.
    std::function<void(const std::string& problem)> on_failure{};
  };

  /// Throws std::runtime_error if the settings are unusable, for example because a file cannot be
  /// read. The broker publishes `will` when the connection breaks.
  MqttConnection(BrokerSettings settings, const MqttPublication& will, Handlers handlers);
  MqttConnection(const MqttConnection&) = delete;
  MqttConnection& operator=(const MqttConnection&) = delete;
  /// Breaks the connection, so that the broker publishes the will, unless close() has ended it.
  ~MqttConnection();

  void start();
  /// Closes the connection cleanly, without the will. Waits at most a second.
  void close();

  /// Makes the thread call on_idle() at once. Any thread.
  void wake() noexcept;

  /// Returns the time of the last traffic from the broker. Any thread.
  Clock::time_point last_heard() const noexcept {
    return Clock::time_point(Clock::duration(last_heard_.load()));
  }

  // On the thread of the connection.

  bool is_connected() const noexcept { return is_connected_; }
  /// The broker may refuse all but the last subscription of a connection.
  void subscribe(const std::vector<std::string>& filters, int quality);
  /// Returns the id of the message; 0 if it is too large for the broker, or its topic is invalid;
  /// nothing if it cannot be sent now. A message with quality 1 and an id is sent again after the
  /// connection was lost, until it is acknowledged.
  std::optional<int> publish(const MqttPublication& message);
  /// True if publish() has a free id. There are 65,535, for both qualities, and the next one may
  /// still belong to an unacknowledged message.
  bool can_publish() const noexcept;
  /// The number of messages with quality 0 that the socket has not accepted yet.
  std::size_t unsent() const noexcept { return unsent_.size(); }

 private:
  struct Callbacks;
  struct Destroy {
    void operator()(mosquitto* connection) const noexcept;
  };

  void set_up(const MqttPublication& will);
  /// Explains a status of the library for this attempt or connection.
  std::string problem_of(int status) const;
  void run();
  void serve();
  /// Starts an attempt. Returns the problem, or "".
  std::string connect();
  void forget_wakes();
  /// Waits for the broker or wake(), and reads and writes. Returns why the connection broke, or "".
  std::string turn();
  std::string read();
  bool can_write();
  /// Waits for `pause` or until the end.
  void rest(std::chrono::milliseconds pause);

  const BrokerSettings settings_;
  const Handlers handlers_;
  const io::detail::Descriptor wake_;
  std::unique_ptr<mosquitto, Destroy> connection_;
  std::thread thread_{};
  std::atomic<bool> is_closing_{false};
  std::atomic<bool> is_breaking_{false};
  std::atomic<Clock::rep> last_heard_{};
  // Only the thread uses these:
  std::size_t attempts_ = 0;
  bool is_connected_ = false;
  bool has_more_ = false;    // to do
  bool is_holding_ = false;  // acknowledgments are held until received messages are settled
  std::string refusal_{};    // of the broker
  std::vector<MqttMessage> arrived_{};
  std::size_t arrived_bytes_ = 0;
  int last_id_ = 0;
  int subscription_ = 0;                                   // the id of the last one
  std::vector<std::string> filters_{};                     // of it
  std::unordered_set<int> unsent_{};                       // ids of messages with quality 0
  std::unordered_map<int, std::string> unacknowledged_{};  // the same with quality 1; their topics
  Clock::time_point begun_{};                              // of the attempt
  BrokerAddress address_{};                                // the same
  TlsLog tls_{};                                           // the same
};

}  // namespace sbgc::tools
