// Tests of the asynchronous client that connects again by itself. One thread runs its executor, so
// that a function that waits for the executor would never return.

#include <asio/bind_cancellation_slot.hpp>
#include <asio/cancellation_signal.hpp>
#include <asio/use_future.hpp>

#include <sbgc/client/async_client.hpp>
#include <sbgc/client/async_reconnecting_client.hpp>
#include <sbgc/client/motion.hpp>
#include <sbgc/client/speed_control.hpp>

#include "testing.hpp"

namespace sbgc::test {
namespace {

class AsyncReconnecting : public CableTest {
 protected:
  AsyncReconnecting() : thread([this] { context.run(); }) {}
  ~AsyncReconnecting() override {
    on_executor([this] { client.reset(); });
    work.reset();
    thread.join();
  }

  void connect(const ReconnectOptions& options = quick_again()) {
    client.emplace(context.get_executor());
    auto connected = client->async_connect_over(cable(), options, asio::use_future);
    watching = client->on_change([this](const LinkChange& change) {
      EXPECT_EQ(std::this_thread::get_id(), thread.get_id());
      watch(change);
    });
    require(connected.get());
  }
  /// Turns the camera, and waits until the board has received it.
  void turn(SpeedControl& control) {
    ASSERT_TRUE(control.set({.yaw = msg::ControlSpeed(100)}));
    wait_for_requests<msg::Control>(1);
  }
  auto ask() { return client->async_call(msg::GetAnglesRequest{}, asio::use_future); }
  /// Does something on the only thread of the executor, and waits for its end.
  void on_executor(const std::function<void()>& act) {
    std::promise<void> done;
    asio::post(context, [&] {
      act();
      done.set_value();
    });
    done.get_future().wait();
  }

  asio::io_context context;
  std::optional<asio::executor_work_guard<asio::io_context::executor_type>> work{
      context.get_executor()};
  std::optional<AsyncClient> client;
  Subscription watching;
  std::thread thread;
};

TEST_F(AsyncReconnecting, TheFirstConnectionMustSucceed) {
  is_plugged = false;
  client.emplace(context.get_executor());
  EXPECT_EQ(ask().get().error().code, ErrorCode::not_connected);
  EXPECT_FALSE(client->on_change([](const LinkChange&) {}));
  EXPECT_THAT(client->async_connect_over(cable(), quick_again(), asio::use_future).get(),
              fails(ErrorCode::not_found));
  EXPECT_EQ(attempts, 1);
  EXPECT_EQ(client->connections(), 0U);
  is_plugged = true;
  connect();
  EXPECT_TRUE(ask().get());
}

TEST_F(AsyncReconnecting, ALaterAttemptToConnectEndsAnEarlierOne) {
  client.emplace(context.get_executor());
  std::unique_ptr<io::Transport> silent;
  const auto silent_line = [&](const asio::any_io_executor& executor) {
    auto pair = io::make_memory_pair(executor);
    silent = std::move(pair.second);
    return std::move(pair.first);
  };
  auto first =
      client->async_connect_over(silent_line, {.timeout = std::chrono::hours(1)}, asio::use_future);
  auto second = client->async_connect_over(cable(), quick_again(), asio::use_future);
  EXPECT_FALSE(first.get());
  EXPECT_TRUE(second.get());
  EXPECT_TRUE(ask().get());
  on_executor([&] { silent.reset(); });
}

TEST_F(AsyncReconnecting, TheFormerNameDoesIt) {
  AsyncReconnectingClient former(context.get_executor());
  ASSERT_TRUE(former.async_connect_over(cable(), asio::use_future).get());
  board.unplug();
  wait_until([&] { return former.connections() >= 2; });
  on_executor([&] { former.close(); });
}

TEST_F(AsyncReconnecting, OperationsCanWaitForTheConnection) {
  connect(quick_again(OutagePolicy::wait));
  pull();
  auto angles = ask();
  auto stream = client->async_stream<msg::RealtimeData4>(
      Ms(20), [](const auto&) {}, asio::use_future);
  auto moved = client->async_run(tasks::stop(), asio::use_future);
  EXPECT_THAT(
      client->async_call(msg::GetAnglesRequest{}, {.timeout = Ms(10)}, asio::use_future).get(),
      fails(ErrorCode::not_connected));
  plug();
  EXPECT_TRUE(angles.get());
  EXPECT_TRUE(stream.get());
  EXPECT_TRUE(moved.get());
}

TEST_F(AsyncReconnecting, WhatWaitsForTheConnectionCanBeCancelled) {
  connect(quick_again(OutagePolicy::wait));
  pull();
  asio::cancellation_signal signal;
  std::promise<ErrorCode> code;
  on_executor([&] {
    client->async_call(msg::GetAnglesRequest{}, {.timeout = std::chrono::hours(1)},
                       asio::bind_cancellation_slot(signal.slot(), [&](const auto& result) {
                         code.set_value(result.error().code);
                       }));
  });
  on_executor([&] { signal.emit(asio::cancellation_type::all); });
  EXPECT_EQ(code.get_future().get(), ErrorCode::cancelled);
}

TEST_F(AsyncReconnecting, NothingRemainsOfACall) {
  connect();
  std::weak_ptr<int> left;
  {
    auto owned = std::make_shared<int>();
    left = owned;
    CallOptions options;
    options.on_confirmation = [owned](unsigned) {};
    EXPECT_TRUE(client->async_call(msg::GetAnglesRequest{}, options, asio::use_future).get());
  }
  on_executor([] {});  // it has completed
  client->close();
  on_executor([this] { client.reset(); });
  EXPECT_TRUE(left.expired());
}

TEST_F(AsyncReconnecting, StreamsGoOn) {
  connect();
  Collector<msg::RealtimeData4> samples;
  const auto take = [&](const msg::RealtimeData4& one) {
    EXPECT_EQ(std::this_thread::get_id(), thread.get_id());
    samples.add(one);
  };
  auto stream =
      checked(client->async_stream<msg::RealtimeData4>(Ms(20), take, asio::use_future).get());
  board.skip(Ms(100));
  samples.wait_for(2);
  pull();
  board.clear_log();
  plug();
  wait_for_requests<msg::DataStreamInterval>(1);
  expect_samples(samples);
  // Cancelling on the executor must not wait for it.
  board.clear_log();
  on_executor([&] { stream->cancel(); });
  wait_for_requests<msg::DataStreamInterval>(1);
  EXPECT_EQ(message<msg::DataStreamInterval>(board.log().back()).interval_ms.raw(), 0);
}

TEST_F(AsyncReconnecting, ATaskEndsWithItsConnection) {
  connect();
  board.on_lost([](const Packet& one) { return !is<msg::BoardInfoRequest>(one); });
  board.clear_log();
  auto moving = client->async_run(tasks::move_to({.yaw = 20_deg}, {.timeout = Ms(600'000)}),
                                  asio::use_future);
  wait_until([&] { return !board.log().empty(); });
  pull();
  const auto moved = moving.get();
  ASSERT_FALSE(moved);
  board.on_lost({});
  plug();
  EXPECT_TRUE(ask().get());
}

TEST_F(AsyncReconnecting, DestroyingItOnItsExecutorEndsEverything) {
  connect(quick_again(OutagePolicy::wait));
  board.on_lost([](const Packet&) { return true; });
  auto asked = client->async_call(msg::GetAnglesRequest{}, {.timeout = std::chrono::hours(1)},
                                  asio::use_future);
  wait_for_requests<msg::GetAnglesRequest>(1);
  on_executor([&] { client.reset(); });
  EXPECT_EQ(asked.get().error().code, ErrorCode::cancelled);
}

TEST_F(AsyncReconnecting, DestroyingItOnItsExecutorEndsTheSearch) {
  ReconnectOptions options = quick_again(OutagePolicy::wait);
  options.connection.timeout = std::chrono::hours(1);
  options.connection.retries = 90;
  connect(options);
  board.on_lost([](const Packet&) { return true; });
  board.unplug();  // the next line leads to a board that is silent
  ASSERT_TRUE(wait_for(LinkState::searching));
  wait_until([&] { return attempts >= 2; });
  auto waiting = client->async_call(msg::GetAnglesRequest{}, {.timeout = std::chrono::hours(1)},
                                    asio::use_future);
  on_executor([&] { client.reset(); });
  EXPECT_EQ(waiting.get().error().code, ErrorCode::not_connected);
}

TEST_F(AsyncReconnecting, AHandlerMayDestroyIt) {
  connect();
  std::promise<void> destroyed;
  const auto ending = client->on_change([&](const LinkChange& change) {
    if (change.state != LinkState::searching) return;
    client.reset();
    destroyed.set_value();
  });
  board.unplug();
  destroyed.get_future().wait();
}

TEST_F(AsyncReconnecting, TheContextIsFreeAfterClose) {
  connect();
  work.reset();
  client->close();
  thread.join();
  thread = std::thread([] {});
  EXPECT_EQ(client->state(), LinkState::closed);
  client.reset();
  context.restart();
  work.emplace(context.get_executor());
  thread.join();
  thread = std::thread([this] { context.run(); });
}

TEST_F(AsyncReconnecting, ACameraTurnsAgainOnlyIfItIsToldTo) {
  connect();
  SpeedControl control(*client, {.silence = std::chrono::hours(1)});
  turn(control);
  pull();
  wait_until([&] { return control.state() != SpeedControl::State::turning; });
  EXPECT_THAT(control.set({.yaw = 20_deg_per_s}), fails(ErrorCode::not_connected));
  board.clear_log();
  plug();
  EXPECT_TRUE(ask().get());
  EXPECT_EQ(board.count<msg::Control>(), 0U);
  turn(control);
}

TEST_F(AsyncReconnecting, ACameraStopsWhenItsOwnerDies) {
  connect();
  std::optional<SpeedControl> control(std::in_place, *client);
  turn(*control);
  board.clear_log();
  on_executor([&] { control.reset(); });  // on the only thread that can send the stop
  const auto is_stop = [](const msg::Control& one) { return one.axes.yaw.speed.raw() == 0; };
  wait_until([&] { return std::ranges::any_of(board.requests<msg::Control>(), is_stop); });
}

}  // namespace
}  // namespace sbgc::test
