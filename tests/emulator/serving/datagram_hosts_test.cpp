// Tests of the hosts that keep a place for datagrams.

#include "serving/datagram_hosts.hpp"

#include <cstdint>
#include <optional>

#include <gtest/gtest.h>

namespace sbgc::serving {
namespace {

using Port = std::optional<std::size_t>;

/// Hosts identified by the number of their UDP port, which is also that of the board's port.
struct HostsRig {
  DatagramHosts hosts{4};
  Instant now{};

  static asio::ip::udp::endpoint endpoint(std::uint16_t number) {
    return {asio::ip::address_v4::loopback(), number};
  }
  /// Returns true if the host has a place afterwards.
  bool say(std::uint16_t number) {
    if (hosts.find(endpoint(number)) != nullptr) {
      hosts.hear(endpoint(number), now);
      return true;
    }
    if (hosts.is_full() && !hosts.make_room(now)) return false;
    hosts.add(endpoint(number), number, now);
    return true;
  }
  bool is_present(std::uint16_t number) const { return hosts.find(endpoint(number)) != nullptr; }
  void wait(Duration time) { now = now + time; }
};

TEST(DatagramHosts, APasserByMakesRoomSoon) {
  HostsRig rig;
  for (std::uint16_t number = 1; number <= 4; ++number) EXPECT_TRUE(rig.say(number));
  EXPECT_FALSE(rig.say(5));
  rig.wait(milliseconds(499));
  EXPECT_FALSE(rig.say(5));
  rig.wait(milliseconds(1));
  EXPECT_TRUE(rig.say(5));
  EXPECT_FALSE(rig.is_present(1)) << "the longest silent one";
  EXPECT_TRUE(rig.is_present(2));
}

TEST(DatagramHosts, OneThatTalksKeepsItsPlace) {
  HostsRig rig;
  rig.say(1);
  rig.say(1);
  std::uint16_t other = 100;
  for (int i = 0; i < 1000; ++i) {
    rig.wait(milliseconds(50));
    rig.say(other++);
    if (i % 90 == 89) {
      EXPECT_TRUE(rig.say(1));
    }
    EXPECT_TRUE(rig.is_present(1)) << i;
    EXPECT_LE(rig.hosts.all().size(), 4U);
  }
}

TEST(DatagramHosts, TheLongestSilentGoesFirst) {
  HostsRig rig;
  for (const bool again : {false, true}) {
    for (std::uint16_t number = 1; number <= 4; ++number) {
      if (again) rig.wait(milliseconds(1000));
      rig.say(number);
    }
  }
  rig.say(1);
  rig.wait(milliseconds(2999));
  EXPECT_FALSE(rig.say(5)) << "all have been heard within 5 s";
  rig.wait(milliseconds(1));
  EXPECT_TRUE(rig.say(5));
  EXPECT_FALSE(rig.is_present(2));
  for (const std::uint16_t number : {std::uint16_t{1}, std::uint16_t{3}, std::uint16_t{4}}) {
    EXPECT_TRUE(rig.is_present(number)) << number;
  }
}

TEST(DatagramHosts, PassersByGoBeforeThoseThatTalk) {
  HostsRig rig;
  for (std::uint16_t number = 1; number <= 3; ++number) {
    rig.say(number);
    rig.say(number);
  }
  rig.wait(seconds(20));
  rig.say(4);
  rig.wait(seconds(1));
  EXPECT_TRUE(rig.say(5));
  EXPECT_FALSE(rig.is_present(4)) << "though the others have been silent for longer";
  EXPECT_FALSE(rig.say(6)) << "5 is safe, and the others may be listening to streams";
  for (const std::uint16_t number : {std::uint16_t{1}, std::uint16_t{2}, std::uint16_t{3}}) {
    EXPECT_TRUE(rig.is_present(number)) << number;
  }
  rig.say(5);
  EXPECT_TRUE(rig.say(6)) << "now all are known";
  EXPECT_FALSE(rig.is_present(1));
}

TEST(DatagramHosts, SilentOnesAreForgotten) {
  HostsRig rig;
  rig.say(1);
  rig.wait(seconds(30));
  rig.say(2);
  rig.wait(seconds(29));
  EXPECT_FALSE(rig.hosts.forget(rig.now));
  rig.wait(seconds(1));
  EXPECT_EQ(rig.hosts.forget(rig.now)->port, 1U);
  EXPECT_FALSE(rig.hosts.forget(rig.now));
  EXPECT_TRUE(rig.is_present(2));
}

}  // namespace
}  // namespace sbgc::serving
