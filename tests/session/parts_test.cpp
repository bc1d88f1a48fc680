// Tests of the parts of a session, alone: time arithmetic, above all at the limits of its range,
// and lists, from which what has been removed has no effect, and whose end nothing passes.

#include <limits>

#include <sbgc/session/late_replies.hpp>
#include <sbgc/session/streams.hpp>
#include <sbgc/time.hpp>

#include "simulation.hpp"

namespace sbgc::test {
namespace {

using detail::LateReplies;
using detail::LateRequest;
using detail::Streams;

constexpr auto any = [](const Responses&) { return true; };
constexpr auto any_request = [](const LateRequest&) { return true; };

/// The responses to a command.
constexpr Responses answers_to(std::uint8_t command) { return {.command = command}; }

/// Takes a late reply; returns the host of its request, or nothing.
template <class List, class Fits>
std::optional<std::uint16_t> take(List& late, const Fits& fits) {
  const auto found = late.match(fits);
  if (found.entry == nullptr) return std::nullopt;
  const std::uint16_t host = found.entry->request.host;
  late.take(*found.entry, 0);
  return host;
}

TEST(LateReplies, AreTakenOnlyOnce) {
  LateReplies<2> late;
  late.add(Handle{1}, 3, answers_to(5), 1, 1000);
  EXPECT_TRUE(late.has(any_request));
  EXPECT_EQ(take(late, any), 3);
  EXPECT_FALSE(late.has(any_request));
  EXPECT_EQ(take(late, any), std::nullopt);
}

TEST(LateReplies, AreNotTakenAfterTheirTime) {
  LateReplies<2> late;
  late.add(Handle{1}, 3, answers_to(5), 1, 1000);
  late.add(Handle{2}, 4, answers_to(6), 1, 2000);
  late.pass(1000);
  late.expire();
  EXPECT_EQ(take(late, any), 4) << "that of the second request";
  EXPECT_EQ(take(late, any), std::nullopt);
}

TEST(LateReplies, TheOldestIsTakenFirst) {
  LateReplies<2, true> late;
  late.add(Handle{2}, 4, answers_to(5), 1, 1000);
  late.add(Handle{1}, 3, answers_to(5), 1, 1000);
  EXPECT_EQ(take(late, any), 3);
  EXPECT_EQ(take(late, any), 4);
}

TEST(LateReplies, OfSeveralHostsAreKeptApart) {
  LateReplies<3, true> late;
  late.add(Handle{1}, 3, answers_to(5), 1, 1000);
  late.add(Handle{2}, 4, answers_to(5), 1, 1000);
  late.add(Handle{3}, 3, answers_to(5), 1, 1000);
  EXPECT_EQ(late.size(), 2U);
  EXPECT_TRUE(late.has([](const LateRequest& request) { return request.host == 4; }));
}

TEST(LateReplies, WithoutRoomTheFirstToEndIsReplaced) {
  LateReplies<2> late;
  late.add(Handle{1}, 1, answers_to(5), 1, 2000);
  late.add(Handle{2}, 2, answers_to(6), 1, 1000);
  late.add(Handle{3}, 3, answers_to(7), 1, 3000);
  EXPECT_EQ(take(late, any), 1);
  EXPECT_EQ(take(late, any), 3);
}

TEST(LateReplies, AFullListEndsAtItsLastEntry) {
  LateReplies<1> late;
  late.add(Handle{1}, 0, answers_to(5), 1, 1000);
  late.extend(Handle{1}, 2000);
  late.extend(Handle{2}, 3000);
  EXPECT_EQ(late.next_end(), 2000U);
  const auto of_another = [](const Responses& responses) { return responses.command == 6; };
  EXPECT_EQ(late.match(of_another).count, 0U);
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
  const Frame sample{25, body, 0};
  Streams<2> streams;
  ASSERT_EQ(streams.check(change, 0), SendStatus::ok);
  ASSERT_TRUE(streams.ask(change));
  streams.settle(change, true);
  EXPECT_TRUE(streams.has(25));
  EXPECT_EQ(streams.take(sample), Sample::yes);
  change.interval_us = 0;
  ASSERT_TRUE(streams.ask(change));
  streams.settle(change, true);
  EXPECT_FALSE(streams.has(25));
  EXPECT_EQ(streams.take(sample), Sample::no);
  EXPECT_EQ(streams.used(), 0U);
}

constexpr std::int64_t most = std::numeric_limits<std::int64_t>::max();
constexpr std::int64_t least = std::numeric_limits<std::int64_t>::min();

static_assert(milliseconds(3) == microseconds(3000));
static_assert(seconds(2) + milliseconds(5) == microseconds(2'005'000));
static_assert(seconds(2) - milliseconds(5) == microseconds(1'995'000));
static_assert(seconds(1) > milliseconds(999));
static_assert(milliseconds(20) * 3 == milliseconds(60));
static_assert(Instant{5} + microseconds(7) == Instant{12});
static_assert(Instant{5} - microseconds(7) == Instant{-2});
static_assert(Instant{5} - Instant{7} == microseconds(-2));
static_assert(earlier({1}, {2}) == Instant{1} && earlier({2}, {1}) == Instant{1});
static_assert(later({1}, {2}) == Instant{2} && later({2}, {1}) == Instant{2});

TEST(Time, StopsAtItsEnds) {
  EXPECT_EQ(Instant::never + seconds(1), Instant::never);
  EXPECT_EQ(Instant{least} - seconds(1), Instant{least});
  EXPECT_EQ(Instant{most} - Instant{least}, Duration{most});
  EXPECT_EQ(Instant{least} - Instant{most}, Duration{least});
  EXPECT_EQ(Duration{most} + Duration{1}, Duration{most});
  EXPECT_EQ(Duration{0} - Duration{least}, Duration{most});
  EXPECT_EQ(Duration{most} * 2, Duration{most});
  EXPECT_EQ(Duration{most} * -2, Duration{least});
  EXPECT_EQ(Duration{least} * 2, Duration{least});
  EXPECT_EQ(Duration{least} * -2, Duration{most});
}

TEST(Time, NothingIsLaterThanNever) {
  EXPECT_LE((Instant{most - 1} + microseconds(5)), Instant::never);
  EXPECT_LT(Instant{}, Instant::never);
}

}  // namespace
}  // namespace sbgc::test
