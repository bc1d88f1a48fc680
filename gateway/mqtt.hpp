/// A connection to an MQTT broker that is made again when it breaks.
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

/// A message for us. The members after is_retained are of MQTT 5, and empty if there are none.
struct MqttMessage {
  std::string topic{};
  std::string payload{};  ///< not more than longest_payload + 1 bytes of it
  bool is_retained = false;
  std::string reply{};
  std::string correlation{};
  std::string key{};  ///< of idempotence: the user property "key"
  std::optional<std::chrono::seconds> expiry{};
};

/// A message of ours. MQTT 3.1.1 has no place for the last two.
struct MqttPublication {
  std::string topic{};
  std::string payload{};
  int quality = 1;  ///< of service, 0 or 1
  bool is_retained = false;
  std::string correlation{};
  std::optional<std::chrono::seconds> expiry{};
};

/// Its thread talks to the broker; handlers run there. It tries the addresses in turn. A name
/// server that does not answer, or with MQTT 5 a host that does not, keeps the thread for a while.
class MqttConnection {
 public:
  using Clock = std::chrono::steady_clock;

  struct Handlers {
    /// What has arrived since the last call, in its order; several times a second, also if that is
    /// nothing. It must not wait.
    std::function<void(std::vector<MqttMessage>)> on_messages{};
    /// True if what has arrived may be acknowledged. Nothing at all is sent before, because the
    /// library has the acknowledgments among what it sends; wake() tells that it has changed.
    std::function<bool()> is_settled{};
    std::function<void()> on_connected{};
    /// With a reason for people; also if an attempt to connect has failed.
    std::function<void(const std::string& reason)> on_lost{};
    /// The broker has answered the last subscribe().
    std::function<void()> on_subscribed{};
    /// A message with quality 1 is acknowledged. `refused` says to which topic and why the broker
    /// did not take it, or is "". The library does not send it again.
    std::function<void(int id, const std::string& refused)> on_acknowledged{};
    /// There is time: after anything else, and several times a second. Returns true if there is
    /// more to do as soon as the socket has taken what was published.
    std::function<bool()> on_idle{};
    /// A handler has thrown this. The thread ends: it acknowledges nothing more, and breaks the
    /// connection, so that the broker publishes the will.
    std::function<void(const std::string& problem)> on_failure{};
  };

  /// Throws std::runtime_error if the settings cannot be used, such as a file that cannot be read.
  /// The broker publishes `will` when the connection breaks.
  MqttConnection(BrokerSettings settings, const MqttPublication& will, Handlers handlers);
  MqttConnection(const MqttConnection&) = delete;
  MqttConnection& operator=(const MqttConnection&) = delete;
  /// Breaks the connection, so that the broker publishes the will, unless close() has ended it.
  ~MqttConnection();

  void start();
  /// Ends the connection in order, without the will. Waits at most a second.
  void close();

  /// Makes the thread call on_idle() at once. Any thread.
  void wake() noexcept;

  /// When the broker was last heard. Any thread.
  Clock::time_point last_heard() const noexcept {
    return Clock::time_point(Clock::duration(last_heard_.load()));
  }

  // On the thread of the connection.

  bool is_connected() const noexcept { return is_connected_; }
  /// The broker may refuse all but the last subscription of a connection.
  void subscribe(const std::vector<std::string>& filters, int quality);
  /// Returns the id of the message; 0 if it is too large for the broker, or its topic cannot be
  /// one; nothing if it cannot be sent now. A message with quality 1 that has an id is sent again
  /// after the connection was lost, until it is acknowledged.
  std::optional<int> publish(const MqttPublication& message);
  /// True if publish() has an id. There are 65,535, for both qualities, and the next one can still
  /// belong to a message that the broker has not acknowledged.
  bool can_publish() const noexcept;
  /// Messages with quality 0 that the socket has not taken yet.
  std::size_t unsent() const noexcept { return unsent_.size(); }

 private:
  struct Callbacks;
  struct Destroy {
    void operator()(mosquitto* connection) const noexcept;
  };

  void set_up(const MqttPublication& will);
  /// Says what a status of the library means for this attempt or connection.
  std::string problem_of(int status) const;
  void run();
  void serve();
  /// Starts an attempt. Returns what went wrong, or "".
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
  bool is_holding_ = false;  // acknowledgments, until what has arrived is settled
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
