// Tests of requests whose types are not known to the program.

#include <sbgc/client/raw_request.hpp>
#include <sbgc/meta/all.hpp>
#include <sbgc/responses/all.hpp>
#include <sbgc/surplus.hpp>

#include "testing.hpp"

namespace sbgc::test {
namespace {

TEST(RawRequest, HasThePolicyOfItsMessageAlsoWithSurplus) {
  int count = 0;
  AllMessages::for_each([&]<class M>(Type<M>) {
    if constexpr (takes_surplus<M>) {
      SCOPED_TRACE(Meta<M>::info.name);
      ++count;
      std::array<std::uint8_t, max_body_size> body{};
      ASSERT_TRUE(encode(M{}, body));
      for (const std::size_t size : {M::max_size + 1, max_body_size}) {
        const auto request = raw_request(Meta<M>::info.id, std::span(body).first(size));
        ASSERT_TRUE(request);
        EXPECT_EQ(request->body.size(), size);
        const ResponsePolicy expected = response_policy(M{});
        EXPECT_EQ(request->policy.responses, expected.responses);
        EXPECT_EQ(request->policy.stops, expected.stops);
        EXPECT_EQ(request->policy.restarts_board, expected.restarts_board);
        EXPECT_EQ(request->policy.confirmations, expected.confirmations);
        EXPECT_EQ(request->policy.timeout_ms, expected.timeout_ms);
      }
    }
  });
  EXPECT_GT(count, 50);
}

TEST(RawRequest, WithSurplusIsStillAStop) {
  constexpr auto motors_off = static_cast<std::uint8_t>(msg::MotorsOff::command);
  for (const std::size_t size : {0U, 1U, 2U, 255U}) {
    const std::array<std::uint8_t, max_body_size> body{};
    const auto request = raw_request(motors_off, std::span(body).first(size));
    ASSERT_TRUE(request);
    EXPECT_TRUE(request->policy.stops) << size << " bytes";
    EXPECT_EQ(request->policy.responses.confirmed, Confirmed::always) << size << " bytes";
  }
}

TEST(RawRequest, BetweenTwoFormsIsSentWithCare) {
  const std::array<std::uint8_t, 14> body{};
  const auto request = raw_request(static_cast<std::uint8_t>(msg::Control::command), body);
  ASSERT_TRUE(request);
  EXPECT_FALSE(request->policy.retry_is_safe);
  EXPECT_TRUE(request->policy.has_effect);
  EXPECT_EQ(request->policy.responses.confirmed, Confirmed::possible);
}

}  // namespace
}  // namespace sbgc::test
