// Tests of unsolicited messages: subscriptions, data streams, notices.

#include "testing.hpp"

namespace sbgc::test {
namespace {

msg::GetAngles angles(std::int16_t raw) {
  msg::GetAngles message;
  message.axes.yaw.imu_angle = msg::Angle14(raw);
  return message;
}

using Subscribed = ScriptedTest;

TEST_F(Subscribed, GetsEveryMessageOfItsKindAnswersToo) {
  board.answer<msg::GetAnglesRequest>(angles(3));
  Client client = connect();
  Collector<msg::GetAngles> got;
  const auto subscription = subscribe_into(got, client);
  board.send(angles(1));
  board.send(msg::RealtimeData3{});
  board.send(angles(2));
  EXPECT_THAT(got.wait_for(2), ElementsAre(angles(1), angles(2)));
  EXPECT_TRUE(client.get_angles({}, once));
  EXPECT_THAT(got.wait_for(3).back(), angles(3));
}

TEST_F(Subscribed, TellsFormsOfACommandApart) {
  Client client = connect();
  std::atomic<int> simple{};
  Collector<msg::ErrorExt> extended;
  const auto one = client.subscribe<msg::Error>([&](const msg::Error&) { ++simple; });
  const auto two = subscribe_into(extended, client);
  board.send(msg::ErrorExt{});
  extended.wait_for(1);
  settle(client);
  EXPECT_EQ(simple, 0);
}

TEST_F(Subscribed, TheRequestTellsAnswersOfOneSizeApart) {
  introduce(board, 2745);
  board.answer<msg::AdjVarsStateRequestExt>(msg::AdjVarsStateExt{.analog_var_value = 1.5F});
  board.answer<msg::AdjVarsStateRequest>(msg::AdjVarsState{.analog_value = 7});
  Client client = connect();
  Collector<float> floats;
  Collector<std::int32_t> integers;
  const auto one = client.subscribe<msg::AdjVarsStateExt>(
      [&](const msg::AdjVarsStateExt& state) { floats.add(state.analog_var_value); });
  const auto two = client.subscribe<msg::AdjVarsState>(
      [&](const msg::AdjVarsState& state) { integers.add(state.analog_value); });
  const auto extended = checked(client.adj_vars_state_ext({}, once));
  EXPECT_EQ(extended->analog_var_value, 1.5F);
  const auto simple = checked(client.adj_vars_state({}, once));
  EXPECT_EQ(simple->analog_value, 7);
  EXPECT_THAT(floats.wait_for(1), ElementsAre(1.5F));
  EXPECT_THAT(integers.wait_for(1), ElementsAre(7));
}

TEST_F(Subscribed, EndsWithItsOwner) {
  Client client = connect();
  std::atomic<int> calls{};
  {
    const auto subscription =
        client.subscribe<msg::GetAngles>([&](const msg::GetAngles&) { ++calls; });
    board.send(angles(1));
    settle(client);
  }
  board.send(angles(2));
  settle(client);
  EXPECT_EQ(calls, 1);
}

TEST_F(Subscribed, CanEndItselfInItsHandler) {
  Client client = connect();
  std::atomic<int> calls{};
  std::optional<Subscription> subscription;
  const auto witness = std::make_shared<int>();
  subscription = client.subscribe<msg::GetAngles>([&, witness](const msg::GetAngles&) {
    ++calls;
    subscription.reset();
  });
  board.send(angles(1));
  board.send(angles(2));
  settle(client);
  EXPECT_EQ(calls, 1);
  EXPECT_FALSE(subscription);
  EXPECT_EQ(witness.use_count(), 1) << "the handler is still held";
}

TEST_F(Subscribed, EndingWaitsForTheHandler) {
  Client client = connect();
  std::promise<void> entered;
  std::promise<void> leave;
  std::atomic<bool> is_running{};
  std::optional<Subscription> subscription =
      client.subscribe<msg::GetAngles>([&](const msg::GetAngles&) {
        is_running = true;
        entered.set_value();
        leave.get_future().wait();
        is_running = false;
      });
  board.send(angles(1));
  entered.get_future().wait();
  std::thread release([&] {
    std::this_thread::sleep_for(Ms(50));  // the other thread is waiting by then
    leave.set_value();
  });
  subscription.reset();
  EXPECT_FALSE(is_running);
  release.join();
}

TEST_F(Subscribed, MayOutliveTheClient) {
  Subscription subscription;
  Subscription stream;
  Subscription notices;
  serve_streams();
  {
    Client client = connect();
    subscription = client.subscribe<msg::GetAngles>([](const auto&) {});
    notices = client.on_notice([](const Notice&) {});
    auto started = checked(client.stream<msg::RealtimeData4>(Ms(20), [](const auto&) {}));
    stream = *std::move(started);
  }
  subscription.cancel();
}

TEST_F(Subscribed, ClientMayBeDestroyedByAHandler) {
  auto client = std::make_unique<Client>(connect());
  std::promise<void> done;
  const auto subscription = client->subscribe<msg::GetAngles>([&](const msg::GetAngles&) {
    client.reset();
    done.set_value();
  });
  board.send(angles(1));
  EXPECT_EQ(done.get_future().wait_for(std::chrono::seconds(10)), std::future_status::ready);
}

TEST_F(Subscribed, CountsWhatItCannotReadAndSaysWhy) {
  Client client = connect();
  const auto parameters =
      client.subscribe<msg::ReadParams3>([](const msg::ReadParams3&) { FAIL(); });
  const auto file = client.subscribe<msg::ReadFileError>([](const msg::ReadFileError&) { FAIL(); });
  Collector<Notice> got;
  const auto notices = client.on_notice([&](const Notice& notice) { got.add(notice); });
  const auto send = [&](auto command, int size) {
    const std::vector<std::uint8_t> body{1, 2, 3, 4};
    board.send_bytes(
        to_frame({static_cast<std::uint8_t>(command), {body.begin(), body.begin() + size}}));
  };
  for (const int size : {3, 3, 4}) send(msg::ReadParams3::command, size);
  send(msg::ReadFile::command, 2);
  settle(client);
  EXPECT_EQ(client.statistics().unreadable, 4U);
  const auto all = got.wait_for(3);
  ASSERT_EQ(all.size(), 3U) << "one for each reason";
  EXPECT_EQ(all[0].kind, NoticeKind::unreadable);
  EXPECT_EQ(all[0].command, 21);
  EXPECT_EQ(all[0].message, "CMD_READ_PARAMS_3 cannot be decoded: 3 bytes, the message needs 134");
  EXPECT_THAT(all[1].message, HasSubstr("4 bytes"));
  EXPECT_EQ(all[2].message,
            "CMD_READ_FILE cannot be decoded: 2 bytes: The command has no form with a body of this "
            "size");
}

// Data streams

TEST_F(Subscribed, ToAStreamRegistersItAndEndsIt) {
  serve_streams();
  Client client = connect();
  Collector<msg::RealtimeData4> samples;
  auto stream = checked(client.stream<msg::RealtimeData4>(
      Ms(20), [&](const msg::RealtimeData4& sample) { samples.add(sample); }, once));
  msg::DataStreamInterval expected{.cmd_id = msg::CommandFromBoard::realtime_data_4,
                                   .interval_ms = 20_ms};
  expected.config.rest.resize(8);
  EXPECT_EQ(registrations.wait_for(1).at(0), expected);
  board.send(msg::RealtimeData4{});
  board.send(msg::RealtimeData4{});
  samples.wait_for(2);
  stream->cancel();
  expected.interval_ms = {};
  EXPECT_EQ(registrations.wait_for(2).at(1), expected);
}

TEST_F(Subscribed, ToAStreamWithAnIntervalThatTheRequestCannotTellFails) {
  serve_streams();
  Client client = connect();
  const auto ask = [&](Ms interval) {
    return client.stream<msg::RealtimeData4>(
        interval, [](const auto&) {}, once);
  };
  for (const Ms interval : {Ms(0), Ms(-20), Ms(0x10000), Ms(70000), Ms::max(), Ms::min()}) {
    const auto stream = ask(interval);
    EXPECT_THAT(stream,
                fails(ErrorCode::invalid, AllOf(HasSubstr(std::to_string(interval.count()) + " ms"),
                                                HasSubstr("1 to 65535 ms"))));
  }
  const auto longest = checked(ask(Ms(0xFFFF)));
  const auto requests = registrations.wait_for(1);
  ASSERT_EQ(requests.size(), 1U) << "nothing was sent for the others";
  EXPECT_EQ(requests.at(0).interval_ms, msg::Milliseconds(0xFFFF));
}

TEST_F(Subscribed, ToAStreamEndsItWithTheClient) {
  serve_streams();
  Subscription survivor;
  {
    Client client = connect();
    auto first = client.stream<msg::RealtimeData4>(Ms(50), [](const auto&) {});
    auto second = client.stream<msg::RealtimeData3>(Ms(50), [](const auto&) {});
    ASSERT_TRUE(first && second);
    survivor = *std::move(second);
    // The other one ends just before the client does.
  }
  // One may be ended twice, if its end was not confirmed yet.
  for (const auto command :
       {msg::CommandFromBoard::realtime_data_4, msg::CommandFromBoard::realtime_data_3}) {
    EXPECT_TRUE(registrations.wait_until([&](const auto& requests) {
      return std::ranges::any_of(requests, [&](const msg::DataStreamInterval& request) {
        return request.cmd_id == command && request.interval_ms == msg::Milliseconds{};
      });
    }));
  }
}

TEST_F(Subscribed, ToTheSameStreamTwiceEndsItOnce) {
  serve_streams();
  Client client = connect();
  auto first = client.stream<msg::RealtimeData4>(
      Ms(20), [](const auto&) {}, once);
  auto second = client.stream<msg::RealtimeData4>(
      Ms(20), [](const auto&) {}, once);
  ASSERT_TRUE(first && second);
  first->cancel();
  settle(client);
  EXPECT_EQ(registrations.wait_for(2).size(), 2U);
  second->cancel();
  EXPECT_EQ(registrations.wait_for(3).at(2).interval_ms, msg::Milliseconds{});
}

TEST_F(Subscribed, ToAStreamReadsItByWhatWasAskedFor) {
  board.on<msg::DataStreamInterval>([this](const msg::DataStreamInterval& request) {
    board.confirm(request);
    if (request.interval_ms.raw() == 0) return;
    msg::RealtimeDataCustom sample;
    sample.imu_angles.emplace().pitch = msg::Angle14(77);
    board.send(sample);
  });
  Client client = connect();
  Collector<msg::RealtimeDataCustom> samples;
  msg::DataStreamInterval request{.interval_ms = 50_ms};
  request.config.flags = msg::RealtimeDataCustomFlags(msg::RealtimeDataCustomFlag::imu_angles);
  const auto stream = checked(client.stream<msg::RealtimeDataCustom>(
      request, [&](const msg::RealtimeDataCustom& sample) { samples.add(sample); }));
  const auto got = samples.wait_for(1);
  ASSERT_TRUE(got.at(0).imu_angles);
  EXPECT_EQ(got.at(0).imu_angles->pitch, msg::Angle14(77));
}

TEST_F(Subscribed, ToMoreThanTheLineCarriesIsRefused) {
  serve_streams();
  const TransportFactory make = [&](const asio::any_io_executor& executor) {
    auto pair = io::make_memory_pair(executor, board.executor(), {.with_line = true});
    static_cast<void>(pair.first->line()->set({9600, io::Parity::none}));
    static_cast<void>(pair.second->line()->set({9600, io::Parity::none}));
    board.serve(std::move(pair.second));
    return std::move(pair.first);
  };
  ConnectOptions options = quick();
  options.detect_line = false;
  auto client = checked(connect_over(make, options));
  const auto stream = checked(client->stream<msg::RealtimeData4>(Ms(500), [](const auto&) {}));
  const auto usage = client->statistics().streams;
  EXPECT_EQ(usage.limit, 960U * 80 / 100);
  EXPECT_GT(usage.used, 0U);
  EXPECT_THAT(client->stream<msg::RealtimeData3>(Ms(1), [](const auto&) {}),
              fails(ErrorCode::overload, "not enough bandwidth for the data stream: 768 bytes/s"));
}

TEST_F(Subscribed, ToAStreamThatTheBoardRefusesFails) {
  board.answer<msg::DataStreamInterval>(msg::ErrorExt{
      .cmd_id = msg::CommandToBoard::data_stream_interval, .error_code = msg::BoardErrorCode(3)});
  Client client = connect();
  const auto stream = client.stream<msg::RealtimeData4>(
      Ms(20), [](const auto&) {}, once);
  ASSERT_THAT(stream, fails(ErrorCode::board_error));
  settle(client);
  EXPECT_EQ(board.count<msg::DataStreamInterval>(), 1U)
      << "a stream that never ran need not be ended";
}

TEST_F(Subscribed, ToAStreamEndsItWhenItIsCancelledBehindTheClient) {
  // The line must be closed after the end of the stream, whichever is requested first.
  serve_streams();
  Client client = connect();
  auto stream = checked(client.stream<msg::RealtimeData4>(Ms(20), [](const auto&) {}));
  // The client's thread is kept busy, so that closing is still pending.
  std::promise<void> is_busy;
  std::promise<void> may_go_on;
  const auto busy = client.subscribe<msg::RealtimeData3>([&](const msg::RealtimeData3&) {
    is_busy.set_value();
    may_go_on.get_future().wait();
  });
  board.send(msg::RealtimeData3{});
  is_busy.get_future().wait();
  client.close();
  stream->cancel();
  may_go_on.set_value();
  EXPECT_TRUE(is_stream_ended());
}

TEST_F(Subscribed, ToAStreamThatMayHaveBegunUnheardEndsIt) {
  board.on<msg::DataStreamInterval>([this](const msg::DataStreamInterval& m) {
    registrations.add(m);
    if (m.interval_ms.raw() == 0) board.confirm(m);  // the other confirmation is lost
  });
  Client client = connect();
  EXPECT_THAT(client.stream<msg::RealtimeData4>(Ms(20), [](const auto&) {},
                                                {.timeout = Ms(1000), .retries = 0}),
              fails(ErrorCode::timeout));
  const auto asked = registrations.wait_for(2);
  ASSERT_GE(asked.size(), 2U);
  EXPECT_EQ(asked[0].interval_ms.raw(), 20U);
  EXPECT_EQ(asked[1].interval_ms.raw(), 0U);
  client.close();  // nothing of it may arrive later
}

// Notices

TEST_F(Subscribed, ToNoticesHearsOfResetsErrorsAndTheLossOfTheLine) {
  Client client = connect();
  Collector<Notice> got;
  const auto subscription = client.on_notice([&](const Notice& notice) { got.add(notice); });
  board.send(msg::ErrorExt{.cmd_id = msg::CommandToBoard::control,
                           .error_code = msg::BoardErrorCode::not_supported});
  board.send(msg::Reset{});
  EXPECT_EQ(got.wait_for(2).at(1).kind, NoticeKind::board_reset);
  board.unplug();
  const auto notices = got.wait_for(3);
  ASSERT_EQ(notices.size(), 3U);
  EXPECT_EQ(notices[0].kind, NoticeKind::board_error);
  EXPECT_EQ(notices[0].detail, 9);
  EXPECT_EQ(notices[0].command, 67);
  EXPECT_EQ(notices[0].message, "CMD_CONTROL: the board refused: NOT_SUPPORTED");
  EXPECT_EQ(notices[2].kind, NoticeKind::link_lost);
  EXPECT_THAT(notices[2].message, HasSubstr("the connection is lost"));
}

}  // namespace
}  // namespace sbgc::test
