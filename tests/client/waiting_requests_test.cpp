// Tests of requests before they are sent: those whose types are not known to the program, and the
// calls that wait for the session.

#include <sbgc/any.hpp>
#include <sbgc/client/raw_request.hpp>
#include <sbgc/responses/all.hpp>

#include "calls/pending_calls.hpp"
#include "testing.hpp"

namespace sbgc::test {
namespace {

TEST(RawRequest, HasThePolicyOfItsMessageAlsoWithSurplus) {
  int count = 0;
  for (const MessageType* const type : message_types()) {
    if (!type->operations->takes_surplus) continue;
    SCOPED_TRACE(type->info->name);
    ++count;
    const AnyMessage message = type->make();
    const ResponsePolicy expected = detail::policy_of(message);
    std::array<std::uint8_t, max_body_size> body{};
    ASSERT_TRUE(message.encode(body));
    for (const std::size_t size : {type->info->max_size + 1, max_body_size}) {
      const auto request = raw_request(type->info->id, std::span(body).first(size));
      ASSERT_TRUE(request);
      EXPECT_EQ(request->body.size(), size);
      EXPECT_EQ(request->policy.responses, expected.responses);
      EXPECT_EQ(request->policy.stops, expected.stops);
      EXPECT_EQ(request->policy.restarts_board, expected.restarts_board);
      EXPECT_EQ(request->policy.confirmations, expected.confirmations);
      EXPECT_EQ(request->policy.timeout_ms, expected.timeout_ms);
    }
  }
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

namespace sbgc::detail {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

template <class M>
CallPointer call_of(const M& message) {
  auto call = std::make_shared<Call>();
  call->id = next_call_id();
  call->request.policy = response_policy(message);
  return call;
}

msg::Control turn(std::int16_t speed) {
  msg::Control request;
  request.control_mode.set_mode(msg::ControlModeKind::speed);
  request.axes.yaw.speed = msg::ControlSpeed(speed);
  return request;
}

TEST(PendingCalls, NoMotionFollowsAYoungerStopAtAnyMoment) {
  PendingCalls calls(8);
  PendingCalls::Superseded superseded;
  const CallPointer motion = call_of(turn(100));
  const CallPointer stop = call_of(turn(0));
  EXPECT_FALSE(calls.add(motion, superseded));
  EXPECT_FALSE(calls.add(stop, superseded));
  // From here on, another thread may send what waits.
  const auto room = [](const Call&) { return true; };
  EXPECT_EQ(calls.next_waiting(room), stop);
  EXPECT_EQ(calls.next_waiting(room), nullptr);
  EXPECT_THAT(superseded.calls, ElementsAre(motion));
}

TEST(PendingCalls, AStopIsNotSuperseded) {
  PendingCalls calls(8);
  PendingCalls::Superseded superseded;
  const CallPointer off = call_of(msg::MotorsOff{});
  const CallPointer still = call_of(turn(0));
  EXPECT_FALSE(calls.add(off, superseded));
  EXPECT_FALSE(calls.add(still, superseded));
  EXPECT_THAT(superseded.calls, IsEmpty());
  const auto room = [](const Call&) { return true; };
  EXPECT_EQ(calls.next_waiting(room), off);
  EXPECT_EQ(calls.next_waiting(room), still);
}

TEST(PendingCalls, KeepTheirOrderWhileThereIsRoom) {
  PendingCalls calls(8);
  PendingCalls::Superseded superseded;
  const CallPointer read = call_of(msg::GetAnglesRequest{});
  const CallPointer beep = call_of(msg::BeepSound{});
  const CallPointer stop = call_of(msg::MotorsOff{});
  for (const CallPointer& call : {read, beep, stop}) EXPECT_FALSE(calls.add(call, superseded));
  const auto room = [](const Call&) { return true; };
  const auto no_reads = [](const Call& call) { return call.request.policy.has_effect; };
  EXPECT_EQ(calls.next_waiting(room), stop);
  EXPECT_EQ(calls.next_waiting(room), read);
  EXPECT_FALSE(calls.add(call_of(msg::GetAnglesRequest{}), superseded));
  EXPECT_EQ(calls.next_waiting(no_reads), beep);
}

}  // namespace
}  // namespace sbgc::detail
