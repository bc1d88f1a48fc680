// Tests of the client with completion tokens.

#include <asio/awaitable.hpp>
#include <asio/bind_cancellation_slot.hpp>
#include <asio/bind_executor.hpp>
#include <asio/cancellation_signal.hpp>
#include <asio/co_spawn.hpp>
#include <asio/thread_pool.hpp>
#include <asio/use_awaitable.hpp>
#include <asio/use_future.hpp>

#include <sbgc/any.hpp>
#include <sbgc/client/async_client.hpp>
#include <sbgc/client/motion.hpp>
#include <sbgc/meta/all.hpp>

#include "testing.hpp"

namespace sbgc::test {
namespace {

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

class Async : public ScriptedTest {
 protected:
  void connect(AsyncClient& one) {
    require(one.async_connect_over(over_line(board), quick(), asio::use_future).get());
  }
  void connect() { connect(*client); }
  /// Cancels an operation, which ends with this code.
  template <class Begin>
  ErrorCode cancel(
      Begin begin, const std::function<void()>& wait = [] {}) {
    asio::cancellation_signal signal;
    std::promise<ErrorCode> code;
    asio::post(running.executor(), [&] {
      begin(asio::bind_cancellation_slot(
          signal.slot(), [&](const auto& result) { code.set_value(result.error().code); }));
    });
    wait();
    asio::post(running.executor(), [&] { signal.emit(asio::cancellation_type::all); });
    return code.get_future().get();
  }

  Running running;
  std::optional<AsyncClient> client{std::in_place, running.executor()};
};

TEST_F(Async, WorksWithFutures) {
  msg::GetAngles angles;
  angles.axes.roll.imu_angle = 10_deg;
  board.answer<msg::GetAnglesRequest>(angles);
  EXPECT_FALSE(client->is_connected());
  connect();
  EXPECT_TRUE(client->is_connected());
  EXPECT_EQ(client->identity().firmware_version(), "2.59");
  const auto answer = client->async_call(msg::GetAnglesRequest{}, {}, asio::use_future).get();
  ASSERT_TRUE(answer) << answer.error().message;
  EXPECT_EQ(*answer, angles);
}

TEST_F(Async, PollsReplaceStreamsOfOldFirmware) {
  emulator::EmulatorOptions old = quick_board();
  old.board.firmware = msg::FirmwareVersion(2439);
  EmulatedBoard old_board{old};
  require(client->async_connect_over(old_board.line(), quick(), asio::use_future).get());
  Collector<msg::RealtimeData3> samples;
  const auto stream = checked(
      client
          ->async_stream<msg::RealtimeData3>(
              Ms(5), [&](const msg::RealtimeData3& one) { samples.add(one); }, asio::use_future)
          .get());
  EXPECT_GE(samples.wait_for(5).size(), 5U);
  client.reset();
}

TEST_F(Async, WorksWithCallbacksThatCanOnlyBeMoved) {
  board.on<msg::MotorsOn>([&](const msg::MotorsOn& request) { board.confirm(request); });
  connect();
  std::promise<std::thread::id> where;
  auto owned = std::make_unique<int>(7);
  client->async_call(msg::MotorsOn{}, {},
                     [&where, owned = std::move(owned)](const Result<void>& result) {
                       EXPECT_TRUE(result);
                       EXPECT_EQ(*owned, 7);
                       where.set_value(std::this_thread::get_id());
                     });
  EXPECT_EQ(where.get_future().get(), running.thread());
}

TEST_F(Async, CompletesOnTheHandlersExecutor) {
  board.answer<msg::GetAnglesRequest>(msg::GetAngles{});
  connect();
  asio::thread_pool pool(1);
  std::promise<bool> is_on_pool;
  client->async_call(msg::GetAnglesRequest{}, {},
                     asio::bind_executor(pool, [&](const Result<msg::GetAngles>&) {
                       is_on_pool.set_value(pool.get_executor().running_in_this_thread());
                     }));
  EXPECT_TRUE(is_on_pool.get_future().get());
  pool.join();
}

TEST_F(Async, NeverCompletesInsideTheCallThatBegins) {
  std::promise<bool> was_behind;
  asio::post(running.executor(), [&] {
    const auto has_returned = std::make_shared<bool>(false);
    client->async_call(msg::GetAnglesRequest{}, {},
                       [&was_behind, has_returned](const auto& result) {
                         EXPECT_EQ(result.error().code, ErrorCode::not_connected);
                         was_behind.set_value(*has_returned);
                       });
    *has_returned = true;
  });
  EXPECT_TRUE(was_behind.get_future().get());
}

TEST_F(Async, CanBeCancelled) {
  connect();
  EXPECT_EQ(cancel(
                [&](auto token) {
                  client->async_call(msg::GetAnglesRequest{}, {.timeout = Ms(60'000)}, token);
                },
                [&] { EXPECT_TRUE(board.wait_for<msg::GetAnglesRequest>(1)); }),
            ErrorCode::cancelled);
}

TEST_F(Async, DestroyingTheClientEndsItsCalls) {
  connect();
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
  // The operators && and || of awaitables and parallel groups do this.
  asio::cancellation_signal signal;
  std::promise<bool> connected;
  asio::post(running.executor(), [&] {
    client->async_connect_over(
        over_line(board), quick(),
        asio::bind_cancellation_slot(signal.slot(), [&](const Result<void>& result) {
          signal.emit(asio::cancellation_type::all);
          connected.set_value(static_cast<bool>(result));
        }));
  });
  ASSERT_TRUE(connected.get_future().get());
  board.answer<msg::GetAnglesRequest>(msg::GetAngles{});
  const auto angles = client->async_call(msg::GetAnglesRequest{}, {}, asio::use_future).get();
  EXPECT_TRUE(angles) << angles.error().message;
}

TEST_F(Async, CallsAMessageOfATypeKnownAtRunTime) {
  connect();
  msg::GetAngles angles;
  angles.axes.yaw.imu_angle = msg::Angle14(1234);
  board.answer<msg::GetAnglesRequest>(angles);
  const AnyMessage request = find_message("GetAnglesRequest")->make();
  const auto answer = client->async_call(request, {}, asio::use_future).get();
  ASSERT_TRUE(answer && *answer);
  ASSERT_NE((*answer)->get_if<msg::GetAngles>(), nullptr);
  EXPECT_EQ(*(*answer)->get_if<msg::GetAngles>(), angles);
  const AnyMessage wrong = find_message("GetAngles")->make();
  EXPECT_EQ(client->async_call(wrong, {}, asio::use_future).get().error().code, ErrorCode::invalid);
}

Task<Result<int>> ask_three_times() {
  int good = 0;
  for (int i = 0; i < 3; ++i) {
    const auto angles = co_await tasks::call(msg::GetAnglesRequest{});
    good += angles ? 1 : 0;
  }
  co_return good;
}

TEST_F(Async, WorksInCoroutines) {
  board.answer<msg::GetAnglesRequest>(msg::GetAngles{});
  const auto talk = [&]() -> asio::awaitable<std::string> {
    const auto connected =
        co_await client->async_connect_over(over_line(board), quick(), asio::use_awaitable);
    if (!connected) co_return connected.error().message;
    const auto angles =
        co_await client->async_call(msg::GetAnglesRequest{}, {}, asio::use_awaitable);
    if (!angles) co_return angles.error().message;
    const auto good = co_await client->async_run(ask_three_times(), asio::use_awaitable);
    if (!good) co_return good.error().message;
    co_return client->identity().firmware_version() + ", " + std::to_string(*good) + " answers";
  };
  EXPECT_EQ(asio::co_spawn(running.executor(), talk(), asio::use_future).get(), "2.59, 3 answers");
}

TEST_F(Async, ATaskNeedsAConnection) {
  EXPECT_THAT(client->async_run(ask_three_times(), asio::use_future).get(),
              fails(ErrorCode::not_connected));
}

TEST_F(Async, MovesWithoutAThread) {
  msg::GetAngles angles;
  angles.axes.pitch.imu_angle = -30_deg;
  board.answer<msg::GetAnglesRequest>(angles);
  board.ignore<msg::ControlExt>();
  connect();
  std::promise<std::thread::id> where;
  MoveOptions options{.settle = Ms(10), .interval = Ms(1)};
  options.progress = [&where, first = true](const MoveProgress&) mutable {
    if (std::exchange(first, false)) where.set_value(std::this_thread::get_id());
    return true;
  };
  const auto moved =
      client->async_run(tasks::move_to({.pitch = -30_deg}, options), asio::use_future).get();
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
  connect();
  EXPECT_EQ(cancel([&](auto token) { client->async_run(wait_long(), token); }),
            ErrorCode::cancelled);
  EXPECT_EQ(cancel([&](auto token) { client->async_run(sleep_long(), token); }),
            ErrorCode::cancelled);
}

Task<Result<void>> throw_soon() {
  const TaskMachine& task = co_await tasks::this_task();
  static_cast<void>(co_await tasks::wait_until(task.now() + sbgc::milliseconds(1)));
  throw std::domain_error("of a handler");
}

TEST_F(Async, AnExceptionOfAHandlerEndsOnlyItsTask) {
  asio::io_context context;
  client.emplace(context.get_executor());
  const auto run_until = [&](const bool& is_over) {
    while (!is_over) context.run_one();
  };
  bool is_connected = false;
  bool is_done = false;
  bool is_answered = false;
  client->async_connect_over(over_line(board), quick(), [&](const auto&) { is_connected = true; });
  run_until(is_connected);
  client->async_run(throw_soon(), [&](const auto&) { is_done = true; });
  EXPECT_THROW(run_until(is_done), std::domain_error);
  client->async_call(msg::BoardInfoRequest{}, [&](const auto&) { is_answered = true; });
  run_until(is_answered);
  EXPECT_FALSE(is_done);
  client.reset();
  context.run();
}

TEST_F(Async, DestroyingTheClientEndsItsTasks) {
  connect();
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
  connect();
  std::promise<std::thread::id> where;
  auto stream =
      client
          ->async_stream<msg::RealtimeData4>(
              Ms(20),
              [&](const msg::RealtimeData4&) { where.set_value(std::this_thread::get_id()); }, {},
              asio::use_future)
          .get();
  ASSERT_TRUE(stream) << stream.error().message;
  EXPECT_EQ(where.get_future().get(), running.thread());
  stream->cancel();
  EXPECT_TRUE(is_stream_ended());
}

TEST_F(Async, RawStreamsHaveTheBytesOfAnyMessage) {
  constexpr std::uint8_t unknown_id = 200;
  board.on<msg::DataStreamInterval>([&](const msg::DataStreamInterval& request) {
    registrations.add(request);
    board.confirm(request);
    for (const std::uint8_t id : {std::uint8_t{201}, unknown_id}) {
      board.send_bytes(to_frame({id, {1, 2, 3}}));
    }
  });
  msg::DataStreamInterval request{.cmd_id = static_cast<msg::CommandFromBoard>(unknown_id)};
  request.interval_ms = msg::Milliseconds(100);  // for 258 bytes at 115200 Bd
  std::promise<Frame> first;
  std::atomic<bool> has_one{};
  const auto take = [&](const Frame& frame) {
    if (!has_one.exchange(true)) first.set_value({.id = frame.id, .body = {}});
  };
  EXPECT_THAT(client->async_stream_raw(request, take, asio::use_future).get(),
              fails(ErrorCode::not_connected));
  connect();
  {
    const auto stream = client->async_stream_raw(request, take, {}, asio::use_future).get();
    ASSERT_TRUE(stream) << stream.error().message;
    EXPECT_EQ(first.get_future().get().id, unknown_id);
  }
  EXPECT_TRUE(registrations.wait_until([](const auto& requests) {
    return requests.size() == 2 && requests.back().interval_ms == msg::Milliseconds{};
  }));
}

TEST_F(Async, CanConnectAgain) {
  board.answer<msg::GetAnglesRequest>(msg::GetAngles{});
  connect();
  connect();
  EXPECT_TRUE(client->async_call(msg::GetAnglesRequest{}, {}, asio::use_future).get());
  client->close();
  EXPECT_EQ(client->async_call(msg::GetAnglesRequest{}, {}, asio::use_future).get().error().code,
            ErrorCode::not_connected);
}

}  // namespace
}  // namespace sbgc::test
