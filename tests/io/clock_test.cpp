// Tests of conversions between the times of the library and of <chrono>.

#include <chrono>
#include <cstdint>
#include <limits>

#include <gtest/gtest.h>

#include <sbgc/io/clock.hpp>

namespace sbgc::io {
namespace {

using namespace std::chrono_literals;

static_assert(from_chrono(Clock::duration(1500us)) == Duration{1500});
static_assert(from_chrono(Clock::duration(-1ns)) == Duration{-1});
static_assert(to_chrono(Duration{1500}) == 1500us);
static_assert(from_chrono(Clock::time_point(3s)) == Instant{3'000'000});
static_assert(to_chrono(Instant{3'000'000}) == Clock::time_point(3s));
static_assert(to_chrono(Instant::never) == Clock::time_point::max());
static_assert(to_chrono(Duration{std::numeric_limits<std::int64_t>::min()}) ==
              Clock::duration::min());

TEST(Clock, NowGoesOn) {
  const Instant before = now();
  const Clock::time_point between = Clock::now();
  EXPECT_LE(before, from_chrono(between));
  EXPECT_LE(from_chrono(between), now());
  EXPECT_LE(to_chrono(before), between);
}

}  // namespace
}  // namespace sbgc::io
