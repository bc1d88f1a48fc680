// Tests of the lists of a session, alone: what has been removed from one has no effect, and nothing
// after its end is touched.

#include <sbgc/session/late_replies.hpp>
#include <sbgc/session/streams.hpp>

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

}  // namespace
}  // namespace sbgc::test
