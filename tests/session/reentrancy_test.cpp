// Tests of sinks that call the session from within an event: nothing is lost.

#include <tuple>

#include "simulation.hpp"

namespace sbgc::test {
namespace {

using Reentrancy = LineTest;

constexpr std::uint8_t realtime_data_3 = 23;

/// Load of a stream of CMD_REALTIME_DATA_4 in bytes per second: frames of 129 bytes at 10 Hz.
constexpr std::uint32_t load_of_4 = 1290;

// Stream requests while an earlier request for the same stream is open

/// Sends a request for the stream, which gets no response, and queues another one.
void ask_in_vain(Simulation& line) {
  line.send(stream_of(realtime_data_4, 100));
  line.run_for(milliseconds(1));
  ASSERT_EQ(line.written.size(), 1U);
  line.send(stream_of(realtime_data_4, 200));
}

void expect_stream_runs(Simulation& line, Handle asked) {
  EXPECT_EQ(line.outcome(asked), Outcome::confirmed);
  EXPECT_EQ(line.session.stream_usage().used, load_of_4);
  line.say(realtime_data_4, body_of(124));
  line.run();
  EXPECT_EQ(line.of(EventKind::stream).size(), 1U);
  EXPECT_EQ(line.of(EventKind::unsolicited).size(), 0U);
}

TEST(ReentrancyRules, AStreamAskedForWhenTheBoardRestartsRuns) {
  for (const bool in_event : {true, false}) {  // or when a request ends with the reset
    Simulation line;
    ask_in_vain(line);
    Handle again;
    line.on_event = [&](const Record& record) {
      if (in_event ? record.event.kind != EventKind::reset
                   : record.event.outcome != Outcome::reset || again) {
        return;
      }
      EXPECT_TRUE(!in_event || line.session.stream_usage().used == 0);
      again = line.send(stream_of(realtime_data_4, 100));
      line.board = [&](const Written& frame) { line.confirm(frame.id); };
    };
    line.say(reset, {});
    line.run();
    expect_stream_runs(line, again);
  }
}

TEST_F(Reentrancy, AStreamAskedForWhenTheBoardAnswersAResetRuns) {
  Handle again;
  line.on_event = [&](const Record& record) {
    if (record.event.outcome != Outcome::answered) return;
    again = line.send(stream_of(realtime_data_4, 100));
  };
  line.board = [&](const Written& frame) {
    if (frame.id == reset) return line.say(reset, {});
    line.confirm(frame.id);
  };
  msg::ResetRequestExt request;
  request.confirm.set(msg::ResetOption::notify);
  line.send(request);
  line.run();
  expect_stream_runs(line, again);
}

TEST_F(Reentrancy, AStreamAskedForWhenTheLinkIsLostRunsOnTheNextOne) {
  ask_in_vain(line);
  Handle again;
  line.on_event = [&](const Record& record) {
    if (record.event.outcome != Outcome::link_lost || again) return;
    EXPECT_EQ(line.session.stream_usage().used, 0U);
    again = line.send(stream_of(realtime_data_4, 100));
  };
  line.session.abandon(line.sink());
  EXPECT_EQ(line.session.open_requests(), 1U);
  EXPECT_EQ(line.session.stream_usage().used, load_of_4) << "it is being requested";
  confirm_all();
  line.run();
  expect_stream_runs(line, again);
}

TEST_F(Reentrancy, AStreamAfterARequestThatRestartsTheBoardRuns) {
  line.board = [&](const Written& frame) {
    if (frame.id == stream_interval) line.confirm(frame.id);
  };
  line.send(stream_of(realtime_data_3, 100));
  line.run();
  line.send(msg::ResetRequest{});  // without notice: it ends as soon as it is written
  const Handle behind = line.send(stream_of(realtime_data_4, 100));
  line.run();
  expect_stream_runs(line, behind);
}

// Each call from each event

/// An event and the actions that cause it.
struct Occasion {
  std::string name;
  EventKind kind;
  Outcome outcome;
  std::function<void(Simulation&)> bring_about;
};

/// Enough time for a request to be sent after another one.
constexpr Duration to_be_sent = milliseconds(20);

void say_reset(Simulation& line) { line.say(reset, {}); }

const std::vector<Occasion>& occasions() {
  const auto send_and_say = [](std::uint8_t id, const Body& body) {
    return [=](Simulation& line) {
      line.send(msg::MotorsOn{});
      line.run_for(to_be_sent);
      line.say(id, body);
    };
  };
  static const std::vector<Occasion> all = {
      {"answered", EventKind::completed, Outcome::answered,
       [](Simulation& line) {
         line.send(msg::BoardInfoRequest{});
         line.run_for(to_be_sent);
         line.say(board_info, body_of(18));
       }},
      {"confirmed", EventKind::completed, Outcome::confirmed, send_and_say(confirm, {motors_on})},
      {"sent", EventKind::completed, Outcome::sent,
       [](Simulation& line) { line.send(msg::Control{}); }},
      {"unconfirmed", EventKind::completed, Outcome::unconfirmed,
       [](Simulation& line) { line.send(msg::Control{}, {.expect_confirmation = true}); }},
      {"failed", EventKind::completed, Outcome::failed,
       [](Simulation& line) {
         line.send(msg::FsClearAll{});
         line.run_for(to_be_sent);
         line.say(confirm, {static_cast<std::uint8_t>(msg::CommandToBoard::fs_clear_all), 1});
       }},
      {"board_error_of_a_request", EventKind::completed, Outcome::board_error,
       send_and_say(error, {motors_on, 1, 0, 0, 0, 0})},
      {"timeout", EventKind::completed, Outcome::timeout,
       [](Simulation& line) { line.send(msg::BoardInfoRequest{}, {.attempts = 1}); }},
      {"reset_of_a_request", EventKind::completed, Outcome::reset, send_and_say(reset, {})},
      {"cancelled", EventKind::completed, Outcome::cancelled,
       [](Simulation& line) {
         const Handle handle = line.send(msg::BoardInfoRequest{});
         line.run_for(to_be_sent);
         EXPECT_TRUE(line.session.cancel(handle, line.sink()));
       }},
      {"link_lost", EventKind::completed, Outcome::link_lost,
       [](Simulation& line) {
         line.send(msg::BoardInfoRequest{});
         line.run_for(to_be_sent);
         line.session.abandon(line.sink());
       }},
      {"confirmation", EventKind::confirmation, Outcome::none,
       [](Simulation& line) {
         line.send(msg::CalibGyro{});
         line.run_for(to_be_sent);
         line.confirm(calib_gyro, milliseconds(5));
         line.confirm(calib_gyro, seconds(2));
       }},
      {"board_error", EventKind::board_error, Outcome::none,
       [](Simulation& line) {
         line.say(error, {99, 1, 0, 0, 0, 0});
       }},
      {"stream", EventKind::stream, Outcome::none,
       [](Simulation& line) {
         line.send(stream_of(realtime_data_3, 100));
         line.run_for(to_be_sent);
         line.confirm(stream_interval);
         line.say(realtime_data_3, body_of(63), milliseconds(5));
       }},
      {"unsolicited", EventKind::unsolicited, Outcome::none,
       [](Simulation& line) { line.say(realtime_data_3, body_of(63)); }},
      {"reset", EventKind::reset, Outcome::none, say_reset},
  };
  return all;
}

/// A call by the sink.
struct Call {
  std::string name;
  std::function<void(Simulation&, const Record&, std::vector<Handle>& sent)> make;
};

const std::vector<Call>& calls() {
  static const std::vector<Call> all = {
      {"send",
       [](Simulation& line, const Record&, std::vector<Handle>& sent) {
         sent.push_back(line.send(msg::ReadParams3Request{}));
       }},
      {"start_stream",
       [](Simulation& line, const Record&, std::vector<Handle>& sent) {
         sent.push_back(line.send(stream_of(realtime_data_4, 100)));
       }},
      {"send_and_cancel",
       [](Simulation& line, const Record&, std::vector<Handle>& sent) {
         const Handle handle = line.send(stream_of(realtime_data_4, 100));
         sent.push_back(handle);
         EXPECT_TRUE(line.session.cancel(handle, line.sink()));
         EXPECT_FALSE(line.session.cancel(handle, line.sink()));
       }},
      {"cancel_what_it_is_about",
       [](Simulation& line, const Record& record, std::vector<Handle>&) {
         const bool is_open = record.event.kind == EventKind::confirmation && record.event.handle;
         EXPECT_EQ(line.session.cancel(record.event.handle, line.sink()), is_open);
       }},
      {"fill_up",
       [](Simulation& line, const Record&, std::vector<Handle>& sent) {
         while (const auto result = line.session.send(msg::MotorsOff{})) {
           sent.push_back(result.handle);
         }
         EXPECT_EQ(line.session.open_requests(), 8U);
       }},
      {"look",
       [](Simulation& line, const Record& record, std::vector<Handle>&) {
         static_cast<void>(line.session.statistics());
         EXPECT_LE(line.session.stream_usage().used, 2 * load_of_4);
         EXPECT_LE(line.session.open_requests(), 8U);
         if (record.event.outcome != Outcome::none) {
           EXPECT_FALSE(line.session.cancel(record.event.handle, line.sink())) << "it is over";
         }
         line.session.set_line({115200, Parity::none});
       }},
  };
  return all;
}

class EachCall : public ::testing::TestWithParam<std::tuple<std::size_t, std::size_t, int>> {};

TEST_P(EachCall, FromEachEventDoesWhatItDoesElsewhere) {
  const Occasion& occasion = occasions()[std::get<0>(GetParam())];
  const Call& call = calls()[std::get<1>(GetParam())];
  const int others = std::get<2>(GetParam());

  Simulation line;
  std::vector<Handle> sent;
  sent.reserve(static_cast<std::size_t>(others));
  for (int i = 0; i < others; ++i) {  // one is in flight and one is queued
    sent.push_back(line.send(msg::EepromReadRequest{}, {.attempts = 1, .timeout = seconds(60)}));
  }
  if (others != 0) line.run_for(to_be_sent);
  bool has_happened = false;
  line.on_event = [&](const Record& record) {
    const bool is_it =
        record.event.kind == occasion.kind && record.event.outcome == occasion.outcome;
    if (!is_it || has_happened) return;
    has_happened = true;
    // From now on the board responds.
    line.board = [&](const Written& frame) {
      if (frame.id == 21) {
        line.say(21, body_of(134));
      } else {
        line.confirm(frame.id);
      }
    };
    call.make(line, record, sent);
  };
  occasion.bring_about(line);
  line.run();
  ASSERT_TRUE(has_happened);

  for (const Handle handle : sent) EXPECT_NE(line.outcome(handle), Outcome::none);
  EXPECT_EQ(line.session.open_requests(), 0U);
  const std::uint32_t stream_3 = occasion.kind == EventKind::stream ? 680 : 0;
  const std::uint32_t stream_4 = call.name == "start_stream" ? load_of_4 : 0;
  EXPECT_EQ(line.session.stream_usage().used, stream_3 + stream_4);
  for (auto i = static_cast<std::size_t>(others); i < sent.size(); ++i) {
    const bool is_cancelled = call.name == "send_and_cancel";
    const bool is_read = call.name == "send";
    EXPECT_EQ(line.outcome(sent[i]), is_cancelled ? Outcome::cancelled
                                     : is_read    ? Outcome::answered
                                                  : Outcome::confirmed);
  }
}

INSTANTIATE_TEST_SUITE_P(All, EachCall,
                         ::testing::Combine(::testing::Range(std::size_t{0}, occasions().size()),
                                            ::testing::Range(std::size_t{0}, calls().size()),
                                            ::testing::Values(0, 2)),
                         [](const auto& one) {
                           return occasions()[std::get<0>(one.param)].name + "_" +
                                  calls()[std::get<1>(one.param)].name + "_" +
                                  std::to_string(std::get<2>(one.param));
                         });

// Random calls

class RandomCalls : public ::testing::TestWithParam<unsigned> {};

/// The session's view of the running streams matches that of a board that restarts from time to
/// time, if it knows the result of the last change of each.
TEST_P(RandomCalls, LeaveTheStreamsAsTheBoardHasThem) {
  std::mt19937 random(GetParam());
  const auto below = [&](int end) {
    return std::uniform_int_distribution<int>(0, end - 1)(random);
  };
  Simulation line;
  std::map<std::uint8_t, std::uint32_t> running;  // loads on the board by command
  std::map<Handle, std::uint8_t> asked;
  std::set<std::uint8_t> unknown;
  line.board = [&](const Written& frame) {
    if (below(6) == 0) {
      running.clear();
      line.fall_silent_at(line.now);
      return line.say(reset, {}, milliseconds(0));
    }
    if (frame.id == stream_interval) {
      const std::uint32_t interval = frame.body[1] + 256U * frame.body[2];
      const std::uint32_t size = frame.body[0] == realtime_data_4 ? 129 : 68;
      running[frame.body[0]] = interval == 0 ? 0 : size * 1000 / interval;
    }
    line.confirm(frame.id, milliseconds(1 + below(80)));
  };
  int left = 150;
  const auto ask = [&] {
    if (left-- <= 0) return;
    const std::uint8_t command = below(2) == 0 ? realtime_data_4 : realtime_data_3;
    const auto sent =
        line.session.send(stream_of(command, static_cast<std::uint16_t>(below(3) * 100)));
    if (sent) asked[sent.handle] = command;
  };
  line.on_event = [&](const Record& record) {
    if (record.event.outcome == Outcome::confirmed) unknown.erase(asked[record.event.handle]);
    if (record.event.outcome == Outcome::timeout) unknown.insert(asked[record.event.handle]);
    if (record.event.kind == EventKind::reset) unknown.clear();
    for (int calls = below(3); calls > 0; --calls) ask();
  };
  while (left > 0) {
    ask();
    line.run_for(milliseconds(below(100)));
  }
  line.run();
  std::uint32_t used = 0;
  for (const auto& [command, load] : running) used += load;
  if (unknown.empty()) {
    EXPECT_EQ(line.session.stream_usage().used, used);
  }
  EXPECT_EQ(line.session.open_requests(), 0U);
}

INSTANTIATE_TEST_SUITE_P(Seeds, RandomCalls, ::testing::Range(1U, 201U));

}  // namespace
}  // namespace sbgc::test
