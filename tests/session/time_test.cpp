// Tests of time arithmetic, above all at the limits of its range.

#include <limits>

#include <gtest/gtest.h>

#include <sbgc/time.hpp>

namespace sbgc::test {
namespace {

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
