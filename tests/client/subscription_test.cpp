// Tests of unsolicited messages: subscriptions, data streams, notices.

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <future>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sbgc/client/client.hpp>
#include <sbgc/messages.hpp>

#include "collector.hpp"
#include "scripted_board.hpp"

namespace sbgc::test {
namespace {

using std::chrono::milliseconds;
using ::testing::HasSubstr;

msg::GetAngles angles(std::int16_t raw) {
  msg::GetAngles message;
  message.axes.yaw.imu_angle = msg::Angle14(raw);
  return message;
}

class Subscribed : public ::testing::Test {
 protected:
  void SetUp() override { introduce(board); }

  Client connect(const ConnectOptions& options = quick()) {
    auto client = connect_over(over_line(board), options);
    if (!client) ADD_FAILURE() << client.error().message;
    return *std::move(client);
  }

  /// Confirms and records every registration.
  void serve_streams() {
    board.on<msg::DataStreamInterval>([this](const msg::DataStreamInterval& request) {
      registrations.add(request);
      board.confirm(request);
    });
  }

  /// Returns when all frames sent so far have been handled.
  void settle(Client& client) {
    board.on<msg::CalibInfoRequest>(
        [this](const msg::CalibInfoRequest&) { board.send(msg::CalibInfo{}); });
    EXPECT_TRUE(client.calib_info());
  }

  /// For calls that are counted.
  const CallOptions once{.timeout = std::chrono::seconds(10), .retries = 0};
  Collector<msg::DataStreamInterval> registrations;
  ScriptedBoard board;
};

TEST_F(Subscribed, GetsEveryMessageOfItsKind) {
  Client client = connect();
  Collector<msg::GetAngles> got;
  const auto subscription =
      client.subscribe<msg::GetAngles>([&](const msg::GetAngles& message) { got.add(message); });
  board.send(angles(1));
  board.send(msg::RealtimeData3{});
  board.send(angles(2));
  EXPECT_THAT(got.wait_for(2), ::testing::ElementsAre(angles(1), angles(2)));
}

TEST_F(Subscribed, GetsAnswersOfCallsToo) {
  board.answer<msg::GetAnglesRequest>(angles(3));
  Client client = connect();
  Collector<msg::GetAngles> got;
  const auto subscription =
      client.subscribe<msg::GetAngles>([&](const msg::GetAngles& message) { got.add(message); });
  EXPECT_TRUE(client.get_angles({}, once));
  EXPECT_THAT(got.wait_for(1), ::testing::ElementsAre(angles(3)));
}

TEST_F(Subscribed, TellsFormsOfACommandApart) {
  Client client = connect();
  std::atomic<int> simple{};
  Collector<msg::ErrorExt> extended;
  const auto one = client.subscribe<msg::Error>([&](const msg::Error&) { ++simple; });
  const auto two =
      client.subscribe<msg::ErrorExt>([&](const msg::ErrorExt& e) { extended.add(e); });
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
  const auto extended = client.adj_vars_state_ext({}, once);
  ASSERT_TRUE(extended) << extended.error().message;
  EXPECT_EQ(extended->analog_var_value, 1.5F);
  const auto simple = client.adj_vars_state({}, once);
  ASSERT_TRUE(simple) << simple.error().message;
  EXPECT_EQ(simple->analog_value, 7);
  EXPECT_THAT(floats.wait_for(1), ::testing::ElementsAre(1.5F));
  EXPECT_THAT(integers.wait_for(1), ::testing::ElementsAre(7));
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
    std::this_thread::sleep_for(milliseconds(50));  // the other thread is waiting by then
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
    subscription = client.subscribe<msg::GetAngles>([](const msg::GetAngles&) {});
    notices = client.on_notice([](const Notice&) {});
    auto started =
        client.stream<msg::RealtimeData4>(milliseconds(20), [](const msg::RealtimeData4&) {});
    ASSERT_TRUE(started) << started.error().message;
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
  const auto send = [&](auto command, std::size_t size) {
    const std::array<std::uint8_t, 4> body{1, 2, 3, 4};
    std::array<std::uint8_t, max_frame_size> frame{};
    const auto written =
        write_frame(static_cast<std::uint8_t>(command), std::span(body).first(size), frame);
    board.send_bytes(std::span(frame).first(written.size));
  };
  for (const std::size_t size : {3U, 3U, 4U}) send(msg::ReadParams3::command, size);
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
  auto stream = client.stream<msg::RealtimeData4>(
      milliseconds(20), [&](const msg::RealtimeData4& sample) { samples.add(sample); }, once);
  ASSERT_TRUE(stream) << stream.error().message;
  msg::DataStreamInterval expected;
  expected.cmd_id = msg::CommandFromBoard::realtime_data_4;
  expected.interval_ms = 20_ms;
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
  const auto ask = [&](milliseconds interval) {
    return client.stream<msg::RealtimeData4>(
        interval, [](const msg::RealtimeData4&) {}, once);
  };
  for (const milliseconds interval :
       {milliseconds(0), milliseconds(-20), milliseconds(0x10000), milliseconds(70000),
        milliseconds::max(), milliseconds::min()}) {
    const auto stream = ask(interval);
    ASSERT_FALSE(stream) << interval.count();
    EXPECT_EQ(stream.error().code, ErrorCode::invalid);
    EXPECT_THAT(stream.error().message,
                testing::AllOf(testing::HasSubstr(std::to_string(interval.count()) + " ms"),
                               testing::HasSubstr("1 to 65535 ms")));
  }
  const auto longest = ask(milliseconds(0xFFFF));
  ASSERT_TRUE(longest) << longest.error().message;
  const auto requests = registrations.wait_for(1);
  ASSERT_EQ(requests.size(), 1U) << "nothing was sent for the others";
  EXPECT_EQ(requests.at(0).interval_ms, msg::Milliseconds(0xFFFF));
}

TEST_F(Subscribed, ToAStreamEndsItWithTheClient) {
  serve_streams();
  Subscription survivor;
  {
    Client client = connect();
    auto first =
        client.stream<msg::RealtimeData4>(milliseconds(50), [](const msg::RealtimeData4&) {});
    auto second =
        client.stream<msg::RealtimeData3>(milliseconds(50), [](const msg::RealtimeData3&) {});
    ASSERT_TRUE(first && second);
    survivor = *std::move(second);
    // The other one ends just before the client does.
  }
  // One may be ended twice, if its end was not confirmed yet.
  const auto is_ended = [](const std::vector<msg::DataStreamInterval>& requests,
                           msg::CommandFromBoard command) {
    return std::any_of(
        requests.begin(), requests.end(), [&](const msg::DataStreamInterval& request) {
          return request.cmd_id == command && request.interval_ms == msg::Milliseconds{};
        });
  };
  EXPECT_TRUE(registrations.wait_until([&](const auto& requests) {
    return is_ended(requests, msg::CommandFromBoard::realtime_data_4) &&
           is_ended(requests, msg::CommandFromBoard::realtime_data_3);
  }));
}

TEST_F(Subscribed, ToTheSameStreamTwiceEndsItOnce) {
  serve_streams();
  Client client = connect();
  auto first = client.stream<msg::RealtimeData4>(
      milliseconds(20), [](const msg::RealtimeData4&) {}, once);
  auto second = client.stream<msg::RealtimeData4>(
      milliseconds(20), [](const msg::RealtimeData4&) {}, once);
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
  msg::DataStreamInterval request;
  request.interval_ms = 50_ms;
  request.config.flags = msg::RealtimeDataCustomFlags(msg::RealtimeDataCustomFlag::imu_angles);
  auto stream = client.stream<msg::RealtimeDataCustom>(
      request, [&](const msg::RealtimeDataCustom& sample) { samples.add(sample); });
  ASSERT_TRUE(stream) << stream.error().message;
  const auto got = samples.wait_for(1);
  ASSERT_TRUE(got.at(0).imu_angles);
  EXPECT_EQ(got.at(0).imu_angles->pitch, msg::Angle14(77));
}

TEST_F(Subscribed, ACallReadsItsAnswerByWhatItAskedFor) {
  board.on<msg::RealtimeDataCustomRequest>([this](const msg::RealtimeDataCustomRequest&) {
    msg::RealtimeDataCustom sample;
    sample.imu_angles.emplace().yaw = msg::Angle14(5);
    board.send(sample);
  });
  Client client = connect();
  const auto answer =
      client.realtime_data_custom({.flags = msg::RealtimeDataCustomFlag::imu_angles});
  ASSERT_TRUE(answer) << answer.error().message;
  ASSERT_TRUE(answer->imu_angles);
  EXPECT_EQ(answer->imu_angles->yaw, msg::Angle14(5));
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
  auto client = connect_over(make, options);
  ASSERT_TRUE(client) << client.error().message;
  auto fits =
      client->stream<msg::RealtimeData4>(milliseconds(500), [](const msg::RealtimeData4&) {});
  ASSERT_TRUE(fits) << fits.error().message;
  const auto usage = client->statistics().streams;
  EXPECT_EQ(usage.limit, 960U * 80 / 100);
  EXPECT_GT(usage.used, 0U);
  const auto refused =
      client->stream<msg::RealtimeData3>(milliseconds(1), [](const msg::RealtimeData3&) {});
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ErrorCode::overload);
  EXPECT_THAT(refused.error().message,
              HasSubstr("not enough bandwidth for the data stream: 768 bytes/s"));
}

TEST_F(Subscribed, ToAStreamThatTheBoardRefusesFails) {
  board.on<msg::DataStreamInterval>([this](const msg::DataStreamInterval&) {
    msg::ErrorExt error;
    error.cmd_id = msg::CommandToBoard::data_stream_interval;
    error.error_code = msg::BoardErrorCode(3);
    board.send(error);
  });
  Client client = connect();
  const auto stream = client.stream<msg::RealtimeData4>(
      milliseconds(20), [](const msg::RealtimeData4&) {}, once);
  ASSERT_FALSE(stream);
  EXPECT_EQ(stream.error().code, ErrorCode::board_error);
  settle(client);
  EXPECT_EQ(board.count<msg::DataStreamInterval>(), 1U)
      << "a stream that never ran need not be ended";
}

TEST_F(Subscribed, ToAStreamEndsItWhenItIsCancelledBehindTheClient) {
  // The line must be closed after the end of the stream, whichever is requested first.
  serve_streams();
  Client client = connect();
  auto stream =
      client.stream<msg::RealtimeData4>(milliseconds(20), [](const msg::RealtimeData4&) {});
  ASSERT_TRUE(stream) << stream.error().message;
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
  EXPECT_TRUE(registrations.wait_until([](const auto& requests) {
    return !requests.empty() && requests.back().interval_ms == msg::Milliseconds{};
  }));
}

TEST_F(Subscribed, ToAStreamThatMayHaveBegunUnheardEndsIt) {
  board.on<msg::DataStreamInterval>([this](const msg::DataStreamInterval& m) {
    registrations.add(m);
    if (m.interval_ms.raw() == 0) board.confirm(m);  // the other confirmation is lost
  });
  Client client = connect();
  const auto stream =
      client.stream<msg::RealtimeData4>(milliseconds(20), [](const msg::RealtimeData4&) {},
                                        {.timeout = milliseconds(1000), .retries = 0});
  ASSERT_FALSE(stream);
  EXPECT_EQ(stream.error().code, ErrorCode::timeout);
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
  msg::ErrorExt error;
  error.cmd_id = msg::CommandToBoard::control;
  error.error_code = msg::BoardErrorCode::not_supported;
  board.send(error);
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
