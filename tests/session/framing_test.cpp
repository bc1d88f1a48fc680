// Tests of a session that changes its framing.

#include <sbgc/availability.hpp>

#include "simulation.hpp"

namespace sbgc::test {
namespace {

using Framings = LineTest;

constexpr std::uint8_t get_angles = 73;

/// A board that answers each request in its framing, if it knows that.
void answer(Simulation& line, const Written& request, Framing newest = Framing::v2) {
  if (request.framing > newest) return;
  const std::size_t size = request.id == board_info || request.id == get_angles ? 18 : 54;
  line.say_bytes(frame_of(request.id, body_of(size), request.framing));
}

std::vector<Framing> framings_of(const std::vector<Written>& written) {
  std::vector<Framing> result;
  result.reserve(written.size());
  for (const Written& frame : written) result.push_back(frame.framing);
  return result;
}

Handle try_v2(Simulation& line) {
  return line.session.try_framing(Framing::v2, msg::BoardInfoRequest{}).handle;
}

TEST(SessionFraming, IsTheNewestOneThatTheFirmwareKnows) {
  EXPECT_EQ(newest_framing({2679, 31}), Framing::v1);
  EXPECT_EQ(newest_framing({2680, 30}), Framing::v2);
}

TEST_F(Framings, ChangesWhenTheBoardAnswersInTheOther) {
  line.board = [&](const Written& request) { answer(line, request); };
  const Handle before = line.send(msg::BoardInfoRequest{});
  line.run();
  EXPECT_EQ(line.session.framing(), Framing::v1);
  const Handle trial = try_v2(line);
  line.run();
  EXPECT_EQ(line.session.framing(), Framing::v2);
  EXPECT_EQ(line.session.statistics().framing, Framing::v2);
  const Handle after = line.send(msg::BoardInfoRequest{});
  line.run();
  for (const Handle handle : {before, trial, after}) {
    EXPECT_EQ(line.outcome(handle), Outcome::answered);
  }
  EXPECT_THAT(framings_of(line.written), ElementsAre(Framing::v1, Framing::v2, Framing::v2));
}

TEST_F(Framings, StaysIfTheBoardDoesNotAnswerInTheOther) {
  line.board = [&](const Written& request) { answer(line, request, Framing::v1); };
  const Handle trial = try_v2(line);
  line.run();
  EXPECT_EQ(line.outcome(trial), Outcome::timeout);
  EXPECT_EQ(line.session.framing(), Framing::v1);
  EXPECT_EQ(line.ask(msg::BoardInfoRequest{}), Outcome::answered);
  EXPECT_THAT(framings_of(line.written),
              ElementsAre(Framing::v2, Framing::v2, Framing::v2, Framing::v1));
}

TEST_F(Framings, StaysIfTheAnswerIsInTheOldOne) {
  line.board = [&](const Written& request) { line.say(request.id, body_of(18)); };
  const Handle trial = try_v2(line);
  line.run();
  EXPECT_EQ(line.outcome(trial), Outcome::answered);
  EXPECT_EQ(line.session.framing(), Framing::v1);
}

TEST_F(Framings, OnlyTheOneInUseIsAccepted) {
  line.say_bytes(frame_of(102, body_of(4), Framing::v2));
  line.run_for(milliseconds(10));
  EXPECT_THAT(line.events, IsEmpty());
  line.board = [&](const Written& request) { answer(line, request); };
  try_v2(line);
  line.run();
  line.events.clear();
  line.say_bytes(frame_of(102, body_of(4), Framing::v1));
  line.run_for(milliseconds(200));
  EXPECT_THAT(line.events, IsEmpty());
  line.say_bytes(frame_of(102, body_of(4), Framing::v2));
  line.run_for(milliseconds(10));
  EXPECT_THAT(line.events, SizeIs(1));
}

TEST_F(Framings, ATrialLosesNoFrameOfEither) {
  line.board = [&](const Written& request) {
    line.say(102, body_of(4), milliseconds(1));
    answer(line, request);
  };
  try_v2(line);
  line.run();
  EXPECT_THAT(line.of(EventKind::unsolicited), SizeIs(1));
  EXPECT_EQ(line.session.framing(), Framing::v2);
}

// A request before the trial is answered in the old framing, one after it in the new one.
TEST_F(Framings, NothingIsInFlightDuringATrial) {
  line.board = [&](const Written& request) { answer(line, request); };
  const Handle before = line.send(msg::GetAnglesRequest{});
  const Handle trial = try_v2(line);
  const Handle after = line.send(msg::GetAnglesExtRequest{});
  line.on_event = [&](const Record& record) {
    if (record.event.handle == before) {
      EXPECT_THAT(line.written, SizeIs(1));
    }
    if (record.event.handle == trial) {
      EXPECT_THAT(line.written, SizeIs(2));
    }
  };
  line.run();
  EXPECT_EQ(line.outcome(trial), Outcome::answered);
  EXPECT_THAT(framings_of(line.written), ElementsAre(Framing::v1, Framing::v2, Framing::v2));
  EXPECT_EQ(line.outcome(before), Outcome::answered);
  EXPECT_EQ(line.outcome(after), Outcome::answered);
}

TEST_F(Framings, ANewLinkBeginsWithTheFramingOfEveryBoard) {
  line.board = [&](const Written& request) { answer(line, request); };
  try_v2(line);
  line.run();
  line.session.abandon(line.sink());
  EXPECT_EQ(line.session.framing(), Framing::v1);
  EXPECT_EQ(line.ask(msg::BoardInfoRequest{}), Outcome::answered);
}

TEST_F(Framings, ACancelledTrialChangesNothing) {
  const Handle trial = try_v2(line);
  line.run_for(milliseconds(50));
  EXPECT_TRUE(line.session.cancel(trial, line.sink()));
  EXPECT_EQ(line.session.framing(), Framing::v1);
  line.board = [&](const Written& request) { answer(line, request); };
  EXPECT_EQ(line.ask(msg::GetAnglesRequest{}), Outcome::answered);
}

TEST(SessionFraming, CanBeFixed) {
  Basic<BasicSession<SessionCapacity{}, FrameFormats<CrcTable::nibbles, Framing::v2>>> line;
  line.board = [&](const Written& request) {
    line.say_bytes(frame_of(request.id, body_of(18), request.framing));
  };
  EXPECT_EQ(line.ask(msg::BoardInfoRequest{}), Outcome::answered);
  EXPECT_THAT(framings_of(line.written), ElementsAre(Framing::v2));
}

}  // namespace
}  // namespace sbgc::test
