// Tests of the lists of a session, alone: what has been removed from one has no effect, and nothing
// behind its end is touched.

#include <array>
#include <cstdint>
#include <optional>

#include <gtest/gtest.h>

#include <sbgc/session/late_replies.hpp>
#include <sbgc/session/streams.hpp>

namespace {

using sbgc::Handle;
using sbgc::SendStatus;
using sbgc::StreamChange;
using sbgc::detail::LateReplies;
using sbgc::detail::LateRequest;
using sbgc::detail::Streams;

constexpr auto any = [](const LateRequest&) { return true; };

/// A request of a command.
constexpr LateRequest request(std::uint64_t number, std::uint8_t command) {
  return {.handle = {number}, .host = 3, .responses = {.command = command}};
}

/// Takes a late reply; returns the host of its request, or nothing.
template <class List, class Fits>
std::optional<std::uint16_t> take(List& late, const Fits& fits) {
  std::uint16_t host = 0;
  return late.take(fits, 0, host) ? std::optional(host) : std::nullopt;
}

TEST(LateReplies, AreTakenOnlyOnce) {
  LateReplies<2> late;
  late.add(request(1, 5), 1, 1000);
  EXPECT_EQ(late.count(any), 1U);
  EXPECT_EQ(take(late, any), 3);
  EXPECT_EQ(late.count(any), 0U);
  EXPECT_EQ(take(late, any), std::nullopt);
}

TEST(LateReplies, AreNotTakenAfterTheirTime) {
  LateReplies<2> late;
  late.add(request(1, 5), 1, 1000);
  late.add(request(2, 6), 1, 2000);
  late.pass(1000);
  late.expire();
  EXPECT_EQ(take(late, any), 3) << "that of the second request";
  EXPECT_EQ(take(late, any), std::nullopt);
}

TEST(LateReplies, AFullListEndsAtItsLastEntry) {
  LateReplies<1> late;
  late.add(request(1, 5), 1, 1000);
  late.extend(Handle{1}, 2000);
  late.extend(Handle{2}, 3000);
  EXPECT_EQ(late.next_end(), 2000U);
  const auto of_another = [](const LateRequest& one) { return one.responses.command == 6; };
  EXPECT_EQ(late.count(of_another), 0U);
  EXPECT_EQ(take(late, of_another), std::nullopt);
  late.limit(500);
  EXPECT_EQ(late.next_end(), 500U);
  late.pass(500);
  late.expire();
  EXPECT_EQ(late.size(), 0U);
}

TEST(Streams, AStoppedOneIsUnknown) {
  StreamChange change{.command = 25, .size = 68, .interval_us = 10'000};
  const std::array<std::uint8_t, 68> body{};
  const sbgc::Frame sample{25, body, 0};
  Streams<2> streams;
  ASSERT_EQ(streams.check(change, 0), SendStatus::ok);
  ASSERT_TRUE(streams.ask(change));
  streams.settle(change, true);
  EXPECT_TRUE(streams.has(25));
  EXPECT_TRUE(streams.has_size_of_sample(sample));
  change.interval_us = 0;
  ASSERT_TRUE(streams.ask(change));
  streams.settle(change, true);
  EXPECT_FALSE(streams.has(25));
  EXPECT_FALSE(streams.has_size_of_sample(sample));
  EXPECT_EQ(streams.used(), 0U);
}

}  // namespace
