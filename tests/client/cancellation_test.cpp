// A cancellation is not lost, whatever comes with it.

#include <sbgc/client/motion.hpp>

#include "testing.hpp"

namespace sbgc::test {
namespace {

Task<Result<void>> ask_then_wait() {
  const auto angles = co_await tasks::call(msg::GetAnglesRequest{});
  if (!angles) co_return ClientError{ErrorCode::invalid, "there was a response"};
  co_return co_await tasks::wait_until(Instant::never);
}

TEST(Cancellation, ThatComesWithTheResponseEndsTheNextWait) {
  auto task = ask_then_wait();
  TaskMachine& machine = task.begin({});
  const TaskStep call = machine.step({});
  ASSERT_EQ(call.kind, TaskStep::Kind::call);

  Reply reply;
  reply.id = static_cast<std::uint8_t>(msg::GetAngles::command);
  reply.kind = ReplyKind::answered;
  const std::vector<std::uint8_t> body = packet(msg::GetAngles{}).body;
  reply.body.assign(body.begin(), body.end());
  machine.replied(call.call, std::move(reply));
  machine.cancel();

  EXPECT_EQ(machine.step({}).kind, TaskStep::Kind::done);
  EXPECT_THAT(std::move(task).result(), fails(ErrorCode::cancelled));
}

Task<Result<void>> wait_twice() {
  const auto first = co_await tasks::wait_until(Instant::never);
  if (first || first.error().code != ErrorCode::superseded) co_return Result<void>();
  co_return co_await tasks::wait_until(Instant::never);
}

TEST(Cancellation, ThatComesWithASuccessorEndsTheNextWait) {
  auto task = wait_twice();
  TaskMachine& machine = task.begin({});
  machine.set_number(1);
  ASSERT_EQ(machine.step({}).kind, TaskStep::Kind::wait);
  machine.cancel();
  machine.supersede(2);
  ASSERT_EQ(machine.step({}).kind, TaskStep::Kind::done);
  EXPECT_THAT(std::move(task).result(), fails(ErrorCode::cancelled));
}

}  // namespace
}  // namespace sbgc::test
