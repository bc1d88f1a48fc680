// Packet ids, with a broker that acknowledges when the test wants it.

#include "gateway/mqtt.hpp"

#include <array>
#include <atomic>
#include <chrono>
#include <cstdint>
#include <future>
#include <thread>
#include <utility>
#include <vector>

#include <arpa/inet.h>
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

namespace sbgc::tools {
namespace {

/// Speaks just enough MQTT 3.1.1 for one connection, and acknowledges no message by itself.
class SilentBroker {
 public:
  SilentBroker() : listener_(::socket(AF_INET, SOCK_STREAM, 0)) {
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    socklen_t size = sizeof address;
    auto* const any = reinterpret_cast<sockaddr*>(&address);
    EXPECT_EQ(::bind(listener_, any, size), 0);
    EXPECT_EQ(::listen(listener_, 1), 0);
    EXPECT_EQ(::getsockname(listener_, any, &size), 0);
    port_ = ntohs(address.sin_port);
    thread_ = std::thread([this] { serve(); });
  }
  SilentBroker(const SilentBroker&) = delete;
  SilentBroker& operator=(const SilentBroker&) = delete;
  ~SilentBroker() {
    ::shutdown(listener_, SHUT_RDWR);
    if (line_ >= 0) ::shutdown(line_, SHUT_RDWR);
    thread_.join();
    ::close(listener_);
    if (line_ >= 0) ::close(line_);
  }

  std::uint16_t port() const { return port_; }

  void acknowledge(int id) {
    const std::array<std::uint8_t, 4> packet{0x40, 2, static_cast<std::uint8_t>(id >> 8),
                                             static_cast<std::uint8_t>(id)};
    EXPECT_EQ(::write(line_, packet.data(), packet.size()), 4);
  }

 private:
  void serve() {
    line_ = ::accept(listener_, nullptr, nullptr);
    std::array<std::uint8_t, 65'536> bytes{};
    if (line_ < 0 || ::read(line_, bytes.data(), bytes.size()) <= 0) return;
    const std::array<std::uint8_t, 4> accepted{0x20, 2, 0, 0};
    EXPECT_EQ(::write(line_, accepted.data(), accepted.size()), 4);
    while (::read(line_, bytes.data(), bytes.size()) > 0) continue;
  }

  int listener_;
  std::atomic<int> line_{-1};
  std::uint16_t port_ = 0;
  std::thread thread_{};
};

/// Publishes one message that the broker does not acknowledge, followed by as much telemetry as
/// possible.
class Publisher {
 public:
  static constexpr int last_id = 65'535;

  explicit Publisher(std::uint16_t port)
      : connection_(settings(port), {.topic = "will"}, handlers()) {
    connection_.start();
  }

  std::future<void> used_all_ids() { return used_all_ids_.get_future(); }
  std::future<void> went_on() { return went_on_.get_future(); }
  int first() const { return first_; }
  void close() { connection_.close(); }

  // After close():

  const std::vector<int>& acknowledged() const { return acknowledged_; }
  const std::vector<int>& used_too_early() const { return used_too_early_; }

 private:
  static BrokerSettings settings(std::uint16_t port) {
    BrokerSettings result;
    result.addresses = {{"127.0.0.1", port}};
    result.client_id = "test";
    return result;
  }

  MqttConnection::Handlers handlers() {
    return {.on_messages = [](const auto&) {},
            .on_connected = [] {},
            .on_lost = [](const auto&) {},
            .on_subscribed = [] {},
            .on_acknowledged = [this](int id, const auto&) { acknowledged_.push_back(id); },
            .on_idle = [this] { return publish(); },
            .on_failure = [](const auto&) {}};
  }

  bool publish() {
    if (!connection_.is_connected() || samples_ > last_id) return false;
    if (first_ == 0) first_ = connection_.publish({.topic = "event"}).value_or(0);
    while (connection_.unsent() < 100 && samples_ <= last_id) {
      const auto id = connection_.publish({.topic = "telemetry", .quality = 0});
      if (!id) {
        if (!std::exchange(is_blocked_, true)) used_all_ids_.set_value();
        return false;
      }
      if (*id == first_ && acknowledged_.empty()) used_too_early_.push_back(*id);
      ++samples_;
    }
    if (samples_ > last_id) went_on_.set_value();
    return true;
  }

  std::promise<void> used_all_ids_{};
  std::promise<void> went_on_{};
  std::atomic<int> first_{0};
  int samples_ = 0;
  bool is_blocked_ = false;
  std::vector<int> acknowledged_{};
  std::vector<int> used_too_early_{};
  MqttConnection connection_;  // last: its thread uses the others
};

TEST(MqttIds, none_is_used_twice_at_the_same_time) {
  using std::chrono::minutes;
  SilentBroker broker;
  Publisher publisher(broker.port());
  const auto used = publisher.used_all_ids().wait_for(minutes(1));
  ASSERT_EQ(used, std::future_status::ready);
  broker.acknowledge(publisher.first());
  const auto went_on = publisher.went_on().wait_for(minutes(1));
  publisher.close();
  EXPECT_EQ(went_on, std::future_status::ready);
  EXPECT_EQ(publisher.acknowledged(), std::vector{publisher.first()});
  EXPECT_TRUE(publisher.used_too_early().empty());
}

}  // namespace
}  // namespace sbgc::tools
