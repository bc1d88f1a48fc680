// Tests of requests that the board answers with a series of messages and a last one.

#include "simulation.hpp"

namespace sbgc::test {
namespace {

using Series = LineTest;

constexpr std::uint8_t test = 37;  // the start and the end of a recording
constexpr std::uint8_t data = 38;

/// Says a number of messages of a series, the first after `first`, 1 s apart.
template <class Line>
void say_data(Line& line, int count, Duration first) {
  for (int i = 0; i < count; ++i) line.say(data, body_of(17, {i}), first + seconds(1) * i);
}

template <class Line>
std::size_t in_series(const Line& line, Handle handle) {
  std::size_t count = 0;
  for (const Record& record : line.events) {
    if (record.event.kind != EventKind::series) continue;
    EXPECT_EQ(record.event.handle, handle);
    EXPECT_EQ(record.event.frame.id, data);
    ++count;
  }
  return count;
}

TEST(SeriesRules, EndsWithTheResponseHoweverLongItTakes) {
  for (const int confirmed_after : {3, 1500, 0}) {  // before the data, after the first, never
    Simulation line;
    line.board = [&](const Written&) {
      if (confirmed_after != 0) line.confirm(test, milliseconds(confirmed_after));
      say_data(line, 9, milliseconds(1000));
      line.say(test, body_of(22), milliseconds(10500));
    };
    const Handle handle = line.send(msg::BodeTestStartStopRequest{});
    line.run();
    EXPECT_EQ(line.outcome(handle), Outcome::answered);
    EXPECT_EQ(in_series(line, handle), 9U);
    EXPECT_EQ(line.completion(handle)->body.size(), 22U);
    EXPECT_EQ(line.session.statistics().unsolicited, 0U);
    EXPECT_EQ(line.written.size(), 1U);
  }
}

TEST(SeriesRules, IsOverAfterSilence) {
  for (const bool is_confirmed : {false, true}) {
    Simulation line;
    line.board = [&](const Written&) {
      if (is_confirmed) line.confirm(test, milliseconds(1900));
      say_data(line, 3, milliseconds(is_confirmed ? 3500 : 1500));
      line.say(test, body_of(22), milliseconds(9000));  // too late
    };
    const Handle handle = line.send(msg::BodeTestStartStopRequest{});
    line.run();
    EXPECT_EQ(line.outcome(handle), Outcome::timeout);
    EXPECT_EQ(in_series(line, handle), 3U);
    const Duration after = line.completion(handle)->at - start_time;
    EXPECT_EQ(after, milliseconds(is_confirmed ? 7500 : 5500)) << after.us;
    EXPECT_EQ(line.written.size(), 1U) << "never repeated";
  }
}

TEST_F(Series, WithoutEndIsLimited) {
  line.board = [&](const Written&) { say_data(line, 3800, milliseconds(500)); };
  const Handle handle = line.send(msg::BodeTestStartStopRequest{});
  line.run();
  EXPECT_EQ(line.outcome(handle), Outcome::timeout);
  const Duration after = line.completion(handle)->at - start_time;
  EXPECT_GE(after, seconds(3600));
  EXPECT_LT(after, seconds(3601));
}

TEST_F(Series, MayBeRefused) {
  line.board = [&](const Written&) { line.say(error, body_of(6, {test, 3})); };
  EXPECT_EQ(line.ask(msg::BodeTestStartStopRequest{}), Outcome::board_error);
}

TEST_F(Series, OfNoRequestIsUnsolicited) {
  line.board = [&](const Written&) {
    line.say(data, body_of(17));
    line.say(realtime_data_4, body_of(124), milliseconds(5));
  };
  line.send(msg::RealtimeData4Request{});
  line.run();
  EXPECT_EQ(line.session.statistics().unsolicited, 1U);
  EXPECT_EQ(line.events.front().event.kind, EventKind::unsolicited);
  EXPECT_FALSE(line.events.front().event.handle);
}

TEST_F(Series, OtherRequestsAreAnsweredMeanwhile) {
  line.board = [&](const Written& frame) {
    if (frame.id != test) return line.say(realtime_data_4, body_of(124));
    say_data(line, 4, milliseconds(1000));
    line.say(test, body_of(22), milliseconds(4500));
  };
  const Handle recording = line.send(msg::BodeTestStartStopRequest{});
  line.run_for(milliseconds(2500));
  const Handle other = line.send(msg::RealtimeData4Request{});
  line.run_for(milliseconds(100));
  EXPECT_EQ(line.outcome(other), Outcome::answered);
  line.run();
  EXPECT_EQ(line.outcome(recording), Outcome::answered);
}

TEST(SeriesRules, ASessionForOneRequestDoesNotKnowThem) {
  using Small = BasicSession<SessionCapacity{.requests = 1, .optimize = Optimize::size}>;
  Basic<Small> line;
  line.board = [&](const Written&) {
    say_data(line, 5, milliseconds(1000));
    line.say(test, body_of(22), milliseconds(6500));
  };
  const Handle handle = line.send(msg::BodeTestStartStopRequest{});
  line.run();
  EXPECT_EQ(line.outcome(handle), Outcome::timeout);
  EXPECT_EQ(in_series(line, handle), 0U);
}

}  // namespace
}  // namespace sbgc::test
