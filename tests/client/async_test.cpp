// Tests of the client with completion tokens.

#include <chrono>
#include <future>
#include <memory>
#include <optional>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include <asio/awaitable.hpp>
#include <asio/bind_cancellation_slot.hpp>
#include <asio/bind_executor.hpp>
#include <asio/cancellation_signal.hpp>
#include <asio/co_spawn.hpp>
#include <asio/executor_work_guard.hpp>
#include <asio/io_context.hpp>
#include <asio/thread_pool.hpp>
#include <asio/use_awaitable.hpp>
#include <asio/use_future.hpp>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sbgc/any.hpp>
#include <sbgc/client/async_client.hpp>
#include <sbgc/client/motion.hpp>
#include <sbgc/messages.hpp>
#include <sbgc/meta/all.hpp>

#include "collector.hpp"
#include "emulated_board.hpp"
#include "scripted_board.hpp"

namespace sbgc::test {
namespace {

using std::chrono::milliseconds;

/// An execution context with a thread that runs it.
class Running {
 public:
  Running() : work_(context_.get_executor()), thread_([this] { context_.run(); }) {}
  Running(const Running&) = delete;
  Running& operator=(const Running&) = delete;
  ~Running() {
    work_.reset();
    thread_.join();
  }

  auto executor() { return context_.get_executor(); }
  std::thread::id thread() const { return thread_.get_id(); }

 private:
  asio::io_context context_;
  asio::executor_work_guard<asio::io_context::executor_type> work_;
  std::thread thread_;
};

class Async : public ::testing::Test {
 protected:
  void SetUp() override { introduce(board); }

  void connect(AsyncClient& client) {
    const auto connected =
        client.async_connect_over(over_line(board), quick(), asio::use_future).get();
    ASSERT_TRUE(connected) << connected.error().message;
  }

  Collector<msg::DataStreamInterval> registrations;
  ScriptedBoard board;
  Running running;
};

TEST_F(Async, WorksWithFutures) {
  msg::GetAngles angles;
  angles.axes.roll.imu_angle = 10_deg;
  board.answer<msg::GetAnglesRequest>(angles);
  AsyncClient client(running.executor());
  EXPECT_FALSE(client.is_connected());
  connect(client);
  EXPECT_TRUE(client.is_connected());
  EXPECT_EQ(client.identity().firmware_version(), "2.59");
  const auto answer = client.async_call(msg::GetAnglesRequest{}, {}, asio::use_future).get();
  ASSERT_TRUE(answer) << answer.error().message;
  EXPECT_EQ(*answer, angles);
}

TEST(AsyncPolls, ReplaceStreamsOfOldFirmware) {
  emulator::EmulatorOptions old = quick_board();
  old.board.firmware = msg::FirmwareVersion(2439);
  EmulatedBoard board{old};
  Running running;
  AsyncClient client(running.executor());
  ASSERT_TRUE(client.async_connect_over(board.line(), quick(), asio::use_future).get());
  Collector<msg::RealtimeData3> samples;
  auto stream = client
                    .async_stream<msg::RealtimeData3>(
                        milliseconds(5), [&](const msg::RealtimeData3& one) { samples.add(one); },
                        asio::use_future)
                    .get();
  ASSERT_TRUE(stream) << stream.error().message;
  EXPECT_GE(samples.wait_for(5).size(), 5U);
}

TEST_F(Async, WorksWithCallbacksThatCanOnlyBeMoved) {
  board.on<msg::MotorsOn>([&](const msg::MotorsOn& request) { board.confirm(request); });
  AsyncClient client(running.executor());
  connect(client);
  std::promise<std::thread::id> where;
  auto owned = std::make_unique<int>(7);
  client.async_call(msg::MotorsOn{}, {},
                    [&where, owned = std::move(owned)](const Result<void>& result) {
                      EXPECT_TRUE(result);
                      EXPECT_EQ(*owned, 7);
                      where.set_value(std::this_thread::get_id());
                    });
  EXPECT_EQ(where.get_future().get(), running.thread());
}

TEST_F(Async, CompletesOnTheHandlersExecutor) {
  board.answer<msg::GetAnglesRequest>(msg::GetAngles{});
  AsyncClient client(running.executor());
  connect(client);
  asio::thread_pool pool(1);
  std::promise<bool> is_on_pool;
  client.async_call(msg::GetAnglesRequest{}, {},
                    asio::bind_executor(pool, [&](const Result<msg::GetAngles>&) {
                      is_on_pool.set_value(pool.get_executor().running_in_this_thread());
                    }));
  EXPECT_TRUE(is_on_pool.get_future().get());
  pool.join();
}

TEST_F(Async, NeverCompletesInsideTheCallThatBegins) {
  AsyncClient client(running.executor());
  std::promise<bool> was_behind;
  asio::post(running.executor(), [&] {
    const auto has_returned = std::make_shared<bool>(false);
    client.async_call(msg::GetAnglesRequest{}, {}, [&was_behind, has_returned](const auto& result) {
      EXPECT_EQ(result.error().code, ErrorCode::not_connected);
      was_behind.set_value(*has_returned);
    });
    *has_returned = true;
  });
  EXPECT_TRUE(was_behind.get_future().get());
}

TEST_F(Async, CanBeCancelled) {
  AsyncClient client(running.executor());
  connect(client);
  asio::cancellation_signal signal;
  std::promise<ErrorCode> code;
  asio::post(running.executor(), [&] {
    client.async_call(msg::GetAnglesRequest{}, {.timeout = std::chrono::seconds(60)},
                      asio::bind_cancellation_slot(signal.slot(), [&](const auto& result) {
                        code.set_value(result.error().code);
                      }));
  });
  ASSERT_TRUE(board.wait_for<msg::GetAnglesRequest>(1));
  asio::post(running.executor(), [&] { signal.emit(asio::cancellation_type::all); });
  EXPECT_EQ(code.get_future().get(), ErrorCode::cancelled);
}

TEST_F(Async, DestroyingTheClientEndsItsCalls) {
  std::optional<AsyncClient> client(std::in_place, running.executor());
  connect(*client);
  auto first = client->async_call(msg::CalibInfoRequest{}, {.timeout = std::chrono::seconds(60)},
                                  asio::use_future);
  auto second = client->async_call(msg::GetAnglesRequest{}, {.timeout = std::chrono::seconds(60)},
                                   asio::use_future);
  ASSERT_TRUE(board.wait_for<msg::CalibInfoRequest>(1));
  client.reset();
  EXPECT_EQ(first.get().error().code, ErrorCode::cancelled);
  EXPECT_EQ(second.get().error().code, ErrorCode::cancelled);
}

TEST_F(Async, DestroyingTheClientEndsConnecting) {
  board.ignore<msg::BoardInfoRequest>();
  std::optional<AsyncClient> client(std::in_place, running.executor());
  ConnectOptions options = quick();
  options.timeout = std::chrono::seconds(60);
  options.retries = 99;
  auto connected = client->async_connect_over(over_line(board), options, asio::use_future);
  ASSERT_TRUE(board.wait_for<msg::BoardInfoRequest>(1));
  client.reset();
  EXPECT_EQ(connected.get().error().code, ErrorCode::cancelled);
}

TEST_F(Async, DestroyingTheClientOnItsExecutorEndsTheSearchForTheLine) {
  board.ignore<msg::BoardInfoRequest>();
  std::optional<AsyncClient> client(std::in_place, running.executor());
  ConnectOptions options = quick();
  options.timeout = std::chrono::seconds(60);
  auto connected = client->async_connect_over(over_memory(board, {.with_line = true}), options,
                                              asio::use_future);
  ASSERT_TRUE(board.wait_for<msg::BoardInfoRequest>(1));
  // No other thread runs the context while it waits.
  std::promise<void> destroyed;
  asio::post(running.executor(), [&] {
    client.reset();
    destroyed.set_value();
  });
  const auto is_destroyed = destroyed.get_future();
  EXPECT_EQ(is_destroyed.wait_for(std::chrono::seconds(10)), std::future_status::ready);
  is_destroyed.wait();  // the posted lambda refers to this function's locals
  EXPECT_EQ(connected.get().error().code, ErrorCode::cancelled);
}

TEST_F(Async, CancellingWhatIsOverDoesNothing) {
  // As the operators && and
  // of awaitables and parallel groups do.
  AsyncClient client(running.executor());
  asio::cancellation_signal signal;
  std::promise<bool> connected;
  asio::post(running.executor(), [&] {
    client.async_connect_over(
        over_line(board), quick(),
        asio::bind_cancellation_slot(signal.slot(), [&](const Result<void>& result) {
          signal.emit(asio::cancellation_type::all);
          connected.set_value(static_cast<bool>(result));
        }));
  });
  ASSERT_TRUE(connected.get_future().get());
  board.answer<msg::GetAnglesRequest>(msg::GetAngles{});
  const auto angles = client.async_call(msg::GetAnglesRequest{}, {}, asio::use_future).get();
  EXPECT_TRUE(angles) << angles.error().message;
}

TEST_F(Async, CallsAMessageOfATypeKnownAtRunTime) {
  AsyncClient client(running.executor());
  connect(client);
  msg::GetAngles angles;
  angles.axes.yaw.imu_angle = msg::Angle14(1234);
  board.answer<msg::GetAnglesRequest>(angles);
  const AnyMessage request = find_message("GetAnglesRequest")->make();
  const auto answer = client.async_call(request, {}, asio::use_future).get();
  ASSERT_TRUE(answer && *answer);
  ASSERT_NE((*answer)->get_if<msg::GetAngles>(), nullptr);
  EXPECT_EQ(*(*answer)->get_if<msg::GetAngles>(), angles);
  const AnyMessage wrong = find_message("GetAngles")->make();
  EXPECT_EQ(client.async_call(wrong, {}, asio::use_future).get().error().code, ErrorCode::invalid);
}

Task<Result<int>> ask_three_times() {
  int good = 0;
  for (int i = 0; i < 3; ++i) {
    const auto angles = co_await tasks::call(msg::GetAnglesRequest{});
    good += angles ? 1 : 0;
  }
  co_return good;
}

TEST_F(Async, RunsTasks) {
  board.answer<msg::GetAnglesRequest>(msg::GetAngles{});
  AsyncClient client(running.executor());
  connect(client);
  const auto count = client.async_run(ask_three_times(), asio::use_future).get();
  ASSERT_TRUE(count);
  EXPECT_EQ(*count, 3);
}

TEST_F(Async, WorksInCoroutines) {
  board.answer<msg::GetAnglesRequest>(msg::GetAngles{});
  AsyncClient client(running.executor());
  const auto talk = [&]() -> asio::awaitable<std::string> {
    const auto connected =
        co_await client.async_connect_over(over_line(board), quick(), asio::use_awaitable);
    if (!connected) co_return connected.error().message;
    const auto angles =
        co_await client.async_call(msg::GetAnglesRequest{}, {}, asio::use_awaitable);
    if (!angles) co_return angles.error().message;
    const auto good = co_await client.async_run(ask_three_times(), asio::use_awaitable);
    if (!good) co_return good.error().message;
    co_return client.identity().firmware_version() + ", " + std::to_string(*good) + " answers";
  };
  EXPECT_EQ(asio::co_spawn(running.executor(), talk(), asio::use_future).get(), "2.59, 3 answers");
}

TEST_F(Async, ATaskNeedsAConnection) {
  AsyncClient client(running.executor());
  const auto count = client.async_run(ask_three_times(), asio::use_future).get();
  ASSERT_FALSE(count);
  EXPECT_EQ(count.error().code, ErrorCode::not_connected);
}

TEST_F(Async, MovesWithoutAThread) {
  msg::GetAngles angles;
  angles.axes.pitch.imu_angle = -30_deg;
  board.answer<msg::GetAnglesRequest>(angles);
  board.ignore<msg::ControlExt>();
  AsyncClient client(running.executor());
  connect(client);
  std::promise<std::thread::id> where;
  MoveOptions options{.settle = milliseconds(10), .interval = milliseconds(1)};
  options.progress = [&where, first = true](const MoveProgress&) mutable {
    if (std::exchange(first, false)) where.set_value(std::this_thread::get_id());
    return true;
  };
  const auto moved =
      client.async_run(tasks::move_to({.pitch = -30_deg}, options), asio::use_future).get();
  ASSERT_TRUE(moved) << moved.error().message;
  EXPECT_TRUE(moved->is_close);
  EXPECT_EQ(where.get_future().get(), running.thread());
}

Task<Result<void>> wait_long() {
  const auto answer =
      co_await tasks::call(msg::CalibInfoRequest{}, {.timeout = std::chrono::seconds(60)});
  if (!answer) co_return answer.error();
  co_return Result<void>();
}

Task<Result<void>> sleep_long() {
  const TaskMachine& task = co_await tasks::this_task();
  co_return co_await tasks::wait_until(task.now() + seconds(60));
}

TEST_F(Async, CancellingATaskEndsWhatItWaitsFor) {
  AsyncClient client(running.executor());
  connect(client);
  for (const bool is_call : {true, false}) {
    asio::cancellation_signal signal;
    std::promise<ErrorCode> code;
    asio::post(running.executor(), [&] {
      client.async_run(is_call ? wait_long() : sleep_long(),
                       asio::bind_cancellation_slot(signal.slot(), [&](const Result<void>& result) {
                         code.set_value(result.error().code);
                       }));
    });
    asio::post(running.executor(), [&] { signal.emit(asio::cancellation_type::all); });
    EXPECT_EQ(code.get_future().get(), ErrorCode::cancelled);
  }
}

TEST_F(Async, DestroyingTheClientEndsItsTasks) {
  std::optional<AsyncClient> client(std::in_place, running.executor());
  connect(*client);
  auto calling = client->async_run(wait_long(), asio::use_future);
  auto sleeping = client->async_run(sleep_long(), asio::use_future);
  ASSERT_TRUE(board.wait_for<msg::CalibInfoRequest>(1));
  client.reset();
  EXPECT_EQ(calling.get().error().code, ErrorCode::cancelled);
  EXPECT_EQ(sleeping.get().error().code, ErrorCode::cancelled);
}

TEST_F(Async, StreamsOnTheExecutor) {
  board.on<msg::DataStreamInterval>([&](const msg::DataStreamInterval& request) {
    registrations.add(request);
    board.confirm(request);
    if (board.count<msg::DataStreamInterval>() == 0) board.send(msg::RealtimeData4{});
  });
  AsyncClient client(running.executor());
  connect(client);
  std::promise<std::thread::id> where;
  auto stream =
      client
          .async_stream<msg::RealtimeData4>(
              milliseconds(20),
              [&](const msg::RealtimeData4&) { where.set_value(std::this_thread::get_id()); }, {},
              asio::use_future)
          .get();
  ASSERT_TRUE(stream) << stream.error().message;
  EXPECT_EQ(where.get_future().get(), running.thread());
  stream->cancel();
  EXPECT_TRUE(registrations.wait_until([](const auto& requests) {
    return !requests.empty() && requests.back().interval_ms == msg::Milliseconds{};
  }));
}

TEST_F(Async, StreamWithAnImpossibleIntervalCompletesWithAnError) {
  board.on<msg::DataStreamInterval>([&](const msg::DataStreamInterval& m) { board.confirm(m); });
  AsyncClient client(running.executor());
  connect(client);
  for (const milliseconds interval : {milliseconds(0), milliseconds(70000)}) {
    const auto stream = client
                            .async_stream<msg::RealtimeData4>(
                                interval, [](const msg::RealtimeData4&) {}, {}, asio::use_future)
                            .get();
    ASSERT_FALSE(stream) << interval.count();
    EXPECT_EQ(stream.error().code, ErrorCode::invalid);
    EXPECT_EQ(stream.error().message, "a stream interval of " + std::to_string(interval.count()) +
                                          " ms is not possible: the range is 1 to 65535 ms");
  }
  const auto possible =
      client
          .async_stream<msg::RealtimeData4>(
              milliseconds(20), [](const msg::RealtimeData4&) {},
              {.timeout = std::chrono::seconds(10), .retries = 0}, asio::use_future)
          .get();
  EXPECT_TRUE(possible);
  EXPECT_TRUE(board.wait_for<msg::DataStreamInterval>(1));
  EXPECT_EQ(board.count<msg::DataStreamInterval>(), 1U) << "nothing was sent for the others";
}

TEST_F(Async, RawStreamsHaveTheBytesOfAnyMessage) {
  constexpr std::uint8_t unknown_id = 200;
  board.on<msg::DataStreamInterval>([&](const msg::DataStreamInterval& request) {
    registrations.add(request);
    board.confirm(request);
    std::array<std::uint8_t, max_frame_size> frame{};
    const std::array<std::uint8_t, 3> body{1, 2, 3};
    for (const std::uint8_t id : {std::uint8_t{201}, unknown_id}) {
      board.send_bytes(std::span(frame).first(write_frame(id, body, frame).size));
    }
  });
  msg::DataStreamInterval request;
  request.cmd_id = static_cast<msg::CommandFromBoard>(unknown_id);
  request.interval_ms = msg::Milliseconds(100);  // for 258 bytes at 115200 Bd
  std::promise<Frame> first;
  std::atomic<bool> has_one{};
  const auto take = [&](const Frame& frame) {
    if (!has_one.exchange(true)) first.set_value({.id = frame.id, .body = {}});
  };
  AsyncClient client(running.executor());
  const auto refused = client.async_stream_raw(request, take, asio::use_future).get();
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ErrorCode::not_connected);
  connect(client);
  {
    const auto stream = client.async_stream_raw(request, take, {}, asio::use_future).get();
    ASSERT_TRUE(stream) << stream.error().message;
    EXPECT_EQ(first.get_future().get().id, unknown_id);
  }
  EXPECT_TRUE(registrations.wait_until([](const auto& requests) {
    return requests.size() == 2 && requests.back().interval_ms == msg::Milliseconds{};
  }));
}

TEST_F(Async, CanConnectAgain) {
  board.answer<msg::GetAnglesRequest>(msg::GetAngles{});
  AsyncClient client(running.executor());
  connect(client);
  connect(client);
  EXPECT_TRUE(client.async_call(msg::GetAnglesRequest{}, {}, asio::use_future).get());
  client.close();
  EXPECT_EQ(client.async_call(msg::GetAnglesRequest{}, {}, asio::use_future).get().error().code,
            ErrorCode::not_connected);
}

}  // namespace
}  // namespace sbgc::test
