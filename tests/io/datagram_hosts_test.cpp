// Tests of the hosts that keep a place for datagrams.

#include "hosts/datagram_hosts.hpp"

#include <cstdint>
#include <optional>
#include <random>

#include <gtest/gtest.h>

namespace sbgc::hosts {
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
  bool say(std::uint16_t number, bool is_answered = true) {
    if (hosts.find(endpoint(number)) != nullptr) {
      hosts.hear(endpoint(number), now);
    } else {
      if (hosts.is_full() && !hosts.make_room(endpoint(number), now)) return false;
      hosts.add(endpoint(number), number, now);
    }
    if (is_answered) hosts.answer(endpoint(number), now);
    return true;
  }
  bool is_present(std::uint16_t number) const { return hosts.find(endpoint(number)) != nullptr; }
  void wait(Duration time) { now = now + time; }
};

TEST(DatagramHosts, APasserByMakesRoomSoon) {
  HostsRig rig;
  for (std::uint16_t number = 1; number <= 4; ++number) EXPECT_TRUE(rig.say(number));
  rig.wait(milliseconds(499));
  EXPECT_FALSE(rig.say(5));
  rig.wait(milliseconds(1));
  EXPECT_TRUE(rig.say(6));
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
  EXPECT_TRUE(rig.say(6)) << "5 is safe, but the others are not in use";
  EXPECT_FALSE(rig.is_present(1));
}

TEST(DatagramHosts, ThoseThatGetAStreamStay) {
  HostsRig rig;
  for (std::uint16_t number = 1; number <= 4; ++number) {
    rig.say(number);
    rig.say(number);
  }
  for (int i = 0; i < 20; ++i) {
    rig.wait(seconds(1));
    for (std::uint16_t number = 1; number <= 3; ++number) {
      rig.hosts.answer(HostsRig::endpoint(number), rig.now);
    }
    rig.say(100);
    for (std::uint16_t number = 1; number <= 3; ++number) EXPECT_TRUE(rig.is_present(number));
  }
  EXPECT_TRUE(rig.is_present(100));
}

TEST(DatagramHosts, OneThatTriesAgainReplacesAPasserBy) {
  HostsRig rig;
  for (std::uint16_t number = 1; number <= 4; ++number) EXPECT_TRUE(rig.say(number));
  rig.say(1);
  EXPECT_FALSE(rig.say(5));
  rig.wait(milliseconds(50));
  EXPECT_TRUE(rig.say(5));
  EXPECT_FALSE(rig.is_present(2)) << "the longest silent of those that have not sent again";
  EXPECT_TRUE(rig.say(2)) << "it tries again as well";
  for (const std::uint16_t number : {std::uint16_t{4}, std::uint16_t{5}, std::uint16_t{2}}) {
    EXPECT_TRUE(rig.say(number)) << number;
  }
  EXPECT_FALSE(rig.say(6));
  EXPECT_FALSE(rig.say(6)) << "all have sent again after an answer";
  rig.wait(seconds(5));
  EXPECT_TRUE(rig.say(6));
}

TEST(DatagramHosts, OneThatTriedAgainHasTimeToGoOn) {
  HostsRig rig;
  for (std::uint16_t number = 1; number <= 8; ++number) rig.say(number, false);
  for (std::uint16_t number = 5; number <= 8; ++number) EXPECT_TRUE(rig.say(number, false));
  EXPECT_FALSE(rig.say(1)) << "the others may go on";
  rig.wait(milliseconds(50));
  EXPECT_TRUE(rig.say(1));
}

TEST(DatagramHosts, TriesAreForgotten) {
  HostsRig rig;
  for (std::uint16_t number = 1; number <= 4; ++number) EXPECT_TRUE(rig.say(number));
  EXPECT_FALSE(rig.say(5));
  rig.wait(seconds(1));
  for (std::uint16_t number = 1; number <= 4; ++number) EXPECT_TRUE(rig.say(number + 10U));
  rig.wait(seconds(1));
  for (std::uint16_t number = 1; number <= 4; ++number) EXPECT_TRUE(rig.say(number + 20U));
  EXPECT_FALSE(rig.say(5));
  rig.wait(milliseconds(50));
  EXPECT_TRUE(rig.say(5));
}

/// Every millisecond, a sender with one of the ports that Linux gives to programs.
class Flood : public ::testing::TestWithParam<bool> {};

TEST_P(Flood, KeepsNobodyOut) {
  constexpr std::uint16_t ports = 28'232;
  HostsRig rig{.hosts = DatagramHosts(8)};
  std::minstd_rand chance(1);
  const auto flood = [&](int count) {
    for (int i = 0; i < count; ++i) {
      rig.wait(milliseconds(1));
      rig.say(static_cast<std::uint16_t>(32'768U + chance() % ports), GetParam());
    }
  };
  flood(5000);
  int late = 0;
  for (std::uint16_t number = 1; number <= 30; ++number) {
    int tries = 1;
    for (; !rig.say(number); ++tries) flood(250);
    EXPECT_LE(tries, 3);
    late += tries == 3 ? 1 : 0;
    // After its answer, it goes on.
    flood(10);
    rig.say(number);
    flood(1000);
    EXPECT_TRUE(rig.is_present(number)) << number;
    flood(1000);
  }
  EXPECT_LE(late, 3) << "of 30: at the second attempt, it has a place";
}

INSTANTIATE_TEST_SUITE_P(OfSenders, Flood, ::testing::Bool(), [](const auto& one) {
  return one.param ? "WithAnswers" : "WithoutAnswers";
});

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
}  // namespace sbgc::hosts
