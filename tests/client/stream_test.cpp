// Tests of data streams from an emulated board, over every kind of line.

#include <sbgc/any.hpp>

#include "testing.hpp"

namespace sbgc::test {
namespace {

class Streams : public ::testing::Test {
 protected:
  Client connect() { return *checked(connect_over(board.line(), quick())); }
  /// Advances the board's time in steps; afterwards `client` has received all samples.
  void let_pass(Client& client, Ms time) {
    // A pseudo-terminal loses data that is not read in time, so the client has to keep up.
    for (Ms passed{}; passed < time; passed += Ms(100)) {
      for (int step = 0; step < 10; ++step) board.skip(Ms(10));
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
  auto connected = checked(connect_over(board.line(), quick()));
  Client& client = *connected;
  Collector<Notice> notices;
  const Subscription told = client.on_notice([&](const Notice& one) { notices.add(one); });
  Collector<msg::RealtimeData4> samples;
  const auto slowest =
      checked(client.stream<msg::RealtimeData4>(std::chrono::minutes(1), [](const auto&) {}));
  EXPECT_EQ(requests(), 1U);
  auto stream = checked(client.stream<msg::RealtimeData4>(
      Ms(5), [&](const msg::RealtimeData4& one) { samples.add(one); }));
  const auto start = std::chrono::steady_clock::now();
  EXPECT_GE(samples.wait_for(20).size(), 20U);
  EXPECT_GE(std::chrono::steady_clock::now() - start, Ms(50)) << "not faster than asked";
  const Notice notice = notices.wait_for(1).front();
  EXPECT_EQ(notice.kind, NoticeKind::polling);
  EXPECT_THAT(notice.message, HasSubstr("firmware 2.59"));
  // The other one goes on, at its own interval.
  stream->cancel();
  EXPECT_TRUE(client.get_angles());
  const std::size_t last = requests();
  std::this_thread::sleep_for(Ms(30));
  EXPECT_EQ(requests(), last);
}

TEST_F(Polls, WaitForTheAnswerBeforeTheNextRequest) {
  std::atomic<bool> is_silent = false;
  board.on_lost([&](const Packet& packet) {
    return is_silent && packet.id == static_cast<std::uint8_t>(msg::RealtimeData4Request::command);
  });
  auto client = checked(connect_over(board.line(), quick()));
  auto stream =
      checked(client->stream<msg::RealtimeData4>(Ms(1), [](const auto&) {}, {.timeout = Ms(200)}));
  is_silent = true;
  const auto calls = client->statistics().calls;
  const auto start = std::chrono::steady_clock::now();
  std::this_thread::sleep_for(Ms(300));
  const auto begun = client->statistics().calls - calls;
  const auto passed = std::chrono::steady_clock::now() - start;
  EXPECT_LE(begun, passed / Ms(200) + 2) << "each takes 200 ms";
  stream->cancel();
  board.on_lost(nullptr);
}

TEST_F(Polls, AMessageWithoutARequestIsRefused) {
  auto client = checked(connect_over(board.line(), quick()));
  EXPECT_THAT(client->stream<msg::RealtimeDataCustom>(Ms(20), [](const auto&) {}),
              fails(ErrorCode::unsupported));
}

TEST_F(Streams, KeepTheirRate) {
  Client client = connect();
  std::atomic<int> fast{};
  std::atomic<int> slow{};
  const Instant earliest = board.now();
  const auto first = checked(
      client.stream<msg::RealtimeData4>(Ms(20), [&](const msg::RealtimeData4&) { ++fast; }));
  const auto second = checked(
      client.stream<msg::RealtimeData3>(Ms(100), [&](const msg::RealtimeData3&) { ++slow; }));
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
  const auto first =
      checked(client.stream<msg::RealtimeData4>(Ms(100), [&](const auto&) { ++slow; }));
  auto second = checked(client.stream<msg::RealtimeData4>(Ms(20), [&](const auto&) { ++fast; }));
  const auto third = checked(client.stream<msg::RealtimeData4>(Ms(500), [](const auto&) {}));
  let_pass(client, std::chrono::seconds(10));
  // This machine's time counts, too.
  EXPECT_GE(fast, 490);
  EXPECT_NEAR(slow, fast / 5, 3);
  second->cancel();
  let_pass(client, Ms(200));
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
  msg::DataStreamInterval request{.interval_ms = msg::Milliseconds(20)};
  std::atomic<int> streamed{0};
  std::atomic<int> heard{0};
  const auto count = [](std::atomic<int>& into) {
    return [&into](const AnyMessage& one) { into += one.get_if<msg::RealtimeData4>() != nullptr; };
  };
  const Subscription listening = client.subscribe(type, count(heard));
  const auto stream = checked(client.stream(type, request, count(streamed)));
  let_pass(client, Ms(200));
  EXPECT_GE(streamed, 8);
  EXPECT_EQ(streamed, heard);
  EXPECT_THAT(client.stream(*find_message("GetAngles"), request, count(streamed)),
              fails(ErrorCode::invalid));
}

TEST_F(Streams, EndWhenTheyAreCancelled) {
  Client client = connect();
  std::atomic<int> samples{};
  auto stream = checked(
      client.stream<msg::RealtimeData4>(Ms(20), [&](const msg::RealtimeData4&) { ++samples; }));
  let_pass(client, Ms(200));
  EXPECT_GE(samples, 9);
  stream->cancel();
  EXPECT_TRUE(client.get_angles());
  const auto sent = board.counters().sent;
  const auto requests = board.counters().requests;
  let_pass(client, std::chrono::seconds(2));
  EXPECT_EQ(board.counters().sent - sent, board.counters().requests - requests);
}

using RawStreams = ScriptedTest;

TEST_F(RawStreams, HaveTheBytesOfAnyMessage) {
  constexpr std::uint8_t unknown_id = 200;  // that no message has
  board.on<msg::DataStreamInterval>([&](const msg::DataStreamInterval& request) {
    // A client that a stall has delayed asks again.
    const auto before = registrations.wait_for(0);
    board.confirm(request);
    if (!before.empty() && before.back() == request) return;
    registrations.add(request);
    for (const std::uint8_t id : {unknown_id, std::uint8_t{201}, unknown_id}) {
      board.send_bytes(to_frame({id, {1, 2, 3}}));
    }
  });
  Client client = connect();
  Collector<Packet> samples;
  msg::DataStreamInterval request{
      .cmd_id = static_cast<msg::CommandFromBoard>(unknown_id),
      .interval_ms = msg::Milliseconds(100)};  // for 258 bytes at 115200 Bd
  ASSERT_TRUE(request.config.rest.resize(8));
  request.config.rest[0] = 0x45;
  {
    const auto stream = checked(client.stream_raw(request, [&](const Frame& frame) {
      samples.add({frame.id, {frame.body.begin(), frame.body.end()}});
    }));
    EXPECT_THAT(samples.wait_for(2), SizeIs(2));
  }
  const auto requests = registrations.wait_for(2);
  settle(client);
  EXPECT_THAT(samples.wait_for(0), AllOf(SizeIs(2), Each(Packet{unknown_id, {1, 2, 3}})))
      << "the subscription has ended";
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
  msg::DataStreamInterval request{.cmd_id = msg::CommandFromBoard::realtime_data_3,
                                  .interval_ms = msg::Milliseconds(100)};
  const auto bytes = checked(client.stream_raw(request, [&](const Frame& frame) {
    if (frame.body.size() == msg::RealtimeData3::min_size) ++raw;
  }));
  const auto values = checked(
      client.stream<msg::RealtimeData3>(Ms(100), [&](const msg::RealtimeData3&) { ++typed; }));
  let_pass(client, std::chrono::seconds(2));
  EXPECT_GE(typed, 15);
  EXPECT_GE(raw, typed);
}

}  // namespace
}  // namespace sbgc::test
