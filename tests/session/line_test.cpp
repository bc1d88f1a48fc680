// Tests of the timing on the line: pauses between commands, and the share of data streams.

#include "simulation.hpp"

namespace sbgc::test {
namespace {

using Pacing = LineTest;
using Timeouts = LineTest;
using StreamBudget = LineTest;

/// Returns the time between the frames of `first` and of another request.
template <class M>
Duration gap_behind(const M& first, const SessionOptions& options = {}) {
  Simulation line(options);
  line.send(first);
  line.send(msg::BeepSound{});
  line.run();
  EXPECT_GE(line.written.size(), 2U);
  return line.written[1].at - line.written[0].at;
}

TEST(WireTime, OfAByteAndOfAFrame) {
  EXPECT_EQ(wire_time({9600, Parity::none}, 96), milliseconds(100));
  EXPECT_EQ(wire_time({9600, Parity::even}, 96), milliseconds(110));
  EXPECT_EQ(wire_time({115200, Parity::none}, 1).us, 87);  // 86.8, rounded up
  EXPECT_EQ(wire_time({0, Parity::none}, 1000), Duration{});
  EXPECT_EQ(bytes_per_second({115200, Parity::none}), 11520U);
  EXPECT_EQ(bytes_per_second({115200, Parity::even}), 10472U);
}

TEST(PacingRules, LiesBetweenTenAndTwentyMilliseconds) {
  const Duration small = gap_behind(msg::Control{});
  const Duration large = gap_behind(msg::ReadParams3Request{});
  EXPECT_EQ(small, milliseconds(10));
  EXPECT_GT(large, small + milliseconds(2)) << "the response has a body of 134 bytes";
  EXPECT_LE(large, milliseconds(20));
}

TEST(PacingRules, GivesTheRequestAndTheAnswerTheirTimeOnTheLine) {
  SessionOptions options;
  options.line = {9600, Parity::even};
  // 6 bytes of request, 139 bytes of response, 11 bits each.
  EXPECT_EQ(gap_behind(msg::ReadParams3Request{}, options),
            wire_time(options.line, 6) + wire_time(options.line, 139));
}

TEST(PacingRules, CanBeOffAndOther) {
  SessionOptions options;
  options.pacing = {};
  options.pacing.shortest = options.pacing.longest = Duration{};
  EXPECT_EQ(gap_behind(msg::Control{}, options), Duration{});
  for (const Duration pause : {milliseconds(40), microseconds(1)}) {
    options.pacing = {pause, pause};
    EXPECT_EQ(gap_behind(msg::Control{}, options), pause);
  }
  options.pacing = {milliseconds(-1), milliseconds(-1)};
  EXPECT_EQ(gap_behind(msg::Control{}, options), Duration{}) << "as if 0";
}

TEST_F(Pacing, EndsWithTheResponse) {
  line.board = [&](const Written& frame) { line.say(frame.id, body_of(18), milliseconds(2)); };
  for (int i = 0; i < 3; ++i) line.send(msg::GetAnglesRequest{});
  line.run();
  ASSERT_THAT(line.written, SizeIs(3));
  EXPECT_EQ(gap(1), milliseconds(2));
  EXPECT_EQ(gap(2), milliseconds(2));
}

TEST_F(Pacing, EndsWithAConfirmationOrAnError) {
  line.board = [&](const Written& frame) { line.confirm(frame.id, milliseconds(1)); };
  line.send(msg::MotorsOn{}, {.expect_confirmation = true});
  line.send(msg::BeepSound{});
  line.run();
  ASSERT_THAT(line.written, SizeIs(2));
  EXPECT_EQ(gap(1), milliseconds(1));

  Simulation refused;
  refused.board = [&](const Written& frame) {
    refused.say(255, {1, frame.id, 0, 0, 0}, milliseconds(1));
  };
  refused.send(msg::GetAnglesRequest{});
  refused.send(msg::BeepSound{});
  refused.run();
  ASSERT_THAT(refused.written, SizeIs(2));
  EXPECT_EQ(refused.written[1].at - refused.written[0].at, milliseconds(1));
}

TEST_F(Pacing, IsKeptAfterAResponseToAnEarlierFrame) {
  line.board = [&](const Written& frame) {
    if (frame.id == 73) line.say(frame.id, body_of(18), milliseconds(11));
  };
  line.send(msg::GetAnglesRequest{});
  line.send(msg::BeepSound{});
  line.send(msg::BeepSound{});
  line.run();
  ASSERT_THAT(ids(line.written), ElementsAre(73, 89, 89));
  // The response arrives between the second frame and the third.
  EXPECT_LT(gap(1), milliseconds(11));
  EXPECT_GE(gap(2), milliseconds(10));
}

TEST_F(Pacing, IsKeptAfterAResponseToAResentFrame) {
  int left = 1;
  line.board = [&](const Written& frame) {
    if (frame.id != 73 || left-- > 0) return;
    line.say(frame.id, body_of(18), milliseconds(1));  // to which of the two?
  };
  line.send(msg::GetAnglesRequest{});
  line.on_event = [&](const Record& record) {
    if (record.event.kind == EventKind::completed && record.event.command == 73) {
      line.send(msg::BeepSound{});
    }
  };
  line.run();
  ASSERT_THAT(ids(line.written), ElementsAre(73, 73, 89));
  EXPECT_GE(gap(2), milliseconds(10));
}

TEST(PacingRules, CanLastLongerThanTheResponse) {
  Simulation line({.pacing = {.until_response = false}});
  line.board = [&](const Written& frame) { line.say(frame.id, body_of(18), milliseconds(2)); };
  line.send(msg::GetAnglesRequest{});
  line.send(msg::GetAnglesRequest{});
  line.run();
  ASSERT_THAT(line.written, SizeIs(2));
  EXPECT_GE(line.written[1].at - line.written[0].at, milliseconds(10));
}

TEST(PacingRules, EndsBeforeTheWriteIsReported) {
  Session session;
  std::array<std::uint8_t, max_frame_size> answer{};
  const std::size_t size = write_frame(73, body_of(18), answer).size;
  const auto ignore = [](const Event&) {};
  ASSERT_TRUE(session.send(msg::GetAnglesRequest{}));
  Instant now = start_time;
  ASSERT_FALSE(session.poll(now, ignore).bytes.empty());
  now = now + milliseconds(2);
  session.feed(std::span(answer).first(size), now, ignore);
  session.written(now);
  ASSERT_TRUE(session.send(msg::GetAnglesRequest{}));
  EXPECT_FALSE(session.poll(now, ignore).bytes.empty());
}

/// Returns the time after which a request ends if no response comes.
template <class M>
Duration until_timeout(const M& request, Simulation& line) {
  const Handle handle = line.send(request, {.attempts = 1});
  const Instant sent = line.now;
  line.run();
  EXPECT_EQ(line.outcome(handle), Outcome::timeout);
  return line.completion(handle)->at - sent;
}

TEST(Timeout, CountsFromTheEndOfWhatIsOnTheLine) {
  for (const std::uint32_t rate : {9600U, 300U}) {
    SessionOptions options;
    options.line = {rate, Parity::none};
    const auto on_line = [&](std::size_t size) { return wire_time(options.line, size); };
    Simulation line(options);
    EXPECT_EQ(until_timeout(msg::ReadParams3Request{}, line),
              on_line(6) + on_line(139) + milliseconds(500));
    EXPECT_EQ(until_timeout(msg::MotorsOn{}, line),
              on_line(5) + on_line(frame_size(roles::confirmation_size)) + milliseconds(500));
  }
}

TEST(Timeout, AResponseWithoutBodyTakesOnlyItsFrame) {
  SessionOptions options;
  options.line = {9600, Parity::none};
  Simulation line(options);
  msg::ResetRequestExt request{.confirm = msg::ResetOption::notify};
  EXPECT_EQ(until_timeout(request, line), wire_time(options.line, frame_size(3)) +
                                              wire_time(options.line, frame_size(0)) +
                                              milliseconds(500));
}

TEST_F(Timeouts, FollowsTheLine) {
  EXPECT_EQ(until_timeout(msg::MotorsOn{}, line), milliseconds(500));
  const LineSettings slow{9600, Parity::none};
  line.session.set_line(slow);
  EXPECT_EQ(line.session.stream_usage().limit, 768U);  // 80 % of 960
  EXPECT_EQ(until_timeout(msg::ReadParams3Request{}, line),
            wire_time(slow, 6) + wire_time(slow, 139) + milliseconds(500));
}

// Data streams

using Of = msg::CommandFromBoard;

msg::DataStreamInterval custom_stream(msg::RealtimeDataCustomFlags flags, std::uint16_t interval) {
  msg::DataStreamInterval request = stream_of(Of::realtime_data_custom, interval);
  request.config.flags = flags;
  return request;
}

SessionOptions at(std::uint32_t baud_rate) { return {.line = {baud_rate, Parity::none}}; }

TEST(Streams, TakeTheirShareOfTheLineOnceTheyAreConfirmed) {
  Simulation line(at(115200));
  line.board = [&](const Written& frame) { line.confirm(frame.id); };
  EXPECT_EQ(line.session.stream_usage().limit, 9216U);  // 80 % of 11520
  line.send(stream_of(Of::realtime_data_4, 20));
  EXPECT_EQ(line.session.stream_usage().used, 6450U) << "129 bytes, 50 times a second";
  line.run();
  EXPECT_EQ(line.session.stream_usage().used, 6450U);
  line.send(stream_of(Of::realtime_data_4, 100));
  EXPECT_EQ(line.session.stream_usage().used, 6450U) << "until it is confirmed";
  line.run();
  EXPECT_EQ(line.session.stream_usage().used, 1290U);
  line.send(stream_of(Of::realtime_data_4, 0));
  line.run();
  EXPECT_EQ(line.session.stream_usage().used, 0U);
}

TEST(Streams, OfASampleInEachCycle) {
  Simulation line(at(0));
  line.send(stream_of(Of::realtime_data_3, 1));
  EXPECT_EQ(line.session.stream_usage().used, 85000U) << "68 bytes every 0.8 ms";
  EXPECT_EQ(line.session.stream_usage().limit, 0U);
}

TEST(Streams, HaveTheSizeThatTheirConfigurationGivesThem) {
  Simulation line(at(115200));
  const auto flags = msg::RealtimeDataCustomFlags{msg::RealtimeDataCustomFlag::imu_angles} |
                     msg::RealtimeDataCustomFlag::rc_channels;
  line.send(custom_stream(flags, 100));
  EXPECT_EQ(line.session.stream_usage().used, 490U) << "5 + 2 + 6 + 36 bytes, 10 times a second";
}

TEST(Streams, BeyondTheBudgetAreRefused) {
  Simulation line(at(9600));  // 960 bytes/s, 768 for streams
  line.board = [&](const Written& frame) { line.confirm(frame.id); };
  EXPECT_TRUE(line.session.send(stream_of(Of::realtime_data_3, 100)));  // 680
  EXPECT_EQ(line.session.send(stream_of(Of::ahrs_helper, 100)).status, SendStatus::not_encodable)
      << "the IMU is missing";
  EXPECT_EQ(line.session.send(stream_of(Of::realtime_data_4, 1000)).status,
            SendStatus::over_budget);  // 129 more
  EXPECT_TRUE(line.session.send(stream_of(Of::realtime_data_4, 2000)));
  EXPECT_EQ(line.session.stream_usage().used, 745U);
  line.run();
  EXPECT_TRUE(line.session.send(stream_of(Of::realtime_data_4, 100), {.ignore_budget = true}));
  line.run();
  EXPECT_GT(line.session.stream_usage().used, line.session.stream_usage().limit);
  EXPECT_TRUE(line.session.send(stream_of(Of::realtime_data_4, 200)))
      << "less than before always fits";
  EXPECT_EQ(line.session.statistics().refused, 2U);
}

TEST(Streams, ThatTheBoardDoesNotStartTakeNothing) {
  for (const bool refuses : {true, false}) {
    Simulation line(at(115200));
    line.board = [&](const Written& frame) {
      if (refuses) line.say(255, {frame.id, 1, 0, 0, 0, 0});
    };
    EXPECT_EQ(line.ask(stream_of(Of::realtime_data_3, 100)),
              refuses ? Outcome::board_error : Outcome::timeout);
    EXPECT_EQ(line.session.stream_usage().used, 0U);
  }
}

TEST_F(StreamBudget, AreLimitedInNumber) {
  confirm_all();
  for (std::uint32_t i = 0; i < 10; ++i) {
    EXPECT_TRUE(line.session.send(custom_stream(msg::RealtimeDataCustomFlags(i), 100))) << i;
    line.run();
  }
  EXPECT_EQ(line.session.send(custom_stream(msg::RealtimeDataCustomFlags(10), 100)).status,
            SendStatus::too_many_streams);
  EXPECT_TRUE(line.session.send(custom_stream(msg::RealtimeDataCustomFlags(3), 0)));
  line.run();
  EXPECT_TRUE(line.session.send(custom_stream(msg::RealtimeDataCustomFlags(10), 100)));
}

TEST(Streams, AreForgottenWhenTheBoardRestarts) {
  Simulation line(at(115200));
  line.board = [&](const Written& frame) { line.confirm(frame.id); };
  line.send(stream_of(Of::realtime_data_3, 100));
  line.run();
  line.say(114, {});
  line.run();
  EXPECT_EQ(line.session.stream_usage().used, 0U);
  line.send(stream_of(Of::realtime_data_3, 100));
  line.run();
  EXPECT_NE(line.session.stream_usage().used, 0U);
  line.send(msg::ResetRequest{});  // without notice
  line.run();
  EXPECT_EQ(line.session.stream_usage().used, 0U);
}

TEST_F(StreamBudget, SamplesAreTold) {
  confirm_all();
  line.send(stream_of(Of::realtime_data_3, 100));
  line.run();
  line.say(23, body_of(63));
  line.say(25, body_of(124));
  line.run();
  ASSERT_THAT(line.of(EventKind::stream), SizeIs(1));
  EXPECT_EQ(line.of(EventKind::stream)[0].event.command, 23);
  EXPECT_THAT(line.of(EventKind::unsolicited), SizeIs(1));
}

/// A running stream of live data: one angle, and the same number of bytes of another kind on
/// request.
class Sampled : public ::testing::Test {
 protected:
  using Flag = msg::RealtimeDataCustomFlag;
  static constexpr std::uint8_t custom = 88;

  /// Starts the stream, of which `count` samples arrive.
  void start(std::uint16_t interval, int count, std::size_t size = 8) {
    line.board = [&](const Written& frame) { line.confirm(frame.id); };
    line.send(custom_stream(msg::RealtimeDataCustomFlags{Flag::imu_angles}, interval));
    line.run_for(milliseconds(3));
    line.board = [](const Written&) {};
    line.written.clear();
    for (int i = 1; i <= count; ++i) {
      line.say(custom, body_of(size, {i}), milliseconds(i * interval));
    }
  }
  Handle ask(Flag what, std::uint16_t host = 0) {
    msg::RealtimeDataCustomRequest request;
    request.flags.set(what);
    return line.send(request, {.host = host, .attempts = 1});
  }
  /// Returns the samples that the board's frames were.
  std::vector<Sample> samples() const {
    std::vector<Sample> result;
    for (const Record& record : line.events) {
      if (record.event.frame.id == custom) result.push_back(record.event.sample);
    }
    return result;
  }

  Simulation line{at(115200)};
};

TEST_F(Sampled, ASampleThatIsDueAnswersAllWhoAskForIt) {
  start(100, 2);
  const Handle first = ask(Flag::imu_angles, 1);
  const Handle second = ask(Flag::imu_angles, 2);
  line.run_for(milliseconds(250));
  EXPECT_THAT(line.written, SizeIs(0));
  for (const Handle handle : {first, second}) {
    ASSERT_EQ(line.outcome(handle), Outcome::answered);
    EXPECT_EQ(line.completion(handle)->body, body_of(8, {1}));
  }
  EXPECT_THAT(samples(), ElementsAre(Sample::yes, Sample::no, Sample::yes));
}

TEST_F(Sampled, AStreamThatIsSlowOrSilentAnswersNothing) {
  for (const std::uint16_t interval : {std::uint16_t{2000}, std::uint16_t{50}}) {
    line.session.abandon(line.sink());
    start(interval, interval == 2000 ? 2 : 0);
    line.board = [&](const Written&) { line.say(custom, body_of(8, {9})); };
    const Handle handle = ask(Flag::imu_angles);
    line.run_for(seconds(3));
    EXPECT_THAT(line.written, SizeIs(1));
    ASSERT_EQ(line.outcome(handle), Outcome::answered);
    EXPECT_EQ(line.completion(handle)->body, body_of(8, {9}));
    line.run();
  }
}

TEST_F(Sampled, OtherContentIsAskedForAfterASample) {
  start(20, 10);
  line.board = [&](const Written&) { line.say(custom, body_of(8, {99}), milliseconds(5)); };
  line.run_for(milliseconds(50));
  const Handle handle = ask(Flag::acc_data);
  line.run_for(milliseconds(60));
  ASSERT_THAT(line.written, SizeIs(1));
  EXPECT_EQ((line.written[0].at - start_time).us % 20'000, 3000) << "right after a sample";
  ASSERT_EQ(line.outcome(handle), Outcome::answered);
  EXPECT_EQ(line.completion(handle)->body, body_of(8, {99}));
  EXPECT_EQ(line.completion(handle)->event.sample, Sample::no);
  line.run();
  EXPECT_EQ(std::ranges::count(samples(), Sample::yes), 10);
}

TEST_F(Sampled, AFrameThatCanBeBothIsForNobodyUntilThereIsOneTooMany) {
  for (const int delay : {17, 50, 390}) {
    line.session.abandon(line.sink());
    line.events.clear();
    start(20, 60);
    line.run_for(milliseconds(30));
    line.board = [&](const Written&) { line.say(custom, body_of(8, {99}), milliseconds(delay)); };
    const Handle handle = ask(Flag::acc_data);
    line.run();
    EXPECT_EQ(line.outcome(handle), Outcome::timeout);
    for (const Record& record : line.events) {
      const bool is_answer = record.body == body_of(8, {99});
      EXPECT_FALSE(is_answer && record.event.sample == Sample::yes) << delay;
    }
    // All samples in doubt, the answer, and at most one more.
    EXPECT_LE(std::ranges::count(samples(), Sample::doubtful), delay / 20 + 2) << delay;
  }
}

TEST_F(Sampled, AnAnswerThatNeverComesCostsNoMoreThanItsTime) {
  start(20, 200);
  line.run_for(milliseconds(30));
  ask(Flag::acc_data);
  line.run();
  EXPECT_LE(std::ranges::count(samples(), Sample::doubtful), 51) << "for 500 ms, and late 500 ms";
  EXPECT_GE(std::ranges::count(samples(), Sample::yes), 148);
}

TEST_F(Sampled, ARefusalEndsTheDoubt) {
  start(20, 10);
  line.board = [&](const Written& frame) { line.say(255, {frame.id, 1, 0, 0, 0, 0}); };
  line.run_for(milliseconds(30));
  const Handle handle = ask(Flag::acc_data);
  line.run();
  EXPECT_EQ(line.outcome(handle), Outcome::board_error);
  EXPECT_EQ(std::ranges::count(samples(), Sample::yes), 10);
}

TEST_F(Sampled, WithoutTimeBetweenSamplesOtherContentIsRefusedAtOnce) {
  start(15, 10);
  const Handle handle = ask(Flag::acc_data);
  line.run_for({});
  EXPECT_EQ(line.outcome(handle), Outcome::indistinct);
  EXPECT_THAT(line.written, SizeIs(0));
}

TEST_F(Sampled, TheFirstSampleSaysItsSize) {
  start(20, 10, 10);  // of other firmware
  line.board = [&](const Written&) { line.say(custom, body_of(8, {99}), milliseconds(30)); };
  line.run_for(milliseconds(30));
  const Handle handle = ask(Flag::acc_data);
  line.run();
  ASSERT_EQ(line.outcome(handle), Outcome::answered);
  EXPECT_EQ(line.completion(handle)->body, body_of(8, {99}));
  EXPECT_EQ(std::ranges::count(samples(), Sample::yes), 10);
}

TEST_F(StreamBudget, ASampleOfAnotherSizeIsNoAnswer) {
  confirm_all();
  line.send(
      custom_stream(msg::RealtimeDataCustomFlags{msg::RealtimeDataCustomFlag::rc_channels}, 100));
  line.run();
  line.board = [&](const Written&) {
    line.say(88, body_of(38), milliseconds(1));  // a sample
    line.say(88, body_of(8), milliseconds(2));
  };
  msg::RealtimeDataCustomRequest request;
  request.flags.set(msg::RealtimeDataCustomFlag::imu_angles);
  const Handle handle = line.send(request);
  line.run();
  ASSERT_EQ(line.outcome(handle), Outcome::answered);
  EXPECT_THAT(line.completion(handle)->body, SizeIs(8));
}

}  // namespace
}  // namespace sbgc::test
