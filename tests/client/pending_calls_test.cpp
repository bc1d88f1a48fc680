// Tests of the calls that wait for the session.

#include "calls/pending_calls.hpp"

#include <cstdint>
#include <memory>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sbgc/responses/all.hpp>

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
