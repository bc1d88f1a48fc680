// Tests of deadlines, without measuring time: in virtual time, or without the thread that would end
// a call; and of cancellations, which are not lost, whatever comes with them.

#include <asio/error.hpp>
#include <asio/strand.hpp>

#include <sbgc/client/backup.hpp>
#include <sbgc/client/memory.hpp>
#include <sbgc/client/motion.hpp>

#include "conversation/state.hpp"
#include "driving/task_driver.hpp"
#include "testing.hpp"
#include "virtual_client.hpp"

namespace sbgc::test {
namespace {

using Timeout = std::chrono::milliseconds;

// The thread that waits for a call ends it.

class WithoutAThread : public ::testing::Test {
 protected:
  void TearDown() override {
    state->close();
    context.poll();  // releases the conversation
  }

  asio::io_context context{1};  // nobody runs it meanwhile
  std::shared_ptr<detail::Conversation::State> state =
      std::make_shared<detail::Conversation::State>(asio::make_strand(context.get_executor()),
                                                    ConnectOptions{});
  detail::Conversation conversation{state};
};

Task<Result<msg::GetAngles>> ask_for_angles(Timeout timeout) {
  co_return co_await tasks::call(msg::GetAnglesRequest{}, {.timeout = timeout});
}

TEST_F(WithoutAThread, ACallEnds) {
  const auto reply = conversation.call(conversation.prepare(msg::GetAnglesRequest{}, {}),
                                       {.timeout = Timeout(20)});
  ASSERT_FALSE(reply);
  EXPECT_EQ(reply.error(),
            (ClientError{ErrorCode::timeout, "CMD_GET_ANGLES could not be sent within 20 ms"}));
}

TEST_F(WithoutAThread, ACallOfATaskEnds) {
  auto task = ask_for_angles(Timeout(20));
  detail::drive(conversation, task.begin({}), Clock::system());
  const auto angles = std::move(task).result();
  ASSERT_FALSE(angles);
  EXPECT_EQ(angles.error(),
            (ClientError{ErrorCode::timeout, "CMD_GET_ANGLES could not be sent within 20 ms"}));
}

// Tasks in virtual time

class TaskDeadline : public ::testing::TestWithParam<Timeout> {
 protected:
  /// Runs a task whose timeout is timeout() while the line is cut after the parameter; expects that
  /// it fails in time.
  template <class R>
  void expect_in_time(Task<R> task) {
    const Instant start = client.now();
    const R result = client.run(std::move(task), [&](TaskMachine&) {
      if (client.now() - start >= milliseconds(GetParam().count())) client.cut_the_line();
    });
    EXPECT_FALSE(result);
    EXPECT_LE(client.now() - start, milliseconds(timeout.count()));
    EXPECT_EQ(client.pending(), 0U);
  }

  /// All parameters, with a change in each profile.
  ParameterSet changed() {
    ParameterSet set = *client.run(tasks::read_parameters());
    for (std::uint8_t profile = 0; profile < 5; ++profile) {
      auto params = *set.get<msg::ReadParams3>(profile);
      ++params.gyro_trust;
      EXPECT_TRUE(set.set(params));
    }
    return set;
  }

  static constexpr Timeout timeout{200};
  VirtualClient client;
};

TEST_P(TaskDeadline, OfReading) { expect_in_time(tasks::read_parameters({.timeout = timeout})); }

TEST_P(TaskDeadline, OfWriting) {
  expect_in_time(tasks::write_parameters(changed(), {.timeout = timeout}));
}

TEST_P(TaskDeadline, OfARestore) {
  RestoreOptions options{.timeout = timeout};
  options.save_current = [](const Backup&) { return Result<void>(); };
  Backup backup = *client.run(tasks::make_backup(""));
  backup.parameters = changed();
  expect_in_time(tasks::restore(std::move(backup), options));
}

TEST_P(TaskDeadline, OfMemory) {
  expect_in_time(tasks::download_eeprom(0, 16'384, {.timeout = timeout}));
}

TEST_P(TaskDeadline, OfAMove) {
  MoveOptions options{.speed = 5_deg_per_s, .timeout = timeout, .stop_on_failure = false};
  expect_in_time(tasks::move_to({.yaw = 60_deg}, options));
}

TEST_P(TaskDeadline, OfAStop) {
  ASSERT_TRUE(client.run(tasks::begin_move({.yaw = 120_deg}, {.speed = 20_deg_per_s})));
  if (GetParam().count() != 0) return;  // the camera has stopped by then
  expect_in_time(tasks::stop({.timeout = timeout}));
}

INSTANTIATE_TEST_SUITE_P(TheLineIsCut, TaskDeadline,
                         ::testing::Values(Timeout(0), Timeout(5), Timeout(20)));

TEST_F(TaskDeadline, NoWriteIsBegunThatCouldNotBeFinished) {
  const ParameterSet wanted = changed();
  Instant start = client.now();
  ASSERT_TRUE(client.run(tasks::write_parameters(wanted, {.dry_run = true})));
  const Duration preparation = client.now() - start;
  const Timeout enough_to_prepare{preparation.us / 1000 + 200};
  start = client.now();
  const WriteReport report =
      client.run(tasks::write_parameters(wanted, {.timeout = enough_to_prepare}));
  ASSERT_THAT(report, fails(ErrorCode::timeout));
  EXPECT_LE(client.now() - start, milliseconds(enough_to_prepare.count()));
  for (const ParametersReport& block : report.parameters) {
    const bool is_changed = !block.wanted.empty();
    EXPECT_EQ(block.state, is_changed ? ParametersState::unwritten : ParametersState::equal);
  }
}

// Connecting

/// A serial port that neither sends nor receives, and notes how it is closed.
class DeadPort final : public io::Transport, private io::LineControl {
 public:
  DeadPort(asio::any_io_executor executor, std::vector<std::string>& events)
      : executor_(std::move(executor)), events_(events) {}
  DeadPort(const DeadPort&) = delete;
  DeadPort& operator=(const DeadPort&) = delete;
  ~DeadPort() override = default;

  void async_read(std::span<std::uint8_t>, Handler handler) override { keep(std::move(handler)); }
  void async_write(std::span<const std::uint8_t>, Handler handler) override {
    keep(std::move(handler));
  }
  void close() override {
    if (std::exchange(is_closed_, true)) return;
    events_.emplace_back("closed");
    for (Handler& handler : pending_) {
      asio::post(executor_,
                 [handler = std::move(handler)] { handler(asio::error::operation_aborted, 0); });
    }
    pending_.clear();
  }
  asio::any_io_executor executor() override { return executor_; }
  std::string description() const override { return "a dead port"; }
  io::LineControl* line() override { return this; }

 private:
  void keep(Handler handler) { pending_.push_back(std::move(handler)); }
  io::Error set(const LineSettings&) override { return {}; }
  LineSettings current() const override { return {}; }
  io::Error flush() override {
    events_.emplace_back("flushed");
    return {};
  }

  asio::any_io_executor executor_;
  std::vector<std::string>& events_;
  std::vector<Handler> pending_{};
  bool is_closed_ = false;
};

TEST(ConnectDeadline, WhatAPortHasNotSentIsDiscardedBeforeItIsClosed) {
  std::vector<std::string> events;
  const TransportFactory make = [&](const asio::any_io_executor& executor) {
    return std::make_unique<DeadPort>(executor, events);
  };
  EXPECT_THAT(connect_over(make, {.timeout = Timeout(100)}), fails(ErrorCode::not_found));
  EXPECT_THAT(events, ElementsAre("flushed", "closed"));
}

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
