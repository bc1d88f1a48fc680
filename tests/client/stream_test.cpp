// Tests of data streams from an emulated board, over every kind of line.

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <cstdint>
#include <mutex>
#include <span>
#include <stdexcept>
#include <thread>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sbgc/any.hpp>
#include <sbgc/client/client.hpp>
#include <sbgc/frame.hpp>
#include <sbgc/messages.hpp>

#include "collector.hpp"
#include "emulated_board.hpp"
#include "scripted_board.hpp"

namespace sbgc::test {
namespace {

using std::chrono::milliseconds;

class Streams : public ::testing::Test {
 protected:
  Client connect() {
    auto client = connect_over(board.line(), quick());
    if (!client) throw std::runtime_error(client.error().message);
    return *std::move(client);
  }
  /// Advances the board's time in steps; afterwards `client` has received all samples.
  void let_pass(Client& client, milliseconds time) {
    // A pseudo-terminal loses data that is not read in time, so the client has to keep up.
    for (milliseconds passed{}; passed < time; passed += milliseconds(100)) {
      for (int step = 0; step < 10; ++step) board.skip(milliseconds(10));
      EXPECT_TRUE(client.get_angles());  // arrives after all samples
    }
  }

  EmulatedBoard board{quick_board(), {}, false};
};

/// A board whose firmware has no data streams.
class Polls : public ::testing::Test {
 protected:
  static emulator::EmulatorOptions old_board() {
    emulator::EmulatorOptions options = quick_board();
    options.board.firmware = msg::FirmwareVersion(2439);
    return options;
  }
  std::size_t requests() { return board.count<msg::RealtimeData4Request>(); }

  EmulatedBoard board{old_board()};
};

TEST_F(Polls, ReplaceStreamsAsLongAsTheyAreWanted) {
  auto connected = connect_over(board.line(), quick());
  ASSERT_TRUE(connected) << connected.error().message;
  Client& client = *connected;
  Collector<Notice> notices;
  const Subscription told = client.on_notice([&](const Notice& one) { notices.add(one); });
  Collector<msg::RealtimeData4> samples;
  auto slow =
      client.stream<msg::RealtimeData4>(std::chrono::minutes(1), [](const msg::RealtimeData4&) {});
  ASSERT_TRUE(slow) << slow.error().message;
  EXPECT_EQ(requests(), 1U);
  auto stream = client.stream<msg::RealtimeData4>(
      milliseconds(5), [&](const msg::RealtimeData4& one) { samples.add(one); });
  ASSERT_TRUE(stream) << stream.error().message;
  const auto start = std::chrono::steady_clock::now();
  EXPECT_GE(samples.wait_for(20).size(), 20U);
  EXPECT_GE(std::chrono::steady_clock::now() - start, milliseconds(50)) << "not faster than asked";
  const Notice notice = notices.wait_for(1).front();
  EXPECT_EQ(notice.kind, NoticeKind::polling);
  EXPECT_THAT(notice.message, ::testing::HasSubstr("firmware 2.59"));
  // The other one goes on, at its own interval.
  stream->cancel();
  EXPECT_TRUE(client.get_angles());
  const std::size_t last = requests();
  std::this_thread::sleep_for(milliseconds(30));
  EXPECT_EQ(requests(), last);
}

TEST_F(Polls, WaitForTheAnswerBeforeTheNextRequest) {
  std::atomic<bool> is_silent = false;
  board.on_lost([&](const Packet& packet) {
    return is_silent && packet.id == static_cast<std::uint8_t>(msg::RealtimeData4Request::command);
  });
  auto client = connect_over(board.line(), quick());
  ASSERT_TRUE(client) << client.error().message;
  auto stream = client->stream<msg::RealtimeData4>(milliseconds(1), [](const auto&) {},
                                                   {.timeout = milliseconds(200)});
  ASSERT_TRUE(stream) << stream.error().message;
  is_silent = true;
  const auto calls = client->statistics().calls;
  const auto start = std::chrono::steady_clock::now();
  std::this_thread::sleep_for(milliseconds(300));
  const auto begun = client->statistics().calls - calls;
  const auto passed = std::chrono::steady_clock::now() - start;
  EXPECT_LE(begun, passed / milliseconds(200) + 2) << "each takes 200 ms";
  stream->cancel();
  board.on_lost(nullptr);
}

TEST_F(Polls, AMessageWithoutARequestIsRefused) {
  auto client = connect_over(board.line(), quick());
  ASSERT_TRUE(client) << client.error().message;
  const auto stream = client->stream<msg::RealtimeDataCustom>(milliseconds(20), [](const auto&) {});
  ASSERT_FALSE(stream);
  EXPECT_EQ(stream.error().code, ErrorCode::unsupported);
}

TEST_F(Streams, KeepTheirRate) {
  Client client = connect();
  std::atomic<int> fast{};
  std::atomic<int> slow{};
  const Instant earliest = board.now();
  auto first = client.stream<msg::RealtimeData4>(milliseconds(20),
                                                 [&](const msg::RealtimeData4&) { ++fast; });
  ASSERT_TRUE(first) << first.error().message;
  auto second = client.stream<msg::RealtimeData3>(milliseconds(100),
                                                  [&](const msg::RealtimeData3&) { ++slow; });
  ASSERT_TRUE(second) << second.error().message;
  const Instant latest = board.now();
  let_pass(client, std::chrono::seconds(10));
  const Instant end = board.now();
  ASSERT_TRUE(client.get_angles());  // arrives after all samples until then
  const int fast_count = fast;
  const int slow_count = slow;
  const Instant last = board.now();
  // This machine's time counts, too, and the exact start of the streams is unknown.
  const auto least = static_cast<double>((end - latest).us) / 1000;
  const auto most = static_cast<double>((last - earliest).us) / 1000;
  EXPECT_GE(fast_count, least / 20 - 3);
  EXPECT_LE(fast_count, most / 20 + 3);
  EXPECT_GE(slow_count, least / 100 - 3);
  EXPECT_LE(slow_count, most / 100 + 3);
  EXPECT_EQ(board.counters().skipped, 0U);
}

TEST_F(Streams, OfOneMessageHaveTheirOwnRates) {
  Client client = connect();
  std::atomic<int> slow = 0;
  std::atomic<int> fast = 0;
  auto first = client.stream<msg::RealtimeData4>(milliseconds(100), [&](const auto&) { ++slow; });
  ASSERT_TRUE(first) << first.error().message;
  auto second = client.stream<msg::RealtimeData4>(milliseconds(20), [&](const auto&) { ++fast; });
  ASSERT_TRUE(second) << second.error().message;
  auto third = client.stream<msg::RealtimeData4>(milliseconds(500), [](const auto&) {});
  ASSERT_TRUE(third) << third.error().message;
  let_pass(client, std::chrono::seconds(10));
  // This machine's time counts, too.
  EXPECT_GE(fast, 490);
  EXPECT_NEAR(slow, fast / 5, 3);
  second->cancel();
  let_pass(client, milliseconds(200));
  const int last = fast;
  slow = 0;
  const auto samples = [&] { return static_cast<int>(client.statistics().session.parser.frames); };
  const auto before = samples();
  let_pass(client, std::chrono::seconds(10));
  EXPECT_GE(slow, 97);
  EXPECT_LT(samples() - before, slow + 150) << "the board does not send what nobody wants";
  EXPECT_EQ(fast, last);
}

TEST_F(Streams, OfATypeAtRunTimeAreThoseOfTheMessage) {
  Client client = connect();
  const MessageType& type = *find_message("RealtimeData4");
  msg::DataStreamInterval request;
  request.interval_ms = msg::Milliseconds(20);
  std::atomic<int> streamed{0};
  std::atomic<int> heard{0};
  const auto count = [](std::atomic<int>& into) {
    return [&into](const AnyMessage& one) { into += one.get_if<msg::RealtimeData4>() != nullptr; };
  };
  const Subscription listening = client.subscribe(type, count(heard));
  const auto stream = client.stream(type, request, count(streamed));
  ASSERT_TRUE(stream) << stream.error().message;
  let_pass(client, milliseconds(200));
  EXPECT_GE(streamed, 8);
  EXPECT_EQ(streamed, heard);
  const auto refused = client.stream(*find_message("GetAngles"), request, count(streamed));
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().code, ErrorCode::invalid);
}

TEST_F(Streams, EndWhenTheyAreCancelled) {
  Client client = connect();
  std::atomic<int> samples{};
  auto stream = client.stream<msg::RealtimeData4>(milliseconds(20),
                                                  [&](const msg::RealtimeData4&) { ++samples; });
  ASSERT_TRUE(stream) << stream.error().message;
  let_pass(client, milliseconds(200));
  EXPECT_GE(samples, 9);
  stream->cancel();
  EXPECT_TRUE(client.get_angles());
  const auto sent = board.counters().sent;
  const auto requests = board.counters().requests;
  let_pass(client, std::chrono::seconds(2));
  EXPECT_EQ(board.counters().sent - sent, board.counters().requests - requests);
}

TEST_F(Streams, ShowWhatTheCameraDoes) {
  Client client = connect();
  std::vector<double> yaw;  // written on the client's thread, read after all samples
  auto stream = client.stream<msg::RealtimeData4>(
      milliseconds(20),
      [&](const msg::RealtimeData4& sample) { yaw.push_back(sample.angle.yaw.degrees()); });
  ASSERT_TRUE(stream) << stream.error().message;
  msg::Control turn;
  turn.control_mode.set_mode(msg::ControlModeKind::speed);
  turn.axes.yaw.speed = 20_deg_per_s;
  ASSERT_TRUE(client.call(turn));
  ASSERT_TRUE(client.get_angles());  // the command has arrived
  let_pass(client, std::chrono::seconds(2));
  stream->cancel();
  ASSERT_TRUE(client.get_angles());
  ASSERT_GE(yaw.size(), 90U);
  EXPECT_TRUE(std::is_sorted(yaw.begin() + 5, yaw.end()));
  EXPECT_NEAR(yaw.back() - yaw[yaw.size() - 51], 20, 2) << "in the last second";
}

/// An id that no message has.
constexpr std::uint8_t unknown_id = 200;

TEST(RawStreams, HaveTheBytesOfAnyMessage) {
  std::mutex mutex;
  std::vector<msg::DataStreamInterval> requests;  // guarded by the mutex
  ScriptedBoard board;
  introduce(board);
  board.on<msg::DataStreamInterval>([&](const msg::DataStreamInterval& request) {
    bool is_repeated = false;
    {
      const std::lock_guard lock(mutex);
      // A client that a stall has delayed asks again.
      is_repeated = !requests.empty() && requests.back() == request;
      if (!is_repeated) requests.push_back(request);
    }
    board.confirm(request);
    if (is_repeated) return;
    std::array<std::uint8_t, max_frame_size> frame{};
    const std::array<std::uint8_t, 3> body{1, 2, 3};
    for (const std::uint8_t id : {unknown_id, std::uint8_t{201}, unknown_id}) {
      const std::size_t size = write_frame(id, body, frame).size;
      board.send_bytes(std::span(frame).first(size));
    }
  });
  auto client = connect_over(over_memory(board), quick());
  ASSERT_TRUE(client) << client.error().message;
  std::atomic<int> samples{};
  std::atomic<int> others{};
  msg::DataStreamInterval request;
  request.cmd_id = static_cast<msg::CommandFromBoard>(unknown_id);
  request.interval_ms = msg::Milliseconds(20);
  ASSERT_TRUE(request.config.rest.resize(8));
  request.config.rest[0] = 0x45;
  {
    auto stream = client->stream_raw(request, [&](const Frame& frame) {
      const bool is_one = frame.id == unknown_id && frame.body.size() == 3 && frame.body[2] == 3;
      ++(is_one ? samples : others);
    });
    ASSERT_TRUE(stream) << stream.error().message;
    for (int i = 0; i < 500 && samples < 2; ++i) std::this_thread::sleep_for(milliseconds(10));
    EXPECT_EQ(samples, 2);
  }
  for (int i = 0; i < 500; ++i) {
    const std::lock_guard lock(mutex);
    if (requests.size() == 2) break;
    std::this_thread::sleep_for(milliseconds(10));
  }
  EXPECT_EQ(samples, 2) << "the subscription has ended";
  EXPECT_EQ(others, 0);
  const std::lock_guard lock(mutex);
  ASSERT_EQ(requests.size(), 2U);
  EXPECT_EQ(requests[0], request);
  EXPECT_EQ(requests[1].cmd_id, request.cmd_id);
  EXPECT_EQ(requests[1].config, request.config);
  EXPECT_EQ(requests[1].interval_ms.raw(), msg::DataStreamInterval::end_stream);
}

TEST_F(Streams, OfKnownMessagesHaveTheirBytes) {
  Client client = connect();
  std::atomic<int> typed{};
  std::atomic<int> raw{};
  msg::DataStreamInterval request;
  request.cmd_id = msg::CommandFromBoard::realtime_data_3;
  request.interval_ms = msg::Milliseconds(100);
  auto bytes = client.stream_raw(request, [&](const Frame& frame) {
    if (frame.body.size() == msg::RealtimeData3::min_size) ++raw;
  });
  ASSERT_TRUE(bytes) << bytes.error().message;
  auto values = client.stream<msg::RealtimeData3>(milliseconds(100),
                                                  [&](const msg::RealtimeData3&) { ++typed; });
  ASSERT_TRUE(values) << values.error().message;
  let_pass(client, std::chrono::seconds(2));
  EXPECT_GE(typed, 15);
  EXPECT_GE(raw, typed);
}

}  // namespace
}  // namespace sbgc::test
